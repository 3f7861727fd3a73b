// SPDX-License-Identifier: GPL-3.0-or-later
// One's own marks compared with others'.
#include "app/gui/physician/comparison_bars.h"

#include <gtest/gtest.h>

namespace torsio::gui {
namespace {

TEST(ComparisonBars, UsesTheSameDecimalsThroughoutAComparison) {
  RowComparison row;
  row.own = 1.0;
  row.mean = 4.27;
  row.lowest = 3.0;
  row.highest = 5.5;
  row.apart = true;
  row.scale = {0, 100, 10};
  ComparisonBars bars;

  bars.setRows({row});

  EXPECT_EQ(bars.accessibleDescription().toStdString(),
            "Overall: you 1.0; others 4.3, from 3.0 to 5.5; difference 3.3");
}

}  // namespace
}  // namespace torsio::gui
