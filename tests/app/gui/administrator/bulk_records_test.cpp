// SPDX-License-Identifier: GPL-3.0-or-later
// Cohorts, curricula, moves, imports and records of people: several at once, all or none, and back again. One
// code finds them in their lists.
#include <filesystem>
#include <map>

#include <QAbstractButton>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/all_or_none.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/two_people.h"
#include "app/services/people/people_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/scoring_plan.h"
#include "sim/core/error.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/services/people/commit_roster.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;

void clickNamed(QWidget& page, const char* name) {
  auto* found = page.findChild<QPushButton*>(QLatin1String(name));
  ASSERT_NE(found, nullptr) << name;
  ASSERT_TRUE(found->isEnabled()) << name;
  found->click();
}

void giveWords(QDialog& dialog) {
  child<QLineEdit>(dialog, "reason").setText(QStringLiteral("asked for it"));
  dialog.accept();
}

QStringList idsOfPeople(const std::vector<TraineeId>& people, std::size_t count) {
  QStringList ids;
  for (std::size_t i = 0; i < count; ++i) {
    ids << toQString(people[i]);
  }
  return ids;
}

class SeveralCohorts : public ::testing::Test {
 protected:
  void SetUp() override {
    office_.centre.addTrainees(9);
    version_ = office_.centre.runPaperCurriculum();
    std::vector<TraineeId> trainees;
    for (const PersonRow& row : people(office_.centre.as("administrator"))) {
      trainees.push_back(row.person.id);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      cohorts_.push_back(addCohort(office_.centre.as("administrator"),
                                   {.name = "Course " + std::to_string(i + 1),
                                    .groups = {{"G1", "one"}, {"G2", "two"}, {"G3", "three"}}}));
      enrolTrainees(
          office_.centre.session(), cohorts_[i],
          {trainees.begin() + static_cast<long>(3 * i), trainees.begin() + static_cast<long>(3 * i + 3)});
    }
  }
  void allocate(const CohortId& cohort) {
    lockAllocation(office_.centre.as("allocator"), {.cohortId = cohort});
    allocateAll(office_.centre.as("allocator"), cohort);
  }
  CohortRow stored(std::size_t cohort) { return cohorts(office_.centre.as("administrator")).at(cohort); }
  void changeState(CohortsPage& page) {
    answer(giveWords);
    clickNamed(page, "cohortState");
  }

  AdministratorDesk office_;
  CurriculumVersionId version_;
  std::vector<CohortId> cohorts_;
};

TEST_F(SeveralCohorts, AreClosedArchivedAndReopenedTogether) {
  for (const CohortId& cohort : cohorts_) {
    allocate(cohort);
  }
  auto page = office_.open<CohortsPage>("administrator");
  auto& table = child<DataTable>(*page, "cohorts");
  child<QAbstractButton>(*page, "archived").click();
  table.selectAll({toQString(cohorts_[0]), toQString(cohorts_[2])});

  changeState(*page);
  EXPECT_EQ(stored(0).cohort.state, CohortState::kClosed);
  EXPECT_EQ(stored(1).cohort.state, CohortState::kRunning);
  EXPECT_EQ(stored(2).cohort.state, CohortState::kClosed);
  EXPECT_EQ(table.selectedIds().size(), 2) << "the choice stays, so that it can be undone";
  changeState(*page);
  EXPECT_EQ(stored(0).cohort.state, CohortState::kArchived);
  EXPECT_EQ(stored(2).cohort.state, CohortState::kArchived);
  changeState(*page);
  EXPECT_EQ(stored(0).cohort.state, CohortState::kRunning);
  EXPECT_EQ(stored(2).cohort.state, CohortState::kRunning);
  EXPECT_FALSE(child<QPushButton>(*page, "renameCohort").isEnabled()) << "a name is of one";
}

TEST_F(SeveralCohorts, AreAllChangedOrNone) {
  allocate(cohorts_[0]);
  SessionContext& session = office_.centre.as("administrator");

  EXPECT_THROW(allOrNone(session, cohorts_,
                         [&](const CohortId& one) {
                           setCohortState(office_.centre.session(), one, CohortState::kClosed, "over");
                         }),
               Error)
      << "drafts are not closed";

  EXPECT_EQ(stored(0).cohort.state, CohortState::kRunning);
}

