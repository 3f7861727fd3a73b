// SPDX-License-Identifier: GPL-3.0-or-later
// Scoring for administrators, with real widgets: an adjudicator in two clicks, the runs of rater calibration.

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDateEdit>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/administrator/scoring/rater_calibration_dialog.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/physician/discrepancy_review_page.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/rater_calibration.h"
#include "app/services/review/review_queue.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/cohort.h"
#include "db/connection/row_reader.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::ReviewCentre;
using torsio::testing::reviewSheet;

QPushButton* buttonOf(QWidget& page, const char* part) {
  for (QPushButton* one : page.findChildren<QPushButton*>()) {
    if (one->isVisibleTo(&page) && one->text().remove(QLatin1Char('&')).contains(QLatin1String(part))) {
      return one;
    }
  }
  return nullptr;
}

/// An administrator's scoring page.
class ScoringPages : public ::testing::Test {
 protected:
  ReviewCentre centre_{ReviewCentre::Setup{}};
  std::unique_ptr<SessionContext> administrator_ = centre_.administrator();
  ShellContext shell_{*administrator_, std::filesystem::path(TORSIO_SOURCE_DIR) / "assets",
                      ThemeKind::kLight};
  std::unique_ptr<ScoringPage> page_;

  void SetUp() override {
    QObject::connect(&shell_, &ShellContext::failed,
                     [](const QString& happened) { ADD_FAILURE() << happened.toStdString(); });
  }
  void open() {
    page_ = std::make_unique<ScoringPage>(shell_);
    page_->resize(1146, 700);
    page_->setVisible(true);
    page_->enter({});
  }
  /// Presses a button of the page; `drive` operates its dialog.
  template <typename Drive>
  void press(const char* part, const Drive& drive) {
    bool driven = false;
    QTimer::singleShot(0, [&] {
      auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
      ASSERT_NE(dialog, nullptr);
      driven = true;
      drive(*dialog);
    });
    QPushButton* button = buttonOf(*page_, part);
    ASSERT_NE(button, nullptr) << part;
    button->click();
    EXPECT_TRUE(driven);
  }
};

TEST_F(ScoringPages, FindsAnAdjudicatorInTwoClicks) {
  Rater rater;
  rater.person = {.id = "rater-900", .code = "CH-900", .createdUtc_us = torsio::testing::kReviewTime_us};
  rater.classCode = "chief";
  PeopleRepository(centre_.connection()).addRaters(std::span(&rater, 1));
  open();
  EXPECT_EQ(buttonOf(*page_, "Adjudicator"), nullptr);  // no requests
  WatchLog log(2'000'000);
  log.played(0, 2'000'000, 1.0);
  submitSheet(*centre_.physician(0), centre_.caseAbout(0, 0), reviewSheet(2, 2, 2), log);
  submitSheet(*centre_.physician(1), centre_.caseAbout(1, 0), reviewSheet(8, 8, 8), log);
  centre_.passTime_us(1'000'000);
  askForAdjudicator(*centre_.physician(0), centre_.caseAbout(0, 0), "I cannot explain the distance");
  centre_.passTime_us(1'000'000);
  page_->enter({});

  // First click: the list, with a suggestion. Second click: assigned.
  press("Adjudicator (1)", [](QDialog& dialog) {
    auto* table = dialog.findChild<DataTable*>();
    ASSERT_NE(table, nullptr);
    EXPECT_TRUE(table->asText().contains(QStringLiteral("I cannot explain the distance")));
    EXPECT_TRUE(dialog.findChild<QComboBox*>()->currentText().contains(QStringLiteral("CH-900")));
    buttonOf(dialog, "Assign")->click();
  });

  EXPECT_EQ(SheetRepository(centre_.connection()).queue("rater-900").size(), 1U);
  EXPECT_EQ(buttonOf(*page_, "Adjudicator"), nullptr);
  EXPECT_TRUE(child<DataTable>(*page_, "matrix").asText().contains(QStringLiteral("CH-900")));
}

