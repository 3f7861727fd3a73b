// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/charts/chart_style.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QTransform>

#include "app/outputs/wording/printed_minus.h"

namespace torsio {

namespace {

QColor between(const QColor& a, const QColor& b, double at) {
  const auto mix = [at](int from, int to) {
    return from + static_cast<int>(std::lround(at * static_cast<double>(to - from)));
  };
  return QColor(mix(a.red(), b.red()), mix(a.green(), b.green()), mix(a.blue(), b.blue()));
}

}  // namespace

QColor seriesColour(std::size_t i, const ChartStyle& look) {
  static const std::array<QColor, 6> kOnWhite{QColor(0x00, 0x5B, 0x96), QColor(0xD9, 0x8A, 0x00),
                                              QColor(0x2E, 0x9B, 0x78), QColor(0xB3, 0x3A, 0x3A),
                                              QColor(0x8E, 0x5A, 0x9E), QColor(0x6E, 0x7B, 0x82)};
  static const std::array<QColor, 6> kOnDark{QColor(0x62, 0xAE, 0xE8), QColor(0xF2, 0xBE, 0x54),
                                             QColor(0x7F, 0xD3, 0xB5), QColor(0xF0, 0x8A, 0x8A),
                                             QColor(0xC9, 0xA3, 0xDA), QColor(0xAE, 0xBB, 0xC3)};
  return look.dark ? kOnDark[i % kOnDark.size()] : kOnWhite[i % kOnWhite.size()];
}

QColor paled(const QColor& colour, double share, const ChartStyle& look) {
  return between(look.ground, colour, share);
}

QBrush seriesFill(std::size_t i, const ChartStyle& look) {
  // Distinguishable in grey and in print, where patterns are fine: solid, light, half.
  static const std::array<Qt::BrushStyle, 6> kPatterns{Qt::SolidPattern,  Qt::BDiagPattern,
                                                       Qt::Dense4Pattern, Qt::DiagCrossPattern,
                                                       Qt::HorPattern,    Qt::FDiagPattern};
  const Qt::BrushStyle pattern = kPatterns[i % kPatterns.size()];
  const QColor colour = seriesColour(i, look);
  constexpr int kDarker = 180;  // PDF draws dots so small that they would look as pale as the lines
  QBrush fill(pattern == Qt::Dense4Pattern && !look.dark ? colour.darker(kDarker) : colour, pattern);
  fill.setTransform(QTransform::fromScale(look.hatch, look.hatch));
  return fill;
}

QColor shade(double at, const ChartStyle& look) {
  const double place = std::clamp(at, 0.0, 1.0);
  static const QColor kPale(0xF2, 0xF6, 0xF8);
  static const QColor kMiddle(0x5F, 0xA3, 0xC4);
  static const QColor kDeep(0x06, 0x2B, 0x45);
  const double from = look.dark ? 1.0 - place : place;
  return from < 0.5 ? between(kPale, kMiddle, 2.0 * from) : between(kMiddle, kDeep, 2.0 * from - 1.0);
}

QString chartNumber(double value, int decimals, const ChartStyle& look) {
  return look.number ? look.number(value, decimals) : printedMinus(QString::number(value, 'f', decimals));
}

QColor inkOn(const QColor& ground) {
  return qGray(ground.rgb()) > 125 ? QColor(0x12, 0x1C, 0x24) : QColor(Qt::white);
}

}  // namespace torsio
