// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/physician/sheet_editor_panel.h"

#include <utility>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QPlainTextEdit>
#include <QToolButton>

#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/accessible_role.h"

namespace torsio::gui {

namespace {

bool isModifier(int key) {
  return key == Qt::Key_Control || key == Qt::Key_Shift || key == Qt::Key_Alt || key == Qt::Key_AltGr ||
         key == Qt::Key_Meta;
}

}  // namespace

SheetEditorPanel::SheetEditorPanel(bool largeTargets, QWidget* parent) : SheetPanel(largeTargets, parent) {
  commentField()->installEventFilter(this);
  connect(this, &SheetPanel::edited, this, [this] { asking_ = awaitsTouch_ = false; });
}

SheetEditorPanel::~SheetEditorPanel() = default;

void SheetEditorPanel::beginSheet(RubricRevision rubric, Sheet sheet, bool withOverall) {
  asking_ = false;
  unsaved_ = false;
  awaitsTouch_ = false;
  auto fresh = std::make_unique<SheetEditor>(std::move(rubric), std::move(sheet), withOverall);
  setEditor(fresh.get());
  editor_ = std::move(fresh);
}

void SheetEditorPanel::endSheet() {
  asking_ = false;
  unsaved_ = false;
  setEditor(nullptr);
  editor_.reset();
}

bool SheetEditorPanel::save(ShellContext& shell, SaidLine& said, std::function<QString()> kept,
                            const std::function<void()>& store) {
  const bool good = attempt(shell, store);
  said.say(
      good ? std::move(kept) : [] { return tr("Not saved"); }, !good);
  unsaved_ = !good;
  return good;
}

void SheetEditorPanel::undo() {
  if (editor_ == nullptr || readOnly() || !editor_->undo()) {
    return;
  }
  refresh();
  Q_EMIT edited();
}

void SheetEditorPanel::redo() {
  if (editor_ == nullptr || readOnly() || !editor_->redo()) {
    return;
  }
  refresh();
  Q_EMIT edited();
}

void SheetEditorPanel::clearAll() {
  if (editor_ == nullptr || readOnly() || !editor_->clearAll()) {
    return;
  }
  refresh();
  Q_EMIT edited();
}

bool SheetEditorPanel::handleCommand(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  const bool alsoRedo = event->key() == Qt::Key_Y && event->modifiers() == Qt::ControlModifier;
  if (event->matches(QKeySequence::Undo)) {
    undo();
  } else if (event->matches(QKeySequence::Redo) || alsoRedo) {
    redo();
  } else if (enter && (event->modifiers() & Qt::ControlModifier) != 0) {
    if (event->isAutoRepeat()) {
      return true;  // the first press asks, the second seals: auto-repeat is not a second press
    }
    if (awaitsTouch_) {
      Q_EMIT heldBack();
    } else {
      Q_EMIT finishWanted();
    }
  } else {
    awaitsTouch_ = awaitsTouch_ && isModifier(event->key());
    return false;
  }
  return true;
}

bool SheetEditorPanel::handle(QKeyEvent* event) {
  return handleCommand(event) || handleKey(event->key(), event->modifiers());
}

bool SheetEditorPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched != commentField() || event->type() != QEvent::KeyPress) {
    return SheetPanel::eventFilter(watched, event);
  }
  // The whole sheet has one undo history: the text field has none of its own.
  auto* key = static_cast<QKeyEvent*>(event);
  if (handleCommand(key)) {
    return true;
  }
  if (key->key() != Qt::Key_Escape) {
    return false;
  }
  takeFocus();
  return true;
}

ChoiceRow::ChoiceRow(QWidget* parent)
    : QWidget(parent), row_(new QHBoxLayout(this)), group_(new QButtonGroup(this)) {
  row_->setContentsMargins(0, 0, 0, 0);
  setAccessibleRole(this, QAccessible::Grouping);
}

void ChoiceRow::setChoices(const std::vector<QString>& texts, std::size_t chosen) {
  for (QAbstractButton* button : group_->buttons()) {
    group_->removeButton(button);
    button->hide();
    button->deleteLater();  // it may be the button just pressed
  }
  while (QLayoutItem* item = row_->takeAt(0)) {
    delete item;
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    auto* button = new QToolButton(this);
    setAccessibleRole(button, QAccessible::RadioButton);
    button->setCheckable(true);
    button->setChecked(i == chosen);
    button->setText(texts[i]);
    group_->addButton(button);
    row_->addWidget(button);
    button->show();
    connect(button, &QToolButton::clicked, this, [this, i] { Q_EMIT this->chosen(i); });
  }
  row_->addStretch(1);
}

}  // namespace torsio::gui
