// SPDX-License-Identifier: GPL-3.0-or-later
// The live sheet follows an administrator's call. What all pages with marks share: one history, one set of
// keys, the save status.

#include "app/gui/physician/live_page.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <QApplication>
#include <QFrame>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/base/page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/widgets/child.h"
#include "app/services/review/sheet_editor.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/live_call.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet_check.h"
#include "sim/core/time_units.h"
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {

namespace {

using torsio::testing::ReviewCentre;

/// Speeds up a page's timers until their data has been read and shown. False: they do not run.
bool looksAnew(const QWidget& page) {
  constexpr int kRings = 20;
  constexpr int kEvery_ms = 100;
  constexpr int kLongest_ms = 20'000;
  int rings = 0;
  QObject here;
  for (QTimer* clock : page.findChildren<QTimer*>(Qt::FindDirectChildrenOnly)) {
    if (clock->isActive()) {
      clock->setInterval(kEvery_ms);
      QObject::connect(clock, &QTimer::timeout, &here, [&rings] { ++rings; });
    }
  }
  return QTest::qWaitFor([&] { return rings >= kRings; }, kLongest_ms);
}

constexpr int kPatience_ms = 20'000;  // the page refreshes every two seconds

class LivePageFollows : public ::testing::Test {
 protected:
  LiveCallId call(std::size_t trainee, const char* room) {
    const CohortId cohortId = cohorts(*office_).at(0).cohort.id;
    const std::vector<Enrolment> all = enrolments(*office_, cohortId);
    return callTrainee(*office_, {cohortId, all.at(trainee).id, "post", room, {}});
  }
  void end(const LiveCallId& id) { endCall(*office_, cohorts(*office_).at(0).cohort.id, id); }
  [[nodiscard]] QString label(std::size_t trainee) {
    return QStringLiteral("Case %1").arg(
        toQString(openSheet(desk_.session(), centre_.cases(0, true).at(trainee)).shown.label));
  }
  /// The case's name is also in the list at the left.
  [[nodiscard]] bool shows(const LivePage& page, std::size_t trainee) {
    const QString wanted = label(trainee);
    const QList<QLabel*> labels = page.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* one) { return one->isVisible() && one->text() == wanted; });
  }
  /// Presses the line of a case.
  void choose(LivePage& page, std::size_t trainee) {
    for (QToolButton* button : page.findChildren<QToolButton*>()) {
      if (button->text().contains(label(trainee))) {
        return button->click();
      }
    }
    FAIL() << "no line of the case";
  }
  void scoreAll() {
    desk_.press({Qt::Key_6, Qt::Key_Down, Qt::Key_7, Qt::Key_Down, Qt::Key_5});
    desk_.finish(2);
  }

  ReviewCentre centre_{{.trainees = 3, .trial_s = 0.2, .live = true, .called = false}};
  std::unique_ptr<SessionContext> office_{centre_.administrator()};
  DeskOf desk_{centre_, 0};
};

TEST_F(LivePageFollows, OpensTheSheetOfTheCaseThatIsCalled) {
  auto& page = desk_.open<LivePage>();
  EXPECT_TRUE(wordsOf(page).contains(QStringLiteral("Nobody is called now")));
  EXPECT_EQ(editorOf(page), nullptr);

  call(1, "room 1");

  EXPECT_TRUE(QTest::qWaitFor([&] { return wordsOf(page).contains(label(1)); }, kPatience_ms));
  ASSERT_NE(editorOf(page), nullptr);
  scoreAll();
  EXPECT_EQ(openSheet(desk_.session(), centre_.cases(0, true).at(1)).state, SheetState::kSubmitted);
}

TEST_F(LivePageFollows, IsNotLockedWhileCallsGoOn) {
  auto& page = desk_.open<LivePage>();
  EXPECT_FALSE(page.callsGoOn());
  const LiveCallId id = call(1, "room 1");
  EXPECT_TRUE(QTest::qWaitFor([&] { return page.callsGoOn(); }, kPatience_ms));
  end(id);
  EXPECT_TRUE(page.callsGoOn()) << "the next trainee is on the way";
  centre_.passTime_us(31 * kMinute_us);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !page.callsGoOn(); }, kPatience_ms));
}

