// SPDX-License-Identifier: GPL-3.0-or-later
// A case at the review desk: its recording, its sheet, and the keys of both. Ten cases in ten minutes, by
// keyboard alone: every key press is simulated and counted. Its time is estimated by the keystroke-level
// model (Card, Moran and Newell 1980): 1.35 s to decide, 0.28 s to press.

#include "app/gui/physician/case_page.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <QAccessible>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/physician/queue_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/physician/trace_view.h"
#include "app/gui/widgets/child.h"
#include "app/services/review/case_sheet.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/time_units.h"
#include "sim/record/sample_codec.h"
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::ReviewCentre;

/// The first case of the first physician, open at the desk.
class CaseAtTheDesk : public ::testing::Test {
 protected:
  ReviewCentre centre{ReviewCentre::Setup{}};
  DeskOf desk{centre, 0};
  CasePage& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
};

TEST(CasePage, LosesNoKeystrokeWhenItDisappears) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const QString id = inputOf(centre.cases(0).front());
  {
    DeskOf desk(centre, 0);
    desk.open<CasePage>(id);
    desk.press({Qt::Key_8, Qt::Key_Down, Qt::Key_6});
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

TEST_F(CaseAtTheDesk, UndoesToTheFirstMarkAndRedoes) {
  desk.press({Qt::Key_8, Qt::Key_Down, Qt::Key_1});
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
  // Undo is stored, too.
  const OpenedSheet stored = openSheet(desk.session(), centre.cases(0).front());
  EXPECT_EQ(SheetEditor(stored.rubric, stored.sheet).answer("time").score_steps, 80);
}

TEST_F(CaseAtTheDesk, ShowsTheMomentOfTheReplayLikeABookmarkThere) {
  auto& replay = child<ReplayPanel>(page, "replay");
  const auto& time = child<QLabel>(replay, "time");

  replay.seek_us(1'960'000);
  EXPECT_TRUE(time.text().startsWith(QStringLiteral("0:02.0 of 0:0"))) << time.text().toStdString();
  replay.seek_us(std::numeric_limits<std::int64_t>::max());
  const QStringList end = time.text().split(QStringLiteral(" of "));
  ASSERT_EQ(end.size(), 2);
  EXPECT_EQ(end[0], end[1]);
}

TEST_F(CaseAtTheDesk, IgnoresItsKeysWhileTyping) {
  child<ReplayPanel>(page, "replay").setRealTime(false);
  child<QPlainTextEdit>(page, "comment").setFocus();

  desk.type(QStringLiteral("b 7 jkl, n."));

  EXPECT_EQ(editorOf(page)->sheet().comment, "b 7 jkl, n.");
  EXPECT_FALSE(editorOf(page)->answer("time").given());
  EXPECT_FALSE(child<ReplayPanel>(page, "replay").playing());
  EXPECT_TRUE(caseRemarks(desk.session(), centre.cases(0).front()).empty());
}

TEST_F(CaseAtTheDesk, NotAssessableNeedsAReason) {
  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("hand in 5 the way"));
  desk.press(Qt::Key_Return);
  EXPECT_EQ(editorOf(page)->answer("time").notAssessableReason, "hand in 5 the way");

  desk.press({Qt::Key_Down, Qt::Key_4});

  EXPECT_EQ(editorOf(page)->answer("accuracy").score_steps, 40);
}

TEST_F(CaseAtTheDesk, EscAfterNKeepsTheScore) {
  desk.press({Qt::Key_7, Qt::Key_N, Qt::Key_Escape});
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);

  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("slip of the hand"));
  EXPECT_FALSE(editorOf(page)->answer("time").score_steps);
  desk.press(Qt::Key_Escape);

  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);
  EXPECT_TRUE(editorOf(page)->answer("time").notAssessableReason.empty());
}

TEST_F(CaseAtTheDesk, TabStaysInTheSheetAndDigitsKeepScoring) {
  for (int i = 0; i < 4; ++i) {  // time, accuracy, overall, comment, and back to the start
    desk.press(Qt::Key_Tab);
  }
  desk.press(Qt::Key_5);
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 50);

  desk.press(Qt::Key_Backtab, Qt::ShiftModifier);  // the comment
  desk.press(Qt::Key_Backtab, Qt::ShiftModifier);
  desk.press(Qt::Key_6);
  EXPECT_EQ(editorOf(page)->answer(kOverallRow).score_steps, 60);
}

