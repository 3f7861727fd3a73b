// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/relief_item.h"

#include <algorithm>
#include <cmath>

#include <QFontMetricsF>
#include <QPainter>

#include "app/outputs/charts/chart_axes.h"
#include "app/outputs/charts/relief.h"

namespace torsio {

namespace {

constexpr double kRowNames = 70.0;  // width of the rows' names, pixels
constexpr double kBetween = 6.0;    // pictures
constexpr double kSharpness = 3.0;  // pixels of a picture for one of the figure: paper is finer than a screen
constexpr double kTallest = 410.0;  // of a picture
constexpr double kMark = 6.5;       // radius

std::size_t columnsOf(const ReportFigure& figure) {
  std::size_t columns = std::max<std::size_t>(1, figure.categories.size());
  for (const FigureSeries& row : figure.series) {
    columns = std::max(columns, row.reliefs.size());
  }
  return columns;
}

QRectF boxOf(const ReportFigure& figure) {
  QRectF box;
  for (const FigureSeries& row : figure.series) {
    box = box.united(reliefBox(row.reliefs));
  }
  return box;
}

double lineHeight(const ChartStyle& look) {
  return QFontMetricsF(chartFont(look.label_px - 1)).height();
}

}  // namespace

ReliefItem::ReliefItem(const ReportFigure& figure, const ChartStyle& look, const Wording& wording)
    : figure_(figure), style_(look), say_(wording) {}

double ReliefItem::namesWidth(const ReportFigure& figure) {
  return std::any_of(figure.series.begin(), figure.series.end(),
                     [](const FigureSeries& row) { return !row.name.empty(); })
             ? kRowNames
             : 0.0;
}

double ReliefItem::heightFor(const ReportFigure& figure, double width, const ChartStyle& look) {
  const QRectF box = boxOf(figure);
  const double cell = (width - namesWidth(figure)) / static_cast<double>(columnsOf(figure)) - kBetween;
  const double row = std::min(kTallest, cell * box.height() / box.width()) + lineHeight(look) + kBetween;
  return row * static_cast<double>(figure.series.size()) +
         (figure.categories.empty() ? 0.0 : lineHeight(look));
}

void ReliefItem::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  const QRectF box = boxOf(figure_);
  const double names = namesWidth(figure_);
  const double head = figure_.categories.empty() ? 0.0 : lineHeight(style_);
  const double wide = (rect().width() - names) / static_cast<double>(columnsOf(figure_));
  const double high = (rect().height() - head) / static_cast<double>(figure_.series.size());
  painter->setFont(chartFont(style_.label_px - 1));
  painter->setPen(style_.ink);
  for (std::size_t c = 0; c < figure_.categories.size(); ++c) {
    painter->drawText(QRectF(names + wide * static_cast<double>(c), 0.0, wide, head), Qt::AlignCenter,
                      say_(figure_.categories[c]));
  }
  for (std::size_t r = 0; r < figure_.series.size(); ++r) {
    const double top = head + high * static_cast<double>(r);
    painter->setPen(style_.ink);
    painter->drawText(QRectF(0.0, top, names - kBetween, high),
                      Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, say_(figure_.series[r].name));
    for (std::size_t c = 0; c < figure_.series[r].reliefs.size(); ++c) {
      paintCell(*painter, figure_.series[r].reliefs[c],
                QRectF(names + wide * static_cast<double>(c), top, wide, high), box);
    }
  }
}

void ReliefItem::paintCell(QPainter& painter, const ReportRelief& relief, const QRectF& cell,
                           const QRectF& box) const {
  const double line = lineHeight(style_);
  const QSizeF room(cell.width() - kBetween, cell.height() - line - kBetween);
  const double scale = std::min(room.width() / box.width(), room.height() / box.height());
  const QSizeF size(scale * box.width(), scale * box.height());
  const QRectF at(QPointF(cell.center().x() - 0.5 * size.width(), cell.top()), size);
  const DrawnRelief drawn =
      drawRelief(relief, box, std::max(1, static_cast<int>(kSharpness * size.width())), style_);
  painter.setRenderHint(QPainter::LosslessImageRendering);  // a packed picture would tint the paper
  painter.drawImage(at, drawn.image);
  const double shrink = size.width() / drawn.image.width();
  painter.setFont(chartFont(style_.label_px - 4));
  for (std::size_t i = 0; i < drawn.marks.size(); ++i) {
    if (!drawn.seen[i]) {
      continue;
    }
    const QPointF place = at.topLeft() + shrink * drawn.marks[i];
    painter.setPen(QPen(style_.ink, 0.8));
    painter.setBrush(style_.ground);
    painter.drawEllipse(place, kMark, kMark);
    painter.drawText(QRectF(place.x() - 2 * kMark, place.y() - kMark, 4 * kMark, 2 * kMark), Qt::AlignCenter,
                     QString::fromStdString(relief.marks[i].first));
  }
  painter.setFont(chartFont(style_.label_px - 1));
  painter.setPen(style_.ink);
  painter.drawText(QRectF(cell.left(), at.bottom(), cell.width(), line), Qt::AlignCenter,
                   say_(relief.caption));
}

}  // namespace torsio
