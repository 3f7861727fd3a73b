// SPDX-License-Identifier: GPL-3.0-or-later
// The physician's pages, driven as a physician drives them: by keys.
#include <memory>

#include <QAbstractButton>
#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/case_page.h"
#include "app/gui/physician/discrepancy_review_page.h"
#include "app/gui/physician/evaluation_page.h"
#include "app/gui/physician/live_page.h"
#include "app/gui/physician/queue_page.h"
#include "app/gui/physician/rater_calibration_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/review_pages.h"
#include "app/gui/physician/severity_page.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/review/discrepancy_review.h"
#include "app/review/evaluation_form.h"
#include "app/review/rater_calibration.h"
#include "assessment/rating/campaign.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/record/sample_codec.h"
#include "tests/app/gui/desk_of.h"
#include "tests/app/gui/visible_texts.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {
namespace {

using torsio::testing::ReviewCentre;
using torsio::testing::reviewSheet;

/// Alignment and severity, as physician `index` sees them: no mark of anybody else.
void expectNothingOfOthers(ReviewCentre& centre, std::size_t index) {
  DeskOf desk(centre, index);
  EXPECT_TRUE(alignmentCases(desk.session()).empty());
  auto& alignment = desk.open<DiscrepancyReviewPage>();
  EXPECT_TRUE(paintedWordsOf(alignment).join(u' ').contains(QStringLiteral("No disagreement waits for you")));
  for (const DataTable* table : alignment.findChildren<DataTable*>()) {
    EXPECT_EQ(table->visibleRows(), 0);
  }
  auto& severity = desk.open<SeverityPage>();
  EXPECT_TRUE(paintedWordsOf(severity).join(u' ').contains(QStringLiteral("Nothing to compare yet")));
  for (const DataTable* table : severity.findChildren<DataTable*>()) {
    EXPECT_EQ(table->visibleRows(), 0);
  }
}

TEST(TenPhysicians, ScoreTheSameTrialsByKeysAndSeeNothingOfEachOther) {
  ReviewCentre::Setup setup;
  setup.raters = 10;
  setup.trainees = 3;
  ReviewCentre centre(setup);
  for (std::size_t rater = 0; rater < 10; ++rater) {
    DeskOf desk(centre, rater);
    if (rater > 0) {
      expectNothingOfOthers(centre, 0);
    }
    if (rater > 0) {
      expectNothingOfOthers(centre, rater);
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
  EXPECT_FALSE(alignmentCases(*centre.physician(0)).empty());
}

TEST(CasePage, LosesNoKeystrokeWhenItVanishes) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const QString id = inputOf(centre.cases(0).front());
  {
    DeskOf desk(centre, 0);
    desk.open<CasePage>(id);
    desk.press(Qt::Key_8);
    desk.press(Qt::Key_Down);
    desk.press(Qt::Key_6);
    desk.press(Qt::Key_Right);  // 6.5
    auto& page = static_cast<CasePage&>(desk.page());
    child<QPlainTextEdit>(page, "comment").setFocus();
    desk.type(QStringLiteral("calm"));

    desk.drop();
  }

  DeskOf again(centre, 0);
  const auto& page = again.open<CasePage>(id);

  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 80);
  EXPECT_EQ(editorOf(page)->answer("accuracy").score_steps, 65);
  EXPECT_EQ(editorOf(page)->sheet().comment, "calm");
}

TEST(CasePage, ShowsAllTenScoresOnASmallScreen) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);

  auto& page = desk.open<CasePage>(inputOf(centre.caseAbout(0, 0)));
  QApplication::processEvents();

  const QList<QWidget*> scales = page.findChildren<QWidget*>(QStringLiteral("scale"));
  ASSERT_FALSE(scales.isEmpty());
  for (const QWidget* scale : scales) {
    const int right = scale->mapTo(&page, QPoint(scale->width(), 0)).x();
    EXPECT_LE(right, page.width());
    const QRect seen = scale->visibleRegion().boundingRect();
    EXPECT_TRUE(seen.isEmpty() || seen.width() == scale->width()) << seen.width() << " of " << scale->width();
  }
}

