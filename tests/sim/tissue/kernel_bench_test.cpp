// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "sim/tissue/twist/twist_bench.h"
#include "sim/tissue/view/cpu_features.h"

namespace torsio {
namespace {

TEST(TissueBench, MeasuresEveryTargetOfTheModelInOneRun) {
  // A small run: what is checked is that everything is measured, not how fast this machine is just now.
  TissueBenchOptions options;
  options.repeats = 3;
  options.vertices = 4000;
  options.ridges = 36;
  options.sections = 20;

  const TissueBenchResult result = runTissueBench(options);

  EXPECT_EQ(result.isa, isaName(bestIsa()));
  for (const char* name : {"lattice_over_triad", "double_lattice_over_triad", "vertices_over_triad",
                           "vertices_portable_over_triad", "precomputed_over_live_kriging", "haptic_query",
                           "haptic_query_p999", "set_up_cpu"}) {
    const auto row = std::find_if(result.rows.begin(), result.rows.end(),
                                  [&](const TissueBenchRow& r) { return r.name == name; });
    ASSERT_NE(row, result.rows.end()) << name;
    EXPECT_TRUE(std::isfinite(row->value) && row->value > 0.0) << name;
    EXPECT_GT(row->target, 0.0) << name;
  }
}

TEST(TissueBench, ATargetIsMetFromTheRightSide) {
  EXPECT_TRUE((TissueBenchRow{"ratio", 0.8, "1", 0.8}).met());
  EXPECT_FALSE((TissueBenchRow{"ratio", 0.79, "1", 0.8}).met());
  EXPECT_TRUE((TissueBenchRow{"time", 90.0, "ns", 100.0, false}).met());
  EXPECT_FALSE((TissueBenchRow{"time", 110.0, "ns", 100.0, false}).met());
  EXPECT_TRUE((TissueBenchRow{"told", 110.0, "us"}).met());
}

}  // namespace
}  // namespace torsio
