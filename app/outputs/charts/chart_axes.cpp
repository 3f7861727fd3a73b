// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/chart_axes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <QBarCategoryAxis>
#include <QCategoryAxis>
#include <QChart>
#include <QFontMetrics>
#include <QString>
#include <QValueAxis>

#include "app/outputs/charts/category_labels.h"
#include "app/outputs/charts/typeface.h"
#include "app/outputs/charts/upright_title.h"

namespace torsio {

namespace {

/// An axis ignores a duplicate name and would leave its tick unlabelled; zero-width characters make names
/// unique.
void appendTo(QCategoryAxis& axis, QString name, double at) {
  constexpr QChar kNothing(0x200B);  // zero width
  while (axis.categoriesLabels().contains(name)) {
    name += kNothing;
  }
  axis.append(name, at);
}

/// Returns the name of a tick on the left, with space between tick and name.
QString withTickSpacing(const QString& name) {
  return name + QChar(QChar::Nbsp);
}

/// Returns a whole step between ticks that gives few enough ticks.
double wholeStep(double span) {
  constexpr double kMaxTicks = 8.0;
  double step = 1.0;
  for (const double wider : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0}) {
    if (span / step > kMaxTicks) {
      step = wider;
    }
  }
  return step;
}

void markWhole(QValueAxis& axis, double step) {
  axis.setTickType(QValueAxis::TicksDynamic);
  axis.setTickAnchor(0.0);
  axis.setTickInterval(step);
}

/// Puts ticks at whole numbers, with a margin at both ends so that the first and last points are drawn
/// completely.
void countAlong(QValueAxis& axis, const AxisRange& range) {
  const double span = range.high - range.low;
  markWhole(axis, wholeStep(span));
  axis.setRange(range.low - 0.03 * span, range.high + 0.03 * span);
}

/// Puts ticks at whole numbers and ends the axis at ticks: counts have no halves.
void countUp(QValueAxis& axis, const AxisRange& range) {
  const double step = wholeStep(range.high - range.low);
  markWhole(axis, step);
  axis.setRange(step * std::floor(range.low / step), step * std::ceil(range.high / step));
}

/// Returns the range with room for whole dots at its ends.
AxisRange widened(AxisRange range) {
  const double room = 0.02 * (range.high - range.low);
  range.low -= room;
  range.high += room;
  return range;
}

/// Returns the values of the ticks, ascending.
std::vector<double> marksOf(const QValueAxis& axis) {
  std::vector<double> marks;
  if (axis.tickType() == QValueAxis::TicksDynamic) {
    constexpr double kRounding = 1e-9;
    const double step = axis.tickInterval();
    const auto first = std::llround(std::ceil(axis.min() / step - kRounding));
    const auto last = std::llround(std::floor(axis.max() / step + kRounding));
    for (auto at = first; at <= last; ++at) {
      marks.push_back(static_cast<double>(at) * step);
    }
    return marks;
  }
  const int count = axis.tickCount();
  for (int i = 0; i < count; ++i) {
    marks.push_back(axis.min() + (axis.max() - axis.min()) * i / (count - 1));
  }
  return marks;
}

/// Returns whether a figure shows whole numbers only.
bool counted(const ReportFigure& figure) {
  const auto whole = [](double v) { return v == std::round(v); };
  bool any = false;
  for (const FigureSeries& series : figure.series) {
    for (const auto& y : series.y) {
      any = any || y.has_value();
      if (y && !whole(*y)) {
        return false;
      }
    }
    if (!std::all_of(series.low.begin(), series.low.end(), whole) ||
        !std::all_of(series.high.begin(), series.high.end(), whole)) {
      return false;
    }
  }
  return any;
}

}  // namespace

QFont chartFont(int pixels) {
  QFont out = printedTypeface();
  out.setPixelSize(pixels);
  return out;
}

ChartAxes::ChartAxes(const ReportFigure& figure, const ChartStyle& look, const Wording& wording,
                     QChart& chart)
    : figure_(figure), style_(look), say_(wording), chart_(chart) {}

