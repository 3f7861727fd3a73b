// SPDX-License-Identifier: GPL-3.0-or-later
// The physician's other pages, and ten physicians one after another. Scoring for administrators, with real
// widgets: an adjudicator in two clicks, the runs of rater calibration.

#include <algorithm>
#include <memory>

#include <QAbstractButton>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDateEdit>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/gui/administrator/scoring/rater_calibration_dialog.h"
#include "app/gui/administrator/scoring/scoring_page.h"
#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/physician/case_page.h"
#include "app/gui/physician/discrepancy_review_page.h"
#include "app/gui/physician/evaluation_page.h"
#include "app/gui/physician/live_page.h"
#include "app/gui/physician/rater_calibration_page.h"
#include "app/gui/physician/review_pages.h"
#include "app/gui/physician/severity_page.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/centre_settings.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/evaluation_form.h"
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
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::ReviewCentre;

/// Alignment and severity as shown to physician `index`: nobody else's marks.
void expectOnlyOwnMarks(ReviewCentre& centre, std::size_t index) {
  DeskOf desk(centre, index);
  EXPECT_TRUE(discrepancyCases(desk.session()).empty());
  auto& discrepancies = desk.open<DiscrepancyReviewPage>();
  EXPECT_TRUE(paintedWordsOf(discrepancies)
                  .join(u' ')
                  .contains(QStringLiteral("No disagreements are waiting for you")));
  for (const DataTable* table : discrepancies.findChildren<DataTable*>()) {
    EXPECT_EQ(table->visibleRows(), 0);
  }
  auto& severity = desk.open<SeverityPage>();
  EXPECT_TRUE(paintedWordsOf(severity).join(u' ').contains(QStringLiteral("Nothing to compare yet")));
  for (const DataTable* table : severity.findChildren<DataTable*>()) {
    EXPECT_EQ(table->visibleRows(), 0);
  }
}

TEST(TenPhysicians, ScoreTheSameTrialsByKeysAndSeeNothingOfEachOther) {
  ReviewCentre centre({.raters = 10, .trainees = 3});
  for (std::size_t rater = 0; rater < 10; ++rater) {
    DeskOf desk(centre, rater);
    if (rater > 0) {
      expectOnlyOwnMarks(centre, 0);
    }
    if (rater > 0) {
      expectOnlyOwnMarks(centre, rater);
    }
    desk.open<CasePage>(inputOf(centre.cases(rater).front()));
    int done = 0;
    do {
      scoreCase(desk, 2 + static_cast<int>(rater) % 8, 5, 3 + done);
      ++done;
    } while (desk.follow());
    EXPECT_EQ(done, 3);
    EXPECT_TRUE(desk.failures().isEmpty()) << desk.failures().join(u' ').toStdString();
  }
  for (std::size_t rater = 0; rater < 10; ++rater) {
    const auto desk = centre.physician(rater);
    const std::vector<AssignmentId> ids = centre.cases(rater);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const OpenedSheet sealed = openSheet(*desk, ids[i]);
      EXPECT_EQ(sealed.state, SheetState::kSubmitted);
      EXPECT_EQ(sealed.sheet.overall_steps, 10 * static_cast<std::int64_t>(3 + i));
      EXPECT_EQ(SheetEditor(sealed.rubric, sealed.sheet).answer("time").score_steps,
                10 * static_cast<std::int64_t>(2 + rater % 8));
    }
  }
  EXPECT_FALSE(discrepancyCases(*centre.physician(0)).empty());
}