TEST(CasePage, UndoesToTheFirstMarkAndRedoes) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  desk.press(Qt::Key_8);
  desk.press(Qt::Key_Down);
  desk.press(Qt::Key_1);
  desk.press(Qt::Key_0);  // ten
  EXPECT_EQ(editorOf(page)->answer("accuracy").score_steps, 100);
  desk.press(Qt::Key_Backspace);

  desk.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editorOf(page)->answer("accuracy").score_steps, 100);
  for (int i = 0; i < 5; ++i) {
    desk.press(Qt::Key_Z, Qt::ControlModifier);
  }

  EXPECT_FALSE(editorOf(page)->answer("time").given());
  EXPECT_FALSE(editorOf(page)->canUndo());
  desk.press(Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 80);
  // What was undone is undone on the disk too.
  const OpenedSheet stored = openSheet(desk.session(), centre.cases(0).front());
  EXPECT_EQ(SheetEditor(stored.rubric, stored.sheet).answer("time").score_steps, 80);
}

TEST(CasePage, KeysAreSilentWhileTyping) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  child<ReplayPanel>(page, "replay").setRealTime(false);
  child<QPlainTextEdit>(page, "comment").setFocus();

  desk.type(QStringLiteral("b 7 jkl, n."));

  EXPECT_EQ(editorOf(page)->sheet().comment, "b 7 jkl, n.");
  EXPECT_FALSE(editorOf(page)->answer("time").given());
  EXPECT_FALSE(child<ReplayPanel>(page, "replay").playing());
  EXPECT_TRUE(caseRemarks(desk.session(), centre.cases(0).front()).empty());
}

TEST(CasePage, NotAssessableTakesAReason) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("hand in 5 the way"));
  desk.press(Qt::Key_Return);
  EXPECT_EQ(editorOf(page)->answer("time").notAssessableReason, "hand in 5 the way");

  desk.press(Qt::Key_Down);
  desk.press(Qt::Key_4);

  EXPECT_EQ(editorOf(page)->answer("accuracy").score_steps, 40);
}

TEST(CasePage, EscAfterNKeepsTheScore) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  desk.press(Qt::Key_7);
  desk.press(Qt::Key_N);
  desk.press(Qt::Key_Escape);
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);

  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("slip of the hand"));
  EXPECT_FALSE(editorOf(page)->answer("time").score_steps);
  desk.press(Qt::Key_Escape);

  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);
  EXPECT_TRUE(editorOf(page)->answer("time").notAssessableReason.empty());
}

TEST(CasePage, TabStaysInTheSheetAndFiguresGoOnScoring) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  for (int i = 0; i < 4; ++i) {  // time, accuracy, overall, comment, and round
    desk.press(Qt::Key_Tab);
  }
  desk.press(Qt::Key_5);
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 50);

  desk.press(Qt::Key_Backtab, Qt::ShiftModifier);  // the comment
  desk.press(Qt::Key_Backtab, Qt::ShiftModifier);
  desk.press(Qt::Key_6);
  EXPECT_EQ(editorOf(page)->answer(kOverallRow).score_steps, 60);
}

TEST(CasePage, TellsWhatTheExerciseAsksForAndNothingOfWhoseItIs) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));

  const QString task = child<QLabel>(page, "task").text();

  EXPECT_TRUE(task.contains(QStringLiteral("Twist to 90°"))) << task.toStdString();
  EXPECT_TRUE(task.contains(QStringLiteral("±2°"))) << task.toStdString();
  for (const std::string& secret : centre.secrets()) {
    EXPECT_FALSE(task.contains(QString::fromStdString(secret))) << secret;
  }
}

