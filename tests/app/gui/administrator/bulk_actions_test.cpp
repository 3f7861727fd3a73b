// SPDX-License-Identifier: GPL-3.0-or-later
// Administrators' actions on several items at once, and undoing them as long as nothing is sealed.

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTableView>
#include <QUrl>
#include <gtest/gtest.h>

#include "app/connectors/built_in.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/reporting/report_preview.h"
#include "app/gui/administrator/reporting/reports_page.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/administrator/station/maintenance_page.h"
#include "app/gui/administrator/study/cohorts_page.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/signing.h"
#include "app/services/access/two_people.h"
#include "app/services/maintenance/retention.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_import.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/live_call.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/study/study_statements.h"
#include "assessment/domain/people/retention.h"
#include "assessment/results/report_model.h"
#include "db/repository/rating/sheet_repository.h"
#include "sim/core/time_units.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/gui/support/hands.h"
#include "tests/support/fake_mail_server.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;
using testing::giveReason;
using testing::press;

void chooseRows(DataTable& table, int count) {
  for (int row = 0; row < count; ++row) {
    table.view().selectionModel()->select(table.view().model()->index(row, 0),
                                          QItemSelectionModel::Select | QItemSelectionModel::Rows);
  }
}

/// Three trainees in a cohort, and two chiefs asked for the live sheets of all three occasions.
class SeveralAtOnce : public ::testing::Test {
 protected:
  void SetUp() override {
    const torsio::PaperStudy study = office_.centre.addStudy(3, 3);
    chiefs_ = study.chiefs;
    cohort_ = study.cohortId;
    ScoringPlan plan = study.plan();
    plan.raterIds.pop_back();
    createAssignments(office_.centre.session(), plan);
  }
  using StudyCentre = torsio::testing::StudyCentre;
  AdministratorDesk office_;
  std::vector<RaterId> chiefs_;
  CohortId cohort_;
};

TEST_F(SeveralAtOnce, OpenSheetsOfARaterGoToAnotherOneAndReturnUnchanged) {
  SheetRepository sheets(office_.centre.connection());
  const AssignmentId begun = sheets.queue(chiefs_[0]).at(4).assignmentId;
  sheets.saveDraft(begun, {.overall_steps = 70});
  auto page = office_.open<ScoringPage>("administrator");
  const auto move = [&](const char* from, const char* to, const char* what) {
    answer([=](QDialog& dialog) {
      auto& whose = child<QComboBox>(dialog, "from");
      whose.setCurrentIndex(whose.findText(QLatin1String(from), Qt::MatchStartsWith));
      EXPECT_FALSE(testing::button(dialog, QStringLiteral("Reassign"))->isEnabled()) << "needs a reason";
      child<QLineEdit>(dialog, "reason").setText(QStringLiteral("ill today"));
      auto& whom = child<QComboBox>(dialog, "to");
      whom.setCurrentIndex(whom.findText(QLatin1String(to), Qt::MatchStartsWith));
      EXPECT_EQ(child<QLabel>(dialog, "what").text(), QLatin1String(what));
      press(dialog, QStringLiteral("Reassign"));
    });
    press(*page, QStringLiteral("Reassign"));
  };

  move("R-01", "R-03", "9 sheet(s) change hands.");  // all, if no rows are selected

  EXPECT_TRUE(sheets.queue(chiefs_[0]).empty());
  EXPECT_EQ(sheets.queue(chiefs_[2]).size(), 9U);

  move("R-03", "R-01", "9 sheet(s) change hands.");  // nothing is sealed: everything returns

  EXPECT_TRUE(sheets.queue(chiefs_[2]).empty());
  ASSERT_EQ(sheets.queue(chiefs_[0]).size(), 9U);
  EXPECT_EQ(sheets.draft(begun)->overall_steps, 70);
  chooseRows(child<DataTable>(*page, "matrix"), 2);
  move("R-01", "nobody", "2 sheet(s) change hands.");
  EXPECT_EQ(sheets.queue(chiefs_[0]).size(), 7U);
  move("R-01: taken back", "R-01", "2 sheet(s) change hands.");
  EXPECT_EQ(sheets.queue(chiefs_[0]).size(), 9U);
}

