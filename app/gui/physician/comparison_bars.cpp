// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/comparison_bars.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QPainter>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

constexpr int kBand = 10;

QString tenths(double points) {
  return numberText(points, 1);
}

}  // namespace

ComparisonBars::ComparisonBars(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ComparisonBars::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void ComparisonBars::setRows(std::vector<RowComparison> rows) {
  rows_ = std::move(rows);
  describe();
  updateGeometry();
  update();
}

int ComparisonBars::rowHeight() const {
  return 2 * fontMetrics().height() + 2 * kSpace;
}

QSize ComparisonBars::sizeHint() const {
  return {360, std::max(1, static_cast<int>(rows_.size())) * rowHeight()};
}

QString ComparisonBars::sentenceOf(const RowComparison& row) const {
  const QString others =
      tr("others %1, from %2 to %3").arg(tenths(row.mean), tenths(row.lowest), tenths(row.highest));
  const QString own = tr("you %1").arg(tenths(row.own));
  return row.apart ? tr("%1; %2; difference %3").arg(own, others, tenths(std::abs(row.own - row.mean)))
                   : tr("%1; %2").arg(own, others);
}

void ComparisonBars::describe() {
  setAccessibleName(tr("Your marks beside the others'"));
  QStringList lines;
  for (const RowComparison& row : rows_) {
    lines << tr("%1: %2").arg(row.label.empty() ? tr("Overall") : toQString(Text(row.label)),
                              sentenceOf(row));
  }
  setAccessibleDescription(lines.join(QStringLiteral(". ")));
}

void ComparisonBars::drawRow(QPainter& painter, const RowComparison& row, const QRect& area) const {
  const int line = fontMetrics().height();
  const QRect head(area.left(), area.top(), area.width(), line);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(theme_->text);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                   row.label.empty() ? tr("Overall") : toQString(Text(row.label)));
  painter.setFont(font());
  painter.setPen(row.apart ? theme_->caution : theme_->quietText);
  painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, sentenceOf(row));
  const double lo = pointsFromSteps(row.scale.lo, row.scale);
  const double hi = pointsFromSteps(row.scale.hi, row.scale);
  const QRectF bar(area.left() + kBand, area.top() + line + kSpace / 2.0, area.width() - 2 * kBand, kBand);
  const auto xOf = [&](double points) { return bar.left() + (points - lo) / (hi - lo) * bar.width(); };
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_->track);
  painter.drawRoundedRect(bar, kBand / 2.0, kBand / 2.0);
  painter.setBrush(theme_->border);
  painter.drawRoundedRect(
      QRectF(xOf(row.lowest) - 3, bar.top(), xOf(row.highest) - xOf(row.lowest) + 6, bar.height()), 4, 4);
  painter.setPen(QPen(theme_->text, 2.0));
  painter.drawLine(QPointF(xOf(row.mean), bar.top() - 3), QPointF(xOf(row.mean), bar.bottom() + 3));
  const QPointF own(xOf(row.own), bar.center().y());
  painter.setPen(QPen(theme_->surface, 1.5));
  painter.setBrush(theme_->accent);
  painter.drawPolygon(
      QPolygonF({own + QPointF(0, -8), own + QPointF(8, 0), own + QPointF(0, 8), own + QPointF(-8, 0)}));
}

void ComparisonBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  int top = 0;
  for (const RowComparison& row : rows_) {
    drawRow(painter, row, QRect(0, top, width(), rowHeight()));
    top += rowHeight();
  }
}

}  // namespace torsio::gui