TEST(CasePage, SubmitsOnlyWhatIsCompleteAndWatched) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  child<ReplayPanel>(page, "replay").setRealTime(false);
  const auto state = [&] { return openSheet(desk.session(), centre.cases(0).front()).state; };
  desk.press(Qt::Key_7);
  for (int i = 0; i < 3; ++i) {
    desk.press(Qt::Key_Return, Qt::ControlModifier);
  }
  EXPECT_EQ(state(), SheetState::kDraft);
  EXPECT_EQ(child<SheetPanel>(page, "sheetPanel").currentRow(), "accuracy");  // the first open row
  desk.press(Qt::Key_7);
  desk.press(Qt::Key_Down);
  desk.press(Qt::Key_7);
  child<ReplayPanel>(page, "replay").seek_us(1'900'000);  // a jump is not watching
  for (int i = 0; i < 3; ++i) {
    desk.press(Qt::Key_Return, Qt::ControlModifier);
  }
  EXPECT_EQ(state(), SheetState::kDraft);

  child<ReplayPanel>(page, "replay").seek_us(0);
  desk.press(Qt::Key_L);
  EXPECT_TRUE(child<ReplayPanel>(page, "replay").playing());
  desk.press(Qt::Key_L);  // locked: no faster
  EXPECT_DOUBLE_EQ(child<ReplayPanel>(page, "replay").recording()->playback.speed(), 1.0);
  watchAll(child<ReplayPanel>(page, "replay"));
  for (int i = 0; i < 2; ++i) {
    desk.press(Qt::Key_Return, Qt::ControlModifier);
  }

  EXPECT_EQ(state(), SheetState::kSubmitted);
}

TEST(CasePage, ClearsTheSheetInOneStepThatUndoTakesBack) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  desk.press(Qt::Key_7);
  ASSERT_EQ(editorOf(page)->answer("time").score_steps, 70);

  page.findChild<QToolButton*>(QStringLiteral("clearSheet"))->click();

  EXPECT_FALSE(editorOf(page)->answer("time").given());
  desk.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);
}

TEST(CasePage, GoesOnAfterAFigureWhereThatIsWanted) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  auto& sheet = child<SheetEditorPanel>(page, "sheetPanel");
  const std::vector<std::string> rows = editorOf(page)->order();
  ASSERT_GE(rows.size(), 3U);
  desk.press(Qt::Key_7);
  EXPECT_EQ(sheet.currentRow(), rows[0]);  // unless it is asked for, nothing moves
  child<QToolButton>(page, "advance").click();

  desk.press(Qt::Key_6);
  EXPECT_EQ(sheet.currentRow(), rows[1]);
  desk.press(Qt::Key_1);
  EXPECT_EQ(sheet.currentRow(), rows[1]);  // it may become a ten
  desk.press(Qt::Key_0);
  EXPECT_EQ(sheet.currentRow(), rows[2]);
  desk.press(Qt::Key_1);
  desk.press(Qt::Key_Up);
  desk.press(Qt::Key_1);
  desk.press(Qt::Key_4);

  const SheetEditor& editor = *editorOf(page);
  const auto points = [&](std::size_t row) {
    const std::int64_t steps = editor.answer(rows[row]).score_steps.value_or(0);
    return steps / editor.scale(rows[row]).stepsPerPoint;
  };
  EXPECT_EQ(points(0), 6);
  EXPECT_EQ(points(1), 1);
  EXPECT_EQ(points(2), 4);  // the four was the next row's, not a fourteen
  child<QToolButton>(page, "advance").click();
  EXPECT_FALSE(sheet.advancing());
}

