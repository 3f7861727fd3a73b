// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/heat_map_item.h"

#include <algorithm>
#include <limits>

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QPainter>

namespace torsio {

namespace {

constexpr double kScaleWidth = 14.0;
constexpr double kGap = 8.0;

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

}  // namespace

HeatMapItem::HeatMapItem(const ReportFigure& figure, const ChartLook& look) : figure_(figure), look_(look) {
  low_ = std::numeric_limits<double>::infinity();
  high_ = -low_;
  for (const FigureSeries& row : figure_.series)
    for (const std::optional<double>& value : row.y) {
      if (!value) continue;
      low_ = std::min(low_, *value);
      high_ = std::max(high_, *value);
    }
  low_ = figure_.yMin.value_or(low_);
  high_ = figure_.yMax.value_or(high_);
  if (!(low_ < high_)) high_ = low_ + 1.0;
}

QFont HeatMapItem::font(int pixels) const {
  QFont out(QStringLiteral("DejaVu Sans"));
  out.setPixelSize(std::max(5, pixels));
  return out;
}

void HeatMapItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QFontMetricsF metrics(font(look_.label_px - 2));
  double names = 0.0;
  for (const FigureSeries& row : figure_.series)
    names = std::max(names, metrics.horizontalAdvance(text(row.name)));
  const double scaleText = metrics.horizontalAdvance(QStringLiteral("10.0")) + kGap;
  const double foot = 2.4 * metrics.height() + kGap;
  const QRectF whole = rect().adjusted(2, 4, -2, -2);
  const QRectF plot = whole.adjusted(names + kGap, 0, -(kScaleWidth + 2 * kGap + scaleText), -foot);
  if (plot.width() < 10 || plot.height() < 10) return;
  paintCells(*painter, plot);
  paintLabels(*painter, plot);
  paintScale(*painter, QRectF(plot.right() + 2 * kGap, plot.top(), kScaleWidth, plot.height()));
}

void HeatMapItem::paintCells(QPainter& painter, const QRectF& plot) const {
  const auto rows = static_cast<double>(figure_.series.size());
  const auto columns = static_cast<double>(figure_.categories.size());
  const double wide = plot.width() / columns;
  const double high = plot.height() / rows;
  const int pixels = static_cast<int>(std::min({high * 0.62, wide * 0.42, look_.label_px * 0.85}));
  painter.setFont(font(pixels));
  for (std::size_t r = 0; r < figure_.series.size(); ++r)
    for (std::size_t c = 0; c < figure_.categories.size(); ++c) {
      const QRectF cell(plot.left() + wide * static_cast<double>(c),
                        plot.top() + high * static_cast<double>(r), wide, high);
      const std::vector<std::optional<double>>& values = figure_.series[r].y;
      const bool known = c < values.size() && values[c].has_value();
      painter.setPen(QPen(look_.ground, 0.8));
      if (!known) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(look_.grid, 0.8));
        painter.drawRect(cell);
        painter.drawLine(cell.topLeft(), cell.bottomRight());
        continue;
      }
      const double value = *values[c];
      const QColor fill = shade((value - low_) / (high_ - low_), look_);
      painter.setBrush(fill);
      painter.drawRect(cell);
      if (pixels < 6) continue;
      painter.setPen(inkOn(fill));
      painter.drawText(cell, Qt::AlignCenter, QString::number(value, 'f', 1));
    }
}

void HeatMapItem::paintLabels(QPainter& painter, const QRectF& plot) const {
  const auto rows = static_cast<double>(figure_.series.size());
  const auto columns = static_cast<double>(figure_.categories.size());
  const double wide = plot.width() / columns;
  const double high = plot.height() / rows;
  painter.setPen(look_.ink);
  painter.setFont(font(std::min(look_.label_px - 2, static_cast<int>(high * 0.9))));
  for (std::size_t r = 0; r < figure_.series.size(); ++r)
    painter.drawText(
        QRectF(rect().left(), plot.top() + high * static_cast<double>(r), plot.left() - kGap, high),
        Qt::AlignRight | Qt::AlignVCenter, text(figure_.series[r].name));
  double widest = 1.0;
  const QFont columnFont = font(look_.label_px - 3);
  const QFontMetricsF metrics(columnFont);
  for (const std::string& category : figure_.categories)
    for (const QString& word : text(category).split(' '))
      widest = std::max(widest, metrics.horizontalAdvance(word) + 3.0);
  const auto every = static_cast<std::size_t>(widest / wide) + 1;
  painter.setFont(columnFont);
  for (std::size_t c = 0; c < figure_.categories.size(); c += every) {
    const double middle = plot.left() + wide * (static_cast<double>(c) + 0.5);
    const double half = 0.5 * wide * static_cast<double>(every);
    painter.drawText(QRectF(middle - half, plot.bottom() + 2, 2 * half, 2 * metrics.height()),
                     Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, text(figure_.categories[c]));
  }
  painter.setFont(font(look_.label_px - 2));
  painter.drawText(
      QRectF(plot.left(), rect().bottom() - metrics.height() - 2, plot.width(), metrics.height() + 2),
      Qt::AlignCenter, text(figure_.xLabel));
}

void HeatMapItem::paintScale(QPainter& painter, const QRectF& bar) const {
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0}) gradient.setColorAt(at, shade(at, look_));
  painter.setPen(QPen(look_.ink, 0.6));
  painter.setBrush(gradient);
  painter.drawRect(bar);
  painter.setPen(look_.ink);
  painter.setFont(font(look_.label_px - 3));
  const QFontMetricsF metrics(painter.font());
  for (const double at : {0.0, 0.5, 1.0}) {
    const double y = bar.bottom() - at * bar.height();
    const double inside = std::clamp(y - 0.5 * metrics.height(), bar.top(), bar.bottom() - metrics.height());
    painter.drawText(QRectF(bar.right() + 4, inside, 60, metrics.height()), Qt::AlignLeft | Qt::AlignVCenter,
                     QString::number(low_ + at * (high_ - low_), 'f', high_ - low_ >= 8.0 ? 0 : 1));
  }
}

}  // namespace torsio
