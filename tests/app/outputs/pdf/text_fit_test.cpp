// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/text_fit.h"

#include <memory>
#include <numeric>
#include <utility>

#include <QBarSeries>
#include <QBuffer>
#include <QCategoryAxis>
#include <QChart>
#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGraphicsScene>
#include <QImage>
#include <QLegend>
#include <QLegendMarker>
#include <QPainter>
#include <QPdfWriter>
#include <QScatterSeries>
#include <gtest/gtest.h>

#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/charts/chart_style.h"
#include "app/outputs/charts/typeface.h"
#include "app/outputs/charts/upright_title.h"
#include "app/outputs/pdf/table_layout.h"

namespace torsio {
namespace {

constexpr double kUnit = 600.0 / 25.4;  // device units per millimetre at 600 dots per inch

QFont fontOf(double points, bool bold) {
  QFont font = typeface();
  font.setPointSizeF(points);
  font.setBold(bold);
  return font;
}

TableLayout laidOut(const PlainTable& table, double available_mm) {
  QBuffer nowhere;
  nowhere.open(QIODevice::WriteOnly);
  QPdfWriter writer(&nowhere);
  writer.setResolution(600);
  return layOut(table, available_mm, writer, kUnit, fontOf);
}

double widthOf(const QString& text, const QFont& font) {
  QBuffer nowhere;
  nowhere.open(QIODevice::WriteOnly);
  QPdfWriter writer(&nowhere);
  writer.setResolution(600);
  return QFontMetricsF(font, &writer).horizontalAdvance(text) / kUnit;
}

TEST(TextFit, BreaksBetweenWordsAfterHyphensAndBetweenChineseCharacters) {
  EXPECT_EQ(breakableParts(QStringLiteral("Real-time performance")),
            (QStringList{QStringLiteral("Real-"), QStringLiteral("time "), QStringLiteral("performance")}));
  // A closing mark stays with the preceding character.
  EXPECT_EQ(breakableParts(QStringLiteral("\u65B9\u5DEE\uFF08n\uFF09")).size(), 3);
  EXPECT_EQ(breakableParts(QStringLiteral("virtual 20-40 min")),
            (QStringList{QStringLiteral("virtual "), QStringLiteral("20-40 "), QStringLiteral("min")}));
}

TEST(TextFit, FillsLinesUpToTheirWidth) {
  QFont font = typeface();
  font.setPixelSize(12);
  const QFontMetricsF metrics(font);
  const QString title = QStringLiteral("mean of own mark and the others' mean (points)");

  const QStringList lines = wrappedLines(title, 160.0, metrics);

  EXPECT_GE(lines.size(), 2);
  for (const QString& line : lines) {
    EXPECT_LE(metrics.horizontalAdvance(line), 160.0);
  }
  EXPECT_EQ(lines.join(QLatin1Char(' ')), title);
}

TEST(UprightTitle, ShowsItsWholeTitleNextToAPlotOfAnyHeight) {
  const QString words = QStringLiteral("own mark minus the other raters' mean (points)");
  for (const double height : {110.0, 133.0, 400.0}) {
    UprightTitle title(words, {}, nullptr);
    title.place(QRectF(40.0, 20.0, 500.0, height));

    EXPECT_EQ(title.lines().join(QLatin1Char(' ')), words) << height;
    EXPECT_LE(title.lines().size(), 3) << height;
    EXPECT_EQ(title.boundingRect().height(), height);
  }
  UprightTitle high(words, {}, nullptr);
  high.place(QRectF(40.0, 20.0, 500.0, 400.0));
  EXPECT_EQ(high.lines().size(), 1);
}

QCategoryAxis* valuesOf(const QChart& chart) {
  for (QAbstractAxis* axis : chart.axes(Qt::Vertical)) {
    if (auto* values = qobject_cast<QCategoryAxis*>(axis)) {
      return values;
    }
  }
  return nullptr;
}

/// Returns the tick labels of an axis without their padding.
QStringList marksOf(QCategoryAxis& axis) {
  QStringList marks;
  for (const QString& label : axis.categoriesLabels()) {
    marks << label.trimmed();
  }
  return marks;
}

TEST(ChartAxes, CountsHaveTicksAtWholeNumbersOnly) {
  ReportFigure figure;
  figure.kind = FigureKind::kGroupedBars;
  figure.categories = {std::string("first"), std::string("second"), std::string("third")};
  FigureSeries twists;
  twists.name = std::string("twists");
  twists.y = {1.0, 0.0, 3.0};
  figure.series = {twists};

  const std::unique_ptr<QChart> counts = buildChart(figure);
  figure.series.front().y = {1.5, 0.0, 3.0};
  const std::unique_ptr<QChart> means = buildChart(figure);

  QCategoryAxis* axis = valuesOf(*counts);
  ASSERT_NE(axis, nullptr);
  EXPECT_EQ(marksOf(*axis).join(u' '), QStringLiteral("0 1 2 3"));
  EXPECT_EQ(axis->min(), 0.0);
  EXPECT_EQ(axis->max(), 3.0);
  ASSERT_NE(valuesOf(*means), nullptr);
  EXPECT_TRUE(marksOf(*valuesOf(*means)).contains(QStringLiteral("1.0")));
}

/// Two differences with their intervals.
ReportFigure differences(FigureKind kind) {
  ReportFigure figure;
  figure.kind = kind;
  figure.categories = {std::string("first"), std::string("second")};
  FigureSeries series;
  series.name = std::string("differences");
  series.y = {-1.4, 2.0};
  series.low = {-1.7, 1.7};
  series.high = {-1.2, 2.2};
  figure.series = {series};
  return figure;
}

TEST(ChartAxes, TicksUseTheNumberFormatOfTheStyle) {
  ReportFigure figure = differences(FigureKind::kGroupedBars);
  figure.series.front().low.clear();
  figure.series.front().high.clear();
  ChartStyle screen;
  screen.number = [](double value, int decimals) {
    return QString::number(value, 'f', decimals).replace(u'-', QChar(0x2212));
  };

  const std::unique_ptr<QChart> printed = buildChart(figure);
  const std::unique_ptr<QChart> shown = buildChart(figure, screen);

  ASSERT_NE(valuesOf(*shown), nullptr);
  const QStringList marks = marksOf(*valuesOf(*shown));
  EXPECT_TRUE(marks.contains(QStringLiteral("\u22122.0"))) << marks.join(u' ').toStdString();
  EXPECT_TRUE(marks.contains(QStringLiteral("2.0"))) << marks.join(u' ').toStdString();
  EXPECT_FALSE(marks.join(u' ').contains(u'-')) << marks.join(u' ').toStdString();
  EXPECT_TRUE(marksOf(*valuesOf(*printed)).contains(QStringLiteral("\u22122.0")));
  EXPECT_EQ(valuesOf(*shown)->endValue(valuesOf(*shown)->categoriesLabels().back()), valuesOf(*shown)->max());
}

/// With a pattern as coarse as that of bars across a 4K screen, the fields of the legend would look empty.
TEST(Chart, LegendKeepsFinePatternsWhileMarkersAndLinesScale) {
  ReportFigure figure;
  figure.categories = {std::string("first")};
  for (const char* name : {"1", "2"}) {
    FigureSeries series;
    series.name = std::string(name);
    series.y = {1.5};
    figure.series.push_back(series);
  }
  ChartStyle wide;
  wide.hatch = 2.0;
  wide.stroke = 1.6;

  const std::unique_ptr<QChart> bars = buildChart(figure, wide);
  figure.kind = FigureKind::kPoints;
  const std::unique_ptr<QChart> points = buildChart(figure, wide);
  const std::unique_ptr<QChart> usual = buildChart(figure);

  const auto* all = qobject_cast<QBarSeries*>(bars->series().at(0));
  ASSERT_NE(all, nullptr);
  EXPECT_EQ(all->barSets().at(1)->brush().transform().m11(), 2.0);
  const QList<QLegendMarker*> fields = bars->legend()->markers(bars->series().at(0));
  ASSERT_EQ(fields.size(), 2);
  EXPECT_EQ(fields[1]->brush().style(), Qt::BDiagPattern);
  EXPECT_EQ(fields[1]->brush().transform().m11(), 1.0);
  const auto sizeIn = [](const QChart& chart) {
    return qobject_cast<QScatterSeries*>(chart.series().at(0))->markerSize();
  };
  EXPECT_NEAR(sizeIn(*points), 1.6 * sizeIn(*usual), 1e-9);
}

TEST(ChartAxes, TheLastNumberBelowFitsIntoTheChart) {
  const ReportFigure figure = differences(FigureKind::kForest);
  QGraphicsScene scene;
  QChart* chart = buildChart(figure).release();
  scene.addItem(chart);
  chart->resize(800, 450);
  QCoreApplication::processEvents();

  auto* axis = qobject_cast<QCategoryAxis*>(chart->axes(Qt::Horizontal).first());
  ASSERT_NE(axis, nullptr);
  const double half =
      QFontMetricsF(axis->labelsFont()).horizontalAdvance(axis->categoriesLabels().back()) / 2.0;
  EXPECT_LE(chart->plotArea().right() + half, 800.0);
  EXPECT_GT(chart->plotArea().right(), 700.0);
}

TEST(ChartLegend, TakesAsManyRowsAsItsNamesNeed) {
  ReportFigure figure = differences(FigureKind::kForest);
  figure.references = {{0.0, Text::tr("as the others")}, {-1.0, Text::tr("lower limit of agreement")}};
  figure.references.push_back({1.0, Text::tr("upper limit of agreement")});
  QGraphicsScene scene;
  QChart* chart = buildChart(figure).release();
  scene.addItem(chart);
  const auto heightIn = [chart](double width) {
    chart->resize(width, 300);
    QCoreApplication::processEvents();
    return chart->legend()->geometry().height();
  };
  const double oneRow = heightIn(1200);

  EXPECT_GT(heightIn(260), 2.0 * oneRow);
  EXPECT_GT(chart->plotArea().top(), chart->legend()->geometry().bottom());
  EXPECT_NEAR(heightIn(1200), oneRow, 1.0);  // back beside the chart when there is room again
  for (const double width : {260.0, 330.0, 400.0, 480.0}) {
    chart->resize(width, 300);
    QCoreApplication::processEvents();
    for (const QGraphicsItem* item : chart->legend()->childItems()) {
      const QRectF place = item->mapRectToItem(chart, item->boundingRect() | item->childrenBoundingRect());
      EXPECT_LE(place.bottom(), chart->plotArea().top()) << width << ": no name lies on the plot";
    }
  }
}

/// Renders a chart as on screen and in print; returns the image and the plot's area.
std::pair<QImage, QRectF> drawn(const ReportFigure& figure) {
  QGraphicsScene scene;
  QChart* chart = buildChart(figure).release();
  scene.addItem(chart);
  chart->resize(800, 450);
  QCoreApplication::processEvents();
  QImage picture(800, 450, QImage::Format_RGB32);
  picture.fill(Qt::white);
  QPainter painter(&picture);
  scene.render(&painter, QRectF(0, 0, 800, 450), QRectF(0, 0, 800, 450));
  return {picture, chart->plotArea()};
}

TEST(ChartAxes, NoTickTouchesItsLabel) {
  for (const FigureKind kind : {FigureKind::kForest, FigureKind::kGroupedBars}) {
    const ReportFigure figure = differences(kind);

    const auto [picture, plot] = drawn(figure);

    const auto inked = [&picture = picture, &plot = plot](int x) {
      for (int y = static_cast<int>(plot.top()); y < static_cast<int>(plot.bottom()); ++y) {
        if (qGray(picture.pixel(x, y)) < 160) {
          return true;
        }
      }
      return false;
    };
    const int axis = static_cast<int>(plot.left());
    int x = axis - 2;
    while (x > 0 && inked(x)) {
      --x;
    }
    EXPECT_LE(axis - x, 8) << static_cast<int>(kind) << ": a mark, not a name";
    int air = 0;
    while (x > 0 && !inked(x)) {
      --x;
      ++air;
    }
    EXPECT_GE(air, 2) << static_cast<int>(kind);
    EXPECT_LE(air, 6) << static_cast<int>(kind) << ": still a pair";
  }
}

TEST(TableLayout, KeepsShortCellsOnOneLineNextToLongHashes) {
  PlainTable table;
  table.columns = {QStringLiteral("Trial"),       QStringLiteral("Trainee"), QStringLiteral("Phase"),
                   QStringLiteral("Model"),       QStringLiteral("Minutes"), QStringLiteral("Outcome"),
                   QStringLiteral("Content hash")};
  table.rows = {{QStringLiteral("d2166898-20dc-4f1c-869e-4c53eead91b3"), QStringLiteral("T-03"),
                 QStringLiteral("virtual 20-40 min"), QStringLiteral("Saint-Venant"), QStringLiteral("0.33"),
                 QStringLiteral("completed"), QStringLiteral("5b03f88e760503ed")}};

  const TableLayout layout = laidOut(table, 170.0);

  EXPECT_LE(std::accumulate(layout.widths_mm.begin(), layout.widths_mm.end(), 0.0), 170.0 + 1e-6);
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    EXPECT_LE(widthOf(table.rows[0][c], layout.regular), layout.widths_mm[c] - 2.0 * kCellPadding_mm) << c;
  }
}

TEST(TableLayout, SpreadsLongCellsOfSeveralColumnsOverEquallyManyLines) {
  PlainTable table;
  for (const char* name : {"Group", "Trainee", "Exercise", "Runs", "Failed", "Excused", "Level",
                           "False pass so far", "False fail so far", "Runs needed at least", "Design"}) {
    table.columns.push_back(QString::fromLatin1(name));
  }
  table.rows.push_back({});
  for (const char* cell :
       {"Group 1", "T-03", "Right forearm: Pronation, 60 degrees", "2", "2", "0",
        "not shown yet; 36 more runs needed", "0.0 %", "100.0 %", "38", "shipped with the exercise"}) {
    table.rows.back().push_back(QString::fromLatin1(cell));
  }

  table.rows.resize(30, table.rows.front());

  const TableLayout layout = laidOut(table, 170.0);

  EXPECT_LT(layout.rows_mm.at(0), 9.0) << "two lines, not four";
}

TEST(TableLayout, SplitsNoWordOfAWideHeader) {
  PlainTable table;
  table.columns = {QStringLiteral("index")};
  std::vector<QString> row{QStringLiteral("MSM, deputy chief physician")};
  for (const char* name :
       {"Effectiveness", "Force feedback", "Real-time performance", "System stability",
        "Deformation efficiency", "Fidelity", "Image fluency", "Telepresence", "Texture"}) {
    table.columns.push_back(QString::fromLatin1(name));
    row.push_back(QStringLiteral("8.3500"));
  }
  table.rows = {row};

  const TableLayout layout = laidOut(table, 170.0);

  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    for (const QString& word : breakableParts(table.columns[c])) {
      EXPECT_LE(widthOf(word.trimmed(), layout.bold), layout.widths_mm[c] - 2.0 * kCellPadding_mm)
          << word.toStdString();
    }
  }
}

TEST(TableLayout, AlignsNumbersAndTheirSubstitutesRight) {
  PlainTable table;
  table.columns = {QStringLiteral("p"), QStringLiteral("Group")};
  table.rows = {{QStringLiteral("< 0.001"), QStringLiteral("Group 1")},
                {QStringLiteral("0.032"), QString()},
                {QStringLiteral("\u22121.4"), QString()}};

  const TableLayout layout = laidOut(table, 170.0);

  EXPECT_TRUE(layout.numeric[0]);
  EXPECT_FALSE(layout.numeric[1]);
}

TEST(TableLayout, HasNoHeaderIfNoColumnHasAName) {
  PlainTable table{{QString(), QString()}, {{QStringLiteral("Centre"), QStringLiteral("A")}}};
  EXPECT_EQ(laidOut(table, 170.0).header_mm, 0.0);
  EXPECT_GT(laidOut(table, 170.0).height_mm(), 0.0);
}

}  // namespace
}  // namespace torsio
