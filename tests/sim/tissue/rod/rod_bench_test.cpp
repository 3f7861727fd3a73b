// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_bench.h"

#include <gtest/gtest.h>

#include "sim/core/angle.h"

namespace torsio {
namespace {

TEST(RodBench, TimesTicksThatTurnTheRod) {
  const RodBenchResult result = runRodBench(500);

  EXPECT_GT(result.median_us, 0.0);
  EXPECT_GE(result.p999_us, result.median_us);
  EXPECT_GT(result.turn_rad, radians(30.0));  // the hand turns by 90 degrees, the rod lags behind and gives
  EXPECT_LT(result.turn_rad, radians(100.0));
}

}  // namespace
}  // namespace torsio
