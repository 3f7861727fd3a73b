// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/chart_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QBoxPlotSeries>
#include <QBoxSet>
#include <QCategoryAxis>
#include <QChart>
#include <QFont>
#include <QGraphicsLayout>
#include <QLegend>
#include <QLegendMarker>
#include <QLineSeries>
#include <QPen>
#include <QScatterSeries>
#include <QValueAxis>

#include "sim/base/contracts.h"

namespace torsio {

namespace {

const QColor kInk(0x26, 0x32, 0x38);
const QColor kGrid(0xDD, 0xE3, 0xE6);
constexpr int kLabelPixels = 13;  // charts are laid out at 96 pixels an inch and scaled as a whole

QFont chartFont(int pixels, bool bold = false) {
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(pixels);
  font.setBold(bold);
  return font;
}

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

/// Long names of categories in small letters on two lines; Qt cuts what does not fit.
constexpr int kSmallLabelPixels = 9;
bool crowded(const ReportFigure& figure) {
  return figure.categories.size() > 6 && std::any_of(figure.categories.begin(), figure.categories.end(),
                                                     [](const auto& c) { return c.size() > 6; });
}

QString categoryLabel(const ReportFigure& figure, const std::string& category) {
  const QString label = text(category).toHtmlEscaped();
  return crowded(figure) ? QString(label).replace(' ', QStringLiteral("<br>")) : label;
}

template <typename Axis>
Axis* styled(Axis* axis, const std::string& title) {
  axis->setLabelsFont(chartFont(kLabelPixels - 1));
  axis->setTitleFont(chartFont(kLabelPixels));
  axis->setTitleText(text(title));
  axis->setLabelsColor(kInk);
  axis->setTitleBrush(kInk);
  axis->setGridLineColor(kGrid);
  axis->setLinePenColor(kInk);
  return axis;
}

/// Half way to white: a fill on which the median line stays readable.
QColor paler(const QColor& colour) {
  return QColor((colour.red() + 255) / 2, (colour.green() + 255) / 2, (colour.blue() + 255) / 2);
}

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
};

Range valueRange(const ReportFigure& figure) {
  Range range;
  for (const FigureSeries& series : figure.series) {
    for (const auto& y : series.y) {
      if (y) range.take(*y);
    }
    for (const double v : series.low) range.take(v);
    for (const double v : series.high) range.take(v);
  }
  if (!(range.low <= range.high)) range = {0.0, 1.0};
  if (figure.kind == FigureKind::kGroupedBars) range.take(0.0);
  return range;
}

QValueAxis* valueAxis(const ReportFigure& figure) {
  auto* axis = styled(new QValueAxis, figure.yLabel);
  const Range range = valueRange(figure);
  axis->setRange(figure.yMin.value_or(range.low), figure.yMax.value_or(range.high));
  axis->setTickCount(6);
  if (!figure.yMin || !figure.yMax) axis->applyNiceNumbers();
  const double span = axis->max() - axis->min();
  axis->setLabelFormat(span >= 8.0 ? "%.0f" : span >= 0.8 ? "%.1f" : "%.2f");
  return axis;
}

/// Categories on a continuous axis at 1, 2, 3 ..., so that marks may stand beside each other.
QCategoryAxis* slotAxis(const ReportFigure& figure) {
  auto* axis = styled(new QCategoryAxis, figure.xLabel);
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  for (std::size_t i = 0; i < figure.categories.size(); ++i) {
    axis->append(categoryLabel(figure, figure.categories[i]), static_cast<double>(i + 1));
  }
  if (crowded(figure)) axis->setLabelsFont(chartFont(kSmallLabelPixels));
  axis->setRange(0.5, static_cast<double>(figure.categories.size()) + 0.5);
  axis->setGridLineVisible(false);
  return axis;
}

/// Where series `s` of `count` stands within its category.
double slot(std::size_t category, std::size_t s, std::size_t count) {
  const double width = 0.62 / static_cast<double>(std::max<std::size_t>(count, 1));
  return static_cast<double>(category + 1) +
         width * (static_cast<double>(s) - 0.5 * static_cast<double>(count - 1));
}

constexpr std::array kMarkers{
    QScatterSeries::MarkerShapeCircle,   QScatterSeries::MarkerShapeRectangle,
    QScatterSeries::MarkerShapeTriangle, QScatterSeries::MarkerShapeRotatedRectangle,
    QScatterSeries::MarkerShapePentagon, QScatterSeries::MarkerShapeStar};

QScatterSeries* scatter(std::size_t s, const std::string& name, double size) {
  auto* points = new QScatterSeries;
  points->setName(text(name));
  points->setMarkerShape(kMarkers[s % kMarkers.size()]);
  points->setMarkerSize(size);
  points->setColor(seriesColour(s));
  points->setBorderColor(seriesColour(s).darker(150));
  return points;
}

void add(QChart& chart, QAbstractSeries* series, QAbstractAxis* x, QAbstractAxis* y, bool inLegend) {
  chart.addSeries(series);
  series->attachAxis(x);
  series->attachAxis(y);
  for (QLegendMarker* marker : chart.legend()->markers(series)) marker->setVisible(inLegend);
}

void addBars(QChart& chart, const ReportFigure& figure, QAbstractAxis* y) {
  auto* axis = styled(new QBarCategoryAxis, figure.xLabel);
  for (const std::string& category : figure.categories) axis->append(categoryLabel(figure, category));
  if (crowded(figure)) axis->setLabelsFont(chartFont(kSmallLabelPixels));
  axis->setGridLineVisible(false);
  chart.addAxis(axis, Qt::AlignBottom);
  auto* bars = new QBarSeries;
  bars->setBarWidth(0.75);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    auto* set = new QBarSet(text(figure.series[s].name));
    set->setColor(seriesColour(s));
    set->setBorderColor(seriesColour(s).darker(140));
    for (const auto& value : figure.series[s].y) *set << value.value_or(0.0);
    bars->append(set);
  }
  add(chart, bars, axis, y, true);
}