TEST(ReviewPages, EverythingFocusableHasANameAndFitsASmallScreen) {
  ReviewCentre centre({.live = true});
  addReferenceRuns(*centre.administrator(),
                   {{centre.trialIds()[0], centre.rubricRevisionId(), 6.0, 5, false}});
  applyTheme(*qApp, theme(ThemeKind::kLight));
  DeskOf desk(centre, 0);
  for (const PageEntry& entry : reviewPages()) {
    const std::unique_ptr<Page> page(entry.make(desk.shell()));
    page->retranslate();
    page->resize(1146, 700);
    page->show();
    page->enter(entry.id == PageId::kCase ? inputOf(centre.cases(0)[0]) : QVariant());
    desk.shell().waitForJobs();
    EXPECT_LE(page->minimumSizeHint().width(), 1146) << pageText(entry.id).toStdString();
    EXPECT_LE(page->minimumSizeHint().height(), 580) << pageText(entry.id).toStdString();
    for (QWidget* widget : page->findChildren<QWidget*>()) {
      const bool reachable = (widget->focusPolicy() & Qt::TabFocus) != 0 && widget->isVisible();
      if (!reachable) {
        continue;
      }
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      const bool named =
          !widget->accessibleName().isEmpty() || (button != nullptr && !button->text().isEmpty());
      EXPECT_TRUE(named) << pageText(entry.id).toStdString() << ": " << widget->metaObject()->className();
    }
  }
}

TEST(LivePage, ScoresInRunningOrderWithTouchTargets) {
  ReviewCentre centre({.trainees = 10, .trial_s = 0.5, .live = true});
  DeskOf desk(centre, 0);
  applyTheme(*qApp, theme(ThemeKind::kLight));  // the style sheet affects sizes
  auto& page = desk.open<LivePage>();
  QApplication::processEvents();
  int targets = 0;
  for (const QAbstractButton* button : page.findChildren<QAbstractButton*>()) {
    if (!button->isVisibleTo(&page)) {
      continue;
    }
    EXPECT_GE(button->height(), 44) << button->text().toStdString();
    if (button->isCheckable()) {
      ++targets;
    }
  }
  EXPECT_EQ(targets, 10);

  const std::vector<AssignmentId> live = centre.cases(0, true);
  for (int i = 0; i < 2; ++i) {
    const QString late = toQString(openSheet(desk.session(), live[static_cast<std::size_t>(i)]).shown.label);
    for (QToolButton* button : page.findChildren<QToolButton*>()) {
      if (button->text().contains(late)) {
        button->click();
        break;
      }
    }
    desk.press({Qt::Key_6, Qt::Key_Down, Qt::Key_7, Qt::Key_Down, digit(5 + i)});
    desk.finish(2);
  }

  EXPECT_EQ(openSheet(desk.session(), live[0]).sheet.overall_steps, 50);
  EXPECT_EQ(openSheet(desk.session(), live[1]).sheet.overall_steps, 60);
  EXPECT_EQ(openSheet(desk.session(), live[1]).state, SheetState::kSubmitted);
  EXPECT_EQ(openSheet(desk.session(), live[2]).state, SheetState::kOpen);
}

TEST(RaterCalibrationPage, ShowsOnesOwnOffsetAfterTheMark) {
  ReviewCentre centre(ReviewCentre::Setup{});
  addReferenceRuns(*centre.administrator(),
                   {{centre.trialIds()[0], centre.rubricRevisionId(), 6.0, 5, false}});
  DeskOf desk(centre, 0);
  auto& page = desk.open<RaterCalibrationPage>();
  EXPECT_FALSE(wordsOf(page).join(u' ').contains(QStringLiteral("Panel of 5")));

  desk.press(Qt::Key_8);
  desk.press(Qt::Key_Return, Qt::ControlModifier);

  EXPECT_TRUE(wordsOf(page).join(u' ').contains(QStringLiteral("Panel of 5")));
  EXPECT_DOUBLE_EQ(*raterCalibration(desk.session()).runs[0].offset_points, 2.0);
}

