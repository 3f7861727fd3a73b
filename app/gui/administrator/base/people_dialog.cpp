// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/people_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

PeopleDialog::PeopleDialog(const QString& title, const QString& question,
                           const std::vector<PersonRow>& people, QWidget* parent)
    : QDialog(parent), table_(new DataTable(QString(), this)) {
  setWindowTitle(title);
  resize(640, 520);
  auto* words = new QLabel(question, this);
  words->setWordWrap(true);
  table_->setColumns({{tr("Code")}, {tr("Sex")}, {tr("Level")}, {tr("Experience")}, {tr("Class of raters")}});
  table_->setEmptyText(tr("There is nobody left to choose."));
  std::vector<Row> rows;
  for (const PersonRow& row : people) {
    rows.push_back({toQString(row.person.id),
                    {{toQString(row.person.code)},
                     {levelName(row.person.sex)},
                     {orDash(row.person.level)},
                     {orDash(row.person.experience)},
                     {raterClassName(row.raterClass)}}});
  }
  table_->setRows(std::move(rows));
  table_->view().setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->view().selectAll();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  QPushButton* take = buttons->button(QDialogButtonBox::Ok);
  const auto sayHowMany = [this, take] {
    const auto chosen = static_cast<int>(table_->selectedIds().size());
    take->setText(tr("Add %n", nullptr, chosen));
    take->setEnabled(chosen > 0);
  };
  connect(table_, &DataTable::currentChanged, this, sayHowMany);
  sayHowMany();
  take->setFocus();  // Enter accepts everybody; the list is for exceptions
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(words);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
}

std::vector<PersonId> PeopleDialog::chosen() const {
  std::vector<PersonId> out;
  for (const QString& id : table_->selectedIds()) {
    out.push_back(id.toStdString());
  }
  return out;
}

}  // namespace torsio::gui
