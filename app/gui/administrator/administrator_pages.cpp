// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/administrator_pages.h"

#include <QCoreApplication>
#include <QDialog>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/connectors/built_in.h"
#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/curriculum/curriculum_editor.h"
#include "app/gui/administrator/people/review_desk_dialog.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/reporting/export_dialog.h"
#include "app/gui/administrator/reporting/reports_page.h"
#include "app/gui/administrator/reporting/results_page.h"
#include "app/gui/administrator/scoring/campaigns_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/station/audit_page.h"
#include "app/gui/administrator/station/devices_page.h"
#include "app/gui/administrator/station/heads_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/station/move_page.h"
#include "app/gui/administrator/station/restore_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/placed_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"

namespace torsio::gui {

namespace {

template <typename Made>
PageEntry entry(PageId id) {
  return {id, [](ShellContext& shell) -> Page* { return new Made(shell); }};
}

ScreenEntry screen(const char* name, PageId page, std::function<void(Page&)> prepare = {}) {
  return {QString::fromLatin1(name), QStringLiteral("administrator"), page, {}, std::move(prepare)};
}

}  // namespace

std::vector<PageEntry> administratorPages() {
  return {entry<TodaysSessionsPage>(PageId::kTodaysSessions),
          entry<RosterPage>(PageId::kRoster),
          entry<CurriculaPage>(PageId::kCurricula),
          entry<CohortsPage>(PageId::kCohorts),
          entry<AllocationPage>(PageId::kAllocation),
          entry<ScoringPage>(PageId::kScoring),
          entry<CampaignsPage>(PageId::kCampaigns),
          entry<ResultsPage>(PageId::kResults),
          entry<ReportsPage>(PageId::kReports),
          entry<UsersPage>(PageId::kUsers),
          entry<AuditPage>(PageId::kAudit),
          entry<HeadsPage>(PageId::kHeads),
          entry<MaintenancePage>(PageId::kMaintenance),
          entry<RestorePage>(PageId::kRestore),
          entry<MovePage>(PageId::kMove),
          entry<DevicesPage>(PageId::kDevices)};
}

std::vector<ScreenEntry> administratorScreens() {
  const auto shows = [](const char* id) {
    return [id](Page& page) {
      auto& results = dynamic_cast<ResultsPage&>(page);
      results.settle();
      results.showItem(QString::fromLatin1(id));
    };
  };
  const auto fromTemplate = [](Page& page) {
    auto& curricula = dynamic_cast<CurriculaPage&>(page);
    if (child<DataTable>(curricula, "curricula").visibleRows() == 0) {
      curricula.add("Twist skills 2026", "paper-three-arms");
    }
    child<CurriculumEditor>(curricula, "editor")
        .setCurrentIndex(child<CurriculumEditor>(curricula, "editor").content().arms.empty() ? 0 : 1);
  };
  const auto report = [](Page& page) { dynamic_cast<ReportsPage&>(page).settle(); };
  return {
      screen("administrator-todays-sessions", PageId::kTodaysSessions),
      screen("administrator-roster", PageId::kRoster),
      screen("administrator-curricula", PageId::kCurricula, fromTemplate),
      screen("administrator-cohorts", PageId::kCohorts),
      screen("administrator-allocation", PageId::kAllocation),
      screen("administrator-scoring", PageId::kScoring),
      screen("administrator-evaluation", PageId::kCampaigns),
      screen("administrator-results-scores", PageId::kResults, shows("figure-22")),
      screen("administrator-results-differences", PageId::kResults, shows("figure-differences")),
      screen("administrator-results-boxes", PageId::kResults, shows("figure-19")),
      screen("administrator-results-severity", PageId::kResults, shows("figure-severity")),
      screen("administrator-results-residuals", PageId::kResults, shows("figure-qq")),
      screen("administrator-reports", PageId::kReports, report),
      screen("administrator-users", PageId::kUsers),
      screen("administrator-audit", PageId::kAudit),
      screen("administrator-maintenance", PageId::kMaintenance),
      screen("administrator-heads", PageId::kHeads),
      screen("administrator-restore", PageId::kRestore),
      screen("administrator-move", PageId::kMove,
             [](Page& page) {
               dynamic_cast<MovePage&>(page).setAddress(
                   {.host = "server.hospital.example", .database = "torsio", .user = "torsio"});
             }),
      screen("administrator-devices", PageId::kDevices),
  };
}

std::vector<ScreenEntry> administratorDialogs() {
  const auto exported = [](ExportDialog::Form form, bool written) {
    return [form, written](Page& page) {
      auto& reports = dynamic_cast<ReportsPage&>(page);
      reports.settle();
      ExportDialog& dialog = reports.placeExport();
      dialog.choose(form);
      if (written) {
        const QTemporaryDir folder;
        dialog.writeTo(toPath(folder.filePath(QStringLiteral("tables"))));
        reports.settle();
      }
      dialog.resize(dialog.sizeHint());
    };
  };
  const auto otherPrograms = [](Page& page) {
    child<QPushButton>(page, "otherPrograms").click();
    placeDialog(child<QDialog>(page, "instrumentOutlet"));
  };
  const auto browsers = [](Page& page) {
    dynamic_cast<UsersPage&>(page).placeReviewDesk(ReviewDeskDialog::ownPlace());
  };
  std::vector<ScreenEntry> dialogs{
      screen("administrator-browsers", PageId::kUsers, browsers),
      screen("administrator-export", PageId::kReports, exported(ExportDialog::Form::kWorkbook, false)),
      screen("administrator-export-dataset", PageId::kReports,
             exported(ExportDialog::Form::kFrictionless, false)),
      screen("administrator-export-written", PageId::kReports, exported(ExportDialog::Form::kR, true)),
  };
  if constexpr (kTrackerBuiltIn) {
    dialogs.push_back(screen("administrator-devices-others", PageId::kDevices, otherPrograms));
  }
  return dialogs;
}

}  // namespace torsio::gui