TEST_F(CaseAtTheDesk, ShowsTheTaskButNotWhoseRecordingItIs) {
  const QString task = child<QLabel>(page, "task").text();

  EXPECT_TRUE(task.contains(QStringLiteral("Twist to 90°"))) << task.toStdString();
  EXPECT_TRUE(task.contains(QStringLiteral("±2°"))) << task.toStdString();
  for (const std::string& secret : centre.secrets()) {
    EXPECT_FALSE(task.contains(QString::fromStdString(secret))) << secret;
  }
}

TEST_F(CaseAtTheDesk, SubmitsOnlyACompleteAndWatchedCase) {
  child<ReplayPanel>(page, "replay").setRealTime(false);
  const auto state = [&] { return openSheet(desk.session(), centre.cases(0).front()).state; };
  desk.press(Qt::Key_7);
  desk.finish(3);
  EXPECT_EQ(state(), SheetState::kDraft);
  EXPECT_EQ(child<SheetPanel>(page, "sheetPanel").currentRow(), "accuracy");  // first open row
  desk.press({Qt::Key_7, Qt::Key_Down, Qt::Key_7});
  child<ReplayPanel>(page, "replay").seek_us(1'900'000);  // seeking does not count as watching
  desk.finish(3);
  EXPECT_EQ(state(), SheetState::kDraft);

  child<ReplayPanel>(page, "replay").seek_us(0);
  desk.press(Qt::Key_L);
  EXPECT_TRUE(child<ReplayPanel>(page, "replay").playing());
  desk.press(Qt::Key_L);  // locked: not faster
  EXPECT_DOUBLE_EQ(child<ReplayPanel>(page, "replay").recording()->playback.speed(), 1.0);
  watchAll(child<ReplayPanel>(page, "replay"));
  desk.finish(2);

  EXPECT_EQ(state(), SheetState::kSubmitted);
}

