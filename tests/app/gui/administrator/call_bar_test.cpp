// SPDX-License-Identifier: GPL-3.0-or-later
// Calling trainees from the board of the day.
#include <iterator>
#include <regex>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDateEdit>
#include <QDateTime>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QSpinBox>
#include <QTableView>
#include <QTest>
#include <QTimeEdit>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/administrator/base/printed_sheets.h"
#include "app/gui/administrator/study/day_plan_dialog.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/base/background.h"
#include "app/gui/base/page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/people/people_service.h"
#include "app/services/review/case_sheet.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/live_call.h"
#include "app/services/study/paper_sheets.h"
#include "app/services/study/scoring_plan.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/support/administrator_desk.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;
using testing::press;

int pagesOf(const std::filesystem::path& pdf) {
  const std::string text = readFile(pdf);
  const std::regex page("/Type /Page[^s]");
  return static_cast<int>(std::distance(std::sregex_iterator(text.begin(), text.end(), page), {}));
}

class CallsFromTheBoard : public ::testing::Test {
 protected:
  void SetUp() override {
    const torsio::PaperStudy study = office_.centre.addStudy(3, 2);
    chiefs_ = study.chiefs;
    cohort_ = study.cohortId;
    createAssignments(office_.centre.session(), study.plan());
    page_ = office_.open<TodaysSessionsPage>("administrator", toQString(cohort_));
  }
  void typeCode(const QString& code, const QString& room = QStringLiteral("Skills lab")) {
    child<QLineEdit>(*page_, "callRoom").setText(room);
    child<QLineEdit>(*page_, "callCode").setText(code);
    QTest::keyClick(&child<QLineEdit>(*page_, "callCode"), Qt::Key_Return);
  }
  [[nodiscard]] QStringList lines() const {
    QStringList all;
    for (const QLabel* label : page_->findChildren<QLabel*>(QStringLiteral("calledCase"))) {
      if (!label->isHidden()) {
        all << label->text();
      }
    }
    return all;
  }
  std::vector<CalledCase> calls() { return calledCases(office_.centre.as("administrator"), cohort_); }

  using StudyCentre = torsio::testing::StudyCentre;
  AdministratorDesk office_;
  std::vector<RaterId> chiefs_;
  CohortId cohort_;
  std::unique_ptr<TodaysSessionsPage> page_;
};

TEST_F(CallsFromTheBoard, AScannedCodeCallsATraineeAndTheLineShowsWhoIsMissing) {
  typeCode(QStringLiteral("t-02"));

  ASSERT_EQ(calls().size(), 1U);
  EXPECT_EQ(calls()[0].traineeCode, "T-02");
  EXPECT_EQ(calls()[0].occasion.code, "pre");
  ASSERT_EQ(lines().size(), 1);
  EXPECT_TRUE(lines()[0].contains(QStringLiteral("T-02")));
  EXPECT_TRUE(lines()[0].contains(QStringLiteral("Skills lab")));
  EXPECT_TRUE(lines()[0].endsWith(QStringLiteral("0 of 2 sheet(s) in")))
      << "none is missing yet: " << lines()[0].toStdString();
  EXPECT_TRUE(child<QLineEdit>(*page_, "callCode").text().isEmpty()) << "ready for the next scan";
  press(*page_, QStringLiteral("Copy reminder"));
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("R-01, R-02")));
  EXPECT_EQ(office_.centre.audited("reminder.copy"), 2) << "an entry for each of the two";
  press(*page_, QStringLiteral("End call"));
  ASSERT_EQ(lines().size(), 1);
  EXPECT_TRUE(lines()[0].startsWith(QStringLiteral("! Late"))) << lines()[0].toStdString();
}

