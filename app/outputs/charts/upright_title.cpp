// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/upright_title.h"

#include <utility>

#include <QFontMetricsF>
#include <QPainter>

#include "app/outputs/charts/text_fit.h"
#include "app/outputs/charts/typeface.h"

namespace torsio {

namespace {

constexpr double kShortPlot_px = 120.0;  // on a printed figure; longer titles may take two lines
constexpr int kSmallestTitle_px = 8;
constexpr double kTitleAir_px = 2.0;

}  // namespace

UprightTitle::UprightTitle(QString words, const ChartStyle& look, QGraphicsItem* parent)
    : QGraphicsItem(parent),
      words_(std::move(words)),
      ink_(look.ink),
      largest_px_(look.label_px),
      pixels_(look.label_px) {
  const QFontMetricsF metrics(font(largest_px_));
  const bool isLong = metrics.horizontalAdvance(words_) > kShortPlot_px;
  width_ = kTitleAir_px + (isLong ? 2.0 * QFontMetricsF(font(largest_px_ - 2)).height() : metrics.height());
}

QFont UprightTitle::font(int pixels) const {
  QFont font = printedTypeface();
  font.setPixelSize(pixels);
  return font;
}

void UprightTitle::place(const QRectF& plot) {
  prepareGeometryChange();
  area_ = QRectF(0.0, plot.top(), width_, plot.height());
  for (pixels_ = largest_px_;; --pixels_) {
    const QFontMetricsF metrics(font(pixels_));
    lines_ = wrappedLines(words_, plot.height(), metrics);
    const double high = static_cast<double>(lines_.size()) * metrics.height();
    if (pixels_ <= kSmallestTitle_px || high + kTitleAir_px <= width_ + 0.5) {
      return;
    }
  }
}

void UprightTitle::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->save();
  painter->setPen(ink_);
  painter->setFont(font(pixels_));
  painter->translate(area_.center());
  painter->rotate(-90.0);
  painter->drawText(QRectF(-0.5 * area_.height(), -0.5 * area_.width(), area_.height(), area_.width()),
                    Qt::AlignCenter | Qt::TextDontClip, lines_.join(u'\n'));
  painter->restore();
}

}  // namespace torsio