TEST_F(SeveralCohorts, FollowACurriculumTogether) {
  auto page = office_.open<CohortsPage>("administrator");
  auto& table = child<DataTable>(*page, "cohorts");
  table.selectAll({toQString(cohorts_[0]), toQString(cohorts_[1])});
  answer([](QDialog& dialog) { dialog.accept(); });
  testing::press(*page, QStringLiteral("Curriculum"));

  EXPECT_EQ(stored(0).cohort.curriculumVersionId, version_);
  EXPECT_EQ(stored(1).cohort.curriculumVersionId, version_);
  EXPECT_TRUE(stored(2).cohort.curriculumVersionId.empty());
}

TEST_F(SeveralCohorts, AreFoundByTheCodeOfATrainee) {
  auto page = office_.open<CohortsPage>("administrator");
  auto& table = child<DataTable>(*page, "cohorts");

  table.filter().setText(QStringLiteral("T-05"));

  ASSERT_EQ(table.visibleRows(), 1);
  table.view().selectRow(0);
  EXPECT_EQ(table.currentId(), toQString(cohorts_[1]));
}

TEST_F(SeveralCohorts, TraineesAreMovedTogetherByHandAndBack) {
  allocate(cohorts_[0]);
  auto page = office_.open<AllocationPage>("allocator", toQString(cohorts_[0]));
  auto& records = child<DataTable>(*page, "records");
  const auto groups = [this] {
    std::map<std::string, int> count;
    for (const Enrolment& one : enrolments(office_.centre.as("allocator"), cohorts_[0])) {
      ++count[one.groupCode];
    }
    return count;
  };
  const auto moveTo = [&](const char* group) {
    answer([=](QDialog& dialog) {
      auto& box = child<QComboBox>(dialog, "group");
      box.setCurrentIndex(box.findText(QLatin1String(group)));
      giveWords(dialog);
    });
    clickNamed(*page, "moveByHand");
  };
  records.view().selectAll();

  moveTo("G2");  // one of the three is already there, and stays

  EXPECT_EQ(groups()["G2"], 3);
  EXPECT_EQ(records.visibleRows(), 5);
  EXPECT_EQ(office_.centre.audited("allocation.override"), 2);
  records.filter().setText(QStringLiteral("T-01"));
  records.view().selectAll();
  moveTo("G1");
  EXPECT_EQ(groups()["G1"], 1);
  EXPECT_TRUE(checkAllocation(office_.centre.as("allocator"),
                              allocationDesigns(office_.centre.as("allocator"), cohorts_[0]).back().stored.id)
                  .sound);
}

TEST(SeveralCurricula, AreStartedClosedAndReopenedTogether) {
  AdministratorDesk office;
  SessionContext& session = office.centre.as("administrator");
  const CurriculumVersion content = curriculumTemplates(office.centre.assets()).front().content;
  QStringList ids;
  for (const char* name : {"Autumn", "Spring", "Winter"}) {
    const CurriculumId id = addCurriculum(session, name, "", content);
    publishCurriculum(session, id, "first", office.centre.assets());
    ids << toQString(id);
  }
  auto page = office.open<CurriculaPage>("administrator");
  auto& table = child<DataTable>(*page, "curricula");
  const auto states = [&office] {
    std::vector<CurriculumState> all;
    for (const CurriculumRow& row : curricula(office.centre.as("administrator"))) {
      all.push_back(row.versions.back().state);
    }
    return all;
  };
  using S = CurriculumState;
  table.selectAll({ids[0], ids[2]});

  testing::press(*page, QStringLiteral("Begin"));
  EXPECT_EQ(states(), (std::vector{S::kRunning, S::kDraft, S::kRunning}));
  answer(giveWords);
  testing::press(*page, QStringLiteral("Close"));
  EXPECT_EQ(states(), (std::vector{S::kClosed, S::kDraft, S::kClosed}));
  answer(giveWords);
  testing::press(*page, QStringLiteral("Run again"));

  EXPECT_EQ(states(), (std::vector{S::kRunning, S::kDraft, S::kRunning}));
  EXPECT_EQ(office.centre.audited("curriculum.running"), 4);
}