// Somebody else calls a trainee while a button is pressed: neither a new refresh nor one under way moves the
// button.
TEST_F(CallsFromTheBoard, TheTimerDoesNotMoveAPressedButton) {
  constexpr int kLongest_ms = 20'000;
  page_->resize(1146, 700);
  page_->show();
  QApplication::processEvents();
  auto* clock = page_->findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly);
  auto* reader = page_->findChild<Background*>(QString(), Qt::FindDirectChildrenOnly);
  ASSERT_TRUE(clock != nullptr && reader != nullptr);
  int rings = 0;
  bool pressAtRing = false;
  QPushButton* held = testing::button(*page_, QStringLiteral("Deviation"));
  ASSERT_NE(held, nullptr);
  QObject::connect(clock, &QTimer::timeout, page_.get(), [&] {
    ++rings;
    if (std::exchange(pressAtRing, false)) {
      EXPECT_TRUE(reader->working());
      QTest::mousePress(held, Qt::LeftButton);
    }
  });
  const auto ring = [&](int times) {
    const int before = rings;
    return QTest::qWaitFor(
        [&] {
          clock->setInterval(1);  // showing sets its own interval
          return rings >= before + times && !reader->working();
        },
        kLongest_ms);
  };
  const std::vector<Enrolment> enrolled = enrolments(office_.centre.session(), cohort_);
  for (const bool underWay : {false, true}) {
    ASSERT_TRUE(ring(2));
    const QPoint place = held->mapTo(page_.get(), QPoint());
    const qsizetype before = lines().size();
    if (!underWay) {
      QTest::mousePress(held, Qt::LeftButton);
    }
    pressAtRing = underWay;
    (void)callTrainee(office_.centre.as("administrator"), {.cohortId = cohort_,
                                                           .enrolmentId = enrolled[underWay ? 1 : 0].id,
                                                           .room = underWay ? "Room 2" : "Room 1"});
    ASSERT_TRUE(ring(3));
    EXPECT_TRUE(held->isDown());
    EXPECT_EQ(lines().size(), before) << underWay;
    EXPECT_EQ(held->mapTo(page_.get(), QPoint()), place) << underWay;

    bool asked = false;
    answer([&asked](QDialog& dialog) {
      asked = true;
      dialog.reject();
    });
    QTest::mouseRelease(held, Qt::LeftButton);
    EXPECT_TRUE(asked) << underWay;
    const auto toldOnce = [&] {
      clock->setInterval(1);
      return lines().size() == before + 1;
    };
    EXPECT_TRUE(QTest::qWaitFor(toldOnce, kLongest_ms)) << underWay;
  }
}

TEST_F(CallsFromTheBoard, SixRowsOfTheBoardAreVisibleWithCallsAlertsAndStations) {
  StudyCentre& centre = office_.centre;
  std::vector<TraineeId> more;
  for (int i = 1; i <= 9; ++i) {
    more.push_back(addPerson(centre.as("administrator"), {.fullName = "Li Na", .trainee = true}));
  }
  const std::vector<EnrolmentId> all = enrolTrainees(centre.as("administrator"), cohort_, more);
  const std::int64_t now_us = centre.session().now_us();
  (void)planDay(centre.as("administrator"), {.cohortId = cohort_,
                                             .enrolmentIds = all,
                                             .places = {"A", "B"},
                                             .firstUtc_us = now_us,
                                             .duration_us = 60'000'000});
  for (const char* station : {"room 1", "room 2", "room 3", "room 4", "room 5"}) {
    StationRepository(centre.connection()).heartbeat({.station = station, .heartbeatUtc_us = now_us});
  }
  centre.passTime_us(30LL * 60'000'000);
  typeCode(QStringLiteral("t-01"));
  press(*page_, QStringLiteral("End call"));
  typeCode(QStringLiteral("t-02"), QStringLiteral("Arm 1"));
  typeCode(QStringLiteral("t-03"), QStringLiteral("Arm 2"));
  constexpr QSize kPageOf1366x768{1176, 695};
  page_->resize(kPageOf1366x768);
  page_->show();
  page_->enter(toQString(cohort_));
  QApplication::processEvents();

  const QTableView& board = child<DataTable>(*page_, "table").view();
  const auto seen = [&board] { return board.viewport()->height() / board.rowHeight(0); };
  EXPECT_GE(seen(), 6);
  const QString stations = child<QLabel>(*page_, "stationsLine").text();
  EXPECT_TRUE(stations.contains(QStringLiteral("not answering: 5"))) << stations.toStdString();
  EXPECT_FALSE(child<DataTable>(*page_, "stations").isVisible());
  EXPECT_EQ(lines().size(), 3);
  auto& showAll = child<QPushButton>(*page_, "allCalls");
  EXPECT_EQ(showAll.text(), QStringLiteral("Show all (3, late: 1)"));
  const auto& calls = child<QScrollArea>(*page_, "calls");
  const int one = calls.height();
  showAll.click();
  EXPECT_GE(calls.height(), 3 * one);
}

