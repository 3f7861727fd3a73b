// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/study/deviations_dialog.h"

#include <algorithm>
#include <map>
#include <optional>

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/study/todays_sessions_dialogs.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/services/study/cohort_service.h"

namespace torsio::gui {

namespace {

constexpr QSize kDeviationsSize(860, 500);

}  // namespace

DeviationsDialog::DeviationsDialog(ShellContext& shell, const CohortId& cohortId, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      cohortId_(cohortId),
      table_(named(new DataTable(QStringLiteral("deviations"), this), "deviations")),
      correct_(named(listButton(table_), "correctDeviations")) {
  setObjectName(QStringLiteral("deviationsDialog"));
  setWindowTitle(tr("Deviations"));
  resize(kDeviationsSize);
  table_->setColumns({{tr("When")}, {tr("Trainee")}, {tr("Kind")}, {tr("Description")}});
  table_->setEmptyText(tr("No deviation was noted."));
  correct_->setText(tr("Entered in &error\u2026"));
  correct_->setToolTip(tr("Marks the selected deviations as wrong, with the reason; nothing is removed"));
  QLabel* words = sentence(this, false);
  words->setText(tr("Where the study departed from the protocol. The report lists it as well."));
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(tr("&Close"), QDialogButtonBox::RejectRole);
  connect(buttons, &QDialogButtonBox::rejected, this, &DeviationsDialog::reject);
  connect(correct_, &QPushButton::clicked, this, &DeviationsDialog::correct);
  connect(table_, &DataTable::currentChanged, this,
          [this] { correct_->setEnabled(!table_->selectedIds().isEmpty()); });
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
  read();
}

void DeviationsDialog::read() {
  std::map<EnrolmentId, std::string> codes;
  for (const Enrolment& enrolment : enrolments(shell_.session(), cohortId_)) {
    codes[enrolment.id] = enrolment.traineeCode;
  }
  std::vector<Row> rows;
  for (const ProtocolDeviation& one : deviations(shell_.session(), cohortId_)) {
    const QString description = orDash(one.description);
    rows.push_back({toQString(one.id),
                    {timeCell(one.happenedUtc_us),
                     {one.enrolmentId.empty() ? tr("the whole cohort") : toQString(codes[one.enrolmentId])},
                     {toQString(Text(one.kind))},
                     {description, {}, description}}});
  }
  std::reverse(rows.begin(), rows.end());
  table_->setRows(std::move(rows));
  correct_->setEnabled(!table_->selectedIds().isEmpty());
}

void DeviationsDialog::correct() {
  std::vector<DeviationId> wrong;
  for (const QString& id : table_->selectedIds()) {
    wrong.emplace_back(id.toStdString());
  }
  const std::optional<std::string> reason =
      askReason(this, tr("Entered in error"),
                tr("%n deviation(s) stay as they are; a correction with this reason is added to each, in the "
                   "report as well.",
                   nullptr, static_cast<int>(wrong.size())));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    correctDeviations(shell_.session(), cohortId_, wrong, *reason);
    read();
  });
}

}  // namespace torsio::gui
