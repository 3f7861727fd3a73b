// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/heat_map_item.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>

#include "app/outputs/charts/text_fit.h"
#include "app/outputs/charts/typeface.h"

namespace torsio {

namespace {

constexpr double kScaleWidth = 14.0;
constexpr double kGap = 8.0;
constexpr double kWidestName = 96.0;  // of a row; longer names take two lines

}  // namespace

HeatMapItem::HeatMapItem(const ReportFigure& figure, const ChartStyle& look, const Wording& wording)
    : figure_(figure), style_(look), say_(wording) {
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (const FigureSeries& row : figure_.series) {
    for (const std::optional<double>& value : row.y) {
      if (!value) {
        continue;
      }
      low_ = std::min(low_, *value);
      high_ = std::max(high_, *value);
      if (*value != std::floor(*value)) {
        decimals_ = 1;
      }
    }
  }
  low_ = figure_.yMin.value_or(low_);
  high_ = figure_.yMax.value_or(high_);
  if (!(low_ < high_)) {
    high_ = low_ + 1.0;
  }
}

QFont HeatMapItem::font(int pixels) const {
  QFont out = printedTypeface();
  out.setPixelSize(std::max(5, pixels));
  return out;
}

void HeatMapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QFontMetricsF metrics(font(style_.label_px - 2));
  const double rows = std::max(1.0, static_cast<double>(figure_.series.size()));
  // Long names take two lines if the rows are high enough.
  const bool wrap = 2.0 * metrics.height() <= (rect().height() - 5.0 * metrics.height()) / rows;
  QStringList rowNames;
  double names = 0.0;
  for (const FigureSeries& row : figure_.series) {
    const QString name = say_(row.name);
    const QStringList lines = wrap ? wrappedLines(name, kWidestName, metrics) : QStringList{name};
    for (const QString& line : lines) {
      names = std::max(names, metrics.horizontalAdvance(line));
    }
    rowNames << lines.join(u'\n');
  }
  const double scaleText = metrics.horizontalAdvance(QStringLiteral("10.0")) + kGap;
  const double unit = figure_.yLabel.empty() ? 0.0 : metrics.height();
  const QRectF whole = rect().adjusted(2, 4, -2, -2);
  const double left = names + kGap;
  const double right = kScaleWidth + 2 * kGap + scaleText + unit;
  const ColumnNames columns = columnNames(whole.width() - left - right);
  const double foot = static_cast<double>(columns.lines) * QFontMetricsF(font(columns.pixels)).height() +
                      1.2 * metrics.height() + kGap;
  const QRectF plot = whole.adjusted(left, 0, -right, -foot);
  if (plot.width() < 10 || plot.height() < 10) {
    return;
  }
  paintCells(*painter, plot);
  paintRowNames(*painter, plot, rowNames);
  paintColumnNames(*painter, plot, columns);
  paintScale(*painter, QRectF(plot.right() + 2 * kGap, plot.top(), kScaleWidth, plot.height()));
}

void HeatMapItem::paintCells(QPainter& painter, const QRectF& plot) const {
  const auto rows = static_cast<double>(figure_.series.size());
  const auto columns = static_cast<double>(figure_.categories.size());
  const double wide = plot.width() / columns;
  const double high = plot.height() / rows;
  const double ofWidth = decimals_ == 0 ? 0.6 : 0.42;
  const int pixels = static_cast<int>(std::min({high * 0.62, wide * ofWidth, style_.label_px * 0.85}));
  painter.setFont(font(pixels));
  for (std::size_t r = 0; r < figure_.series.size(); ++r) {
    for (std::size_t c = 0; c < figure_.categories.size(); ++c) {
      const QRectF cell(plot.left() + wide * static_cast<double>(c),
                        plot.top() + high * static_cast<double>(r), wide, high);
      const std::vector<std::optional<double>>& values = figure_.series[r].y;
      const bool known = c < values.size() && values[c].has_value();
      painter.setPen(QPen(style_.ground, 0.8));
      if (!known) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(style_.grid, 0.8));
        painter.drawRect(cell);
        painter.drawLine(cell.topLeft(), cell.bottomRight());
        continue;
      }
      const double value = *values[c];
      const QColor fill = shade((value - low_) / (high_ - low_), style_);
      painter.setBrush(fill);
      painter.drawRect(cell);
      if (pixels < 6) {
        continue;
      }
      painter.setPen(inkOn(fill));
      painter.drawText(cell, Qt::AlignCenter, chartNumber(value, decimals_, style_));
    }
  }
}

