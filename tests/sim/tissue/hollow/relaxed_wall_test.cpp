// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/relaxed_wall.h"

#include <cmath>

#include <gtest/gtest.h>

namespace torsio {
namespace {

/// Metric of principal stretches `x` and `y`, the larger one at an angle from the axis.
WallMetric metricOf(double x, double y, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {x * x * c * c + y * y * s * s, (x * x - y * y) * c * s, x * x * s * s + y * y * c * c};
}

TEST(RelaxedWall, StressIsTheSlopeOfTheEnergy) {
  const WallLaw law{1.0, 0.04};
  constexpr double kStep = 1e-6;
  // Taut, held by the bending of its folds, folded beyond that, slack both ways.
  for (const WallMetric& m : {metricOf(1.2, 0.97, 0.6), metricOf(1.1, 0.948, 0.6), metricOf(1.15, 0.7, 0.4),
                              metricOf(0.96, 0.8, 1.1)}) {
    const WallMetric stress = wallStress(law, m);

    const auto slope = [&](double a, double b, double c) {
      const double more = wallEnergy(law, {m.a + a, m.b + b, m.c + c});
      const double less = wallEnergy(law, {m.a - a, m.b - b, m.c - c});
      return (more - less) / (2.0 * kStep);
    };
    EXPECT_NEAR(stress.a, slope(kStep, 0, 0), 1e-7);
    EXPECT_NEAR(stress.b, slope(0, kStep, 0), 1e-7);
    EXPECT_NEAR(stress.c, slope(0, 0, kStep), 1e-7);
  }
}

TEST(RelaxedWall, StressIsContinuousWhereFoldsBeginAndWhereTheyYield) {
  const WallLaw law{1.0, 0.04};
  for (const double excess : {0.0, 0.25 * law.foldHold}) {
    const double x = 1.1;
    const double y = 1.0 / std::sqrt(x) - excess;

    const WallMetric before = wallStress(law, metricOf(x, y + 1e-9, 0.5));
    const WallMetric after = wallStress(law, metricOf(x, y - 1e-9, 0.5));

    EXPECT_NEAR(before.a, after.a, 1e-7);
    EXPECT_NEAR(before.b, after.b, 1e-7);
    EXPECT_NEAR(before.c, after.c, 1e-7);
  }
}

TEST(RelaxedWall, UnloadedIsAtRest) {
  const WallMetric stress = wallStress({1.0, 0.04}, {});

  EXPECT_NEAR(wallEnergy({1.0, 0.04}, {}), 0.0, 1e-15);
  EXPECT_NEAR(stress.a, 0.0, 1e-8);
  EXPECT_NEAR(stress.b, 0.0, 1e-8);
  EXPECT_NEAR(stress.c, 0.0, 1e-8);
}

TEST(RelaxedWall, EnergyOfAlmostNeoHookeanTissueIsHalfTheInvariant) {
  // J_m -> infinity: W = I / 2, here of a taut wall.
  const WallMetric m{1.21, 0.0, 0.95};
  const double invariant = 1.21 + 0.95 + 1.0 / (1.21 * 0.95) - 3.0;

  EXPECT_NEAR(wallEnergy({1e9, 0.0}, m), 0.5 * invariant, 1e-10);
}

}  // namespace
}  // namespace torsio
