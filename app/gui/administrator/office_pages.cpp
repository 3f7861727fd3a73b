// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/office_pages.h"

#include <QCoreApplication>

#include "app/gui/administrator/allocation_page.h"
#include "app/gui/administrator/audit_page.h"
#include "app/gui/administrator/campaigns_page.h"
#include "app/gui/administrator/care_page.h"
#include "app/gui/administrator/cohorts_page.h"
#include "app/gui/administrator/curricula_page.h"
#include "app/gui/administrator/curriculum_editor.h"
#include "app/gui/administrator/devices_page.h"
#include "app/gui/administrator/move_page.h"
#include "app/gui/administrator/reports_page.h"
#include "app/gui/administrator/restore_page.h"
#include "app/gui/administrator/results_page.h"
#include "app/gui/administrator/roster_page.h"
#include "app/gui/administrator/run_day_page.h"
#include "app/gui/administrator/scoring_page.h"
#include "app/gui/administrator/users_page.h"
#include "app/gui/widgets/data_table.h"

namespace torsio::gui {

namespace {

template <typename Made>
PageEntry entry(const char* id, const char* icon, const char* title, std::vector<Operation> needs) {
  return {QString::fromLatin1(id), QString::fromLatin1(icon),
          [title] { return QCoreApplication::translate("OfficePages", title); }, std::move(needs),
          [](ShellContext& shell) -> Page* { return new Made(shell); }};
}

ScreenEntry screen(const char* name, const char* page, std::function<void(Page&)> prepare = {}) {
  return {QString::fromLatin1(name),
          QStringLiteral("administrator"),
          QString::fromLatin1(page),
          {},
          std::move(prepare)};
}

}  // namespace

std::vector<PageEntry> officePages() {
  using enum Operation;
  return {
      entry<RunDayPage>("office.runday", "board", QT_TRANSLATE_NOOP("OfficePages", "Run day"), {kStudySetup}),
      entry<RosterPage>("office.roster", "people", QT_TRANSLATE_NOOP("OfficePages", "Roster"),
                        {kPersonViewCoded}),
      entry<CurriculaPage>("office.curricula", "curriculum", QT_TRANSLATE_NOOP("OfficePages", "Curricula"),
                           {kCurriculumEdit}),
      entry<CohortsPage>("office.cohorts", "cohort", QT_TRANSLATE_NOOP("OfficePages", "Cohorts"),
                         {kPersonViewCoded}),
      entry<AllocationPage>("office.allocation", "allocation", QT_TRANSLATE_NOOP("OfficePages", "Allocation"),
                            {kAllocationView}),
      entry<ScoringPage>("office.scoring", "matrix", QT_TRANSLATE_NOOP("OfficePages", "Scoring"),
                         {kStudySetup}),
      entry<CampaignsPage>("office.campaigns", "campaign", QT_TRANSLATE_NOOP("OfficePages", "Evaluation"),
                           {kEvaluationSetup}),
      entry<ResultsPage>("office.results", "chart", QT_TRANSLATE_NOOP("OfficePages", "Results"),
                         {kResultsCompute}),
      entry<ReportsPage>("office.reports", "report", QT_TRANSLATE_NOOP("OfficePages", "Reports"),
                         {kResultsCompute}),
      entry<UsersPage>("office.users", "user", QT_TRANSLATE_NOOP("OfficePages", "Users"), {kUserManage}),
      entry<AuditPage>("office.audit", "audit", QT_TRANSLATE_NOOP("OfficePages", "Audit trail"),
                       {kAuditView}),
      entry<CarePage>("office.care", "care", QT_TRANSLATE_NOOP("OfficePages", "Care"), {kDatabaseBackup}),
      entry<RestorePage>("office.restore", "", QT_TRANSLATE_NOOP("OfficePages", "Restore"),
                         {kDatabaseRestore}),
      entry<MovePage>("office.move", "", QT_TRANSLATE_NOOP("OfficePages", "Move"), {kDatabaseRestore}),
      entry<DevicesPage>("office.devices", "device", QT_TRANSLATE_NOOP("OfficePages", "Devices"),
                         {kSettingsEdit}),
  };
}

std::vector<ScreenEntry> officeScreens() {
  const auto shows = [](const char* id) {
    return [id](Page& page) {
      auto& results = dynamic_cast<ResultsPage&>(page);
      results.settle();
      results.showItem(QString::fromLatin1(id));
    };
  };
  const auto fromTemplate = [](Page& page) {
    auto& curricula = dynamic_cast<CurriculaPage&>(page);
    if (curricula.curricula().visibleRows() == 0) curricula.add("Twist skills 2026", "paper-three-arms");
    curricula.editor().setCurrentIndex(curricula.editor().content().arms.empty() ? 0 : 1);
  };
  const auto report = [](Page& page) { dynamic_cast<ReportsPage&>(page).settle(); };
  return {
      screen("office-run-day", "office.runday"),
      screen("office-roster", "office.roster"),
      screen("office-curricula", "office.curricula", fromTemplate),
      screen("office-cohorts", "office.cohorts"),
      screen("office-allocation", "office.allocation"),
      screen("office-scoring", "office.scoring"),
      screen("office-evaluation", "office.campaigns"),
      screen("office-results-scores", "office.results", shows("figure-22")),
      screen("office-results-differences", "office.results", shows("figure-differences")),
      screen("office-results-boxes", "office.results", shows("figure-19")),
      screen("office-results-severity", "office.results", shows("figure-severity")),
      screen("office-reports", "office.reports", report),
      screen("office-users", "office.users"),
      screen("office-audit", "office.audit"),
      screen("office-care", "office.care"),
      screen("office-restore", "office.restore"),
      screen("office-move", "office.move",
             [](Page& page) {
               dynamic_cast<MovePage&>(page).setAddress(
                   {.host = "server.hospital.example", .database = "torsio", .user = "torsio"});
             }),
      screen("office-devices", "office.devices"),
  };
}

}  // namespace torsio::gui
