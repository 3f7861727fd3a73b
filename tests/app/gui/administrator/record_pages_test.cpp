// SPDX-License-Identifier: GPL-3.0-or-later
// Administrators' decisions about records: retention, a person's own copy, erasure on request, a move to
// another group, another occasion. Cohorts, curricula, moves, imports and records of people: several at
// once, all or none, and back again. One code finds them in their lists.

#include <algorithm>
#include <filesystem>
#include <map>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QHostAddress>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTcpServer>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/people/review_desk_dialog.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/access_service.h"
#include "app/services/access/all_or_none.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/two_people.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/serving/review_desk.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/retention.h"
#include "assessment/domain/study/allocation.h"
#include "db/connection/connection.h"
#include "sim/core/error.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/services/people/commit_roster.h"

namespace torsio::gui {

namespace {

using testing::AdministratorDesk;
using testing::answer;
using testing::giveReason;

TEST(MaintenancePage, SetsAndRemovesRetentionRules) {
  AdministratorDesk office;
  setRetentionRule(office.centre.as("administrator"), kRetainRater, 30, "contract");
  auto page = office.open<MaintenancePage>("administrator");
  answer([](QDialog& dialog) {
    child<QCheckBox>(dialog, "trainee").setChecked(true);
    child<QSpinBox>(dialog, "trainee.days").setValue(1'825);
    child<QLineEdit>(dialog, "trainee.basis").setText(QStringLiteral("consent"));
    child<QCheckBox>(dialog, "rater").setChecked(false);
    dialog.accept();
  });

  child<QPushButton>(*page, "retentionRules").click();

  const std::vector<RetentionRule> rules = retentionRules(office.centre.session());
  ASSERT_EQ(rules.size(), 1U);
  EXPECT_EQ(rules.front().category, kRetainTrainee);
  EXPECT_EQ(rules.front().keep_days, 1'825);
  EXPECT_EQ(rules.front().basis, "consent");
  EXPECT_EQ(office.centre.audited("retention.remove_rule"), 1);
}

TEST(MaintenancePage, HidesTheRulesFromUsersWhoMayNotManageThem) {
  AdministratorDesk office;

  auto page = office.open<MaintenancePage>("statistician");

  EXPECT_FALSE(child<QPushButton>(*page, "retentionRules").isEnabled());
}

TEST(RosterPage, WritesAllDataOfAPersonIntoANewFolder) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  auto page = office.open<RosterPage>("administrator");
  page->findChild<DataTable*>()->select(toQString(trainees.front()));
  const std::filesystem::path folder = office.centre.folder() / "record-T-01";

  ASSERT_TRUE(child<QPushButton>(*page, "exportPerson").isEnabled());
  page->exportRecords(folder, "asked for it");
  office.shell().waitForJobs();

  EXPECT_TRUE(std::filesystem::exists(folder / "manifest.json"));
  EXPECT_EQ(office.centre.audited("person.export"), 1);
}

TEST(RosterPage, ErasesARecordOnRequestWithAReason) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  auto page = office.open<RosterPage>("administrator");
  page->findChild<DataTable*>()->select(toQString(trainees.front()));
  answer(giveReason);

  child<QPushButton>(*page, "erasePerson").click();

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
    child<QPushButton>(dialog, "granted").click();
    child<QPushButton>(dialog, "withdrawn").click();
    shown = child<DataTable>(dialog, "decisions").visibleRows();
    dialog.reject();
  });

  child<QPushButton>(*page, "consents").click();

  EXPECT_EQ(shown, 2);
  const std::vector<ConsentDecision> kept =
      consentHistory(office.centre.as("administrator"), trainees.front());
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].purpose, "training_record");
  EXPECT_TRUE(kept[0].granted);
  EXPECT_FALSE(kept[1].granted);
  EXPECT_EQ(office.centre.audited("consent.withdraw"), 1);
}

TEST(RosterPage, ShowsTraineesRequestsAndGoesToThem) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  SessionContext& trainee = office.centre.as("trainee");
  Actor actor = trainee.actor();
  actor.personId = trainees[1];
  trainee.setActor(actor);
  requestAboutOwnRecord(trainee, PersonRequestKind::kExport);
  auto page = office.open<RosterPage>("administrator");
  EXPECT_TRUE(child<QPushButton>(*page, "personRequests").text().contains(QStringLiteral("(1)")));
  answer([](QDialog& dialog) {
    auto* table = dialog.findChild<DataTable*>();
    EXPECT_EQ(table->visibleRows(), 1);
    table->view().selectRow(0);
    testing::press(dialog, QStringLiteral("Go to the person"));
  });
  child<QPushButton>(*page, "personRequests").click();
  EXPECT_EQ(page->findChild<DataTable*>()->currentId(), toQString(trainees[1]));

  answer([](QDialog& dialog) {
    dialog.findChild<DataTable*>()->view().selectRow(0);
    answer(giveReason);
    child<QPushButton>(dialog, "requestDone").click();
    EXPECT_FALSE(child<QPushButton>(dialog, "requestDone").isEnabled());
    dialog.reject();
  });
  child<QPushButton>(*page, "personRequests").click();
  EXPECT_FALSE(child<QPushButton>(*page, "personRequests").text().contains(QStringLiteral("(1)")));
  EXPECT_EQ(office.centre.audited("person.request_answer"), 1);
}

