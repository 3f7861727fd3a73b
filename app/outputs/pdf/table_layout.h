// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QFont>
#include <QPaintDevice>
#include <QString>

namespace torsio {

/// A table of strings for layout.
struct PlainTable {
  std::vector<QString> columns;  ///< all empty: no header
  std::vector<std::vector<QString>> rows;

  [[nodiscard]] bool hasHeader() const;
};

/// Layout of a table on paper: font size, column widths, row heights. Lengths in millimetres.
struct TableLayout {
  QFont regular;
  QFont bold;
  std::vector<double> widths_mm;
  std::vector<bool> numeric;  ///< right-aligned
  double header_mm = 0.0;     ///< 0: no header
  std::vector<double> rows_mm;

  [[nodiscard]] double height_mm() const;
};

inline constexpr double kCellPadding_mm = 1.4;

/// Chooses the largest font in which no word is split and no short cell ("Group 1", "virtual 0-20 min")
/// wraps. `font`: with a size in points and weight.
[[nodiscard]] TableLayout layOut(const PlainTable& table, double available_mm, QPaintDevice& device,
                                 double unit, const std::function<QFont(double points, bool bold)>& font);

}  // namespace torsio
