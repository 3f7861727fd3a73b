// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/fold_field.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/core/angle.h"

namespace torsio {
namespace {

/// Height and slope of folds that are not mixed.
FoldedPoint foldedPoint(const FoldWaves& folds, double round_rad) {
  return foldedPoint(folds.waves, foldPhase(folds), roundWave(folds.waves, round_rad));
}

// Length of the folded line as drawn, against a circle of radius 1: chords of many points.
double chordsOf(const FoldWaves& folds, double meanRadius) {
  constexpr int kPoints = 20'000;
  double length = 0.0;
  double x0 = 0.0;
  double y0 = 0.0;
  for (int k = 0; k <= kPoints; ++k) {
    const double round = kTurn * k / kPoints;
    const FoldedPoint point = foldedPoint(folds, round);
    const double x = meanRadius * point.radius * std::cos(round + point.turn_rad);
    const double y = meanRadius * point.radius * std::sin(round + point.turn_rad);
    length += k > 0 ? std::hypot(x - x0, y - y0) : 0.0;
    x0 = x;
    y0 = y;
  }
  return length / kTurn;
}

TEST(FoldField, KeepsThePerimeterAsTheTubeNarrows) {
  for (const int waves : {3, 4, 5, 6}) {
    for (const double slack : {0.995, 0.95, 0.9, 0.85, 0.8}) {
      const double amplitude = foldAmplitude(waves, slack);

      if (amplitude < kDeepestFold) {
        EXPECT_NEAR(chordsOf({waves, amplitude, 0.3}, slack), 1.0, 1e-3) << waves << ' ' << slack;
      }
    }
  }
}

TEST(FoldField, HasThePerimeterOfThePrototype) {
  // Prototype in another language: n, r / R, eps of the closed formula ((R/r)^2 - 1) / (n^2/2 - 1),
  // perimeter.
  EXPECT_NEAR(foldedPerimeter(5, std::sqrt((1 / .81 - 1) / 11.5)) * 0.9, 1.0, 0.005);
  EXPECT_NEAR(foldedPerimeter(3, std::sqrt((1 / .81 - 1) / 3.5)) * 0.9, 1.0, 0.0075);
}

TEST(FoldField, WithoutSlackIsTheIdentityToTheLastBit) {
  for (int k = 0; k < 100; ++k) {
    const FoldedPoint point = foldedPoint({4, foldAmplitude(4, 1.0), 0.7}, 0.06 * k);

    EXPECT_EQ(point.radius, 1.0);
    EXPECT_EQ(point.turn_rad, 0.0);
  }
}

TEST(FoldField, MirroredOrganHasMirroredFolds) {
  for (int k = 0; k < 100; ++k) {
    const FoldedPoint right = foldedPoint({4, 0.3, 0.7}, 0.06 * k);
    const FoldedPoint left = foldedPoint({4, 0.3, -0.7}, -0.06 * k);

    EXPECT_EQ(left.radius, right.radius);
    EXPECT_EQ(left.turn_rad, -right.turn_rad);
  }
}

TEST(FoldField, BeginsWithoutAJumpAndGrowsToTheDeepestFold) {
  for (int waves = 2; waves <= 9; ++waves) {
    EXPECT_LT(foldAmplitude(waves, 1.0 - 1e-10), 1e-4);
    double before = 0.0;
    for (int k = 1; k <= 100; ++k) {
      const double amplitude = foldAmplitude(waves, 1.0 - 0.009 * k);
      EXPECT_GE(amplitude, before) << waves << ' ' << k;
      before = amplitude;
    }
    EXPECT_EQ(before, kDeepestFold) << waves;
  }
}

TEST(FoldField, DrawsTwoFoldsAsThree) {
  EXPECT_EQ(drawnWaves(2), 3);
  EXPECT_EQ(drawnWaves(5), 5);
}

}  // namespace
}  // namespace torsio
