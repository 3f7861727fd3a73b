// SPDX-License-Identifier: GPL-3.0-or-later
// Administrators' pages on the first day, with an empty record, which the demonstration never shows.
#include <QStringList>
#include <gtest/gtest.h>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/reporting/reports_page.h"
#include "app/gui/administrator/reporting/results_page.h"
#include "app/gui/administrator/scoring/campaigns_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/station/audit_page.h"
#include "app/gui/administrator/station/devices_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/language.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/gui/support/visible_texts.h"

namespace torsio::gui {
namespace {

constexpr QSize kPageInASmallWindow(1176, 696);  // 1366 x 768 without navigation and header

template <typename Made>
void lookAtPage(testing::AdministratorDesk& office, QStringList& clipped) {
  const auto page = office.open<Made>("administrator");
  page->resize(kPageInASmallWindow);
  page->show();
  QApplication::processEvents();
  for (const QString& text : testing::clippedTexts(*page)) {
    clipped << QStringLiteral("%1: %2").arg(QLatin1String(page->metaObject()->className()), text);
  }
}

TEST(EmptyCentre, AdministratorsPagesAreFullyReadableInBothLanguages) {
  testing::AdministratorDesk office;
  LanguageSwitch language;
  for (const Language chosen : {Language::kEnglish, Language::kSimplifiedChinese}) {
    language.choose(chosen);
    QStringList clipped;
    lookAtPage<TodaysSessionsPage>(office, clipped);
    lookAtPage<RosterPage>(office, clipped);
    lookAtPage<CurriculaPage>(office, clipped);
    lookAtPage<CohortsPage>(office, clipped);
    lookAtPage<AllocationPage>(office, clipped);
    lookAtPage<ScoringPage>(office, clipped);
    lookAtPage<CampaignsPage>(office, clipped);
    lookAtPage<ResultsPage>(office, clipped);
    lookAtPage<ReportsPage>(office, clipped);
    lookAtPage<UsersPage>(office, clipped);
    lookAtPage<AuditPage>(office, clipped);
    lookAtPage<DevicesPage>(office, clipped);
    lookAtPage<MaintenancePage>(office, clipped);
    EXPECT_TRUE(clipped.isEmpty()) << clipped.join(QLatin1Char('\n')).toStdString();
  }
  language.choose(Language::kEnglish);
}

}  // namespace
}  // namespace torsio::gui
