// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/ordered_list.h"

#include <algorithm>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kOrderedWidth = 190;
constexpr int kCodeWidth = 12 * kSpace;

}  // namespace

OrderedList::OrderedList(const QString& name, QWidget* form, QWidget* parent)
    : QWidget(parent),
      list_(new QListWidget),
      add_(new QPushButton),
      remove_(new QPushButton),
      up_(new QPushButton),
      down_(new QPushButton) {
  list_->setObjectName(name);
  list_->setMinimumWidth(kOrderedWidth);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setTextElideMode(Qt::ElideNone);
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  auto* buttons = new QGridLayout;
  buttons->setSpacing(kSpace / 2);
  int next = 0;
  for (QPushButton* button : {add_, remove_, up_, down_}) {
    button->setAutoDefault(false);
    buttons->addWidget(button, next / 2, next % 2);
    ++next;
  }
  auto* left = new QVBoxLayout;
  left->setSpacing(kSpace);
  left->addWidget(list_, 1);
  left->addLayout(buttons);
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(form);
  keepOffScrollBar(*scroll, *form->layout());
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(2 * kSpace);
  row->addLayout(left, 1);
  row->addWidget(scroll, 3);
  connect(list_, &QListWidget::currentRowChanged, this, [this] {
    enableButtons();
    Q_EMIT chosen();
  });
  connect(add_, &QPushButton::clicked, this, &OrderedList::addWanted);
  connect(remove_, &QPushButton::clicked, this, &OrderedList::removeWanted);
  connect(up_, &QPushButton::clicked, this, [this] { Q_EMIT moveWanted(-1); });
  connect(down_, &QPushButton::clicked, this, [this] { Q_EMIT moveWanted(+1); });
  enableButtons();
}

void OrderedList::setLines(const QStringList& lines, int row) {
  const QSignalBlocker quiet(list_);
  list_->clear();
  for (const QString& line : lines) {
    list_->addItem(line);
    list_->item(list_->count() - 1)->setToolTip(line);
  }
  list_->setCurrentRow(std::min(row, list_->count() - 1));
  enableButtons();
}

void OrderedList::setCurrentLine(const QString& line) {
  if (QListWidgetItem* item = list_->currentItem()) {
    item->setText(line);
  }
}

int OrderedList::row() const {
  return list_->currentRow();
}

void OrderedList::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  enableButtons();
}

void OrderedList::setListName(const QString& name) {
  list_->setAccessibleName(name);
}

void OrderedList::enableButtons() {
  const bool change = row() >= 0 && !readOnly_;
  add_->setEnabled(!readOnly_);
  remove_->setEnabled(change);
  up_->setEnabled(change && row() > 0);
  down_->setEnabled(change && row() + 1 < list_->count());
}

void OrderedList::retranslate() {
  add_->setText(tr("Add"));
  remove_->setText(tr("Remove"));
  up_->setText(tr("Up"));
  up_->setToolTip(tr("Moves it before the one above."));
  down_->setText(tr("Down"));
  down_->setToolTip(tr("Moves it behind the one below."));
}

CodeField::CodeField() : field_(new QLineEdit), problem_(fieldHint()) {
  field_->setMaximumWidth(kCodeWidth);
}

void CodeField::show(const std::string& code) {
  field_->setText(toQString(code));
  problem_->hide();
}

std::optional<std::string> CodeField::changed(const std::string& before,
                                              const std::vector<std::string>& taken, const QString& missing,
                                              const QString& used) {
  std::string code = field_->text().trimmed().toStdString();
  const bool free = code == before || std::find(taken.begin(), taken.end(), code) == taken.end();
  sayHint(problem_, code.empty() ? missing : free ? QString() : used);
  if (code == before) {
    return std::nullopt;
  }
  if (!code.empty() && free) {
    return code;
  }
  field_->setText(toQString(before));
  return std::nullopt;
}

}  // namespace torsio::gui
