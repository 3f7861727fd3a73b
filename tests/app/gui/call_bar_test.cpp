// SPDX-License-Identifier: GPL-3.0-or-later
// The office calls trainees from the board of the day.
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/administrator/study/run_day_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/review/case_sheet.h"
#include "app/study/cohort_service.h"
#include "app/study/live_call.h"
#include "app/study/scoring_plan.h"
#include "db/repository/rating/sheet_repository.h"
#include "tests/app/gui/administrator_desk.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::answer;
using testing::press;

class CallsFromTheBoard : public ::testing::Test {
 protected:
  void SetUp() override {
    StudyCentre& centre = office_.centre;
    const std::vector<TraineeId> trainees = centre.addTrainees(3);
    chiefs_ = centre.addChiefs(2);
    const std::string rubric = centre.addPaperRubric();
    cohort_ = addCohort(centre.as("administrator"),
                        {.name = "Study", .curriculumVersionId = centre.runPaperCurriculum()});
    enrolTrainees(centre.session(), cohort_, trainees);
    createAssignments(centre.session(), {.cohortId = cohort_,
                                         .occasionCodes = {"pre", "mid", "post"},
                                         .raterIds = chiefs_,
                                         .rubricRevisionId = rubric,
                                         .seed = 3});
    page_ = office_.open<RunDayPage>("administrator", toQString(cohort_));
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
  std::unique_ptr<RunDayPage> page_;
};

TEST_F(CallsFromTheBoard, AScannedCodeCallsAndTheLineSaysWhoIsMissing) {
  typeCode(QStringLiteral("t-02"));

  ASSERT_EQ(calls().size(), 1U);
  EXPECT_EQ(calls()[0].traineeCode, "T-02");
  EXPECT_EQ(calls()[0].occasion.code, "pre");
  ASSERT_EQ(lines().size(), 1);
  EXPECT_TRUE(lines()[0].contains(QStringLiteral("T-02")));
  EXPECT_TRUE(lines()[0].contains(QStringLiteral("Skills lab")));
  EXPECT_TRUE(lines()[0].contains(QStringLiteral("0 of 2 sheets are in; missing: R-01, R-02")))
      << lines()[0].toStdString();
  EXPECT_TRUE(child<QLineEdit>(*page_, "callCode").text().isEmpty()) << "ready for the next scan";
  press(*page_, QStringLiteral("Copy reminder"));
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("R-01, R-02")));
  press(*page_, QStringLiteral("End call"));
  ASSERT_EQ(lines().size(), 1);
  EXPECT_TRUE(lines()[0].startsWith(QStringLiteral("! Late"))) << lines()[0].toStdString();
}

TEST_F(CallsFromTheBoard, TheChosenTraineeIsCalledByTheButtonAndNotDueNeedsAReason) {
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

TEST_F(CallsFromTheBoard, SheetsThatComeInAreSeenWithoutATouch) {
  typeCode(QStringLiteral("T-01"));
  const AssignmentId id = SheetRepository(office_.centre.connection()).assignmentsOf(chiefs_[0]).at(0).id;
  AssignmentId called = id;
  for (const Assignment& one : SheetRepository(office_.centre.connection()).assignmentsOf(chiefs_[0])) {
    if (one.enrolmentId == calls()[0].call.enrolmentId && one.occasionCode == "pre") {
      called = one.id;
    }
  }
  SessionContext& rater = office_.centre.asRater(chiefs_[0]);
  Sheet sheet{.overall_steps = 70};
  for (const RubricLine& row : openSheet(rater, called).rubric.rows) {
    sheet.rows.push_back({row.code, 70, ""});
  }
  submitSheet(office_.centre.session(), called, sheet, WatchLog());
  office_.centre.as("administrator");

  constexpr int kPatience_ms = 30'000;
  EXPECT_TRUE(QTest::qWaitFor(
      [&] {
        return lines().join(QChar(u'\n')).contains(QStringLiteral("1 of 2 sheets are in; missing: R-02"));
      },
      kPatience_ms))
      << lines().join(QChar(u'\n')).toStdString();
}

}  // namespace
}  // namespace torsio::gui