TEST(CasePage, BookmarksRemarksAndSteps) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  child<ReplayPanel>(page, "replay").setRealTime(false);
  desk.press(Qt::Key_Period);
  desk.press(Qt::Key_Period);
  desk.press(Qt::Key_B);
  desk.press(Qt::Key_Comma);
  desk.press(Qt::Key_R);
  desk.type(QStringLiteral("second grip slips"));
  desk.press(Qt::Key_Return);

  const std::vector<CaseRemark> remarks = caseRemarks(desk.session(), centre.cases(0).front());

  ASSERT_EQ(remarks.size(), 2U);
  EXPECT_EQ(remarks[0].time_us, 40'000);
  EXPECT_EQ(remarks[0].text, "second grip slips");
  EXPECT_EQ(remarks[1].time_us, 80'000);

  desk.press(Qt::Key_R, Qt::ShiftModifier);
  auto& field = child<QLineEdit>(page, "remarkField");
  EXPECT_EQ(field.text(), QStringLiteral("second grip slips"));
  field.setText(QStringLiteral("the <b>second</b> grip"));
  desk.press(Qt::Key_Return);

  const CaseRemark edited = caseRemarks(desk.session(), centre.cases(0).front()).front();
  EXPECT_EQ(edited.text, "the <b>second</b> grip");
  EXPECT_EQ(edited.time_us, 40'000);
  ASSERT_EQ(edited.earlier.size(), 1U);
  auto& listed = child<QLabel>(page, "remarks");
  EXPECT_TRUE(listed.text().contains(QStringLiteral("the &lt;b&gt;second&lt;/b&gt; grip (edited)")));
  EXPECT_TRUE(listed.toolTip().contains(QStringLiteral("second grip slips")));
  Q_EMIT listed.linkActivated(QString::fromStdString(edited.id));
  EXPECT_EQ(field.text(), QStringLiteral("the <b>second</b> grip"));
  desk.press(Qt::Key_Escape);
  EXPECT_EQ(caseRemarks(desk.session(), centre.cases(0).front()).front().earlier.size(), 1U);
}

TEST(CasePage, TheOverallMarkIsSeenWithoutScrollingAndRowsAreSliders) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  page.resize(1146, 420);  // less than a screen of 768 lines leaves it
  QApplication::processEvents();

  const ScoreRow* overall = nullptr;
  for (ScoreRow* row : page.findChildren<ScoreRow*>()) {
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(row);
    ASSERT_NE(told, nullptr);
    EXPECT_EQ(told->role(), QAccessible::Slider);
    EXPECT_TRUE(told->text(QAccessible::Value).contains(QStringLiteral("1 to 10")))
        << told->text(QAccessible::Value).toStdString();
    if (row->code() == kOverallRow) {
      overall = row;
    }
  }
  ASSERT_NE(overall, nullptr);
  for (const QScrollArea* area : page.findChildren<QScrollArea*>()) {
    EXPECT_FALSE(area->isAncestorOf(overall));
  }
  const QRect shown(overall->mapTo(&page, QPoint(0, 0)), overall->size());
  EXPECT_TRUE(page.rect().contains(shown)) << shown.bottom() << " of " << page.height();
}

TEST(CasePage, AmendingNeedsAReasonAndKeepsBothVersions) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const std::string id = centre.cases(0).front();
  desk.open<CasePage>(inputOf(id));
  scoreCase(desk, 7, 6, 6);
  auto& page = desk.open<CasePage>(inputOf(id));
  desk.press(Qt::Key_9);  // sealed: nothing happens
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);
  for (QPushButton* button : page.findChildren<QPushButton*>()) {
    if (button->text().contains(QStringLiteral("mend")) && button->isVisibleTo(&page)) {
      button->click();
    }
  }
  desk.press(Qt::Key_9);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(desk.failures().size(), 1);  // no reason yet
  EXPECT_EQ(sheetVersions(desk.session(), id).size(), 1U);

  desk.type(QStringLiteral("looked again"));
  desk.press(Qt::Key_Return, Qt::ControlModifier);

  const std::vector<SheetVersion> versions = sheetVersions(desk.session(), id);
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(versions[1].amendReason, "looked again");
  auto& again = desk.open<CasePage>(inputOf(id));
  bool told = false;
  for (const QLabel* label : again.findChildren<QLabel*>()) {
    told = told || (label->text().contains(QStringLiteral("version 2")) &&
                    label->toolTip().contains(QStringLiteral("looked again")));
  }
  EXPECT_TRUE(told);
  const OpenedSheet sealed = openSheet(desk.session(), id);
  EXPECT_EQ(SheetEditor(sealed.rubric, sealed.sheet).answer("time").score_steps, 90);
}

