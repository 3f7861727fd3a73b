// SPDX-License-Identifier: GPL-3.0-or-later
// What an administrator decides about records: how long they are kept, a person's own copy, erasure on
// request, a move to another group, another occasion.
#include <filesystem>

#include <QCheckBox>
#include <QComboBox>
#include <QInputDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/maintenance/retention.h"
#include "app/people/consent_service.h"
#include "app/people/people_service.h"
#include "app/study/cohort_service.h"
#include "app/study/occasion_service.h"
#include "assessment/people/consent.h"
#include "assessment/people/retention.h"
#include "assessment/study/allocation_entry.h"
#include "tests/app/gui/administrator_desk.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;

QPushButton& named(QWidget& page, const char* name) {
  auto* found = page.findChild<QPushButton*>(QLatin1String(name));
  EXPECT_NE(found, nullptr) << name;
  return *found;
}

void giveReason(QDialog& dialog) {
  dialog.findChild<QLineEdit*>(QStringLiteral("reason"))->setText(QStringLiteral("asked for it"));
  dialog.accept();
}

TEST(MaintenancePage, SetsAndTakesAwayRulesForKeepingRecords) {
  AdministratorDesk office;
  setRetentionRule(office.centre.as("administrator"), kRetainRater, 30, "contract");
  auto page = office.open<MaintenancePage>("administrator");
  answer([](QDialog& dialog) {
    dialog.findChild<QCheckBox*>(QStringLiteral("trainee"))->setChecked(true);
    dialog.findChild<QSpinBox*>(QStringLiteral("trainee.days"))->setValue(1'825);
    dialog.findChild<QLineEdit*>(QStringLiteral("trainee.basis"))->setText(QStringLiteral("consent"));
    dialog.findChild<QCheckBox*>(QStringLiteral("rater"))->setChecked(false);
    dialog.accept();
  });

  named(*page, "retentionRules").click();

  const std::vector<RetentionRule> rules = retentionRules(office.centre.session());
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules.front().category, kRetainTrainee);
  EXPECT_EQ(rules.front().keep_days, 1'825);
  EXPECT_EQ(rules.front().basis, "consent");
  EXPECT_EQ(office.centre.audited("retention.remove_rule"), 1);
}

TEST(MaintenancePage, KeepsTheRulesFromWhoeverMayNotManageThem) {
  AdministratorDesk office;

  auto page = office.open<MaintenancePage>("statistician");

  EXPECT_FALSE(named(*page, "retentionRules").isEnabled());
}

TEST(RosterPage, WritesEverythingAboutOnePersonIntoANewFolder) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  auto page = office.open<RosterPage>("administrator");
  page->findChild<DataTable*>()->select(toQString(trainees.front()));
  const std::filesystem::path folder = office.centre.folder() / "record-T-01";

  ASSERT_TRUE(named(*page, "exportPerson").isEnabled());
  page->exportPerson(folder, "asked for it");
  office.shell().waitForJobs();

  EXPECT_TRUE(std::filesystem::exists(folder / "manifest.json"));
  EXPECT_EQ(office.centre.audited("person.export"), 1);
}

TEST(RosterPage, ErasesOneRecordOnRequestWithAReason) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  auto page = office.open<RosterPage>("administrator");
  page->findChild<DataTable*>()->select(toQString(trainees.front()));
  answer(giveReason);

  named(*page, "erasePerson").click();

  EXPECT_EQ(office.centre.audited("person.erase"), 1);
  for (const NamedPersonRow& one : namedPeople(office.centre.as("administrator"))) {
    EXPECT_EQ(one.identity.fullName.empty(), one.row.person.id == trainees.front());
  }
}

TEST(RosterPage, EntersWhatWasSignedOnPaperAndShowsEveryDecision) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(1);
  auto page = office.open<RosterPage>("administrator");
  page->findChild<DataTable*>()->select(toQString(trainees.front()));
  int shown = 0;
  answer([&shown](QDialog& dialog) {
    auto* purpose = dialog.findChild<QComboBox*>(QStringLiteral("purpose"));
    purpose->setCurrentIndex(purpose->findText(QStringLiteral("Training record")));
    named(dialog, "granted").click();
    named(dialog, "withdrawn").click();
    shown = dialog.findChild<DataTable*>(QStringLiteral("decisions"))->visibleRows();
    dialog.reject();
  });

  named(*page, "consents").click();

  EXPECT_EQ(shown, 2);
  const std::vector<ConsentDecision> kept =
      consentHistory(office.centre.as("administrator"), trainees.front());
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].purpose, "training_record");
  EXPECT_TRUE(kept[0].granted);
  EXPECT_FALSE(kept[1].granted);
  EXPECT_EQ(office.centre.audited("consent.withdraw"), 1);
}

TEST(RosterPage, OffersNeitherToWhoeverMayNot) {
  AdministratorDesk office;
  office.centre.addTrainees(1);

  auto page = office.open<RosterPage>("statistician");

  EXPECT_TRUE(named(*page, "exportPerson").isHidden());
  EXPECT_TRUE(named(*page, "erasePerson").isHidden());
}

TEST(AllocationPage, MovesATraineeByHandBesideTheDrawnRecord) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  const std::string version = office.centre.runPaperCurriculum();
  SessionContext& session = office.centre.as("administrator");
  const CohortId cohort = addCohort(session, {.name = "Study", .curriculumVersionId = version});
  enrolTrainees(session, cohort, trainees);
  AllocationPlan plan;
  plan.cohortId = cohort;
  const std::string design = lockAllocation(office.centre.as("allocator"), plan).stored.id;
  allocateAll(office.centre.as("allocator"), cohort);
  const AllocationEntry drawn = allocations(office.centre.as("allocator"), design).front();
  auto page = office.open<AllocationPage>("allocator");
  child<DataTable>(*page, "records").select(toQString(drawn.id));
  std::string to;
  answer([&to](QDialog& dialog) {
    to = dialog.findChild<QComboBox*>(QStringLiteral("group"))->currentData().toString().toStdString();
    giveReason(dialog);
  });

  named(*page, "moveByHand").click();

  const std::vector<AllocationEntry> records = allocations(office.centre.as("allocator"), design);
  ASSERT_EQ(records.size(), 4U);  // three drawn, one moved
  EXPECT_EQ(records.back().enrolmentId, drawn.enrolmentId);
  EXPECT_NE(to, drawn.groupId);
  EXPECT_EQ(records.back().groupId, to);
  EXPECT_EQ(records.back().overrideReason, "asked for it");
}

TEST(CurriculaPage, AddsAnOccasionThatTheEditorThenOffers) {
  AdministratorDesk office;
  office.centre.runPaperCurriculum();
  auto page = office.open<CurriculaPage>("administrator");
  answer([](QDialog& dialog) { testing::type(dialog, QStringLiteral("six months later")); });

  named(*page, "addOccasion").click();

  EXPECT_EQ(knownOccasions(office.centre.as("administrator")).size(), 4U);
  bool offered = false;
  for (const QCheckBox* box : page->findChildren<QCheckBox*>()) {
    offered = offered || box->text() == QStringLiteral("six months later");
  }
  EXPECT_TRUE(offered);
}

}  // namespace
}  // namespace torsio::gui
