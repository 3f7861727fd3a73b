// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace torsio::gui {

struct ColumnWidth {
  int wanted_px = 0;  ///< shows all that is in it
  int least_px = 0;   ///< to which it may give way
};

/// Where the columns are wider than the list, the widest give way, pixel by pixel and the first of several,
/// so that nothing is scrolled sideways while it can be read. Where the list is wider they all grow alike, to
/// three times their width at most: a row is read along. Returns px, one a column.
[[nodiscard]] std::vector<int> sharedWidths(const std::vector<ColumnWidth>& columns, int list_px);

}  // namespace torsio::gui