TEST(RaterCalibrationPage, HasScoreButtonsLargeEnoughForFingerAndMouse) {
  constexpr int kLeast_px = 32;
  constexpr int kButtons = 10;  // the paper's scale from 1 to 10
  ReviewCentre centre(ReviewCentre::Setup{});
  addReferenceRuns(*centre.administrator(),
                   {{centre.trialIds()[0], centre.rubricRevisionId(), 6.0, 5, false}});
  DeskOf desk(centre, 0);

  auto& page = desk.open<RaterCalibrationPage>();
  QApplication::processEvents();

  const auto& scale = child<QWidget>(page, "scale");
  EXPECT_GE(scale.width(), kButtons * kLeast_px);
  EXPECT_GE(scale.height(), kLeast_px);
  EXPECT_EQ(scale.visibleRegion().boundingRect(), scale.rect());
  const auto& sheet = *page.findChild<SheetPanel*>();
  EXPECT_LT(sheet.height(), 3 * scale.height()) << "one row leaves the room to the rubric";
}

TEST(DiscrepancyReviewPage, ChangesAMarkWithAReasonAndKeepsTheOther) {
  ReviewCentre centre({.trainees = 1});
  for (std::size_t rater = 0; rater < 2; ++rater) {
    DeskOf scorer(centre, rater);
    scorer.open<CasePage>(inputOf(centre.caseAbout(rater, 0)));
    scoreCase(scorer, 3 + 5 * static_cast<int>(rater), 3 + 5 * static_cast<int>(rater),
              3 + 5 * static_cast<int>(rater));
  }
  DeskOf desk(centre, 0);
  ASSERT_EQ(discrepancyCases(desk.session()).size(), 1U);
  auto& page = desk.open<DiscrepancyReviewPage>();
  const auto button = [&page](const char* part) {
    for (QPushButton* one : page.findChildren<QPushButton*>()) {
      if (one->text().contains(QLatin1String(part)) && one->isVisibleTo(&page)) {
        return one;
      }
    }
    return static_cast<QPushButton*>(nullptr);
  };
  ASSERT_NE(button("with a reason"), nullptr);
  button("with a reason")->click();
  desk.press(Qt::Key_8);
  ASSERT_NE(button("Seal"), nullptr);
  button("Seal")->click();
  const auto saidAtTheField = [&page] {
    const QList<QLabel*> labels = page.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(), [&page](const QLabel* label) {
      return label->isVisibleTo(&page) && label->text().startsWith(QLatin1String("A reason is needed"));
    });
  };
  EXPECT_TRUE(saidAtTheField());
  EXPECT_TRUE(desk.failures().isEmpty());  // close to it

  for (QLineEdit* line : page.findChildren<QLineEdit*>()) {
    if (line->accessibleName() == QStringLiteral("Reason")) {
      line->setFocus();
    }
  }
  desk.type(QStringLiteral("missed the second grip"));
  EXPECT_FALSE(saidAtTheField());
  button("Seal")->click();

  EXPECT_EQ(sheetVersions(desk.session(), centre.caseAbout(0, 0)).size(), 2U);
  ASSERT_EQ(discrepancyCases(desk.session()).size(), 1U);  // two rows are still discrepant
  EXPECT_EQ(discrepancyCases(desk.session())[0].decision, DiscrepancyChoice::kMove);
}

TEST(ReviewPages, RepeatMessagesInTheLanguageChosenLast) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(false);
  DeskOf desk(centre, 0);
  const auto follows = [&](Page& page, const char* sentence) {
    const QString english = QString::fromLatin1(sentence);
    EXPECT_TRUE(wordsOf(page).contains(english)) << sentence;
    LanguageSwitch language;
    language.choose(Language::kSimplifiedChinese);
    page.retranslate();
    EXPECT_FALSE(wordsOf(page).contains(english)) << sentence;
    language.choose(Language::kEnglish);
    page.retranslate();
    EXPECT_TRUE(wordsOf(page).contains(english)) << sentence;
  };
  auto& scored = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  desk.press(Qt::Key_8);
  follows(scored, "Saved");
  follows(desk.open<CasePage>(inputOf(centre.cases(0).front())), "Draft found and opened");

  auto& evaluated = desk.open<EvaluationPage>();
  desk.press(Qt::Key_8);
  follows(evaluated, "Saved");
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  follows(evaluated, "Still open: 8 of 9");
}