TEST_F(LivePageFollows, AsksWhenASheetIsReadyRightAfterTheCall) {
  auto& page = desk_.open<LivePage>();
  call(1, "room 1");
  ASSERT_TRUE(QTest::qWaitFor([&] { return editorOf(page) != nullptr; }, kPatience_ms));
  centre_.passTime_us(12'000'000);
  desk_.press({Qt::Key_6, Qt::Key_Down, Qt::Key_7, Qt::Key_Down, Qt::Key_5});
  desk_.press(Qt::Key_Return, Qt::ControlModifier);
  EXPECT_TRUE(wordsOf(page).join(u' ').contains(QStringLiteral("The trainee was called only 12 s ago")));
}

TEST_F(LivePageFollows, StartsTheNextSheetAtItsFirstRow) {
  end(call(0, "room 1"));
  auto& page = desk_.open<LivePage>();
  EXPECT_FALSE(shows(page, 0)) << "a late sheet is chosen by hand";
  EXPECT_TRUE(wordsOf(page).join(u' ').contains(QStringLiteral("Some sheets are late")));

  call(1, "room 1");
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows(page, 1); }, kPatience_ms));
  desk_.press(Qt::Key_6);

  ASSERT_NE(editorOf(page), nullptr);
  EXPECT_TRUE(editorOf(page)->answer(editorOf(page)->order().front()).score_steps.has_value());
  EXPECT_FALSE(editorOf(page)->answer(kOverallRow).score_steps.has_value());
}

TEST_F(LivePageFollows, APressedLineIsNotRebuiltBeforeItsRelease) {
  call(2, "room 1");
  auto& page = desk_.open<LivePage>();
  const QList<QToolButton*> all = page.findChildren<QToolButton*>();
  const auto line = std::find_if(all.begin(), all.end(), [&](const QToolButton* one) {
    return one->isVisible() && one->text().contains(label(2));
  });
  ASSERT_NE(line, all.end());
  const QPointer<QToolButton> pressed(*line);
  const QSignalSpy clicks(pressed, &QToolButton::clicked);
  QTest::mousePress(pressed, Qt::LeftButton);

  call(1, "room 2");
  ASSERT_TRUE(looksAnew(page));

  ASSERT_FALSE(pressed.isNull());
  EXPECT_TRUE(pressed->isVisible() && pressed->isDown());
  QTest::mouseRelease(pressed, Qt::LeftButton);
  EXPECT_EQ(clicks.count(), 1);
}

TEST_F(LivePageFollows, StaysWithItsRoom) {
  const LiveCallId first = call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));

  call(1, "room 2");

  auto& hint = child<QLabel>(page, "called");
  ASSERT_TRUE(QTest::qWaitFor([&] { return hint.isVisible(); }, kPatience_ms));
  EXPECT_TRUE(shows(page, 0)) << "nobody marked it yet, but the trainee is still there";
  EXPECT_TRUE(hint.text().contains(label(1))) << hint.text().toStdString();
  EXPECT_TRUE(hint.text().contains(QStringLiteral("room 2"))) << hint.text().toStdString();
  end(first);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shows(page, 1) && !hint.isVisible(); }, kPatience_ms))
      << "when the trainee has left, the sheet follows";
}

TEST_F(LivePageFollows, NeverReplacesAStartedSheet) {
  call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(wordsOf(page).contains(label(0)));
  desk_.press(Qt::Key_6);

  call(1, "room 2");

  auto& hint = child<QLabel>(page, "called");
  EXPECT_TRUE(QTest::qWaitFor([&] { return hint.isVisible(); }, kPatience_ms));
  EXPECT_TRUE(hint.text().contains(label(1)));
  EXPECT_TRUE(wordsOf(page).contains(label(0))) << "the begun sheet stays";
  scoreAll();
  EXPECT_TRUE(wordsOf(page).contains(label(1))) << "and the called one follows when it is in";
  EXPECT_FALSE(hint.isVisible());
  EXPECT_EQ(openSheet(desk_.session(), centre_.cases(0, true).at(0)).state, SheetState::kSubmitted);
}

TEST_F(LivePageFollows, KeepsInputDuringADatabaseOutage) {
  call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));
  desk_.press(Qt::Key_6);
  Connection& record = centre_.connection();
  record.executeVerbatim(
      "CREATE TRIGGER away BEFORE UPDATE ON mark_draft BEGIN SELECT RAISE(ABORT, 'away'); END");
  desk_.press(Qt::Key_7);
  EXPECT_TRUE(wordsOf(page).contains(QStringLiteral("Not saved")));
  EXPECT_EQ(desk_.failures().size(), 1);
  record.executeVerbatim("DROP TRIGGER away");

  QEvent answered(databaseAnsweredEvent());
  QCoreApplication::sendEvent(&page, &answered);

  EXPECT_FALSE(wordsOf(page).contains(QStringLiteral("Not saved")));
  const OpenedSheet kept = openSheet(desk_.session(), centre_.cases(0, true).at(0));
  const auto scores = [](const Sheet& sheet) {
    std::map<std::string, std::optional<std::int64_t>> byRow;
    for (const SheetRow& row : sheet.rows) {
      byRow[row.code] = row.score_steps;
    }
    return byRow;
  };
  EXPECT_EQ(scores(kept.sheet), scores(editorOf(page)->sheet()));
}

