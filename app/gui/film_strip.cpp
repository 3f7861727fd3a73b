// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/film_strip.h"

#include <QPainter>

namespace torsio::gui {

namespace {

constexpr int kGap = 8;
constexpr int kFrameWidth = 480;

}  // namespace

QImage filmStrip(const std::vector<std::vector<StripFrame>>& rows) {
  if (rows.empty() || rows.front().empty() || rows.front().front().picture.isNull()) return {};
  const QSize first = rows.front().front().picture.size();
  const QSize cell(kFrameWidth, kFrameWidth * first.height() / first.width());
  QFont font;
  font.setPixelSize(18);
  const int caption = QFontMetrics(font).height() + kGap;
  const auto columns = static_cast<int>(rows.front().size());
  QImage strip(columns * (cell.width() + kGap) + kGap,
               static_cast<int>(rows.size()) * (cell.height() + caption + kGap) + kGap, QImage::Format_RGB32);
  strip.fill(Qt::white);
  QPainter painter(&strip);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setFont(font);
  painter.setPen(Qt::black);
  int y = kGap;
  for (const std::vector<StripFrame>& row : rows) {
    int x = kGap;
    for (const StripFrame& frame : row) {
      painter.drawImage(QRect(QPoint(x, y), cell), frame.picture);
      painter.drawText(QRect(x, y + cell.height(), cell.width(), caption), Qt::AlignCenter, frame.caption);
      x += cell.width() + kGap;
    }
    y += cell.height() + caption + kGap;
  }
  return strip;
}

}  // namespace torsio::gui