TEST(SeveralPeople, GetAFolderEachWithTheirOwnRecord) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  auto page = office.open<RosterPage>("administrator");
  child<DataTable>(*page, "table").selectAll(idsOfPeople(trainees, 2));
  const std::filesystem::path folder = office.centre.folder() / "records";

  page->exportRecords(folder, "asked for it");
  office.shell().waitForJobs();

  EXPECT_TRUE(std::filesystem::exists(folder / "record-T-01" / "manifest.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "record-T-02" / "manifest.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "record-T-03"));
  EXPECT_EQ(office.centre.audited("person.export"), 2);
}

TEST(SeveralPeople, AreErasedOnRequestTogether) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  auto page = office.open<RosterPage>("administrator");
  auto& table = child<DataTable>(*page, "table");
  table.selectAll(idsOfPeople(trainees, 2));
  answer(giveWords);

  clickNamed(*page, "erasePerson");

  EXPECT_EQ(office.centre.audited("person.erase"), 2);
  for (const NamedPersonRow& one : namedPeople(office.centre.as("administrator"))) {
    EXPECT_EQ(one.identity.fullName.empty(), one.row.person.id != trainees[2]);
  }
}

TEST(SeveralPeople, AreRequestedOnceIfErasingNeedsTwoPeople) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  setCentreSetting<kTwoPeople>(office.centre.as("administrator"), true);
  auto page = office.open<RosterPage>("administrator");
  child<DataTable>(*page, "table").view().selectAll();
  answer([](QDialog& dialog) {
    answer([](QDialog& asked) {
      EXPECT_EQ(asked.objectName(), QStringLiteral("askSecondPerson"));
      asked.accept();
    });
    giveWords(dialog);
  });

  clickNamed(*page, "erasePerson");

  EXPECT_EQ(office.centre.audited("person.erase"), 0);
  EXPECT_EQ(openRequests(office.centre.as("administrator")).size(), 2U);
}

TEST(SeveralRaters, AreAskedByPressingEnterInTheirList) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  office.centre.addChiefs(3);
  office.centre.addPaperRubric();
  const CohortId cohort =
      addCohort(office.centre.as("administrator"),
                {.name = "Study", .curriculumVersionId = office.centre.runPaperCurriculum()});
  enrolTrainees(office.centre.session(), cohort, trainees);
  auto page = office.open<ScoringPage>("administrator");
  answer([](QDialog& dialog) {
    auto* table = dialog.findChild<DataTable*>();
    table->view().selectAll();
    QTest::keyClick(&table->view(), Qt::Key_Return);
    EXPECT_FALSE(dialog.isVisible()) << "Enter answered it";
    if (dialog.isVisible()) {
      dialog.reject();  // or the test would wait forever
    }
  });

  testing::press(*page, QStringLiteral("Invite raters"));

  EXPECT_EQ(scoringMatrix(office.centre.as("administrator"), cohort).raters.size(), 3U);
}

TEST(SeveralImports, AreUndoneTogetherAndFoundByTheCodeOfAPerson) {
  AdministratorDesk office;
  commitRoster(office.centre.as("administrator"), "Staff ID,Name\nS-1,A\nS-2,B\nS-3,C\nS-4,D\nS-5,E\n");
  commitRoster(office.centre.as("administrator"), "Staff ID,Name\nS-6,F\n");
  auto page = office.open<RosterPage>("administrator");
  answer([](QDialog& dialog) {
    auto& imports = child<DataTable>(dialog, "imports");
    imports.filter().setText(QStringLiteral("T-05"));
    EXPECT_EQ(imports.visibleRows(), 1) << "the fifth of a list that names three";
    imports.filter().clear();
    imports.view().selectAll();
    answer(giveWords);
    clickNamed(dialog, "takeBack");
    dialog.reject();
  });

  clickNamed(*page, "undoImport");

  EXPECT_TRUE(people(office.centre.as("administrator")).empty());
}

}  // namespace
}  // namespace torsio::gui