TEST_F(LivePageFollows, RepeatsMessagesInTheLanguageChosenLast) {
  call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));
  desk_.press(Qt::Key_6);
  ASSERT_TRUE(wordsOf(page).contains(QStringLiteral("Saved on this machine")));
  call(1, "room 2");
  auto& hint = child<QLabel>(page, "called");
  ASSERT_TRUE(QTest::qWaitFor([&] { return hint.isVisible(); }, kPatience_ms));

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  page.retranslate();

  EXPECT_FALSE(wordsOf(page).contains(QStringLiteral("Saved on this machine")));
  EXPECT_FALSE(hint.text().contains(QStringLiteral("is called"))) << hint.text().toStdString();
  EXPECT_TRUE(hint.text().contains(QStringLiteral("room 2"))) << hint.text().toStdString();
  language.choose(Language::kEnglish);
  page.retranslate();
  EXPECT_TRUE(wordsOf(page).contains(QStringLiteral("Saved on this machine")));
}

TEST_F(LivePageFollows, ALateSheetCanBeSubmittedAfterTheCall) {
  end(call(0, "room 1"));
  call(1, "room 1");
  auto& page = desk_.open<LivePage>();
  EXPECT_TRUE(wordsOf(page).contains(label(1))) << "who stands at the arm comes first";
  QStringList lines;
  for (const QToolButton* button : page.findChildren<QToolButton*>()) {
    lines << button->text();
  }
  EXPECT_TRUE(lines.join(u'\n').contains(label(0) + QStringLiteral(", late")))
      << lines.join(u'\n').toStdString();
  EXPECT_TRUE(lines.join(u'\n').contains(label(1) + QStringLiteral(", called now")));
  scoreAll();
  EXPECT_FALSE(shows(page, 0)) << "nobody scores into it by mistake";
  choose(page, 0);
  EXPECT_TRUE(shows(page, 0));
  scoreAll();
  EXPECT_EQ(openSheet(desk_.session(), centre_.cases(0, true).at(0)).state, SheetState::kSubmitted);
}

TEST_F(LivePageFollows, ALateSheetCanBeOpenedWhileAnotherCaseIsCalled) {
  end(call(0, "room 1"));
  call(1, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(wordsOf(page).contains(label(1)));

  choose(page, 0);

  EXPECT_TRUE(wordsOf(page).contains(label(0)));
  EXPECT_TRUE(child<QLabel>(page, "called").text().contains(label(1))) << "says who is called meanwhile";
}

TEST_F(LivePageFollows, AHastyCtrlEnterDoesNotReachTheNextSheet) {
  end(call(1, "room 1"));
  const AssignmentId next = centre_.cases(0, true).at(1);
  static_cast<void>(saveSheet(desk_.session(), next, torsio::testing::reviewSheet(5, 6, 5), {}));
  call(0, "room 1");  // before the late one
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));
  scoreAll();

  for (int i = 0; i < 3; ++i) {
    desk_.press(Qt::Key_Return, Qt::ControlModifier);
  }
  EXPECT_EQ(openSheet(desk_.session(), next).state, SheetState::kDraft);

  choose(page, 1);
  ASSERT_TRUE(shows(page, 1));
  desk_.press(Qt::Key_Down);
  desk_.finish(2);
  EXPECT_EQ(openSheet(desk_.session(), next).state, SheetState::kSubmitted);
}

/// A scale of ten points in ten steps each, for one row and the overall mark.
RubricRevision oneRow() {
  RubricRevision rubric;
  rubric.overall = {.lo = 0, .hi = 100, .stepsPerPoint = 10};
  rubric.rows.push_back({"time", "Time", rubric.overall, {}});
  return rubric;
}

