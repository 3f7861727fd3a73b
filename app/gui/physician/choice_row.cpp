// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/choice_row.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>

#include "app/gui/widgets/accessible_role.h"

namespace torsio::gui {

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
