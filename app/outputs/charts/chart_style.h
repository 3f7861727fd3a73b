// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include <QBrush>
#include <QColor>
#include <QString>

namespace torsio {

/// Colours and sizes of a chart: print on white, or a screen in the window's theme.
struct ChartStyle {
  QColor ground{Qt::white};
  QColor ink{0x26, 0x32, 0x38};
  QColor grid{0xDD, 0xE3, 0xE6};
  bool dark = false;
  int label_px = 13;       ///< print: charts are laid out at 96 pixels per inch and scaled as a whole
  double hatch = 1.0;      ///< scale of fill patterns: larger for charts many pixels wide
  double stroke = 1.0;     ///< scale of markers and lines: likewise
  double axis_px = 570.0;  ///< least length of the axis below; as on a page if it is not stated
  /// Formats the tick labels of an axis. If empty: ungrouped, like report tables.
  std::function<QString(double value, int decimals)> number;
};

/// Returns the colour of series `i`, distinguishable for colour-blind readers (after Okabe and Ito). In grey,
/// pattern, dash and marker distinguish the series.
[[nodiscard]] QColor seriesColour(std::size_t i, const ChartStyle& look = {});
/// Blends a colour with the background instead of using transparency, which PDF/A forbids. `share` of the
/// colour: 0 to 1.
[[nodiscard]] QColor paled(const QColor& colour, double share, const ChartStyle& look);
/// Returns the fill of a bar; neighbouring series differ in pattern as well as colour.
[[nodiscard]] QBrush seriesFill(std::size_t i, const ChartStyle& look = {});
/// Returns the shade of a heat map, `at` from 0 (lowest) to 1: lightness falls evenly, so that it is readable
/// in grey.
[[nodiscard]] QColor shade(double at, const ChartStyle& look = {});
/// Formats a number of a chart with a typographic minus.
[[nodiscard]] QString chartNumber(double value, int decimals, const ChartStyle& look);
/// Returns a text colour readable on a background.
[[nodiscard]] QColor inkOn(const QColor& ground);

}  // namespace torsio
