// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/question_dialog.h"

#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kDialogWidth = 440;

struct ReasonDialog {
  Q_DECLARE_TR_FUNCTIONS(ReasonDialog)
};

struct LossDialog {
  Q_DECLARE_TR_FUNCTIONS(LossDialog)
};

}  // namespace

QString reasonWanted() {
  return ReasonDialog::tr("Say why: the reason stays in the record.");
}

QuestionDialog::QuestionDialog(QWidget* parent, const QString& title, const QString& question)
    : QDialog(parent), column_(new QVBoxLayout(this)) {
  setWindowTitle(title);
  setMinimumWidth(kDialogWidth);
  column_->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column_->setSpacing(2 * kSpace);
  if (!question.isEmpty()) {
    addNote(question);
  }
}

void QuestionDialog::addNote(const QString& text) {
  auto* label = new QLabel(text, this);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setProperty("quiet", true);
  column_->addWidget(label);
}

QPushButton* QuestionDialog::finish(const QString& accept) {
  return addButtons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this), accept);
}

QPushButton* QuestionDialog::finishWithoutCancel(const QString& accept) {
  return addButtons(new QDialogButtonBox(QDialogButtonBox::Ok, this), accept);
}

QPushButton* QuestionDialog::addButtons(QDialogButtonBox* buttons, const QString& accept) {
  QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
  ok->setText(accept);
  ok->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column_->addWidget(buttons);
  return ok;
}

std::optional<std::string> askReason(QWidget* parent, const QString& title, const QString& question) {
  QuestionDialog dialog(parent, title, question);
  auto* reason = new QLineEdit(&dialog);
  reason->setObjectName(QStringLiteral("reason"));
  auto* form = new QFormLayout;
  form->addRow(ReasonDialog::tr("&Reason"), reason);
  FieldChecks checks(&dialog);
  checks.addNeeded(form, reason, reasonWanted());
  dialog.column()->addLayout(form);
  checks.decide(dialog.finish(title));
  reason->setFocus();
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return reason->text().trimmed().toStdString();
}

bool mayLoseChanges(QWidget* parent) {
  QuestionDialog sure(parent, LossDialog::tr("Close without publishing"),
                      LossDialog::tr("The changes are not published and will be lost."));
  sure.finish(LossDialog::tr("&Discard"));
  return sure.exec() == QDialog::Accepted;
}

void pressNothingByEnter(QDialog& dialog) {
  for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
    button->setAutoDefault(false);
  }
}

}  // namespace torsio::gui
