// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/remark_words.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr int kFieldHeight = 72;

}  // namespace

RemarkWords::RemarkWords(QWidget* parent)
    : QWidget(parent),
      text_(plainLabel(this)),
      history_(linkButton(this)),
      edit_(linkButton(this)),
      earlier_(plainLabel(this, "quiet")),
      editor_(new QWidget(this)),
      field_(new QPlainTextEdit(editor_)),
      save_(new QPushButton(tr("Save"), editor_)) {
  text_->setObjectName(QStringLiteral("words"));
  history_->setObjectName(QStringLiteral("edited"));
  edit_->setObjectName(QStringLiteral("editWords"));
  earlier_->setObjectName(QStringLiteral("earlierWords"));
  field_->setObjectName(QStringLiteral("newWords"));
  save_->setObjectName(QStringLiteral("saveWords"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpace / 2);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpace);
  row->addWidget(text_, 1);
  row->addWidget(history_, 0, Qt::AlignTop);
  row->addWidget(edit_, 0, Qt::AlignTop);
  column->addLayout(row);
  column->addWidget(earlier_);
  auto* editorRow = new QHBoxLayout(editor_);
  editorRow->setContentsMargins(0, 0, 0, 0);
  editorRow->setSpacing(kSpace);
  editorRow->addWidget(field_, 1);
  editorRow->addWidget(save_, 0, Qt::AlignTop);
  auto* leave = linkButton(editor_);
  leave->setText(tr("Cancel"));
  editorRow->addWidget(leave, 0, Qt::AlignTop);
  column->addWidget(editor_);
  edit_->setText(tr("Edit"));
  history_->setCheckable(true);
  field_->setTabChangesFocus(true);
  field_->setFixedHeight(kFieldHeight);
  field_->setAccessibleName(tr("New wording; the earlier one is kept"));
  field_->installEventFilter(this);
  earlier_->hide();
  editor_->hide();
  connect(history_, &QPushButton::toggled, earlier_, &QLabel::setVisible);
  connect(edit_, &QPushButton::clicked, this, [this] { setEditing(true); });
  connect(leave, &QPushButton::clicked, this, [this] { setEditing(false); });
  connect(save_, &QPushButton::clicked, this, &RemarkWords::save);
  connect(field_, &QPlainTextEdit::textChanged, save_, [this] {
    const QString now = field_->toPlainText().trimmed();
    save_->setEnabled(!now.isEmpty() && now != words_);
  });
}

void RemarkWords::setWords(const QString& text, std::int64_t editedUtc_us,
                           const std::vector<RemarkWording>& earlier, bool own) {
  words_ = text;
  showText();
  history_->setVisible(editedUtc_us != 0);
  history_->setText(tr("edited %1").arg(shownTime(editedUtc_us)));
  history_->setToolTip(tr("Shows the earlier wording"));
  edit_->setVisible(own && !text.isEmpty());
  QStringList lines;
  for (const RemarkWording& one : earlier) {
    lines << tr("%1: %2").arg(shownTime(one.writtenUtc_us), toQString(one.text));
  }
  earlier_->setText(lines.join(QLatin1Char('\n')));
  setEditing(false);
}

void RemarkWords::setLead(const QString& lead) {
  lead_ = lead;
  showText();
}

void RemarkWords::showText() {
  text_->setText(lead_.isEmpty() ? words_ : tr("%1: %2").arg(lead_, words_));
}

void RemarkWords::setEditing(bool editing) {
  editor_->setVisible(editing);
  text_->setVisible(!editing);
  edit_->setEnabled(!editing);
  if (editing) {
    field_->setPlainText(words_);
    field_->selectAll();
    field_->setFocus(Qt::OtherFocusReason);
  }
}

void RemarkWords::save() {
  if (save_->isEnabled()) {
    Q_EMIT edited(field_->toPlainText().trimmed());
  }
}

bool RemarkWords::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_ && event->type() == QEvent::KeyPress) {
    auto* key = static_cast<QKeyEvent*>(event);
    const bool enter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
    if (enter && (key->modifiers() & Qt::ControlModifier) != 0) {
      save();
      return true;
    }
    if (key->key() == Qt::Key_Escape) {
      setEditing(false);
      edit_->setFocus(Qt::OtherFocusReason);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace torsio::gui
