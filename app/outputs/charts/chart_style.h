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
  int label_px = 13;    ///< print: charts are laid out at 96 pixels an inch and scaled as a whole
  double hatch = 1.0;   ///< size of the patterns of fills: larger where a chart is many pixels wide
  double stroke = 1.0;  ///< size of marks and lines: likewise
  /// Writes the numbers at the marks of an axis. Empty: not grouped, like those in the tables of a
  /// report.
  std::function<QString(double value, int decimals)> number;
};

/// Colour of series `i`: told apart by colour-blind readers (after Okabe and Ito). Pattern, dash and marker
/// tell the series apart in grey.
[[nodiscard]] QColor seriesColour(std::size_t i, const ChartStyle& look = {});
/// A colour that lets the ground through, without transparency, which archive files may not have. `share` of
/// the colour: 0 to 1.
[[nodiscard]] QColor paled(const QColor& colour, double share, const ChartStyle& look);
/// Fill of a bar: neighbouring series differ in pattern, not in colour alone.
[[nodiscard]] QBrush seriesFill(std::size_t i, const ChartStyle& look = {});
/// Shade of a heat map, `at` from 0 (lowest) to 1: lightness falls evenly, so that it reads in grey.
[[nodiscard]] QColor shade(double at, const ChartStyle& look = {});
/// A number of a chart, with the minus of print.
[[nodiscard]] QString chartNumber(double value, int decimals, const ChartStyle& look);
/// Ink that can be read on a ground.
[[nodiscard]] QColor inkOn(const QColor& ground);

}  // namespace torsio