TEST(RosterPage, MarksAllSelectedPeopleAsGoneAndUndoesIt) {
  AdministratorDesk office;
  office.centre.addTrainees(5);
  auto page = office.open<RosterPage>("administrator");
  auto& table = *page->findChild<DataTable*>();
  const auto gone = [&] {
    const std::vector<PersonRow> all = people(office.centre.as("administrator"));
    return std::count_if(all.begin(), all.end(),
                         [](const PersonRow& row) { return row.person.state == PersonState::kLeft; });
  };

  table.view().selectAll();
  answer([](QDialog& dialog) {
    EXPECT_TRUE(dialog.findChild<QLabel*>()->text().contains(QStringLiteral("T-01, T-02, T-03 and 2 more")));
    giveReason(dialog);
  });
  testing::press(*page, QStringLiteral("Has left"));
  EXPECT_EQ(gone(), 5);

  table.view().selectAll();
  answer(giveReason);
  testing::press(*page, QStringLiteral("Came back"));
  EXPECT_EQ(gone(), 0);
}

TEST(UsersPage, MakesKioskCardsAndRevokesThem) {
  AdministratorDesk office;
  setCentreSetting<kKioskCodes>(office.centre.as("administrator"), true);
  auto page = office.open<UsersPage>("administrator");
  const std::filesystem::path file = office.centre.folder() / "cards.pdf";
  answer([&file](QDialog& dialog) {
    auto& cards = dynamic_cast<KioskCardsDialog&>(dialog);
    EXPECT_EQ(dialog.findChild<DataTable*>()->visibleRows(), 1) << "the one who only trains";
    cards.saveCards(file);
    cards.reject();
  });
  child<QPushButton>(*page, "makeKioskCards").click();
  EXPECT_TRUE(std::filesystem::exists(file));
  const std::map<UserId, std::int64_t> made = kioskCodesInForce(office.centre.as("administrator"));
  ASSERT_EQ(made.size(), 1U);

  page->findChild<DataTable*>()->select(toQString(made.begin()->first));
  answer(giveReason);
  child<QPushButton>(*page, "revokeKioskCards").click();
  EXPECT_TRUE(kioskCodesInForce(office.centre.as("administrator")).empty());
}

TEST(UsersPage, SaysHowManyCardsAndLinksAnUpgradeMadeUseless) {
  AdministratorDesk office;
  auto page = office.open<UsersPage>("administrator");
  EXPECT_TRUE(child<QLabel>(*page, "outdatedAccess").isHidden());
  office.centre.connection().execute(
      "INSERT INTO invitation (id, user_id, token_hash, made_utc_us, expires_utc_us, state)"
      " VALUES ('old', ?, 'a proof', 1, ?, 'open')",
      {users(office.centre.as("administrator")).front().id, office.centre.session().now_us() + 1});

  page->enter({});

  EXPECT_FALSE(child<QLabel>(*page, "outdatedAccess").isHidden());
  EXPECT_TRUE(child<QLabel>(*page, "outdatedAccess").text().contains(QStringLiteral("1 invitation")));
}

TEST(UsersPage, InvitesByALinkShownOnceAndRevokesIt) {
  AdministratorDesk office;
  auto page = office.open<UsersPage>("administrator");
  UserId rater;
  for (const UserAccount& user : users(office.centre.as("administrator"))) {
    rater = user.login == "rater" ? user.id : rater;
  }
  const std::filesystem::path file = office.centre.folder() / "invitations.pdf";
  QString copied;
  page->findChild<DataTable*>()->select(toQString(rater));
  answer([&](QDialog& dialog) {
    child<QLineEdit>(dialog, "browserAddress").setText(QStringLiteral("https://desk.example.org/"));
    answer([&](QDialog& shown) {
      auto& links = dynamic_cast<InvitationsDialog&>(shown);
      links.copy();
      copied = QApplication::clipboard()->text();
      links.saveCards(file);
      links.reject();
    });
    dialog.accept();
  });
  child<QPushButton>(*page, "inviteUsers").click();

  EXPECT_TRUE(copied.contains(QStringLiteral("https://desk.example.org/join#"))) << copied.toStdString();
  EXPECT_TRUE(copied.contains(QStringLiteral("Your sign-in name is rater")));
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(invitationsInForce(office.centre.as("administrator")).count(rater), 1U);
  page->findChild<DataTable*>()->select(toQString(rater));
  answer(giveReason);
  child<QPushButton>(*page, "revokeInvitations").click();
  EXPECT_TRUE(invitationsInForce(office.centre.as("administrator")).empty());
}