TEST_F(SeveralAtOnce, RemindersGoThroughTheCentresMailServerToAllWhoOweASheet) {
  if constexpr (!kMailBuiltIn) {
    GTEST_SKIP() << "built without mail";
  }
  torsio::testing::FakeMailServer server;
  StudyCentre& centre = office_.centre;
  for (std::size_t i = 0; i < 2; ++i) {
    changePerson(centre.as("administrator"), chiefs_[i],
                 {.fullName = "Chief " + std::to_string(i + 1),
                  .externalId = "C-" + std::to_string(2001 + i),
                  .email = "chief" + std::to_string(i + 1) + "@example.org",
                  .trainee = false,
                  .raterClass = "chief"},
                 "mail addresses");
  }
  const EnrolmentId first = enrolments(centre.as("administrator"), cohort_).front().id;
  (void)callTrainee(centre.as("administrator"),
                    {.cohortId = cohort_, .enrolmentId = first, .room = "Skills lab"});
  auto page = office_.open<ScoringPage>("administrator");
  answer([&](QDialog& dialog) {
    EXPECT_FALSE(child<QPushButton>(dialog, "sendReminders").isEnabled()) << "no server is set";
    answer([&](QDialog& settings) {
      child<QLineEdit>(settings, "mailHost").setText(QStringLiteral("127.0.0.1"));
      child<QComboBox>(settings, "mailEncryption").setCurrentIndex(2);
      child<QSpinBox>(settings, "mailPort").setValue(server.port());
      child<QLineEdit>(settings, "mailFrom").setText(QStringLiteral("office@example.org"));
      settings.accept();
    });
    child<QPushButton>(dialog, "setMailServer").click();
    ASSERT_TRUE(child<QPushButton>(dialog, "sendReminders").isEnabled());
    child<QPushButton>(dialog, "sendReminders").click();
    office_.shell().waitForJobs();
    dialog.reject();
  });

  press(*page, QStringLiteral("Send reminders"));

  ASSERT_EQ(server.taken().size(), 2U);
  EXPECT_EQ(server.taken()[0].to, "chief1@example.org");
  const std::string& text = server.taken()[0].text;
  const QByteArray body = QByteArray::fromBase64(QByteArray::fromStdString(text.substr(text.find("\n\n"))));
  EXPECT_TRUE(body.contains("please submit in Torsio: case ")) << body.toStdString();
  EXPECT_FALSE(body.contains("T-0")) << "no trainee is named";
  EXPECT_EQ(centre.audited("reminder.mail"), 2);
}

TEST_F(SeveralAtOnce, SheetsOfCasesThatTheOtherRaterAlreadyScoresStay) {
  auto page = office_.open<ScoringPage>("administrator");
  answer([](QDialog& dialog) {
    auto& whom = child<QComboBox>(dialog, "to");
    whom.setCurrentIndex(whom.findText(QStringLiteral("R-02"), Qt::MatchStartsWith));
    testing::leave(whom);
    EXPECT_TRUE(testing::hintBelow(dialog, whom).contains(QStringLiteral("another rater")));
    auto& reason = child<QLineEdit>(dialog, "reason");
    testing::leave(reason);
    EXPECT_FALSE(testing::hintBelow(dialog, reason).isEmpty());
    testing::retype(reason, QStringLiteral("ill today"));
    EXPECT_EQ(testing::hintBelow(dialog, reason), QString());
    EXPECT_TRUE(child<QLabel>(dialog, "what").text().contains(QStringLiteral("9 stay(s)")))
        << child<QLabel>(dialog, "what").text().toStdString();
    EXPECT_FALSE(testing::button(dialog, QStringLiteral("Reassign"))->isEnabled());
    dialog.reject();
  });

  press(*page, QStringLiteral("Reassign"));
}