TEST(EvaluationPage, FitsASmallScreenWithARecording) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(true);
  DeskOf desk(centre, 0);
  applyTheme(*qApp, theme(ThemeKind::kLight));
  auto& page = desk.open<EvaluationPage>();
  ASSERT_TRUE(QTest::qWaitFor([&] { return child<QLabel>(page, "task").isVisible(); }, 20'000));

  EXPECT_LE(page.minimumSizeHint().width(), 1146);
  EXPECT_LE(page.minimumSizeHint().height(), 650);
}

TEST(EvaluationPage, FillsNineIndicesByKeysAndKeepsTheDraft) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(false);
  {
    DeskOf desk(centre, 0);
    auto& page = desk.open<EvaluationPage>();
    const QString all = wordsOf(page).join(u' ');
    for (const char* hidden : {"FEM", "PM", "finite", "proposed"}) {
      EXPECT_FALSE(all.contains(QLatin1String(hidden))) << hidden;
    }
    const auto& definition = child<QLabel>(page, "definition");
    EXPECT_TRUE(definition.text().contains(QStringLiteral("prepares for twisting")));
    EXPECT_TRUE(all.contains(QStringLiteral("10: prepares as well as the real thing")));
    EXPECT_TRUE(all.contains(QStringLiteral("There is no recording of this model here")));
    for (int i = 0; i < 5; ++i) {
      desk.press({digit(i + 4), Qt::Key_Down});
    }
    EXPECT_TRUE(definition.text().contains(QStringLiteral("twisted shape"))) << "of fidelity";
    desk.press({Qt::Key_1, Qt::Key_0});
    desk.press(Qt::Key_Left, Qt::ShiftModifier);  // 9.9
    desk.drop();
  }
  DeskOf desk(centre, 0);
  desk.open<EvaluationPage>();
  EXPECT_EQ(evaluationForms(desk.session())[0].models[0].scores[5], 99);
  for (int i = 0; i < 6; ++i) {
    desk.press(Qt::Key_Down);
  }
  for (int i = 0; i < 3; ++i) {
    desk.press({Qt::Key_7, Qt::Key_Down});
  }
  desk.finish(2);

  const EvaluationForm form = evaluationForms(desk.session())[0];
  EXPECT_TRUE(form.models[0].submitted);
  EXPECT_EQ(form.models[0].hiddenLabel, "M");
  EXPECT_FALSE(form.models[1].submitted);
}

TEST(EvaluationPage, AHastyCtrlEnterDoesNotReachTheNextModel) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(false);
  DeskOf desk(centre, 0);
  const EvaluationForm empty = evaluationForms(desk.session())[0];
  for (const EvaluationFormModel& model : empty.models) {  // ready to seal
    for (std::size_t i = 0; i < model.scores.size(); ++i) {
      saveEvaluationScore(desk.session(), empty.campaignId, model.hiddenLabel, i, 70);
    }
  }
  desk.open<EvaluationPage>();
  const auto sealed = [&] {
    const EvaluationForm form = evaluationForms(desk.session())[0];
    return std::count_if(form.models.begin(), form.models.end(),
                         [](const EvaluationFormModel& model) { return model.submitted; });
  };
  desk.finish(2);
  ASSERT_EQ(sealed(), 1);

  desk.finish(3);
  EXPECT_TRUE(desk.notices().join(u' ').contains(QStringLiteral("This is the next model")));
  EXPECT_EQ(sealed(), 1);

  desk.press(Qt::Key_Down);
  desk.finish(2);
  EXPECT_EQ(sealed(), 2);
}

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
  setCentreSetting<kPanelWaits>(*centre_.administrator(), false);  // their queues are longer
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
      child<QLineEdit>(*asked, "reason").setText(QStringLiteral("the panel erred"));
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
