// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/installation_dialog.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

InstallationDialog::InstallationDialog(std::vector<InstallationCheck> checks, QWidget* parent)
    : QDialog(parent) {
  setObjectName(QStringLiteral("installation"));
  setWindowTitle(tr("This computer"));
  resize(1000, 560);
  sortByUrgency(checks);
  QLabel* words = sentence(this);
  words->setText(toQString(summaryOf(checks)));
  auto* table = named(new DataTable(QStringLiteral("installation"), this), "checks");
  table->setColumns({{tr("State")}, {tr("What")}, {tr("Found")}, {tr("What to do")}});
  std::vector<Row> rows;
  for (const InstallationCheck& one : checks) {
    const QString state = toQString(labelOf(one.state));
    const QString found = toQString(one.finding);
    const QString remedy = toQString(one.remedy);
    rows.push_back({toQString(one.name),
                    {{state, static_cast<int>(rows.size())},
                     {toQString(labelOf(one))},
                     {found, {}, found},
                     {remedy, {}, remedy}}});
  }
  table->setRows(std::move(rows));
  table->wrapWhatIsCut();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  auto* report =
      named(buttons->addButton(tr("&Save a report for support\u2026"), QDialogButtonBox::ActionRole),
            "supportReport");
  connect(report, &QPushButton::clicked, this, &InstallationDialog::askForFile);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(table, 1);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &InstallationDialog::reject);
}

void InstallationDialog::askForFile() {
  const QString file = askFileToSave(this, tr("Save a report for support"),
                                     QStringLiteral("torsio-support.json"), tr("Report (*.json)"));
  if (!file.isEmpty()) {
    Q_EMIT reportWanted(file);
  }
}

}  // namespace torsio::gui
