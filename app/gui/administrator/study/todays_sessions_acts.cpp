// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of TodaysSessionsPage on the selected trainees.
#include <cstdint>
#include <map>

#include <QComboBox>
#include <QLineEdit>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/reminder_text.h"
#include "app/gui/administrator/study/call_bar.h"
#include "app/gui/administrator/study/day_plan_dialog.h"
#include "app/gui/administrator/study/paper_dialog.h"
#include "app/gui/administrator/study/todays_sessions_dialogs.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/services/access/all_or_none.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/paper_sheets.h"

namespace torsio::gui {

std::vector<const DayBoardRow*> TodaysSessionsPage::chosen() const {
  if (!board_) {
    return {};
  }
  return chosenRows(*table_, board_->rows, [](const DayBoardRow& row) { return row.enrolmentId; });
}

void TodaysSessionsPage::planDay() {
  if (!board_) {
    return;
  }
  std::vector<std::pair<EnrolmentId, QString>> everybody;
  std::vector<std::pair<EnrolmentId, QString>> some;
  const QStringList ids = table_->selectedIds();
  for (const DayBoardRow& row : board_->rows) {
    if (row.state == EnrolmentState::kWithdrawn) {
      continue;
    }
    everybody.emplace_back(row.enrolmentId, toQString(row.traineeCode));
    if (ids.contains(toQString(row.enrolmentId))) {
      some.push_back(everybody.back());
    }
  }
  // A station without any training looks like a rater's desk: it is only offered, as are places of earlier
  // plans.
  QStringList places;
  QStringList others;
  for (const StationState& station : board_->stations) {
    (isTrainingStation(station) ? places : others) << toQString(station.station);
  }
  attempt(shell(), [&] {
    for (const DaySlot& slot : daySlots(shell().session(), chosenId(cohort_), 0, INT64_MAX)) {
      others << toQString(slot.place);
    }
    others.removeDuplicates();
    others.removeIf([&places](const QString& place) { return places.contains(place); });
    DayPlanDialog(shell(), chosenId(cohort_), some.size() > 1 ? some : everybody, places, others, this)
        .exec();
  });
  read();
}

void TodaysSessionsPage::swap() {
  const DayBoardRow* row = current();
  if (row == nullptr) {
    return;
  }
  std::vector<std::pair<std::string, QString>> others;
  for (const DayBoardRow& other : board_->rows) {
    if (other.enrolmentId != row->enrolmentId && other.state != EnrolmentState::kWithdrawn) {
      others.emplace_back(other.enrolmentId, toQString(other.traineeCode));
    }
  }
  const std::string id = row->enrolmentId;
  const std::optional<Swap> wanted = askSwap(this, toQString(row->traineeCode), others);
  if (!wanted) {
    return;
  }
  attempt(shell(), [&] {
    swapTurns(shell().session(), chosenId(cohort_), id, wanted->enrolmentId, wanted->reason);
    read();
    shell().notify(tr("Swapped; both deviations are noted."));
  });
}

void TodaysSessionsPage::logTime() {
  // People who trained together are selected together; withdrawn ones are skipped.
  std::vector<EnrolmentId> ids;
  QStringList codes;
  std::map<ExposureKind, QStringList> unplanned;
  for (const DayBoardRow* row : chosen()) {
    if (row->state != EnrolmentState::kWithdrawn) {
      ids.push_back(row->enrolmentId);
      codes << toQString(row->traineeCode);
      for (const ExposureKind kind : row->unplanned) {
        unplanned[kind] << codes.back();
      }
    }
  }
  if (ids.empty()) {
    return;
  }
  std::optional<NewExposure> exposure = askExposure(this, firstFew(codes), unplanned);
  if (!exposure) {
    return;
  }
  attempt(shell(), [&] {
    exposure->cohortId = chosenId(cohort_);
    allOrNone(shell().session(), ids, [&](const EnrolmentId& id) {
      exposure->enrolmentId = id;
      exposure->startedUtc_us = shell().session().now_us() - exposure->duration_us;
      recordExposure(shell().session(), *exposure);
    });
    read();
  });
}

void TodaysSessionsPage::reportDeviation() {
  std::vector<EnrolmentId> ids;
  QStringList codes;
  for (const DayBoardRow* row : chosen()) {
    ids.push_back(row->enrolmentId);
    codes << toQString(row->traineeCode);
  }
  const std::optional<NewDeviation> deviation =
      askDeviation(this, codes.isEmpty() ? tr("the whole cohort") : firstFew(codes));
  if (!deviation) {
    return;
  }
  if (ids.empty()) {
    ids.emplace_back();
  }
  attempt(shell(), [&] {
    std::vector<NewDeviation> noted;
    for (const EnrolmentId& id : ids) {
      noted.push_back(*deviation);
      noted.back().cohortId = chosenId(cohort_);
      noted.back().enrolmentId = id;
    }
    reportDeviations(shell().session(), noted);
    read();
  });
}

void TodaysSessionsPage::changeState() {
  const DayBoardRow* row = current();
  if (row == nullptr) {
    return;
  }
  // All selected trainees with the same state as the current one.
  const bool back = row->state == EnrolmentState::kWithdrawn;
  std::vector<EnrolmentId> ids;
  QStringList codes;
  for (const DayBoardRow* one : chosen()) {
    if ((one->state == EnrolmentState::kWithdrawn) == back) {
      ids.push_back(one->enrolmentId);
      codes << toQString(one->traineeCode);
    }
  }
  const std::optional<std::string> reason =
      back ? askReason(this, tr("Return to the study"), tr("%1 takes part again.").arg(firstFew(codes)))
           : askReason(this, tr("Withdraw from the study"),
                       tr("%1 stops training; existing records are kept.").arg(firstFew(codes)));
  if (!reason) {
    return;
  }
  attempt(shell(), [&] {
    allOrNone(shell().session(), ids, [&](const EnrolmentId& id) {
      setEnrolmentState(shell().session(), chosenId(cohort_), id,
                        back ? EnrolmentState::kEnrolled : EnrolmentState::kWithdrawn, *reason);
    });
    read();
  });
}

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
      shell().notify(tr("No live sheet is missing in this selection."));
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