TEST_F(CaseAtTheDesk, ClearsTheSheetInOneUndoStep) {
  desk.press(Qt::Key_7);
  ASSERT_EQ(editorOf(page)->answer("time").score_steps, 70);

  child<QToolButton>(page, "clearSheet").click();

  EXPECT_FALSE(editorOf(page)->answer("time").given());
  desk.press(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(editorOf(page)->answer("time").score_steps, 70);
}

TEST_F(CaseAtTheDesk, AdvancesAfterADigitIfEnabled) {
  auto& sheet = child<SheetEditorPanel>(page, "sheetPanel");
  const std::vector<std::string> rows = editorOf(page)->order();
  ASSERT_GE(rows.size(), 3U);
  desk.press(Qt::Key_7);
  EXPECT_EQ(sheet.currentRow(), rows[0]);  // disabled: stays
  child<QToolButton>(page, "advance").click();

  desk.press(Qt::Key_6);
  EXPECT_EQ(sheet.currentRow(), rows[1]);
  desk.press(Qt::Key_1);
  EXPECT_EQ(sheet.currentRow(), rows[1]);  // may become a ten
  desk.press(Qt::Key_0);
  EXPECT_EQ(sheet.currentRow(), rows[2]);
  desk.press({Qt::Key_1, Qt::Key_Up, Qt::Key_1, Qt::Key_4});

  const SheetEditor& editor = *editorOf(page);
  const auto points = [&](std::size_t row) {
    const std::int64_t steps = editor.answer(rows[row]).score_steps.value_or(0);
    return steps / editor.scale(rows[row]).stepsPerPoint;
  };
  EXPECT_EQ(points(0), 6);
  EXPECT_EQ(points(1), 1);
  EXPECT_EQ(points(2), 4);  // the four belongs to the next row, it is not a fourteen
  child<QToolButton>(page, "advance").click();
  EXPECT_FALSE(sheet.advancing());
}

TEST_F(CaseAtTheDesk, BookmarksRemarksAndSteps) {
  child<ReplayPanel>(page, "replay").setRealTime(false);
  desk.press({Qt::Key_Period, Qt::Key_Period, Qt::Key_B, Qt::Key_Comma, Qt::Key_R});
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

TEST_F(CaseAtTheDesk, ShowsTheOverallMarkWithoutScrollingAndRowsAreSliders) {
  page.resize(1146, 420);  // less than on a screen of 768 lines
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

TEST_F(CaseAtTheDesk, TheOverallMarkFollowsTheRowsOnATallPage) {
  page.resize(3600, 2000);
  page.show();
  const auto gap_px = [this] {
    int end = 0;
    int overall = 0;
    for (const ScoreRow* row : page.findChildren<ScoreRow*>()) {
      const int top = row->mapTo(&page, QPoint(0, 0)).y();
      (row->code() == kOverallRow ? overall : end) =
          row->code() == kOverallRow ? top : std::max(end, top + row->height());
    }
    return overall - end;
  };

  EXPECT_TRUE(QTest::qWaitFor([&] { return gap_px() >= 0 && gap_px() < 40; })) << gap_px();
}

TEST_F(CaseAtTheDesk, TracesOnlyGrowOnATallScreen) {
  page.show();
  auto& replay = *page.findChild<ReplayPanel*>();
  auto& curves = *page.findChild<TraceView*>();
  for (const QSize& size : {QSize(3600, 2000), QSize(1160, 700)}) {
    page.resize(size);
    QApplication::processEvents();

    EXPECT_GE(curves.height(), std::min(replay.height() / 4, curves.sizeHint().height())) << size.height();
    EXPECT_GE(4 * curves.height() + 4, size.height() > 1000 ? replay.height() : 0) << size.height();
    EXPECT_LT(2 * curves.height(), replay.height()) << size.height();
  }
}

TEST(CasePage, AHastyCtrlEnterDoesNotReachTheNextCase) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const AssignmentId second = centre.cases(0)[1];
  {  // the next case is a complete draft
    OpenedSheet ready = openSheet(desk.session(), second);
    ready.watched.played(0, ready.watched.length_us(), 1.0);
    static_cast<void>(
        saveSheet(desk.session(), second, torsio::testing::reviewSheet(5, 6, 5), ready.watched));
  }
  desk.open<CasePage>(inputOf(centre.cases(0)[0]));
  scoreCase(desk, 4, 6, 5);
  ASSERT_TRUE(desk.follow());

  desk.finish(3);
  const auto& sheet = child<SheetEditorPanel>(desk.page(), "sheetPanel");
  EXPECT_FALSE(sheet.asking());
  EXPECT_TRUE(desk.notices().join(u' ').contains(QStringLiteral("This is the next case")));
  EXPECT_EQ(openSheet(desk.session(), second).state, SheetState::kDraft);

  desk.press(Qt::Key_Down);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(sheet.asking());
  QKeyEvent held(QEvent::KeyPress, Qt::Key_Return, Qt::ControlModifier, QString(), true);
  QApplication::sendEvent(desk.page().focusWidget(), &held);
  EXPECT_EQ(openSheet(desk.session(), second).state, SheetState::kDraft) << "one press, held down";
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_EQ(openSheet(desk.session(), second).state, SheetState::kSubmitted);
}

TEST(CasePage, PlayPressedWhileTheRecordingLoadsStartsWithIt) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0)[0]));
  auto& replay = child<ReplayPanel>(page, "replay");
  replay.setRealTime(false);
  page.enter(inputOf(centre.cases(0)[1]));
  ASSERT_FALSE(replay.ready());

  desk.press(Qt::Key_Space);
  desk.shell().waitForJobs();
  EXPECT_TRUE(replay.playing());

  page.enter(inputOf(centre.cases(0)[0]));
  desk.press(Qt::Key_Space);
  desk.press(Qt::Key_K);  // changed one's mind
  desk.shell().waitForJobs();
  EXPECT_TRUE(replay.ready());
  EXPECT_FALSE(replay.playing());
}

TEST_F(CaseAtTheDesk, WatchingCountsWhileTheQuestionIsShown) {
  auto& replay = child<ReplayPanel>(page, "replay");
  replay.setRealTime(false);
  for (const Qt::Key key : {Qt::Key_7, Qt::Key_Down, Qt::Key_6, Qt::Key_Down, Qt::Key_5}) {
    desk.press(key);
  }
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  auto& submit = child<QPushButton>(page, "stripGo");
  EXPECT_FALSE(submit.isEnabled());

  desk.press(Qt::Key_Space);
  watchAll(replay);

  EXPECT_TRUE(submit.isEnabled());
}

TEST(CasePage, AmendingNeedsAReasonAndKeepsBothVersions) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  const std::string id = centre.cases(0).front();
  desk.open<CasePage>(inputOf(id));
  scoreCase(desk, 7, 6, 6);
  auto& page = desk.open<CasePage>(inputOf(id));
  desk.press(Qt::Key_9);  // sealed: no effect
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

