// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace torsio::gui {

struct ColumnWidth {
  int wanted_px = 0;  ///< shows all content
  int least_px = 0;   ///< minimum width
};

/// Distributes widths: if the columns are wider than the list, the widest shrink, pixel by pixel and the
/// first of several, to avoid horizontal scrolling as long as the list is legible. If the list is wider, all
/// grow equally, at most to three times their width, so that rows stay easy to follow. Returns px, one per
/// column.
[[nodiscard]] std::vector<int> sharedWidths(const std::vector<ColumnWidth>& columns, int list_px);

}  // namespace torsio::gui
