// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/field_checks.h"

#include <utility>

#include <QAbstractButton>
#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QFocusEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>

#include "app/gui/widgets/form.h"

namespace torsio::gui {

QLabel* fieldHint(QWidget* parent) {
  QLabel* label = sentence(parent, false);
  setLook(label, "caution", true);
  label->setObjectName(QStringLiteral("fieldHint"));
  label->hide();
  return label;
}

void sayHint(QLabel* hint, const QString& wrong) {
  hint->setText(wrong);
  hint->setVisible(!wrong.isEmpty());
}

FieldChecks::FieldChecks(QWidget* form) : QObject(form) {}

void FieldChecks::add(QFormLayout* form, QWidget* field, std::function<QString()> wrong) {
  QLabel* hint = fieldHint();
  form->addRow(QString(), hint);
  add(hint, field, std::move(wrong));
}

void FieldChecks::add(QBoxLayout* column, QWidget* field, std::function<QString()> wrong) {
  QLabel* hint = fieldHint();
  column->addWidget(hint);
  add(hint, field, std::move(wrong));
}

void FieldChecks::add(QLabel* hint, QWidget* field, std::function<QString()> wrong) {
  checks_.push_back({field, hint, std::move(wrong)});
  watch(field);
}

void FieldChecks::addNeeded(QFormLayout* form, QLineEdit* field, const QString& missing) {
  add(form, field, [field, missing] { return field->text().trimmed().isEmpty() ? missing : QString(); });
}

void FieldChecks::decide(QPushButton* accept, std::function<bool()> also) {
  accept_ = accept;
  also_ = std::move(also);
  check();
}

void FieldChecks::watch(QWidget* field) {
  field->installEventFilter(this);
  const auto changed = [this] { check(); };
  const auto typed = [this, field] { touch(field); };
  if (auto* line = qobject_cast<QLineEdit*>(field)) {
    connect(line, &QLineEdit::textChanged, this, changed);
    connect(line, &QLineEdit::textEdited, this, typed);
  } else if (auto* text = qobject_cast<QPlainTextEdit*>(field)) {
    connect(text, &QPlainTextEdit::textChanged, this, changed);
  } else if (auto* list = qobject_cast<QComboBox*>(field)) {
    connect(list, &QComboBox::currentIndexChanged, this, changed);
    connect(list, &QComboBox::activated, this, typed);
  }
  for (auto* box : field->findChildren<QAbstractButton*>()) {  // group of boxes
    box->installEventFilter(this);
    connect(box, &QAbstractButton::toggled, this, changed);
    connect(box, &QAbstractButton::clicked, this, typed);
  }
}

void FieldChecks::touch(const QWidget* field) {
  for (Check& one : checks_) {
    one.touched = one.touched || one.field == field;
  }
  check();
}

bool FieldChecks::check() {
  QString first;
  for (const Check& one : checks_) {
    const QString wrong = one.field->isEnabled() ? one.wrong() : QString();
    if (first.isEmpty()) {
      first = wrong;
    }
    sayHint(one.hint, one.touched ? wrong : QString());
  }
  if (accept_ != nullptr) {
    accept_->setEnabled(first.isEmpty() && (!also_ || also_()));
    accept_->setToolTip(first);
  }
  return first.isEmpty();
}

bool FieldChecks::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::FocusOut) {
    const Qt::FocusReason reason = static_cast<QFocusEvent*>(event)->reason();
    const bool stays = reason == Qt::ActiveWindowFocusReason || reason == Qt::PopupFocusReason;
    for (const Check& one : checks_) {
      // For a group, when focus leaves its last box.
      if (!stays && (watched == one.field || one.field->isAncestorOf(qobject_cast<QWidget*>(watched)))) {
        if (reason == Qt::OtherFocusReason) {
          // A form's destruction moves focus from its fields after the data of their checks is gone; by the
          // time of the queued call, this is gone too.
          QMetaObject::invokeMethod(
              this, [this, field = one.field] { touch(field); }, Qt::QueuedConnection);
        } else {
          touch(one.field);
        }
        break;
      }
    }
  }
  return QObject::eventFilter(watched, event);
}

}  // namespace torsio::gui