TEST_F(CallsFromTheBoard, TheDayIsPlannedAndPrintedAndOverdueTraineesAreShown) {
  StudyCentre& centre = office_.centre;
  const QDateTime now = QDateTime::fromMSecsSinceEpoch(centre.as("administrator").now_us() / 1000);
  const std::filesystem::path file = centre.folder() / "plan.pdf";
  answer([&](QDialog& dialog) {
    child<QTimeEdit>(dialog, "planFirst").setTime(now.time().addSecs(600));
    child<QSpinBox>(dialog, "planMinutes").setValue(20);
    child<QLineEdit>(dialog, "planPlaces").setText(QStringLiteral("Station 1, Skills lab"));
    child<QSpinBox>(dialog, "planMinutes").setValue(600);
    EXPECT_FALSE(child<QPushButton>(dialog, "planAdd").isEnabled()) << "slots in the night";
    EXPECT_TRUE(child<QLabel>(dialog, "planOutlook").text().startsWith(QLatin1Char('!')));
    child<QSpinBox>(dialog, "planMinutes").setValue(20);
    EXPECT_TRUE(
        child<QLabel>(dialog, "planOutlook").text().startsWith(QStringLiteral("The last slot ends at ")))
        << child<QLabel>(dialog, "planOutlook").text().toStdString();
    child<QPushButton>(dialog, "planAdd").click();
    auto& slots = child<DataTable>(dialog, "planSlots");
    EXPECT_EQ(slots.visibleRows(), 3);
    EXPECT_TRUE(slots.asText().contains(QStringLiteral("Skills lab\tT-02"))) << slots.asText().toStdString();
    dynamic_cast<DayPlanDialog&>(dialog).print(file);
    dialog.reject();
  });
  press(*page_, QStringLiteral("Plan the day"));
  EXPECT_EQ(pagesOf(file), 1);
  const auto board = [&] { return child<DataTable>(*page_, "table").asText(); };
  EXPECT_TRUE(board().contains(QStringLiteral("Station 1"))) << board().toStdString();
  EXPECT_FALSE(board().contains(QStringLiteral("overdue")));

  centre.passTime_us(16LL * 60 * 1'000'000);  // the first two are six minutes late
  page_->enter(toQString(cohort_));

  EXPECT_EQ(board().count(QStringLiteral("overdue")), 2) << board().toStdString();
  EXPECT_TRUE(child<QLabel>(*page_, "alerts").text().contains(QStringLiteral("T-01 was expected at")))
      << child<QLabel>(*page_, "alerts").text().toStdString();
}