void HeatMapItem::paintRowNames(QPainter& painter, const QRectF& plot, const QStringList& names) const {
  const double high = plot.height() / static_cast<double>(figure_.series.size());
  painter.setPen(style_.ink);
  painter.setFont(font(std::min(style_.label_px - 2, static_cast<int>(high * 0.9))));
  for (qsizetype r = 0; r < names.size(); ++r) {
    painter.drawText(
        QRectF(rect().left(), plot.top() + high * static_cast<double>(r), plot.left() - kGap, high),
        Qt::AlignRight | Qt::AlignVCenter, names[r]);
  }
}

/// Uses the largest font that fits; if even the smallest does not, every second or third name.
HeatMapItem::ColumnNames HeatMapItem::columnNames(double width) const {
  constexpr int kSmallest_px = 8;
  const double wide = std::max(1.0, width / static_cast<double>(figure_.categories.size()));
  QStringList names;
  for (const Text& category : figure_.categories) {
    names << say_(category);
  }
  ColumnNames out;
  // A long name may extend beyond its column as far as its neighbours leave room.
  const auto needed = [&names](const QFontMetricsF& metrics) {
    double most = 1.0;
    double before = 0.0;
    for (const QString& name : names) {
      const double own = widestPart(name, metrics);
      most = std::max(most, names.size() < 2 ? own : 0.5 * (before + own) + 3.0);
      before = own;
    }
    return most;
  };
  out.pixels = style_.label_px - 2;
  while (out.pixels > kSmallest_px && needed(QFontMetricsF(font(out.pixels))) > wide) {
    --out.pixels;
  }
  out.every = static_cast<qsizetype>(needed(QFontMetricsF(font(out.pixels))) / (wide + 0.5)) + 1;
  const QFontMetricsF metrics(font(out.pixels));
  for (const QString& name : names) {
    const double room = std::max(widestPart(name, metrics), wide * static_cast<double>(out.every));
    const QStringList lines = wrappedLines(name, room, metrics);
    out.lines = std::max(out.lines, lines.size());
    out.names << lines.join(u'\n');
  }
  return out;
}

void HeatMapItem::paintColumnNames(QPainter& painter, const QRectF& plot, const ColumnNames& set) const {
  const double wide = plot.width() / static_cast<double>(figure_.categories.size());
  painter.setFont(font(set.pixels));
  const double high = static_cast<double>(set.lines) * QFontMetricsF(painter.font()).height();
  const double half = wide * static_cast<double>(set.every);
  for (qsizetype c = 0; c < set.names.size(); c += set.every) {
    const double middle = plot.left() + wide * (static_cast<double>(c) + 0.5);
    painter.drawText(QRectF(middle - half, plot.bottom() + 2, 2 * half, high + 2),
                     Qt::AlignHCenter | Qt::AlignTop, set.names[c]);
  }
  painter.setFont(font(style_.label_px - 2));
  const QFontMetricsF title(painter.font());
  painter.drawText(
      QRectF(plot.left(), rect().bottom() - title.height() - 1, plot.width(), title.height() + 1),
      Qt::AlignCenter, say_(figure_.xLabel));
}

void HeatMapItem::paintScale(QPainter& painter, const QRectF& bar) const {
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    gradient.setColorAt(at, shade(at, style_));
  }
  painter.setPen(QPen(style_.ink, 0.6));
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setPen(style_.ink);
  painter.setFont(font(style_.label_px - 3));
  const QFontMetricsF metrics(painter.font());
  const bool whole = std::floor(low_) == low_ && std::floor(high_) == high_;
  const bool wholeMiddle = whole && std::fmod(low_ + high_, 2.0) == 0.0;
  for (const double at : {0.0, 0.5, 1.0}) {
    const double y = bar.bottom() - at * bar.height();
    const double inside = std::clamp(y - 0.5 * metrics.height(), bar.top(), bar.bottom() - metrics.height());
    painter.drawText(
        QRectF(bar.right() + 4, inside, 60, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
        chartNumber(low_ + at * (high_ - low_), (at == 0.5 ? wholeMiddle : whole) ? 0 : 1, style_));
  }
  if (figure_.yLabel.empty()) {
    return;
  }
  painter.save();
  painter.translate(rect().right() - 1, bar.center().y());
  painter.rotate(-90);
  painter.drawText(QRectF(-0.5 * bar.height(), -metrics.height(), bar.height(), metrics.height()),
                   Qt::AlignCenter, say_(figure_.yLabel));
  painter.restore();
}

}  // namespace torsio