TEST(UsersPage, OpensTheReviewDeskForBrowsersAndClosesIt) {
  AdministratorDesk office;
  auto page = office.open<UsersPage>("administrator");
  ReviewDeskDialog& dialog = page->placeReviewDesk({TORSIO_PROGRAM, office.centre.folder() / "review-desk"});
  const auto text = [&dialog](const char* name) {
    return dialog.findChild<QLabel*>(QLatin1String(name))->text().toStdString();
  };
  QTcpServer other;
  ASSERT_TRUE(other.listen(QHostAddress::LocalHost, 0));
  child<QSpinBox>(dialog, "deskPort").setValue(other.serverPort());
  child<QPushButton>(dialog, "deskAct").click();
  office.shell().waitForJobs();
  EXPECT_NE(text("deskSaid").find("nother program uses this port"), std::string::npos) << text("deskSaid");
  other.close();

  child<QPushButton>(dialog, "deskAct").click();
  office.shell().waitForJobs();

  EXPECT_EQ(text("deskState"), "The review desk is open, and closes with this window.") << text("deskSaid");
  const QString address = child<QComboBox>(dialog, "deskAddress").currentText();
  EXPECT_TRUE(address.startsWith(QStringLiteral("https://"))) << address.toStdString();
  EXPECT_NE(text("deskTrust").find("SHA-256"), std::string::npos);
  child<QPushButton>(dialog, "deskAct").click();
  office.shell().waitForJobs();
  EXPECT_EQ(text("deskState"), "The review desk is closed.");
  EXPECT_FALSE(openReviewDesk(office.centre.as("administrator"),
                              {TORSIO_PROGRAM, office.centre.folder() / "review-desk"}));
}

TEST(RosterPage, OffersNeitherWithoutTheRight) {
  AdministratorDesk office;
  office.centre.addTrainees(1);

  auto page = office.open<RosterPage>("statistician");

  EXPECT_TRUE(child<QPushButton>(*page, "exportPerson").isHidden());
  EXPECT_TRUE(child<QPushButton>(*page, "erasePerson").isHidden());
}

TEST(AllocationPage, MovesATraineeByHandInAdditionToTheDraw) {
  AdministratorDesk office;
  const CohortId cohort = office.centre.addStudy(3).cohortId;
  const std::string design = lockAllocation(office.centre.as("allocator"), {.cohortId = cohort}).stored.id;
  allocateAll(office.centre.as("allocator"), cohort);
  const AllocationEntry drawn = allocations(office.centre.as("allocator"), design).front();
  auto page = office.open<AllocationPage>("allocator");
  child<DataTable>(*page, "records").select(toQString(drawn.id));
  std::string to;
  answer([&to](QDialog& dialog) {
    to = child<QComboBox>(dialog, "group").currentData().toString().toStdString();
    giveReason(dialog);
  });

  child<QPushButton>(*page, "moveByHand").click();

  const std::vector<AllocationEntry> records = allocations(office.centre.as("allocator"), design);
  ASSERT_EQ(records.size(), 4U);  // three drawn, one moved
  EXPECT_EQ(records.back().enrolmentId, drawn.enrolmentId);
  EXPECT_NE(to, drawn.groupId);
  EXPECT_EQ(records.back().groupId, to);
  EXPECT_EQ(records.back().overrideReason, "asked for it");
}

TEST(CurriculaPage, AddsAnOccasionWhichTheEditorThenOffers) {
  AdministratorDesk office;
  office.centre.runPaperCurriculum();
  auto page = office.open<CurriculaPage>("administrator");
  answer([](QDialog& dialog) { testing::type(dialog, QStringLiteral("six months later")); });

  child<QPushButton>(*page, "addOccasion").click();

  EXPECT_EQ(knownOccasions(office.centre.as("administrator")).size(), 4U);
  bool offered = false;
  for (const QCheckBox* box : page->findChildren<QCheckBox*>()) {
    offered = offered || box->text() == QStringLiteral("six months later");
  }
  EXPECT_TRUE(offered);
}

void clickNamed(QWidget& page, const char* name) {
  ASSERT_TRUE(child<QPushButton>(page, name).isEnabled()) << name;
  child<QPushButton>(page, name).click();
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
    const std::vector<TraineeId> trainees = office_.centre.addTrainees(9);
    version_ = office_.centre.runPaperCurriculum();
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
    answer(giveReason);
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
      giveReason(dialog);
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
  answer(giveReason);
  testing::press(*page, QStringLiteral("Close"));
  EXPECT_EQ(states(), (std::vector{S::kClosed, S::kDraft, S::kClosed}));
  answer(giveReason);
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
  answer(giveReason);

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
    giveReason(dialog);
  });

  clickNamed(*page, "erasePerson");

  EXPECT_EQ(office.centre.audited("person.erase"), 0);
  EXPECT_EQ(openRequests(office.centre.as("administrator")).size(), 2U);
}

TEST(SeveralRaters, AreAskedByPressingEnterInTheirList) {
  AdministratorDesk office;
  const CohortId cohort = office.centre.addStudy(3, 3).cohortId;
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
    answer(giveReason);
    clickNamed(dialog, "takeBack");
    dialog.reject();
  });

  clickNamed(*page, "undoImport");

  EXPECT_TRUE(people(office.centre.as("administrator")).empty());
}

}  // namespace

}  // namespace torsio::gui