TEST_F(CallsFromTheBoard, APlanStartsAtTheNextQuarterOfAnHourAtTheTraineesStations) {
  StudyCentre& centre = office_.centre;
  const QDateTime morning = QDateTime::fromMSecsSinceEpoch(centre.as("administrator").now_us() / 1000);
  const QDateTime seen(morning.date(), QTime(14, 7));  // in any time zone of this machine
  centre.passTime_us((morning.msecsTo(seen) + (seen < morning ? 24LL * 3600 * 1000 : 0)) * 1000);
  StationRepository stations(centre.connection());
  stations.heartbeat({.station = "simulator-1",
                      .heartbeatUtc_us = centre.session().now_us(),
                      .deviceJson = R"({"text":"Touch"})"});
  stations.heartbeat({.station = "desk-of-r-01", .heartbeatUtc_us = centre.session().now_us()});
  page_->enter(toQString(cohort_));
  answer([&](QDialog& dialog) {
    auto& first = child<QTimeEdit>(dialog, "planFirst");
    auto& day = child<QDateEdit>(dialog, "planDate");
    EXPECT_EQ(first.time(), QTime(14, 15));
    EXPECT_EQ(child<QLineEdit>(dialog, "planPlaces").text(), QStringLiteral("simulator-1"));
    EXPECT_FALSE(child<QLabel>(dialog, "planOutlook").text().startsWith(QLatin1Char('!')));
    day.setDate(day.date().addDays(1));
    EXPECT_EQ(first.time(), QTime(9, 0)) << "another day begins in the morning";
    first.setTime(QTime(10, 30));
    day.setDate(day.date().addDays(-1));
    EXPECT_EQ(first.time(), QTime(10, 30)) << "what somebody typed stays";
    dialog.reject();
  });

  press(*page_, QStringLiteral("Plan the day"));
}

TEST_F(CallsFromTheBoard, AStationWithoutAnyTrainingIsOfferedForThePlan) {
  StudyCentre& centre = office_.centre;
  StationRepository stations(centre.connection());
  stations.heartbeat({.station = "simulator-1",
                      .heartbeatUtc_us = centre.session().now_us(),
                      .deviceJson = R"({"text":"Touch"})"});
  stations.heartbeat({.station = "simulator & 2", .heartbeatUtc_us = centre.session().now_us()});
  page_->enter(toQString(cohort_));
  const auto offered = [](QDialog& dialog) {
    QStringList texts;
    for (const QAction* action : child<QPushButton>(dialog, "planMore").menu()->actions()) {
      texts << (action->isVisible() ? QStringList{action->text()} : QStringList{});
    }
    return texts;
  };
  answer([&](QDialog& dialog) {
    auto& places = child<QLineEdit>(dialog, "planPlaces");
    EXPECT_EQ(places.text(), QStringLiteral("simulator-1"));
    ASSERT_EQ(offered(dialog), QStringList{QStringLiteral("simulator && 2")});
    EXPECT_FALSE(child<QPushButton>(dialog, "planMore").autoDefault()) << "Enter in a field plans";
    child<QPushButton>(dialog, "planMore").menu()->actions().last()->trigger();
    EXPECT_EQ(places.text(), QStringLiteral("simulator-1, simulator & 2"));
    EXPECT_TRUE(child<QPushButton>(dialog, "planMore").isHidden()) << "all are named";
    places.setText(QStringLiteral("Skills lab"));
    EXPECT_EQ(offered(dialog).size(), 2);
    child<QPushButton>(dialog, "planAdd").click();
    dialog.reject();
  });
  press(*page_, QStringLiteral("Plan the day"));
  answer([&](QDialog& dialog) {
    EXPECT_TRUE(offered(dialog).contains(QStringLiteral("Skills lab"))) << "it was in the plan before";
    dialog.reject();
  });
  press(*page_, QStringLiteral("Plan the day"));
}

TEST_F(CallsFromTheBoard, TheBoardIsRereadWhenTheDatabaseAnswersAgain) {
  (void)callTrainee(office_.centre.as("administrator"),
                    {.cohortId = cohort_,
                     .enrolmentId = enrolments(office_.centre.session(), cohort_).front().id,
                     .room = "Skills lab"});
  ASSERT_TRUE(lines().isEmpty()) << "it was called elsewhere";

  QEvent answered(databaseAnsweredEvent());
  QApplication::sendEvent(page_.get(), &answered);

  EXPECT_EQ(lines().size(), 1);
}