TEST(CasePage, PlaysTheRecordingBitForBitAndVerifiesIt) {
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
  // The window shows the sample of each moment.
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

TEST(CasePage, FitsASmallScreenInEveryState) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  applyTheme(*qApp, theme(ThemeKind::kLight));
  auto& page = desk.open<CasePage>(inputOf(centre.cases(0).front()));
  const auto height = [&page] {
    QApplication::processEvents();
    return page.minimumSizeHint().height();
  };
  // 768 lines without the window's frame, the header, a desktop bar and the panel of work in progress.
  constexpr int kLeft_px = 560;
  EXPECT_LE(height(), kLeft_px);
  desk.press(Qt::Key_N);
  desk.type(QStringLiteral("hand in the way"));
  desk.press({Qt::Key_Return, Qt::Key_R});
  EXPECT_LE(height(), kLeft_px) << "while a remark is written";
  desk.type(QStringLiteral("second grip slips"));
  desk.press(Qt::Key_Return);
  desk.press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_LE(height(), kLeft_px) << "while it asks whether to submit";
  EXPECT_LE(page.minimumSizeHint().width(), 1146);
}

constexpr int kCases = 10;
constexpr double kDecide_s = 1.35;
constexpr double kPress_s = 0.28;
constexpr double kRecording_s = 40.0;  // ten twists of a practised hand; each recording is watched completely
constexpr double kTenMinutes_s = 600.0;

TEST(QueuePage, ShowsHowManyCasesFitIntoTenMinutesAndThanksTheRater) {
  ReviewCentre centre({.raters = 1, .trainees = 5});
  DeskOf desk(centre, 0);
  const std::vector<AssignmentId> cases = centre.cases(0);
  for (std::size_t i = 0; i < 3; ++i) {
    OpenedSheet opened = openSheet(desk.session(), cases[i]);
    opened.watched.played(0, opened.watched.length_us(), 1.0);
    opened.watched.worked(4 * kMinute_us);
    submitSheet(desk.session(), cases[i], torsio::testing::reviewSheet(5, 5, 5), opened.watched);
  }

  const QString said = paintedWordsOf(desk.open<QueuePage>()).join(u' ');

  EXPECT_TRUE(said.contains(QStringLiteral("3 submitted so far (12 min). Thank you"))) << said.toStdString();
  EXPECT_TRUE(said.contains(
      QRegularExpression(QStringLiteral("2 case\\S* fit into ten minutes, at your own pace so far"))))
      << said.toStdString();
}

TEST(TenCases, AreScoredByKeyboardAloneInTenMinutes) {
  ReviewCentre centre({.raters = 1, .trainees = kCases, .trial_s = 1.0});
  DeskOf desk(centre, 0);
  int keys = 0;
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    ++keys;
    desk.press(key, modifiers);
  };
  desk.open<QueuePage>();
  press(Qt::Key_Return);  // the button to continue has focus
  ASSERT_FALSE(desk.wanted().empty());
  const QVariant first = desk.wanted().back().second;
  desk.wanted().clear();
  desk.open<CasePage>(first);

  int done = 0;
  do {
    auto& replay = child<ReplayPanel>(desk.page(), "replay");
    replay.setRealTime(false);
    press(Qt::Key_Space);
    watchAll(replay);
    press(digit(4 + done % 5));
    press(Qt::Key_Down);
    press(digit(6));
    press(Qt::Key_Down);
    press(digit(5));
    press(Qt::Key_Return, Qt::ControlModifier);
    press(Qt::Key_Return, Qt::ControlModifier);
    ++done;
  } while (desk.follow() && done < 2 * kCases);

  EXPECT_EQ(done, kCases);
  EXPECT_TRUE(desk.failures().isEmpty()) << desk.failures().join(u' ').toStdString();
  for (const AssignmentId& id : centre.cases(0)) {
    EXPECT_EQ(openSheet(desk.session(), id).state, SheetState::kSubmitted);
  }
  const double needed_s = keys * (kDecide_s + kPress_s) + kCases * kRecording_s;
  RecordProperty("keys", keys);
  EXPECT_LE(keys, 9 * kCases);
  EXPECT_LE(needed_s, kTenMinutes_s);
}

}  // namespace

}  // namespace torsio::gui
