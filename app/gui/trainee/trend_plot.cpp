// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/trend_plot.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <QLocale>
#include <QPainter>
#include <QPainterPath>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr double kTrendLeft = 62.0;
constexpr double kTrendRight = 20.0;
constexpr double kTrendTop = 26.0;
constexpr double kTrendBottom = 44.0;
constexpr double kMark = 5.0;

}  // namespace

TrendPlot::TrendPlot(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TrendPlot::setTrend(const Trend& trend) {
  trend_ = trend;
  findRange();
  retranslate();
}

void TrendPlot::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void TrendPlot::retranslate() {
  setAccessibleName(tr("%1 over the attempts").arg(toQString(Text(rowOf(trend_.quantity).name))));
  QStringList values;
  for (const TrendPoint& point : trend_.points) {
    if (point.value) {
      values << toQString(shownValue(trend_.quantity, *point.value));
    }
  }
  setAccessibleDescription(values.join(QStringLiteral(", ")));
  update();
}

void TrendPlot::findRange() {
  std::vector<double> seen;
  for (const TrendPoint& point : trend_.points) {
    if (point.value) {
      seen.push_back(shown(*point.value));
    }
  }
  for (const TrendCurvePoint& point : trend_.curve) {
    seen.push_back(shown(point.value));
  }
  if (trend_.threshold) {
    seen.push_back(shown(*trend_.threshold));
  }
  if (seen.empty()) {
    seen = {0.0, 1.0};
  }
  const auto [low, high] = std::minmax_element(seen.begin(), seen.end());
  // Identical values (no violation in any attempt) still need a meaningful axis.
  const double flat = *high == 0.0 ? 1.0 : 0.05 * std::abs(*high);
  const double room = *high > *low ? std::max(0.12 * (*high - *low), 0.05 * std::abs(*high)) : flat;
  if (isAnswer(trend_.quantity)) {
    low_ = -0.25;
    high_ = 1.25;
    return;
  }
  low_ = *low >= 0.0 ? std::max(0.0, *low - room) : *low - room;
  high_ = *high + room;
}

double TrendPlot::shown(double value) const {
  return value * rowOf(trend_.quantity).shown.scale;
}

double TrendPlot::xOf(double attempt) const {
  const double last = std::max<double>(4.0, static_cast<double>(trend_.points.size()));
  return kTrendLeft + 14.0 + (attempt - 1.0) / (last - 1.0) * (width() - kTrendLeft - kTrendRight - 28.0);
}

double TrendPlot::yOf(double value) const {
  return height() - kTrendBottom - (value - low_) / (high_ - low_) * (height() - kTrendTop - kTrendBottom);
}

std::vector<double> TrendPlot::marks() const {
  const double power = std::pow(10.0, std::floor(std::log10((high_ - low_) / 4.0)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0}) {
    step = factor * power;
    if ((high_ - low_) / step <= 6.0) {
      break;
    }
  }
  if (rowOf(trend_.quantity).traits.kind != QuantityKind::kMeasure) {
    step = std::max(1.0, std::round(step));
  }
  std::vector<double> all;
  for (auto at = static_cast<std::int64_t>(std::ceil(low_ / step)); static_cast<double>(at) * step <= high_;
       ++at) {
    all.push_back(static_cast<double>(at) * step);
  }
  return all;
}

void TrendPlot::drawGrid(QPainter& painter) const {
  QFont small = font();
  small.setPointSizeF(kSmallText_pt);
  painter.setFont(small);
  const bool answer = isAnswer(trend_.quantity);
  const std::vector<double> values = marks();
  const double step = values.size() > 1 ? values[1] - values[0] : 1.0;
  const int decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  for (const double v : values) {
    painter.setPen(theme_->line);
    painter.drawLine(QPointF(kTrendLeft, yOf(v)), QPointF(width() - kTrendRight, yOf(v)));
    painter.setPen(theme_->quietText);
    painter.drawText(QRectF(0.0, yOf(v) - 9.0, kTrendLeft - 8.0, 18.0), Qt::AlignRight | Qt::AlignVCenter,
                     answer ? toQString(shownValue(trend_.quantity, v)) : numberText(v, decimals));
  }
  const std::size_t last = std::max<std::size_t>(4, trend_.points.size());
  const std::size_t every = last > 20 ? last / 10 : 1;
  for (std::size_t a = 1; a <= last; a += every) {
    painter.drawText(QRectF(xOf(static_cast<double>(a)) - 20.0, height() - kTrendBottom + 8.0, 40.0, 16.0),
                     Qt::AlignHCenter, QString::number(a));
  }
  painter.drawText(QRectF(kTrendLeft, height() - 20.0, width() - kTrendLeft - kTrendRight, 18.0),
                   Qt::AlignHCenter, tr("Attempt"));
  painter.drawText(QRectF(0.0, 2.0, width(), 18.0), Qt::AlignLeft, toQString(titleWithUnit(trend_.quantity)));
}

void TrendPlot::drawCurve(QPainter& painter) const {
  if (trend_.curve.empty()) {
    return;
  }
  QPolygonF middle;
  QPolygonF band;
  for (const TrendCurvePoint& point : trend_.curve) {
    middle << QPointF(xOf(point.attempt), yOf(shown(point.value)));
    band << QPointF(xOf(point.attempt), yOf(shown(point.upper)));
  }
  for (auto point = trend_.curve.rbegin(); point != trend_.curve.rend(); ++point) {
    band << QPointF(xOf(point->attempt), yOf(shown(point->lower)));
  }
  QColor shade = theme_->accent;
  shade.setAlphaF(0.13F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(shade);
  painter.drawPolygon(band);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(theme_->accent, 2.0));
  painter.drawPolyline(middle);
}

void TrendPlot::drawPoints(QPainter& painter) const {
  for (const TrendPoint& point : trend_.points) {
    if (!point.value) {
      continue;
    }
    const QPointF at(xOf(static_cast<double>(point.attempt)), yOf(shown(*point.value)));
    const bool passed = point.outcome == RunOutcome::kPassed;
    const QColor colour = passed                                    ? theme_->good
                          : point.outcome == RunOutcome::kNotJudged ? theme_->quietText
                                                                    : theme_->caution;
    painter.setPen(QPen(colour, 2.0));
    painter.setBrush(passed ? colour : theme_->surface);
    if (passed) {
      painter.drawEllipse(at, kMark, kMark);
    } else if (point.outcome == RunOutcome::kNotJudged) {
      painter.drawRect(QRectF(at.x() - kMark, at.y() - kMark, 2.0 * kMark, 2.0 * kMark));
    } else {
      painter.drawPolygon(QPolygonF({at + QPointF(0.0, -kMark - 1.0), at + QPointF(kMark + 1.0, kMark),
                                     at + QPointF(-kMark - 1.0, kMark)}));
    }
  }
}

void TrendPlot::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawGrid(painter);
  painter.setClipRect(QRectF(kTrendLeft, kTrendTop - 6.0, width() - kTrendLeft - kTrendRight,
                             height() - kTrendTop - kTrendBottom + 12.0));
  if (trend_.threshold) {
    const double y = yOf(shown(*trend_.threshold));
    painter.setPen(QPen(theme_->text, 1.4, Qt::DashLine));
    painter.drawLine(QPointF(kTrendLeft, y), QPointF(width() - kTrendRight, y));
    painter.setPen(theme_->text);
    const bool answer = isAnswer(trend_.quantity);  // its points lie on grid lines
    painter.drawText(
        QRectF(kTrendLeft, y - (answer ? 26.0 : 18.0), width() - kTrendLeft - kTrendRight - 6.0, 16.0),
        Qt::AlignRight, tr("threshold"));
  }
  drawCurve(painter);
  drawPoints(painter);
}

}  // namespace torsio::gui
