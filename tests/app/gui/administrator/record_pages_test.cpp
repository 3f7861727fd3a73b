// SPDX-License-Identifier: GPL-3.0-or-later
// Administrators' decisions about records: retention, a person's own copy, erasure on request, a move to
// another group, another occasion.
#include <algorithm>
#include <filesystem>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QHostAddress>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTcpServer>

#include "app/gui/administrator/curriculum/curricula_page.h"
#include "app/gui/administrator/people/review_desk_dialog.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/study/allocation_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/serving/review_desk.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/people/consent.h"
#include "assessment/domain/people/retention.h"
#include "assessment/domain/study/allocation.h"
#include "tests/app/gui/support/administrator_desk.h"

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

TEST(MaintenancePage, SetsAndRemovesRetentionRules) {
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

TEST(MaintenancePage, HidesTheRulesFromUsersWhoMayNotManageThem) {
  AdministratorDesk office;

  auto page = office.open<MaintenancePage>("statistician");

  EXPECT_FALSE(named(*page, "retentionRules").isEnabled());
}

TEST(RosterPage, WritesAllDataOfAPersonIntoANewFolder) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(2);
  auto page = office.open<RosterPage>("administrator");
  page->findChild<DataTable*>()->select(toQString(trainees.front()));
  const std::filesystem::path folder = office.centre.folder() / "record-T-01";

  ASSERT_TRUE(named(*page, "exportPerson").isEnabled());
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

TEST(RosterPage, ShowsTraineesRequestsAndGoesToThem) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  SessionContext& trainee = office.centre.as("trainee");
  Actor actor = trainee.actor();
  actor.personId = trainees[1];
  trainee.setActor(actor);
  requestAboutOwnRecord(trainee, PersonRequestKind::kExport);
  auto page = office.open<RosterPage>("administrator");
  EXPECT_TRUE(named(*page, "personRequests").text().contains(QStringLiteral("(1)")));
  answer([](QDialog& dialog) {
    auto* table = dialog.findChild<DataTable*>();
    EXPECT_EQ(table->visibleRows(), 1);
    table->view().selectRow(0);
    testing::press(dialog, QStringLiteral("Go to the person"));
  });
  named(*page, "personRequests").click();
  EXPECT_EQ(page->findChild<DataTable*>()->currentId(), toQString(trainees[1]));

  answer([](QDialog& dialog) {
    dialog.findChild<DataTable*>()->view().selectRow(0);
    answer(giveReason);
    named(dialog, "requestDone").click();
    EXPECT_FALSE(named(dialog, "requestDone").isEnabled());
    dialog.reject();
  });
  named(*page, "personRequests").click();
  EXPECT_FALSE(named(*page, "personRequests").text().contains(QStringLiteral("(1)")));
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
  named(*page, "makeKioskCards").click();
  EXPECT_TRUE(std::filesystem::exists(file));
  const std::map<UserId, std::int64_t> made = kioskCodesInForce(office.centre.as("administrator"));
  ASSERT_EQ(made.size(), 1U);

  page->findChild<DataTable*>()->select(toQString(made.begin()->first));
  answer(giveReason);
  named(*page, "revokeKioskCards").click();
  EXPECT_TRUE(kioskCodesInForce(office.centre.as("administrator")).empty());
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
    dialog.findChild<QLineEdit*>(QStringLiteral("browserAddress"))
        ->setText(QStringLiteral("https://desk.example.org/"));
    answer([&](QDialog& shown) {
      auto& links = dynamic_cast<InvitationsDialog&>(shown);
      links.copy();
      copied = QApplication::clipboard()->text();
      links.saveCards(file);
      links.reject();
    });
    dialog.accept();
  });
  named(*page, "inviteUsers").click();

  EXPECT_TRUE(copied.contains(QStringLiteral("https://desk.example.org/join#"))) << copied.toStdString();
  EXPECT_TRUE(copied.contains(QStringLiteral("Your sign-in name is rater")));
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(invitationsInForce(office.centre.as("administrator")).count(rater), 1U);
  page->findChild<DataTable*>()->select(toQString(rater));
  answer(giveReason);
  named(*page, "revokeInvitations").click();
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
  dialog.findChild<QSpinBox*>(QStringLiteral("deskPort"))->setValue(other.serverPort());
  named(dialog, "deskAct").click();
  office.shell().waitForJobs();
  EXPECT_NE(text("deskSaid").find("nother program uses this port"), std::string::npos) << text("deskSaid");
  other.close();

  named(dialog, "deskAct").click();
  office.shell().waitForJobs();

  EXPECT_EQ(text("deskState"), "The review desk is open, and closes with this window.") << text("deskSaid");
  const QString address = dialog.findChild<QComboBox*>(QStringLiteral("deskAddress"))->currentText();
  EXPECT_TRUE(address.startsWith(QStringLiteral("https://"))) << address.toStdString();
  EXPECT_NE(text("deskTrust").find("SHA-256"), std::string::npos);
  named(dialog, "deskAct").click();
  office.shell().waitForJobs();
  EXPECT_EQ(text("deskState"), "The review desk is closed.");
  EXPECT_FALSE(openReviewDesk(office.centre.as("administrator"),
                              {TORSIO_PROGRAM, office.centre.folder() / "review-desk"}));
}

TEST(RosterPage, OffersNeitherWithoutTheRight) {
  AdministratorDesk office;
  office.centre.addTrainees(1);

  auto page = office.open<RosterPage>("statistician");

  EXPECT_TRUE(named(*page, "exportPerson").isHidden());
  EXPECT_TRUE(named(*page, "erasePerson").isHidden());
}

TEST(AllocationPage, MovesATraineeByHandInAdditionToTheDraw) {
  AdministratorDesk office;
  const std::vector<TraineeId> trainees = office.centre.addTrainees(3);
  const std::string version = office.centre.runPaperCurriculum();
  SessionContext& session = office.centre.as("administrator");
  const CohortId cohort = addCohort(session, {.name = "Study", .curriculumVersionId = version});
  enrolTrainees(session, cohort, trainees);
  const std::string design = lockAllocation(office.centre.as("allocator"), {.cohortId = cohort}).stored.id;
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

TEST(CurriculaPage, AddsAnOccasionWhichTheEditorThenOffers) {
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