TEST_F(SeveralAtOnce, EveryAlertIsListedAndTheLineCountsThem) {
  StudyCentre& centre = office_.centre;
  auto page = office_.open<TodaysSessionsPage>("administrator");
  std::vector<TraineeId> more;
  for (int i = 1; i <= 9; ++i) {
    more.push_back(addPerson(centre.as("administrator"), {.fullName = "Li Na", .trainee = true}));
  }
  const std::vector<EnrolmentId> all = enrolTrainees(centre.as("administrator"), cohort_, more);
  (void)planDay(centre.as("administrator"), {.cohortId = cohort_,
                                             .enrolmentIds = all,
                                             .places = {"A", "B", "C", "D", "E", "F", "G", "H", "I"},
                                             .firstUtc_us = centre.session().now_us(),
                                             .duration_us = 60 * kMinute_us});
  centre.passTime_us(6 * kMinute_us);

  page->enter(toQString(cohort_));

  const QString lines = child<QLabel>(*page, "alerts").text();
  EXPECT_EQ(lines.count(QStringLiteral("was expected at")), 9) << lines.toStdString();
  EXPECT_FALSE(lines.contains(QStringLiteral("more")));
  const QString counts = child<QLabel>(*page, "alertCounts").text();
  EXPECT_TRUE(counts.contains(QStringLiteral("overdue: 9"))) << counts.toStdString();
  EXPECT_TRUE(counts.contains(QStringLiteral("without a group: 12"))) << counts.toStdString();
  page->setVisible(true);
  QApplication::processEvents();
  auto& panel = child<QWidget>(*page, "alertPanel");
  auto* scroll = panel.findChild<QScrollArea*>();
  EXPECT_FALSE(scroll->isVisible()) << "one line until somebody asks";
  child<QPushButton>(panel, "unfold").click();
  QApplication::processEvents();
  EXPECT_TRUE(scroll->isVisible());
  EXPECT_LT(scroll->height(), 100) << "the board keeps its room";
  EXPECT_GT(scroll->verticalScrollBar()->maximum(), 0);
}

TEST_F(SeveralAtOnce, AWrongRosterIsUndoneCompletely) {
  StudyCentre& centre = office_.centre;
  const RosterFile file = parseRoster("Staff ID,Name\nC-901,Ann Chief\nC-902,Bo Chief\n", "chiefs.csv");
  const RosterColumns columns = suggestColumns(file, RosterKind::kTrainees);
  SessionContext& session = centre.as("administrator");
  const RosterPreview preview = previewRoster(session, file, RosterKind::kTrainees, columns);
  (void)importRoster(session, file, RosterKind::kTrainees, columns, preview.fingerprint, RosterMode::kCommit);
  const std::size_t before = people(session).size();
  auto page = office_.open<RosterPage>("administrator");
  QString said;
  answer([&said](QDialog& dialog) {
    auto& imports = child<DataTable>(dialog, "imports");
    EXPECT_EQ(imports.visibleRows(), 1);
    answer(giveReason);
    child<QPushButton>(dialog, "takeBack").click();
    said = imports.asText();
    EXPECT_FALSE(child<QPushButton>(dialog, "takeBack").isEnabled());
    dialog.reject();
  });

  child<QPushButton>(*page, "undoImport").click();

  EXPECT_TRUE(said.contains(QStringLiteral("taken back"))) << said.toStdString();
  EXPECT_EQ(people(centre.as("administrator")).size(), before - 2);
  EXPECT_EQ(child<DataTable>(*page, "table").visibleRows(), static_cast<int>(before - 2));
}

TEST_F(SeveralAtOnce, DeviationsOfSeveralAreNotedAndCorrectedTogether) {
  auto page = office_.open<TodaysSessionsPage>("administrator");
  auto& table = child<DataTable>(*page, "table");
  table.view().selectAll();
  answer([](QDialog& dialog) {
    auto* kind = dialog.findChild<QComboBox*>();
    kind->setCurrentIndex(kind->findData(QStringLiteral("device failed")));
    dialog.accept();
  });
  press(*page, QStringLiteral("Deviation"));
  const auto noted = [this] { return deviations(office_.centre.as("administrator"), cohort_); };
  ASSERT_EQ(noted().size(), 3U);

  answer([](QDialog& dialog) {
    auto& list = child<DataTable>(dialog, "deviations");
    EXPECT_TRUE(list.asText().contains(QStringLiteral("device failed")));
    chooseRows(list, 2);
    answer([](QDialog& why) { testing::type(why, QStringLiteral("it was another room")); });
    child<QPushButton>(dialog, "correctDeviations").click();
    EXPECT_EQ(list.visibleRows(), 5);
    dialog.reject();
  });
  press(*page, QStringLiteral("Noted"));

  ASSERT_EQ(noted().size(), 5U);
  std::size_t corrections = 0;
  for (const ProtocolDeviation& one : noted()) {
    corrections += one.description == "entered in error: \"device failed\": it was another room" ? 1 : 0;
  }
  EXPECT_EQ(corrections, 2U);
  table.view().selectAll();
  answer([](QDialog& dialog) { testing::type(dialog, QStringLiteral("the course is cancelled")); });
  press(*page, QStringLiteral("Withdraw"));
  for (const Enrolment& one : enrolments(office_.centre.as("administrator"), cohort_)) {
    EXPECT_EQ(one.state, EnrolmentState::kWithdrawn);
  }
  table.view().selectAll();
  answer([](QDialog& dialog) { testing::type(dialog, QStringLiteral("it is not")); });
  press(*page, QStringLiteral("Back in"));
  for (const Enrolment& one : enrolments(office_.centre.as("administrator"), cohort_)) {
    EXPECT_EQ(one.state, EnrolmentState::kEnrolled);
  }
}