void addRanges(QChart& chart, const ReportFigure& figure, QAbstractAxis* y) {
  auto* axis = slotAxis(figure);
  chart.addAxis(axis, Qt::AlignBottom);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const FigureSeries& series = figure.series[s];
    TORSIO_EXPECTS(series.low.size() == series.y.size() && series.high.size() == series.y.size());
    auto* middle = scatter(s, series.name, 9.0);
    for (std::size_t c = 0; c < series.y.size(); ++c) {
      if (!series.y[c]) continue;
      const double x = slot(c, s, figure.series.size());
      auto* line = new QLineSeries;
      line->setPen(QPen(seriesColour(s), 2.2));
      const double cap = 0.05;
      line->append({{x - cap, series.low[c]},
                    {x + cap, series.low[c]},
                    {x, series.low[c]},
                    {x, series.high[c]},
                    {x - cap, series.high[c]},
                    {x + cap, series.high[c]}});
      add(chart, line, axis, y, false);
      middle->append(x, *series.y[c]);
    }
    add(chart, middle, axis, y, true);
  }
}

void addPoints(QChart& chart, const ReportFigure& figure, QAbstractAxis* y) {
  auto* axis = slotAxis(figure);
  chart.addAxis(axis, Qt::AlignBottom);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const FigureSeries& series = figure.series[s];
    auto* points = scatter(s, series.name, 7.0);
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      if (!series.y[i]) continue;
      const double category = i < series.x.size() ? series.x[i] : static_cast<double>(i);
      points->append(category + slot(0, s, figure.series.size()), *series.y[i]);
    }
    add(chart, points, axis, y, true);
  }
}