TEST_F(ScoringPages, ADeadlineIsSetWithTheRequestAndRemindersAreCopied) {
  open();
  press("Invite raters", [](QDialog& dialog) {
    dialog.findChild<DataTable*>()->view().selectAll();
    EXPECT_FALSE(child<QDateEdit>(dialog, "due").isEnabled()) << "no deadline unless one is wanted";
    child<QCheckBox>(dialog, "limited").setChecked(true);
    child<QDateEdit>(dialog, "due").setDate(QDate(2036, 5, 31));
    buttonOf(dialog, "Ask")->click();
  });

  const std::int64_t due_us = QDate(2036, 5, 31).endOfDay().toMSecsSinceEpoch() * 1000;
  std::size_t limited = 0;
  for (const Cohort& cohort : StudyRepository(centre_.connection()).cohorts()) {
    for (const AssignmentStatus& one : SheetRepository(centre_.connection()).assignments(cohort.id)) {
      limited += one.assignment.dueUtc_us == due_us ? 1 : 0;
    }
  }
  EXPECT_GT(limited, 0U);
  buttonOf(*page_, "Copy reminders")->click();
  EXPECT_TRUE(QGuiApplication::clipboard()->text().contains(QStringLiteral("please submit in Torsio: case ")))
      << QGuiApplication::clipboard()->text().toStdString();
  EXPECT_EQ(selectAll(centre_.connection(), "SELECT action FROM audit_entry WHERE action = 'reminder.copy'",
                      {}, readText)
                .size(),
            static_cast<std::size_t>(QGuiApplication::clipboard()->text().count(QLatin1Char('\n')) + 1));
}

TEST_F(ScoringPages, SelectsRunsOfRaterCalibrationWithThePanelsMark) {
  Trial copy = TrialRepository(centre_.connection()).load(centre_.trialIds()[0]);
  TrialRepository repository(centre_.connection(), {.station = "station-7"});
  for (const char* id : {"11111111-2222-4333-8444-555555555555", "22222222-2222-4333-8444-555555555555"}) {
    copy.header.trialId = id;
    repository.begin(copy.header);
    for (const TrialChunk& chunk : copy.chunks) {
      repository.append(chunk);
    }
    repository.finish(copy.summary);
  }
  open();

  press("Rater calibration", [](QDialog& dialog) {
    auto& calibration = static_cast<RaterCalibrationDialog&>(dialog);
    EXPECT_EQ(child<DataTable>(calibration, "candidates").visibleRows(), 2);
    EXPECT_FALSE(buttonOf(dialog, "Add")->isEnabled());  // no selection
    for (const double mark : {4.1, 7.6}) {
      child<DataTable>(calibration, "candidates").view().selectRow(0);
      dialog.findChild<QDoubleSpinBox*>()->setValue(mark);
      dialog.findChild<QSpinBox*>()->setValue(8);
      buttonOf(dialog, "Add")->click();
    }
    EXPECT_EQ(child<DataTable>(calibration, "present").visibleRows(), 2);
    EXPECT_EQ(child<DataTable>(calibration, "candidates").visibleRows(), 0);
    buttonOf(dialog, "Close")->click();
  });

  const std::vector<ReferenceRow> rows = referenceRows(*administrator_);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_DOUBLE_EQ(rows[0].panel_points, 4.1);
  EXPECT_DOUBLE_EQ(rows[1].panel_points, 7.6);
  EXPECT_EQ(rows[1].panelRaters, 8);
  EXPECT_TRUE(reviewQueue(*centre_.physician(0)).calibrationWaiting);
}

TEST_F(ScoringPages, WithdrawsARunOfRaterCalibrationWithAReason) {
  addReferenceRuns(*administrator_, {{centre_.trialIds()[0], centre_.rubricRevisionId(), 6.2, 8, false}});
  open();

  press("Rater calibration", [](QDialog& dialog) {
    auto& calibration = static_cast<RaterCalibrationDialog&>(dialog);
    QPushButton* withdraw = buttonOf(dialog, "Withdraw");
    EXPECT_FALSE(withdraw->isEnabled());  // no selection
    child<DataTable>(calibration, "present").view().selectRow(0);
    QTimer::singleShot(0, &dialog, [] {
      QWidget* asked = QApplication::activeModalWidget();
      asked->findChild<QLineEdit*>(QStringLiteral("reason"))->setText(QStringLiteral("the panel erred"));
      buttonOf(*asked, "Withdraw a reference run")->click();
    });
    withdraw->click();
    EXPECT_TRUE(
        child<DataTable>(calibration, "present").asText().contains(QStringLiteral("the panel erred")));
    EXPECT_FALSE(withdraw->isEnabled());
    buttonOf(dialog, "Close")->click();
  });

  EXPECT_EQ(referenceRows(*administrator_)[0].withdrawnBecause, "the panel erred");
  EXPECT_TRUE(raterCalibration(*centre_.physician(0)).runs.empty());
}

}  // namespace

namespace {

TEST(ComparisonBars, UsesTheSameDecimalsThroughoutAComparison) {
  RowComparison row{
      .own = 1.0, .mean = 4.27, .lowest = 3.0, .highest = 5.5, .apart = true, .scale = {0, 100, 10}};
  ComparisonBars bars;

  bars.setRows({row});

  EXPECT_EQ(bars.accessibleDescription().toStdString(),
            "Overall: you 1.0; others 4.3, from 3.0 to 5.5; difference 3.3");
}

}  // namespace

}  // namespace torsio::gui
