// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/column_widths.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace torsio::gui {

namespace {

constexpr std::int64_t kMaxGrowth = 3;

}  // namespace

std::vector<int> sharedWidths(const std::vector<ColumnWidth>& columns, int list_px) {
  std::vector<int> widths;
  int over = -list_px;
  for (const ColumnWidth& column : columns) {
    widths.push_back(column.wanted_px);
    over += column.wanted_px;
  }
  if (over < 0) {
    const std::int64_t whole = over + list_px;
    const std::int64_t room = std::min<std::int64_t>(list_px, kMaxGrowth * whole);
    for (int& width : widths) {
      width = whole > 0 ? static_cast<int>(width * room / whole) : width;
    }
  }
  for (; over > 0; --over) {
    std::size_t widest = widths.size();
    for (std::size_t at = 0; at < widths.size(); ++at) {
      if (widths[at] > columns[at].least_px && (widest == widths.size() || widths[at] > widths[widest])) {
        widest = at;
      }
    }
    if (widest == widths.size()) {
      break;
    }
    --widths[widest];
  }
  return widths;
}

}  // namespace torsio::gui
