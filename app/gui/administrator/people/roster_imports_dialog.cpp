// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/roster_imports_dialog.h"

#include <algorithm>
#include <optional>
#include <string>

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

namespace {

constexpr int kImportedPeople = 7;  // column

}  // namespace

RosterImportsDialog::RosterImportsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      table_(named(new DataTable(QStringLiteral("roster-imports"), this), "imports")),
      takeBack_(named(listButton(table_), "takeBack")) {
  setObjectName(QStringLiteral("rosterImports"));
  setWindowTitle(tr("Imported rosters"));
  resize(900, 420);
  takeBack_->setText(tr("&Take back\u2026"));
  QLabel* words = sentence(this);
  words->setText(
      tr("An import made by mistake can be undone as a whole: people it added are removed, people it changed "
         "are restored. This works only while no records depend on them."));
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  table_->setColumns({{tr("Imported")},
                      {tr("By")},
                      {tr("Lists")},
                      {tr("Added"), true},
                      {tr("Changed"), true},
                      {tr("People")},
                      {tr("State")},
                      {tr("Everybody")}});
  table_->hideAtFirst(kImportedPeople);  // a search for a code finds its import
  table_->setEmptyText(tr("No roster has been imported yet."));
  connect(buttons, &QDialogButtonBox::rejected, this, &RosterImportsDialog::reject);
  connect(takeBack_, &QPushButton::clicked, this, &RosterImportsDialog::takeBack);
  connect(table_, &DataTable::currentChanged, this, &RosterImportsDialog::showButtons);
  read();
  if (!imports_.empty()) {
    table_->select(toQString(imports_.front().id));
  }
}

QString RosterImportsDialog::stateText(const ImportedRoster& one) const {
  if (one.takenBack) {
    return tr("taken back");
  }
  return one.hindrance.empty() ? tr("can be undone") : toQString(one.hindrance);
}

void RosterImportsDialog::read() {
  attempt(shell_, [&] { imports_ = importedRosters(shell_.session()); });
  std::vector<Row> rows;
  for (const ImportedRoster& one : imports_) {
    const QStringList codes = listOf(one.codes);
    const QString state = stateText(one);
    rows.push_back({toQString(one.id),
                    {timeCell(one.importedUtc_us),
                     {orDash(one.importedBy)},
                     {one.kind == RosterKind::kTrainees ? tr("trainees") : tr("raters")},
                     {QString::number(one.added), static_cast<qlonglong>(one.added)},
                     {QString::number(one.changed), static_cast<qlonglong>(one.changed)},
                     {codes.isEmpty() ? QStringLiteral("\u2013") : firstFew(codes)},
                     {state, {}, state},
                     {codes.join(QStringLiteral(", "))}}});
  }
  table_->setRows(std::move(rows));
  showButtons();
}

std::vector<const ImportedRoster*> RosterImportsDialog::chosen() const {
  std::vector<const ImportedRoster*> rows =
      chosenRows(*table_, imports_, [](const ImportedRoster& one) { return one.id; });
  std::erase_if(rows, [](const ImportedRoster* one) { return one->takenBack; });
  return rows;
}

void RosterImportsDialog::showButtons() {
  const std::vector<const ImportedRoster*> rows = chosen();
  // Selected imports may depend on each other; undoing them takes care of the order.
  takeBack_->setEnabled(std::any_of(rows.begin(), rows.end(),
                                    [](const ImportedRoster* one) { return one->hindrance.empty(); }));
}

void RosterImportsDialog::takeBack() {
  std::vector<std::string> ids;
  std::int64_t added = 0;
  std::int64_t changed = 0;
  for (const ImportedRoster* one : chosen()) {
    ids.push_back(one->id);
    added += one->added;
    changed += one->changed;
  }
  if (ids.empty()) {
    return;
  }
  const std::optional<std::string> reason =
      askReason(this, tr("Take back"),
                tr("People removed, with accounts that were never used: %1. People restored: %2. Codes that "
                   "were assigned are not reused.")
                    .arg(added)
                    .arg(changed));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    takeBackRosters(shell_.session(), ids, *reason);
    shell_.notify(tr("%n import(s) undone", nullptr, static_cast<int>(ids.size())));
  });
  read();
}

}  // namespace torsio::gui