void ChartAxes::addUprightTitle(const Text& words) const {
  if (words.empty()) {
    return;
  }
  auto* title = new UprightTitle(say_(words), style_, &chart_);  // the chart owns it
  QMargins margins = chart_.margins();
  margins.setLeft(margins.left() + static_cast<int>(std::ceil(title->width())));
  chart_.setMargins(margins);
  QObject::connect(&chart_, &QChart::plotAreaChanged, &chart_,
                   [title](const QRectF& plot) { title->place(plot); });
}

template <typename Axis>
Axis* ChartAxes::styled(Axis* axis, const Text& title) const {
  axis->setLabelsFont(chartFont(style_.label_px - 1));
  axis->setTitleFont(chartFont(style_.label_px));
  axis->setTitleText(say_(title).toHtmlEscaped());
  axis->setLabelsColor(style_.ink);
  axis->setTitleBrush(style_.ink);
  axis->setGridLineColor(style_.grid);
  axis->setLinePenColor(style_.ink);
  return axis;
}

AxisRange ChartAxes::valueRange() const {
  AxisRange range;
  for (const FigureSeries& series : figure_.series) {
    for (const auto& y : series.y) {
      if (y) {
        range.take(*y);
      }
    }
    for (const double v : series.low) {
      range.take(v);
    }
    for (const double v : series.high) {
      range.take(v);
    }
  }
  for (const FigureReference& reference : figure_.references) {
    range.take(reference.value);
  }
  if (range.empty()) {
    range = {0.0, 1.0};
  }
  if (figure_.kind == FigureKind::kGroupedBars) {
    range.take(0.0);
  }
  if (range.low == range.high) {
    range.high = range.low + 1.0;
  }
  return figure_.kind == FigureKind::kScatter ? widened(range) : range;
}

/// A value axis formats numbers in the C locale; a category axis uses the style's format.
QCategoryAxis* ChartAxes::numbered(const QValueAxis& range, int decimals, const Text& title,
                                   Qt::Alignment side) const {
  auto* axis = styled(new QCategoryAxis, title);
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  axis->setRange(range.min(), range.max());
  const std::vector<double> marks = marksOf(range);
  if (!marks.empty()) {
    axis->setStartValue(marks.front());
  }
  for (const double value : marks) {
    const QString number = chartNumber(value, decimals, style_);
    appendTo(*axis, side == Qt::AlignLeft ? withTickSpacing(number) : number, value);
  }
  return axis;
}

/// The last tick may be at the end of its axis, with half of its label beyond it.
void ChartAxes::leaveRoomForLast(QCategoryAxis& axis) const {
  const QStringList marks = axis.categoriesLabels();
  if (marks.isEmpty()) {
    return;
  }
  QMargins margins = chart_.margins();
  margins.setRight(margins.right() +
                   (QFontMetrics(axis.labelsFont()).horizontalAdvance(marks.back()) + 1) / 2);
  chart_.setMargins(margins);
}

QCategoryAxis* ChartAxes::addPowers() {
  const AxisRange range = valueRange();
  constexpr double kRounding = 1e-9;
  const int low = static_cast<int>(std::floor(std::log10(range.low) + kRounding));
  const int high = std::max(low + 1, static_cast<int>(std::ceil(std::log10(range.high) - kRounding)));
  auto* axis = styled(new QCategoryAxis, Text());
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  axis->setRange(low, high);
  axis->setStartValue(low);
  for (int power = low; power <= high; ++power) {
    appendTo(*axis, withTickSpacing(chartNumber(std::pow(10.0, power), std::max(0, -power), style_)), power);
  }
  addUprightTitle(figure_.yLabel);
  chart_.addAxis(axis, Qt::AlignLeft);
  return axis;
}