TEST(SheetEditorPanel, KeepsOneHistoryForMarksAndComment) {
  SheetEditorPanel panel;
  panel.beginSheet(oneRow(), {});
  QSignalSpy edited(&panel, &SheetPanel::edited);

  panel.handleKey(Qt::Key_7, Qt::NoModifier);
  QTest::keyClicks(&child<QPlainTextEdit>(panel, "comment"), QStringLiteral("calm"));
  EXPECT_EQ(panel.editor()->sheet().comment, "calm");
  QTest::keyClick(&child<QPlainTextEdit>(panel, "comment"), Qt::Key_Z, Qt::ControlModifier);

  EXPECT_EQ(panel.editor()->sheet().comment, "");
  EXPECT_EQ(panel.editor()->answer("time").score_steps, 70);  // 7 points of 10 steps
  panel.undo();
  EXPECT_FALSE(panel.editor()->answer("time").given());
  QTest::keyClick(&child<QPlainTextEdit>(panel, "comment"), Qt::Key_Y, Qt::ControlModifier);
  EXPECT_EQ(panel.editor()->answer("time").score_steps, 70);
  EXPECT_EQ(edited.count(), 1 + 4 + 3);  // the mark, four letters, undo twice and redo once
}

TEST(SheetEditorPanel, UndoesNothingOnASealedSheet) {
  SheetEditorPanel panel;
  panel.beginSheet(oneRow(), {});
  panel.handleKey(Qt::Key_7, Qt::NoModifier);

  panel.setReadOnly(true);
  panel.undo();

  EXPECT_EQ(panel.editor()->answer("time").score_steps, 70);
}

TEST(SheetEditorPanel, AsksAgainAfterEveryChange) {
  SheetEditorPanel panel;
  panel.beginSheet(oneRow(), {});
  QSignalSpy finish(&panel, &SheetEditorPanel::finishWanted);

  QTest::keyClick(&child<QPlainTextEdit>(panel, "comment"), Qt::Key_Return, Qt::ControlModifier);
  panel.setAsking(true);
  panel.handleKey(Qt::Key_7, Qt::NoModifier);

  EXPECT_EQ(finish.count(), 1);
  EXPECT_FALSE(panel.asking());
}

/// Three rows, each with two lines of anchors in a narrow panel.
RubricRevision threeRows() {
  RubricRevision rubric = oneRow();
  const std::vector<RubricAnchor> anchors{{10, "Does not finish; long stops between the steps"},
                                          {50, "Finishes with some waiting; one or two corrections"},
                                          {100, "Brisk, no idle moment, one movement from grip to release"}};
  rubric.rows[0].anchors = anchors;
  rubric.rows.push_back({"grip", "Grip", rubric.overall, anchors});
  rubric.rows.push_back({"care", "Care", rubric.overall, anchors});
  return rubric;
}

TEST(SheetEditorPanel, NoRowMovesUnderTheFingerWhenAnchorsGetShorter) {
  SheetEditorPanel panel;
  panel.resize(520, 900);  // the anchors of a row take two lines
  panel.show();
  panel.beginSheet(threeRows(), {});
  const QList<ScoreRow*> rows = panel.findChildren<ScoreRow*>();
  const auto places = [&] {
    QApplication::processEvents();
    std::vector<int> all;
    for (const ScoreRow* row : rows) {
      all.push_back(row->mapTo(&panel, QPoint(0, 0)).y());
    }
    return all;
  };
  ASSERT_EQ(rows.size(), 4);
  std::vector<int> before;
  while (before != places()) {  // the overall mark moves once the rows have their height
    before = places();
  }

  for (int i = 0; i < 4; ++i) {
    panel.handleKey(Qt::Key_7, Qt::NoModifier);
    panel.handleKey(Qt::Key_Down, Qt::NoModifier);
    EXPECT_EQ(places(), before) << "row " << i;
  }
}

TEST(SheetEditorPanel, AnEdgeSeparatesClippedRowsFromTheOverallMark) {
  SheetEditorPanel panel;
  panel.resize(520, 900);
  panel.show();
  panel.beginSheet(threeRows(), {});
  const auto& edge = child<QFrame>(panel, "edge");
  const QScrollBar& bar = *panel.findChild<QScrollArea*>()->verticalScrollBar();
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar.maximum() == 0 && edge.isHidden(); }));

  panel.resize(520, 320);

  EXPECT_TRUE(QTest::qWaitFor([&] { return bar.maximum() > 0 && edge.isVisible(); }));
  panel.resize(520, 900);
  EXPECT_TRUE(QTest::qWaitFor([&] { return bar.maximum() == 0 && edge.isHidden(); }));
}