TEST_F(SeveralAtOnce, UnplannedTimeIsOnlyLoggedWithAReason) {
  AllocationPlan plan{.cohortId = cohort_};
  lockAllocation(office_.centre.as("allocator"), plan);
  allocateAll(office_.centre.as("allocator"), cohort_);  // one in each of the paper's groups
  auto page = office_.open<TodaysSessionsPage>("administrator", toQString(cohort_));
  child<DataTable>(*page, "table").view().selectAll();
  answer([](QDialog& dialog) {
    auto& kind = child<QComboBox>(dialog, "exposureKind");
    const auto& warned = child<QLabel>(dialog, "besideThePlan");
    EXPECT_EQ(kind.currentText(), QStringLiteral("rest")) << "neither arm is planned for all three";
    EXPECT_FALSE(warned.isVisible());
    kind.setCurrentIndex(kind.findText(QStringLiteral("on the real arm")));
    EXPECT_TRUE(warned.isVisible());
    EXPECT_TRUE(warned.text().startsWith(QStringLiteral("! The plan of T-0"))) << warned.text().toStdString();
    EXPECT_EQ(warned.text().count(QStringLiteral("T-0")), 1) << "two of three have such time";
    EXPECT_FALSE(testing::button(dialog, QStringLiteral("Log time"))->isEnabled());
    child<QLineEdit>(dialog, "reason").setText(QStringLiteral("the simulator failed"));
    EXPECT_TRUE(testing::button(dialog, QStringLiteral("Log time"))->isEnabled());
    dialog.accept();
  });
  press(*page, QStringLiteral("Log time"));

  int beside = 0;
  for (const ProtocolDeviation& one : deviations(office_.centre.as("administrator"), cohort_)) {
    beside += one.kind == "trained outside the plan" ? 1 : 0;
  }
  EXPECT_EQ(beside, 1);
}

TEST(RetentionQueue, DecidesForAllSelectedPeopleAndUndoesIt) {
  AdministratorDesk office;
  setRetentionRule(office.centre.as("administrator"), kRetainTrainee, 1, "contract");
  office.centre.addTrainees(4);
  office.centre.passTime_us(3 * kDay_us);
  auto page = office.open<MaintenancePage>("administrator");
  auto& queue = child<DataTable>(*page, "queue");
  ASSERT_EQ(queue.visibleRows(), 4);
  chooseRows(queue, 3);
  const auto held = [&office] {
    std::size_t count = 0;
    for (const RetentionItem& item : retentionQueue(office.centre.as("administrator"))) {
      count += item.held ? 1 : 0;
    }
    return count;
  };

  answer(giveReason);
  child<QPushButton>(*page, "retentionLock").click();
  EXPECT_EQ(held(), 3U);
  EXPECT_TRUE(child<QPushButton>(*page, "retentionLock").text().contains(QStringLiteral("Release")));
  EXPECT_FALSE(child<QPushButton>(*page, "retentionErase").isEnabled()) << "who is held is not erased";
  answer(giveReason);
  child<QPushButton>(*page, "retentionLock").click();  // the same button undoes it
  EXPECT_EQ(held(), 0U);
  answer(giveReason);
  child<QPushButton>(*page, "retentionErase").click();

  EXPECT_EQ(queue.visibleRows(), 1);
  EXPECT_EQ(office.centre.audited("person.erase"), 3);
  EXPECT_EQ(office.centre.audited("retention.lock"), 3);
}