QCategoryAxis* ChartAxes::addValues(Qt::Alignment side) {
  if (figure_.logarithmic) {
    return addPowers();
  }
  const bool upright = side == Qt::AlignLeft;
  QValueAxis values;
  const AxisRange range = valueRange();
  values.setRange(figure_.yMin.value_or(range.low), figure_.yMax.value_or(range.high));
  const bool whole = counted(figure_);
  if (whole) {
    countUp(values, {values.min(), values.max()});
  } else {
    values.setTickCount(6);
    if (!figure_.yMin || !figure_.yMax) {
      values.applyNiceNumbers();
    }
  }
  const double span = values.max() - values.min();
  QCategoryAxis* axis = numbered(values,
                                 whole || span >= 8.0 ? 0
                                 : span >= 0.8        ? 1
                                                      : 2,
                                 upright ? Text() : figure_.yLabel, side);
  if (upright) {
    addUprightTitle(figure_.yLabel);
  }
  if (side == Qt::AlignBottom) {
    leaveRoomForLast(*axis);
  }
  chart_.addAxis(axis, side);
  return axis;
}

QCategoryAxis* ChartAxes::addCategories() {
  auto* axis = styled(new QCategoryAxis, figure_.xLabel);
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  QStringList categories;
  for (const Text& category : figure_.categories) {
    categories << say_(category);
  }
  const auto [names, letters] = categoryLabels(categories, style_);
  for (qsizetype i = 0; i < names.size(); ++i) {
    appendTo(*axis, names[i], static_cast<double>(i + 1));
  }
  axis->setLabelsFont(letters);
  axis->setRange(0.5, static_cast<double>(figure_.categories.size()) + 0.5);
  axis->setGridLineVisible(false);
  chart_.addAxis(axis, Qt::AlignBottom);
  across_ = {0.5, static_cast<double>(figure_.categories.size()) + 0.5};
  return axis;
}

QCategoryAxis* ChartAxes::addNumbers() {
  QValueAxis values;
  AxisRange range;
  for (const FigureSeries& series : figure_.series) {
    for (const double x : series.x) {
      range.take(x);
    }
  }
  if (range.empty()) {
    range = {0.0, 1.0};
  }
  if (range.low == range.high) {
    range.high = range.low + 1.0;
  }
  values.setRange(range.low, range.high);
  if (figure_.kind == FigureKind::kScatter) {
    range = widened(range);
    values.setRange(range.low, range.high);
    values.setTickCount(6);
    values.applyNiceNumbers();
  } else {
    countAlong(values, range);
  }
  const bool whole = figure_.kind != FigureKind::kScatter || values.max() - values.min() >= 4.0;
  QCategoryAxis* axis = numbered(values, whole ? 0 : 1, figure_.xLabel, Qt::AlignBottom);
  leaveRoomForLast(*axis);
  chart_.addAxis(axis, Qt::AlignBottom);
  across_ = {axis->min(), axis->max()};
  return axis;
}

QCategoryAxis* ChartAxes::addRows() {
  const auto rows = static_cast<double>(figure_.categories.size());
  auto* axis = styled(new QCategoryAxis, figure_.xLabel);
  axis->setLabelsPosition(QCategoryAxis::AxisLabelsPositionOnValue);
  for (std::size_t i = 0; i < figure_.categories.size(); ++i) {
    appendTo(*axis, withTickSpacing(say_(figure_.categories[i]).toHtmlEscaped()), static_cast<double>(i + 1));
  }
  axis->setRange(0.4, rows + 0.6);
  axis->setReverse(true);  // first row at the top
  axis->setGridLineVisible(false);
  chart_.addAxis(axis, Qt::AlignLeft);
  across_ = {0.4, rows + 0.6};
  return axis;
}

QBarCategoryAxis* ChartAxes::addBoxes() {
  auto* axis = styled(new QBarCategoryAxis, figure_.xLabel);
  axis->setGridLineVisible(false);
  chart_.addAxis(axis, Qt::AlignBottom);
  return axis;
}

}  // namespace torsio