TEST(CasePage, PlaysTheRecordingBitForBitAndProvesIt) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const std::string id = centre.caseAbout(0, 0);
  auto& page = desk.open<CasePage>(inputOf(id));
  const Trial original = TrialRepository(centre.connection()).load(centre.trialIds()[0]);

  ASSERT_NE(child<ReplayPanel>(page, "replay").recording(), nullptr);
  const std::vector<TrialChunk>& played = child<ReplayPanel>(page, "replay").recording()->playback.chunks();
  ASSERT_EQ(played.size(), original.chunks.size());
  for (std::size_t i = 0; i < played.size(); ++i) {
    EXPECT_EQ(played[i].bytes, original.chunks[i].bytes);
    EXPECT_EQ(played[i].outputDigest, original.chunks[i].outputDigest);
  }
  // And what the window shows at any instant is the sample of that instant.
  const std::vector<Sample> samples = decodeTrial(original);
  for (std::size_t at = 0; at < samples.size(); at += 97) {
    child<ReplayPanel>(page, "replay").seek_us(samples[at].device.time_us - samples.front().device.time_us);
    const LiveState shown = child<ReplayPanel>(page, "replay").recording()->playback.state();
    EXPECT_EQ(shown.tick, samples[at].tick);
    EXPECT_EQ(shown.response, samples[at].response);
  }

  const QString digest = toQString(blindedDigest(original.summary.contentHash, id));
  bool shown = false;
  for (const QLabel* label : page.findChildren<QLabel*>()) {
    shown = shown || label->text().contains(digest);
  }
  EXPECT_TRUE(shown);
}

TEST(ReviewPages, EverythingThatTakesTheKeyboardHasANameAndFitsASmallScreen) {
  ReviewCentre::Setup setup;
  setup.live = true;
  ReviewCentre centre(setup);
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

TEST(CasePage, FitsASmallScreenInEveryState) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  applyTheme(*qApp, theme(ThemeKind::kLight));
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  const auto height = [&page] {
    QApplication::processEvents();
    return page.minimumSizeHint().height();
  };
  // What 768 lines leave beside the frame of the window, the header, a bar of the desktop and the panel that
  // tells of work in progress.
  constexpr int kLeft_px = 560;
  EXPECT_LE(height(), kLeft_px);
  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("hand in the way"));
  desk.press(Qt::Key_Return);
  desk.press(Qt::Key_R);
  EXPECT_LE(height(), kLeft_px) << "while a remark is written";
  desk.type(QStringLiteral("second grip slips"));
  desk.press(Qt::Key_Return);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_LE(height(), kLeft_px) << "while it asks whether to submit";
  EXPECT_LE(page.minimumSizeHint().width(), 1146);
}

TEST(LivePage, ScoresInRunningOrderWithTargetsForFingers) {
  ReviewCentre::Setup setup;
  setup.trainees = 10;
  setup.live = true;
  setup.trial_s = 0.5;
  ReviewCentre centre(setup);
  DeskOf desk(centre, 0);
  applyTheme(*qApp, theme(ThemeKind::kLight));  // the style sheet has a say in sizes
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

  for (int i = 0; i < 2; ++i) {
    desk.press(Qt::Key_6);
    desk.press(Qt::Key_Down);
    desk.press(Qt::Key_7);
    desk.press(Qt::Key_Down);
    desk.press(digit(5 + i));
    desk.press(Qt::Key_Return, Qt::ControlModifier);
    desk.press(Qt::Key_Return, Qt::ControlModifier);
  }

  const std::vector<AssignmentId> live = centre.cases(0, true);
  EXPECT_EQ(openSheet(desk.session(), live[0]).sheet.overall_steps, 50);
  EXPECT_EQ(openSheet(desk.session(), live[1]).sheet.overall_steps, 60);
  EXPECT_EQ(openSheet(desk.session(), live[1]).state, SheetState::kSubmitted);
  EXPECT_EQ(openSheet(desk.session(), live[2]).state, SheetState::kOpen);
}