void addLines(QChart& chart, const ReportFigure& figure, QAbstractAxis* y) {
  QAbstractAxis* axis = nullptr;
  const bool overCategories = !figure.categories.empty();
  if (!overCategories) {
    auto* value = styled(new QValueAxis, figure.xLabel);
    Range range;
    for (const FigureSeries& series : figure.series) {
      for (const double x : series.x) range.take(x);
    }
    if (range.low < range.high) value->setRange(range.low, range.high);
    value->setTickCount(6);
    value->setLabelFormat("%.3g");
    axis = value;
  } else {
    axis = slotAxis(figure);
  }
  chart.addAxis(axis, Qt::AlignBottom);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const FigureSeries& series = figure.series[s];
    auto* line = new QLineSeries;
    QPen pen(seriesColour(s), 2.2);
    pen.setStyle(static_cast<Qt::PenStyle>(Qt::SolidLine + static_cast<int>(s % 4)));
    line->setPen(pen);
    line->setName(text(series.name));
    for (std::size_t i = 0; i < series.y.size(); ++i) {
      const bool placed = !overCategories && i < series.x.size();
      if (series.y[i]) line->append(placed ? series.x[i] : static_cast<double>(i + 1), *series.y[i]);
    }
    add(chart, line, axis, y, true);
  }
}

void addBoxes(QChart& chart, const ReportFigure& figure, QAbstractAxis* y) {
  auto* axis = styled(new QBarCategoryAxis, figure.xLabel);
  axis->setGridLineVisible(false);
  auto* boxes = new QBoxPlotSeries;
  auto* means = scatter(3, "mean", 9.0);
  auto* outliers = scatter(0, "outside the whiskers", 6.0);
  outliers->setColor(Qt::white);
  boxes->setBoxWidth(0.45);
  for (std::size_t s = 0; s < figure.series.size(); ++s) {
    const FigureSeries& series = figure.series[s];
    TORSIO_EXPECTS(series.box.has_value());
    const BoxSummary& box = *series.box;
    auto* set = new QBoxSet(box.lowerWhisker, box.lowerQuartile, box.median, box.upperQuartile,
                            box.upperWhisker, text(series.name));
    set->setBrush(paler(seriesColour(s)));
    set->setPen(QPen(kInk, 1.4));
    boxes->append(set);
    means->append(static_cast<double>(s), box.mean);
    for (const double value : box.outliers) outliers->append(static_cast<double>(s), value);
  }
  chart.addAxis(axis, Qt::AlignBottom);
  add(chart, boxes, axis, y, false);
  add(chart, means, axis, y, true);
  if (outliers->count() > 0) {
    add(chart, outliers, axis, y, true);
  } else {
    delete outliers;
  }
}

}  // namespace

QColor seriesColour(std::size_t i) {
  static const std::array<QColor, 6> kColours{QColor(0x00, 0x5B, 0x96), QColor(0xE6, 0x9F, 0x00),
                                              QColor(0x5F, 0xB9, 0x9C), QColor(0xB3, 0x3A, 0x3A),
                                              QColor(0x8E, 0x5A, 0x9E), QColor(0x6E, 0x7B, 0x82)};
  return kColours[i % kColours.size()];
}

std::unique_ptr<QChart> buildChart(const ReportFigure& figure) {
  auto chart = std::make_unique<QChart>();
  chart->setAnimationOptions(QChart::NoAnimation);
  chart->setDropShadowEnabled(false);
  chart->setBackgroundVisible(false);
  chart->setMargins(QMargins(2, 2, 2, 2));
  chart->layout()->setContentsMargins(0, 0, 0, 0);
  chart->legend()->setAlignment(Qt::AlignTop);
  chart->legend()->setFont(chartFont(kLabelPixels));
  chart->legend()->setLabelColor(kInk);
  // Bars have no marker of their own: asked for one, Qt leaves it white and cuts the names short.
  chart->legend()->setMarkerShape(figure.kind == FigureKind::kGroupedBars ? QLegend::MarkerShapeRectangle
                                                                          : QLegend::MarkerShapeFromSeries);
  QValueAxis* y = valueAxis(figure);
  chart->addAxis(y, Qt::AlignLeft);
  switch (figure.kind) {
    case FigureKind::kGroupedBars:
      addBars(*chart, figure, y);
      break;
    case FigureKind::kRanges:
      addRanges(*chart, figure, y);
      break;
    case FigureKind::kBoxes:
      addBoxes(*chart, figure, y);
      break;
    case FigureKind::kPoints:
      addPoints(*chart, figure, y);
      break;
    case FigureKind::kLines:
      addLines(*chart, figure, y);
      break;
  }
  chart->legend()->setVisible(figure.series.size() > 1);
  return chart;
}

}  // namespace torsio
