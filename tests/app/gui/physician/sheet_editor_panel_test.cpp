// SPDX-License-Identifier: GPL-3.0-or-later
// What all pages with marks share: one history, one set of keys, the save status.
#include "app/gui/physician/sheet_editor_panel.h"

#include <QApplication>
#include <QFrame>
#include <QLabel>
#include <QPlainTextEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/widgets/child.h"
#include "assessment/domain/rating/rubric.h"
#include "tests/app/gui/physician/desk_of.h"

namespace torsio::gui {
namespace {

using torsio::testing::ReviewCentre;

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