TEST(RaterCalibrationPage, ShowsTheOwnOffsetAfterTheMark) {
  ReviewCentre centre(ReviewCentre::Setup{});
  addReferenceRuns(*centre.administrator(),
                   {{centre.trialIds()[0], centre.rubricRevisionId(), 6.0, 5, false}});
  DeskOf desk(centre, 0);
  auto& page = desk.open<RaterCalibrationPage>();
  EXPECT_FALSE(wordsOf(page).join(u' ').contains(QStringLiteral("Panel of 5")));

  desk.press(Qt::Key_8);
  desk.press(Qt::Key_Return, Qt::ControlModifier);

  EXPECT_TRUE(wordsOf(page).join(u' ').contains(QStringLiteral("Panel of 5")));
  EXPECT_DOUBLE_EQ(*warmUp(desk.session()).runs[0].offset_points, 2.0);
}

TEST(RaterCalibrationPage, HasScoreButtonsThatAFingerOrAMouseHits) {
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
}

TEST(DiscrepancyReviewPage, MovesAMarkWithAReasonAndKeepsTheOther) {
  ReviewCentre::Setup setup;
  setup.trainees = 1;
  ReviewCentre centre(setup);
  for (std::size_t rater = 0; rater < 2; ++rater) {
    DeskOf scorer(centre, rater);
    scorer.open<CasePage>(inputOf(centre.caseAbout(rater, 0)));
    scoreCase(scorer, 3 + 5 * static_cast<int>(rater), 3 + 5 * static_cast<int>(rater),
              3 + 5 * static_cast<int>(rater));
  }
  DeskOf desk(centre, 0);
  ASSERT_EQ(alignmentCases(desk.session()).size(), 1U);
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
  EXPECT_EQ(desk.failures().size(), 1);  // no reason yet

  for (QLineEdit* line : page.findChildren<QLineEdit*>()) {
    if (line->accessibleName() == QStringLiteral("Reason")) {
      line->setFocus();
    }
  }
  desk.type(QStringLiteral("missed the second grip"));
  button("Seal")->click();

  EXPECT_EQ(sheetVersions(desk.session(), centre.caseAbout(0, 0)).size(), 2U);
  ASSERT_EQ(alignmentCases(desk.session()).size(), 1U);  // two rows still lie apart
  EXPECT_EQ(alignmentCases(desk.session())[0].decision, DiscrepancyChoice::kMove);
}

TEST(EvaluationPage, FillsNineIndicesByKeysAndKeepsTheDraft) {
  ReviewCentre centre(ReviewCentre::Setup{});
  Campaign campaign;
  campaign.id = "campaign";
  campaign.name = "Three models";
  campaign.instrument = paperInstrument();
  campaign.instrument.classes = {{"chief", "chief physicians", 1000}};
  campaign.models = {{"PM", "proposed model", "K", 1}, {"FEM", "finite elements", "M", 2}};
  campaign.raters = {{centre.raterId(0), "chief", "FEM,PM"}};
  EvaluationRepository(centre.connection()).addCampaign(campaign);
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
      desk.press(digit(i + 4));
      desk.press(Qt::Key_Down);
    }
    EXPECT_TRUE(definition.text().contains(QStringLiteral("twisted shape"))) << "of fidelity";
    desk.press(Qt::Key_1);
    desk.press(Qt::Key_0);
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
    desk.press(Qt::Key_7);
    desk.press(Qt::Key_Down);
  }
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  desk.press(Qt::Key_Return, Qt::ControlModifier);

  const EvaluationForm form = evaluationForms(desk.session())[0];
  EXPECT_TRUE(form.models[0].submitted);
  EXPECT_EQ(form.models[0].hiddenLabel, "M");
  EXPECT_FALSE(form.models[1].submitted);
}

}  // namespace
}  // namespace torsio::gui