TEST(RetentionQueue, AsksOnceForASecondPersonToEraseSeveral) {
  AdministratorDesk office;
  setRetentionRule(office.centre.as("administrator"), kRetainTrainee, 1, "contract");
  setCentreSetting<kTwoPeople>(office.centre.session(), true);
  office.centre.addTrainees(2);
  office.centre.passTime_us(3 * kDay_us);
  auto page = office.open<MaintenancePage>("administrator");
  child<DataTable>(*page, "queue").view().selectAll();
  answer([](QDialog& dialog) {
    answer([](QDialog& asked) {
      EXPECT_EQ(asked.objectName(), QStringLiteral("askSecondPerson"));
      asked.accept();
    });
    giveReason(dialog);
  });

  child<QPushButton>(*page, "retentionErase").click();

  EXPECT_EQ(child<DataTable>(*page, "queue").visibleRows(), 2);
  EXPECT_EQ(office.centre.audited("duty.request"), 2);
}

TEST(InterimFreeze, IsAskedForByOneAndDoneByAnother) {
  AdministratorDesk office;
  const PaperStudy study = office.centre.addStudy(2, 2);
  createAssignments(office.centre.as("administrator"), study.plan());
  setCentreSetting<kTwoPeople>(office.centre.as("administrator"), true);
  auto page = office.open<ReportsPage>("administrator");
  answer([](QDialog& dialog) {
    EXPECT_EQ(dialog.objectName(), QStringLiteral("askSecondPerson"));
    dialog.accept();
  });

  EXPECT_FALSE(page->freeze("look", "the board meets"));

  EXPECT_EQ(office.centre.audited("duty.request"), 1);
  EXPECT_EQ(office.centre.audited("dataset.freeze"), 0);
  auto other = office.open<ReportsPage>("statistician", toQString(study.cohortId.text()));
  showPassword(office.centre.session(), kStudyPassword);
  EXPECT_TRUE(other->freeze("look", "the board meets"));
  other->settle();
  ASSERT_NE(other->inputs(), nullptr);
  ASSERT_TRUE(other->inputs()->freeze.has_value());
  EXPECT_TRUE(other->inputs()->freeze->interim());
  EXPECT_EQ(other->inputs()->freeze->askedBy, "administrator");
}

TEST(AboutAStudy, IsStatedInADialogAndKept) {
  AdministratorDesk office;
  const CohortId cohort = office.centre.addStudy(2).cohortId;
  auto page = office.open<CohortsPage>("administrator", toQString(cohort.text()));
  answer([](QDialog& dialog) {
    child<QPlainTextEdit>(dialog, "ethics").setPlainText(QStringLiteral(" board of the house, 12/26 "));
    dialog.accept();
  });
  child<QPushButton>(*page, "aboutStudy").click();
  EXPECT_EQ(studyStatements(office.centre.as("administrator"), cohort),
            (StudyStatements{{StudyItem::kEthics, "board of the house, 12/26"}}));

  auto reader = office.open<CohortsPage>("statistician", toQString(cohort.text()));
  answer([](QDialog& dialog) {
    EXPECT_TRUE(child<QPlainTextEdit>(dialog, "ethics").isReadOnly());
    dialog.reject();
  });
  child<QPushButton>(*reader, "aboutStudy").click();
}

TEST(ReportPreview, ShowsTheNumberOfRowsOfALongTableAndAllRowsOnRequest) {
  ReportModel report;
  report.sections.emplace_back();
  ReportTable& table = report.sections.back().tables.emplace_back();
  table.title = Text::verbatim("Attendance");
  table.columns = {Text::verbatim("Trainee")};
  for (int row = 1; row <= 40; ++row) {
    table.rows.push_back({"person-" + std::to_string(row) + "."});
  }
  ReportPreview preview;

  preview.setReport(report, wordingIn("en"));

  EXPECT_TRUE(preview.toPlainText().contains(QStringLiteral("15 of 40 rows")));
  EXPECT_FALSE(preview.toPlainText().contains(QStringLiteral("person-16.")));
  Q_EMIT preview.anchorClicked(QUrl(QStringLiteral("rows:0")));
  EXPECT_TRUE(preview.toPlainText().contains(QStringLiteral("person-40.")));
  EXPECT_TRUE(preview.toPlainText().contains(QStringLiteral("all 40 rows")));
  Q_EMIT preview.anchorClicked(QUrl(QStringLiteral("rows:0")));
  EXPECT_FALSE(preview.toPlainText().contains(QStringLiteral("person-40.")));
}

}  // namespace
}  // namespace torsio::gui