TEST_F(CallsFromTheBoard, TheButtonCallsTheSelectedTraineeAndNeedsAReasonIfNotDue) {
  child<QLineEdit>(*page_, "callRoom").setText(QStringLiteral("Room 2"));
  child<DataTable>(*page_, "table").view().selectRow(0);
  auto& occasion = child<QComboBox>(*page_, "callOccasion");
  occasion.setCurrentIndex(occasion.findData(QStringLiteral("post")));
  answer([](QDialog& dialog) { dialog.reject(); });
  press(*page_, QStringLiteral("Call to the arm"));
  EXPECT_TRUE(calls().empty());

  answer([](QDialog& dialog) {
    testing::type(dialog, QStringLiteral("the arm is free today only"));
    dialog.accept();
  });
  press(*page_, QStringLiteral("Call to the arm"));

  ASSERT_EQ(calls().size(), 1U);
  EXPECT_EQ(calls()[0].occasion.code, "post");
  EXPECT_EQ(deviations(office_.centre.session(), cohort_).size(), 1U);
}

TEST_F(CallsFromTheBoard, APaperSheetIsEnteredAndWaitsForASecondPerson) {
  typeCode(QStringLiteral("t-01"));
  QString said;
  QTimer::singleShot(0, [&said] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    auto& table = child<DataTable>(*dialog, "cases");
    EXPECT_EQ(table.visibleRows(), 2);
    EXPECT_FALSE(table.asText().contains(QStringLiteral("T-01"))) << "the case, never who";
    table.view().selectRow(0);
    for (QDoubleSpinBox* mark : dialog->findChildren<QDoubleSpinBox*>()) {
      EXPECT_EQ(mark->value(), mark->minimum()) << "nothing is filled in";
      mark->setValue(7.0);
    }
    child<QPushButton>(*dialog, "keep").click();
    said = table.asText();
    dialog->reject();
  });
  child<QAction>(*page_, "typeSheets").trigger();

  EXPECT_TRUE(said.contains(QStringLiteral("typed by you, waits for another"))) << said.toStdString();
  EXPECT_EQ(calls()[0].submitted, 0U);
}

TEST_F(CallsFromTheBoard, PrintedSheetsAndCallListsHavePages) {
  typeCode(QStringLiteral("t-01"));
  const std::vector<PaperSheet> sheets = paperSheets(office_.centre.as("administrator"), cohort_, {}, "pre");
  ASSERT_EQ(sheets.size(), 6U);
  const std::filesystem::path folder = office_.centre.folder();

  writePaperSheets(sheets, QStringLiteral("Skills lab"), folder / "sheets.pdf");
  writeCallList({{"T-01", "G1", "virtual 0-20 min", "before", 2}}, QStringLiteral("Study"), {},
                folder / "calls.pdf");

  EXPECT_EQ(pagesOf(folder / "sheets.pdf"), 6) << "a page a sheet";
  EXPECT_EQ(pagesOf(folder / "calls.pdf"), 1);
}

TEST_F(CallsFromTheBoard, IncomingSheetsAppearWithoutInteraction) {
  typeCode(QStringLiteral("T-01"));
  const AssignmentId id = SheetRepository(office_.centre.connection()).assignmentsOf(chiefs_[0]).at(0).id;
  AssignmentId called = id;
  for (const Assignment& one : SheetRepository(office_.centre.connection()).assignmentsOf(chiefs_[0])) {
    if (one.enrolmentId == calls()[0].call.enrolmentId && one.occasionCode == "pre") {
      called = one.id;
    }
  }
  SessionContext& rater = office_.centre.asRater(chiefs_[0]);
  submitSheet(office_.centre.session(), called, evenSheet(openSheet(rater, called).rubric, 70, 70),
              WatchLog());
  office_.centre.as("administrator");

  constexpr int kPatience_ms = 30'000;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return lines().join(QChar(u'\n')).contains(QStringLiteral("1 of 2 sheet(s) in; still to come: R-02"));
      },
      kPatience_ms))
      << lines().join(QChar(u'\n')).toStdString();
}

}  // namespace
}  // namespace torsio::gui
