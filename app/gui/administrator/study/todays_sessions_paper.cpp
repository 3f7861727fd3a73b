// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of TodaysSessionsPage on paper: lists and sheets to print, reminders to copy.
#include <QComboBox>
#include <QLineEdit>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/base/reminder_text.h"
#include "app/gui/administrator/base/study_labels.h"
#include "app/gui/administrator/study/call_bar.h"
#include "app/gui/administrator/study/paper_dialog.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/file_choice.h"
#include "app/services/study/paper_sheets.h"

namespace torsio::gui {

void TodaysSessionsPage::printCallList() {
  if (!board_) {
    return;
  }
  const QString cohort = toQString(board_->cohortName);
  const QString file =
      askFileToSave(this, tr("Print the call list"), tr("Call list %1.pdf").arg(cohort), tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  attempt(shell(), [&] {
    std::vector<CallLine> lines;
    for (const DayBoardRow& row : board_->rows) {
      if (row.state != EnrolmentState::kWithdrawn && row.sheetsMissing > 0) {
        lines.push_back({toQString(row.traineeCode), orDash(row.groupCode), nowText(row),
                         occasionName(row.occasionDue), static_cast<int>(row.sheetsMissing)});
      }
    }
    writeCallList(lines, cohort, child<QLineEdit>(*callBar_, "callRoom").text(), toPath(file));
    shell().notify(tr("Written: %n trainee(s) to call", nullptr, static_cast<int>(lines.size())));
  });
}

void TodaysSessionsPage::printSheets() {
  const DayBoardRow* row = current();
  attempt(shell(), [&] {
    const std::vector<PaperSheet> sheets =
        paperSheets(shell().session(), chosenId(cohort_), row != nullptr ? row->enrolmentId : EnrolmentId(),
                    child<QComboBox>(*callBar_, "callOccasion").currentData().toString().toStdString());
    if (sheets.empty()) {
      shell().notify(tr("No live sheet is missing for what is chosen."));
      return;
    }
    const QString file =
        askFileToSave(this, tr("Print sheets on paper"),
                      tr("Sheets %1.pdf").arg(toQString(board_->cohortName)), tr("PDF (*.pdf)"));
    if (file.isEmpty()) {
      return;
    }
    writePaperSheets(sheets, toQString(board_->cohortName), toPath(file));
    shell().notify(tr("Written: %n sheet(s), a page each", nullptr, static_cast<int>(sheets.size())));
  });
}

void TodaysSessionsPage::typeSheets() {
  if (!board_) {
    return;
  }
  PaperDialog(shell(), chosenId(cohort_), this).exec();
  read();
}

void TodaysSessionsPage::copyReminders() {
  attempt(shell(), [&] { gui::copyReminders(shell(), chosenId(cohort_), locale()); });
}

}  // namespace torsio::gui
