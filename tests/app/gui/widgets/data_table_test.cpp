// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/data_table.h"

#include <map>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QImage>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSettings>
#include <QTableView>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/widgets/column_widths.h"
#include "app/gui/widgets/signed_box.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {
namespace {

std::vector<Row> trainees() {
  return {{"a", {{"T-2"}, {"8.5", 8.5}}}, {"b", {{"T-10"}, {"10.0", 10.0}}}, {"c", {{"T-1"}, {"9.0", 9.0}}}};
}

struct Shown {
  DataTable table{QString()};
  Shown() {
    table.setColumns({{"Code"}, {"Mark", true}});
    table.setRows(trainees());
  }
};

TEST(ColumnWidths, TheWidestShrinkDownToTheirTitles) {
  using Widths = std::vector<int>;
  EXPECT_EQ(sharedWidths({{100, 40}, {60, 40}}, 160), (Widths{100, 60})) << "there is room";
  EXPECT_EQ(sharedWidths({{100, 40}, {0, 0}, {60, 40}}, 200), (Widths{125, 0, 75})) << "all take of it";
  EXPECT_EQ(sharedWidths({{100, 40}, {60, 40}}, 3000), (Widths{300, 180})) << "a row is read along";
  EXPECT_EQ(sharedWidths({{100, 40}, {60, 40}, {0, 0}}, 130), (Widths{70, 60, 0})) << "the widest first";
  EXPECT_EQ(sharedWidths({{100, 90}, {60, 20}}, 130), (Widths{90, 40})) << "its title stays whole";
  EXPECT_EQ(sharedWidths({{100, 90}, {60, 50}}, 30), (Widths{90, 50})) << "then the list is scrolled";
  EXPECT_EQ(sharedWidths({}, 30), Widths{});
}

TEST(NumberText, IsGroupedWithATypographicMinusButNoneBeforeZero) {
  EXPECT_EQ(numberText(-68219.456, 1), QStringLiteral("\u221268,219.5"));
  EXPECT_EQ(numberText(-0.04, 1), QStringLiteral("0.0"));
  EXPECT_EQ(numberText(-0.06, 1), QStringLiteral("\u22120.1"));
  EXPECT_EQ(countText(-1080), QStringLiteral("\u22121,080"));
}

TEST(NumberText, FromAFileKeepsItsDecimalsAndOtherTextIsUnchanged) {
  EXPECT_EQ(numberText(QStringLiteral("-1808.0031")), QStringLiteral("\u22121,808.0031"));
  EXPECT_EQ(numberText(QStringLiteral("7666")), QStringLiteral("7,666"));
  for (const char* none : {"", "007", "1e-5", "2026-01-05", "0.5 N", "-"}) {
    EXPECT_EQ(numberText(QLatin1String(none)), QString()) << none;
  }
}

TEST(DataTable, CopiesAMinusThatOtherProgramsUnderstand) {
  DataTable table{QString()};
  table.setColumns({{"Angle", true}});
  table.setRows({{"a", {{numberText(-58.81, 2), -58.81}}}});

  EXPECT_EQ(table.asText(), "Angle\n-58.81\n");
}

/// Returns the colours along the upper edge of a row with their frequencies.
std::map<QRgb, int> edgeOf(DataTable& table, int row) {
  const QImage seen = table.view().viewport()->grab().toImage();
  const int y = table.view().rowViewportPosition(row);
  std::map<QRgb, int> colours;
  for (int x = 0; x < seen.width(); ++x) {
    ++colours[seen.pixel(x, y)];
  }
  return colours;
}

TEST(DataTable, ShowsFocusOnARowAndNeverOnACell) {
  applyTheme(*qApp, theme(ThemeKind::kLight));
  Shown shown;
  shown.table.resize(500, 300);
  shown.table.show();
  shown.table.activateWindow();
  shown.table.view().setFocus(Qt::TabFocusReason);
  QApplication::processEvents();
  ASSERT_TRUE(shown.table.view().hasFocus());
  ASSERT_TRUE(shown.table.view().selectionModel()->selectedRows().isEmpty());
  EXPECT_EQ(edgeOf(shown.table, 0).size(), 1U) << "one line from edge to edge";
  EXPECT_EQ(edgeOf(shown.table, 0).begin()->first, theme(ThemeKind::kLight).accent.rgb());

  QTest::keyClick(&shown.table.view(), Qt::Key_Down);
  QApplication::processEvents();
  EXPECT_EQ(edgeOf(shown.table, 1).size(), 1U) << "the ground of the selection, in every cell";
  EXPECT_EQ(edgeOf(shown.table, 1).begin()->first, theme(ThemeKind::kLight).accent.rgb());
  EXPECT_EQ(edgeOf(shown.table, 0).count(theme(ThemeKind::kLight).accent.rgb()), 0U);
}

TEST(DataTable, KeepsTheGivenOrderUntilAHeaderIsClicked) {
  Shown shown;

  EXPECT_EQ(shown.table.asText(), "Code\tMark\nT-2\t8.5\nT-10\t10.0\nT-1\t9.0\n");
}

TEST(DataTable, SortsCodesByTheirNumbersAndMarksBySize) {
  Shown shown;

  shown.table.view().sortByColumn(0, Qt::AscendingOrder);
  const QString byCode = shown.table.asText();
  shown.table.view().sortByColumn(1, Qt::DescendingOrder);
  const QString byMark = shown.table.asText();

  EXPECT_EQ(byCode, "Code\tMark\nT-1\t9.0\nT-2\t8.5\nT-10\t10.0\n");
  EXPECT_EQ(byMark, "Code\tMark\nT-10\t10.0\nT-1\t9.0\nT-2\t8.5\n");
}

TEST(DataTable, ANumberInTheLastColumnStaysNearItsRowHoweverWideTheList) {
  DataTable numbers{QString()};
  DataTable words{QString()};
  numbers.setColumns({{"Code"}, {"Mark", true}});
  words.setColumns({{"Code"}, {"State"}});
  for (DataTable* table : {&numbers, &words}) {
    table->resize(1600, 200);
    table->setRows(trainees());
    table->show();
  }
  QApplication::processEvents();
  const auto filled_px = [](const DataTable& table) { return table.view().horizontalHeader()->length(); };

  EXPECT_LT(filled_px(numbers), 500);
  EXPECT_EQ(filled_px(words), words.view().viewport()->width());
  // The last visible column counts.
  words.setColumns({{"Code"}, {"State"}, {"Mark", true}});
  EXPECT_FALSE(words.view().horizontalHeader()->stretchLastSection());
  words.setColumnHidden(2, true);
  EXPECT_TRUE(words.view().horizontalHeader()->stretchLastSection());
}

TEST(DataTable, ANumberIsSeparatedFromTheNextTextInRowsAndTitles) {
  applyTheme(*qApp, theme(ThemeKind::kLight));
  DataTable table{QString()};
  table.resize(300, 200);
  table.setColumns({{"Mark", true}, {"Code"}});
  table.setRows({{"a", {{"88", 88}, {"H"}}}});
  table.show();
  QApplication::processEvents();
  QTableView& view = table.view();
  view.clearSelection();
  view.clearFocus();
  const int edge = view.columnViewportPosition(1);
  const auto lastInk = [edge](QWidget& part, int from, int until) {
    const QImage seen = part.grab().toImage();
    for (int x = edge - 1; x > 0; --x) {
      for (int y = from; y < until; ++y) {
        if (qGray(seen.pixel(x, y)) < 160) {
          return edge - x;
        }
      }
    }
    return 0;
  };
  QWidget& titles = *view.horizontalHeader()->viewport();

  EXPECT_GE(lastInk(*view.viewport(), 4, view.rowHeight(0) - 4), 2 * kSpace);
  EXPECT_GE(lastInk(titles, 4, titles.height() - 4), 2 * kSpace);
  EXPECT_NEAR(lastInk(*view.viewport(), 4, view.rowHeight(0) - 4), lastInk(titles, 4, titles.height() - 4),
              3);
  EXPECT_GE(view.horizontalHeader()->sectionSize(0),
            QFontMetrics(titles.font()).horizontalAdvance("Mark") + 3 * kSpace);
}

TEST(DataTable, RowColoursContinueBeyondTheLastColumn) {
  Shown shown;
  shown.table.resize(1200, 300);
  shown.table.show();
  QApplication::processEvents();
  QTableView& view = shown.table.view();
  view.clearSelection();
  const int end = view.horizontalHeader()->length();
  ASSERT_LT(end + 40, view.viewport()->width());
  const auto seen = [&view](int x, int row) {
    return view.viewport()->grab().toImage().pixelColor(x, view.rowViewportPosition(row) + 2);
  };

  EXPECT_EQ(seen(end + 20, 1), seen(end - 2, 1));
  EXPECT_NE(seen(end + 20, 1), seen(end + 20, 0)) << "every second row";
  view.selectRow(0);
  EXPECT_EQ(seen(end + 20, 0), seen(end - 2, 0)) << "chosen";
  EXPECT_NE(seen(end + 20, 0), seen(end + 20, 2));
}

TEST(DataTable, AShortLastColumnLeavesSpaceForTheOthers) {
  DataTable table{QString()};
  table.resize(1200, 200);  // the last column fills it before there are rows
  table.setColumns({{"Name"}, {"State"}});
  table.show();
  QApplication::processEvents();
  const QString name(40, QLatin1Char('m'));
  table.setRows({{"a", {{name}, {"running"}}}});
  table.resize(table.wholeWidth(), 200);
  QApplication::processEvents();

  EXPECT_LT(table.wholeWidth(), 900);
  EXPECT_GE(table.view().horizontalHeader()->sectionSize(0), table.fontMetrics().horizontalAdvance(name));
}

TEST(DataTable, AHiddenColumnIsReadableAsSoonAsItIsShown) {
  for (const bool touched : {false, true}) {
    DataTable table{QString()};
    table.resize(600, 200);
    table.setColumns({{"Code"}, {"Name"}, {"State"}});
    table.setRows({{"a", {{"T-2"}, {""}, {"active"}}}});
    table.setColumnHidden(1, true);
    table.show();
    QApplication::processEvents();
    table.resize(640, 200);  // redistributes the widths
    QApplication::processEvents();
    if (touched) {
      table.view().sortByColumn(0, Qt::AscendingOrder);
    }

    table.setRows({{"a", {{"T-2"}, {"Wang Xiaoming"}, {"active"}}}});
    table.setColumnHidden(1, false);

    EXPECT_GE(table.view().horizontalHeader()->sectionSize(1),
              table.fontMetrics().horizontalAdvance("Wang Xiaoming"))
        << touched;
  }
}

TEST(DataTable, ShrinksTheWidestColumnBeforeItScrollsHorizontally) {
  DataTable table{QString()};
  table.resize(500, 200);
  table.setColumns({{"Code"}, {"What was done"}, {"Mark", true}});

  table.setRows({{"a", {{"T-2"}, {QString(200, QLatin1Char('w'))}, {"8.5", 8.5}}}});
  table.show();
  QApplication::processEvents();

  const QHeaderView& header = *table.view().horizontalHeader();
  EXPECT_EQ(table.view().horizontalScrollBar()->maximum(), 0);
  EXPECT_GE(header.sectionSize(0), table.fontMetrics().horizontalAdvance("Code"));
  EXPECT_GT(header.sectionSize(1), header.sectionSize(0));
}

// Like the two lists of the allocation page on the smallest screen, one with a tool and one without.
TEST(DataTable, AnEmptyListWithFittingTitlesDoesNotScrollAndAlignsWithItsNeighbour) {
  applyTheme(*qApp, theme(ThemeKind::kLight));
  QWidget window;
  auto* row = new QHBoxLayout(&window);
  std::vector<DataTable*> tables;
  for (int i = 0; i < 2; ++i) {
    tables.push_back(new DataTable(QString(), &window));
    row->addWidget(tables.back(), 1);
    tables.back()->setColumns({{"Detail"},
                               {"Value"},
                               {"Trainees", true},
                               {"Expected"},
                               {"Usual difference", true},
                               {"Worst", true}});
    tables.back()->setRows({});
  }
  tables[1]->addTool(new QPushButton(QStringLiteral("Move by hand"), &window));
  window.resize(1150, 300);
  window.show();
  QApplication::processEvents();

  EXPECT_EQ(tables[0]->view().horizontalScrollBar()->maximum(), 0);
  EXPECT_EQ(tables[0]->view().mapTo(&window, QPoint()).y(), tables[1]->view().mapTo(&window, QPoint()).y());
  EXPECT_EQ(tables[0]->filter().mapTo(&window, QPoint()).y(),
            tables[1]->filter().mapTo(&window, QPoint()).y());
}

TEST(DataTable, FiltersWhileTyping) {
  Shown shown;

  QTest::keyClicks(&shown.table.filter(), "t-1");

  EXPECT_EQ(shown.table.visibleRows(), 2);
}

TEST(DataTable, CopiesTheSelectionAsShownWithItsHeaders) {
  Shown shown;
  shown.table.view().horizontalHeader()->moveSection(1, 0);
  shown.table.select("c");

  QTest::keyClick(&shown.table.view(), Qt::Key_C, Qt::ControlModifier);

  EXPECT_EQ(QApplication::clipboard()->text(), "Mark\tCode\n9.0\tT-1\n");
}

TEST(DataTable, KeepsTheSelectionWhenRowsAreReread) {
  Shown shown;
  shown.table.select("b");

  shown.table.setRows(trainees());

  EXPECT_EQ(shown.table.currentId(), "b");
  EXPECT_EQ(shown.table.selectedIds(), QStringList{"b"});
}

TEST(DataTable, OpensTheCurrentRowWithEnter) {
  Shown shown;
  QString opened;
  QObject::connect(&shown.table, &DataTable::activated, [&opened](const QString& id) { opened = id; });
  shown.table.select("c");

  QTest::keyClick(&shown.table.view(), Qt::Key_Return);

  EXPECT_EQ(opened, "c");
}

TEST(DataTable, ShowsSumsOfVisibleRows) {
  DataTable table{QString()};
  table.setColumns({{"Code"}, {"Mark", true, true}});
  table.setRows(trainees());
  EXPECT_EQ(table.totals(), "Total: Mark 27.5");

  table.filter().setText("T-1");

  EXPECT_EQ(table.totals(), "Total: Mark 19");
}

/// A page of this role with a list in which the user moved a column.
QString firstColumnOf(const QString& role, bool move) {
  QWidget page;
  page.setProperty("role", role);
  DataTable table(QStringLiteral("remembering"), &page);
  table.setColumns({{"Code"}, {"Mark", true}});
  table.setRows(trainees());
  if (move) {
    table.view().horizontalHeader()->moveSection(1, 0);
  }
  return table.asText().section(QLatin1Char('\t'), 0, 0);
}

TEST(DataTable, RemembersItsColumnsForEachRole) {
  QSettings().clear();
  EXPECT_EQ(firstColumnOf("administrator", true), "Mark");

  EXPECT_EQ(firstColumnOf("administrator", false), "Mark");
  EXPECT_EQ(firstColumnOf("statistician", false), "Code");
}

TEST(DataTable, SortsAndSelectsColumnsWithoutTheMouse) {
  Shown shown;
  QTableView& view = shown.table.view();
  view.selectionModel()->setCurrentIndex(view.model()->index(0, 1), QItemSelectionModel::NoUpdate);
  const QList<QAction*> acts = shown.table.view().actions();
  ASSERT_EQ(acts.size(), 3);  // copy, sort, columns: what the menu key shows

  acts[1]->trigger();
  EXPECT_EQ(shown.table.asText(), "Code\tMark\nT-2\t8.5\nT-1\t9.0\nT-10\t10.0\n");
  acts[1]->trigger();

  EXPECT_EQ(shown.table.asText(), "Code\tMark\nT-10\t10.0\nT-1\t9.0\nT-2\t8.5\n");
}

TEST(SignedBox, ShowsATypographicMinusAndAcceptsBothSigns) {
  SignedBox box;
  box.setRange(-180.0, 180.0);
  box.setSuffix(QStringLiteral("\u00b0"));
  box.setValue(-60.0);
  EXPECT_EQ(box.text(), QStringLiteral("\u221260.00\u00b0"));
  for (const QString& typed : {QStringLiteral("-12.5"), QStringLiteral("\u221212.5")}) {
    box.setValue(0.0);
    box.selectAll();
    box.findChild<QLineEdit*>()->insert(typed);
    box.interpretText();
    EXPECT_EQ(box.value(), -12.5) << typed.toStdString();
  }
}

}  // namespace
}  // namespace torsio::gui