TEST(SheetEditorPanel, ATapScrollsNothingAwayInALowWindow) {
  SheetEditorPanel panel;
  panel.resize(520, 900);
  panel.show();
  panel.beginSheet(threeRows(), {});
  QApplication::processEvents();
  const QList<ScoreRow*> rows = panel.findChildren<ScoreRow*>();
  ASSERT_EQ(rows.size(), 4);
  QScrollArea& scroll = *panel.findChild<QScrollArea*>();
  const int anchors = rows[2]->height() - rows[2]->scaleEnd();
  for (int low = 890; low > 200 && scroll.verticalScrollBar()->maximum() < anchors / 2; low -= 8) {
    panel.resize(520, low);  // until half of the text below the third row's scale is hidden
    QApplication::processEvents();
  }
  ASSERT_GT(scroll.verticalScrollBar()->maximum(), 0);

  for (int i = 0; i < 3; ++i) {
    QTest::mouseClick(rows[i], Qt::LeftButton, {}, QPoint(60, rows[i]->scaleEnd() - 10));
    QApplication::processEvents();
    EXPECT_EQ(scroll.verticalScrollBar()->value(), 0) << "row " << i;
    EXPECT_TRUE(panel.editor()->answer(rows[i]->code()).given());
  }
  panel.handleKey(Qt::Key_Up, Qt::NoModifier);
  panel.handleKey(Qt::Key_Down, Qt::NoModifier);
  EXPECT_GT(scroll.verticalScrollBar()->value(), 0) << "by the keys, what a row says comes into sight whole";
}

TEST(SheetEditorPanel, TheRowToScoreIsFullyVisibleOnceThereIsRoom) {
  SheetEditorPanel panel(true);
  panel.resize(520, 250);  // as before layout of its page
  panel.show();
  panel.beginSheet(threeRows(), {});
  QApplication::processEvents();
  const ScoreRow& first = *panel.findChildren<ScoreRow*>().first();
  QScrollArea& scroll = *panel.findChild<QScrollArea*>();
  ASSERT_LT(scroll.viewport()->height(), first.height());
  panel.setCurrentRow("time");
  ASSERT_GT(scroll.verticalScrollBar()->value(), 0);

  panel.resize(520, 250 + 2 * first.height());
  QApplication::processEvents();

  ASSERT_GT(scroll.verticalScrollBar()->maximum(), 0) << "not all rows fit";
  EXPECT_GE(first.mapTo(scroll.viewport(), QPoint(0, 0)).y(), 0);
}

TEST(SheetEditorPanel, TheOverallMarkIsAsWideAsTheRowsBesideTheirScrollBar) {
  SheetEditorPanel panel(true);
  panel.resize(520, 900);
  panel.show();
  panel.beginSheet(threeRows(), {});
  const QList<ScoreRow*> rows = panel.findChildren<ScoreRow*>();
  ASSERT_EQ(rows.size(), 4);
  const QScrollArea& scroll = *panel.findChild<QScrollArea*>();
  const auto widths = [&] { return std::pair(rows.front()->width(), rows.back()->width()); };

  for (const int height : {900, 380, 900}) {
    panel.resize(520, height);
    EXPECT_TRUE(QTest::qWaitFor([&] {
      return (scroll.verticalScrollBar()->maximum() > 0) == (height < 900) &&
             rows.front()->width() == rows.back()->width();
    })) << height
        << ": " << widths().first << " and " << widths().second;
  }
}

TEST(SheetEditorPanel, ShowsWhetherASheetIsSaved) {
  ReviewCentre centre(ReviewCentre::Setup{});
  DeskOf desk(centre, 0);
  SheetEditorPanel panel;
  QLabel label;
  SaidLine said(&label);
  const auto kept = [] { return QStringLiteral("Saved"); };

  const bool failed = panel.save(desk.shell(), said, kept, [] {
    throw Error(ErrorCode::kDatabase, Text::verbatim("the disk is full"), "",
                Text::verbatim("Free some space"));
  });

  EXPECT_FALSE(failed);
  EXPECT_EQ(label.text(), QStringLiteral("Not saved"));
  EXPECT_TRUE(label.property("caution").toBool());
  EXPECT_EQ(desk.failures().size(), 1);
  EXPECT_TRUE(panel.save(desk.shell(), said, kept, [] {}));
  EXPECT_EQ(label.text(), QStringLiteral("Saved"));
  EXPECT_FALSE(label.property("caution").toBool());
}

}  // namespace

}  // namespace torsio::gui
