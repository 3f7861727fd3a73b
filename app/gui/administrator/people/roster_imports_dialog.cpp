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

RosterImportsDialog::RosterImportsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      table_(new DataTable(QStringLiteral("roster-imports"), this)),
      takeBack_(listButton(table_)) {
  setObjectName(QStringLiteral("rosterImports"));
  setWindowTitle(tr("Imported rosters"));
  resize(900, 420);
  table_->setObjectName(QStringLiteral("imports"));
  takeBack_->setObjectName(QStringLiteral("takeBack"));
  takeBack_->setText(tr("&Take back\u2026"));
  QLabel* words = sentence(this);
  words->setText(
      tr("A roster that was imported by mistake is taken back whole: whom it added goes, whom it changed is "
         "as before. That can be done while nothing hangs on its people."));
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
                      {tr("State")}});
  table_->setEmptyText(tr("No roster was imported yet."));
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
  return one.hindrance.empty() ? tr("can be taken back") : toQString(one.hindrance);
}

void RosterImportsDialog::read() {
  attempt(shell_, [&] { imports_ = importedRosters(shell_.session()); });
  std::vector<Row> rows;
  for (const ImportedRoster& one : imports_) {
    QStringList codes;
    for (const std::string& code : one.codes) {
      codes << toQString(code);
    }
    const QString state = stateText(one);
    rows.push_back({toQString(one.id),
                    {timeCell(one.importedUtc_us),
                     {orDash(one.importedBy)},
                     {one.kind == RosterKind::kTrainees ? tr("trainees") : tr("raters")},
                     {QString::number(one.added), static_cast<qlonglong>(one.added)},
                     {QString::number(one.changed), static_cast<qlonglong>(one.changed)},
                     {codes.isEmpty() ? QStringLiteral("\u2013") : firstFew(codes)},
                     {state, {}, state}}});
  }
  table_->setRows(std::move(rows));
  showButtons();
}

const ImportedRoster* RosterImportsDialog::current() const {
  const std::string id = table_->currentId().toStdString();
  const auto found = std::find_if(imports_.begin(), imports_.end(),
                                  [&id](const ImportedRoster& one) { return one.id == id; });
  return found == imports_.end() ? nullptr : &*found;
}

void RosterImportsDialog::showButtons() {
  const ImportedRoster* one = current();
  takeBack_->setEnabled(one != nullptr && !one->takenBack && one->hindrance.empty());
}

void RosterImportsDialog::takeBack() {
  const ImportedRoster* one = current();
  if (one == nullptr) {
    return;
  }
  const std::optional<std::string> reason = askReason(
      this, tr("Take back"),
      tr("People who go, with accounts that nobody used: %1. People who are as before: %2. Codes that were "
         "given are not given again.")
          .arg(one->added)
          .arg(one->changed));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    takeBackRoster(shell_.session(), one->id, *reason);
    shell_.notify(tr("The import is taken back"));
  });
  read();
}

}  // namespace torsio::gui
