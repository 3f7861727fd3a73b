// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/tube_onset.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/tissue/hollow/fold_field.h"

namespace torsio {
namespace {

constexpr double kNeoHookean = 1e9;

TEST(TubeOnset, WithoutPressureIsThatOfCalculix) {
  // CalculiX 2.20, C3D20R *BUCKLE, clamped ends, tau / E at nu = 0.45 (tests/data/hollow/README.md). Donnell:
  // tau / E = 0.736 (1 - nu^2)^(-5/8) (t / R)^(5/4) (R / L)^(1/2), so that omega = tau / G at nu = 0.5 is
  // 3 (0.75 / 0.7975)^(-5/8) of it.
  struct Case {
    double thinness, slenderness, stress;
  };
  const double toHalf = 3.0 * std::pow(0.75 / 0.7975, -0.625);
  for (const Case& c : {Case{0.03, 3, 0.00623}, Case{0.05, 6, 0.00818}, Case{0.05, 12, 0.00611},
                        Case{0.10, 3, 0.02953}, Case{0.10, 6, 0.01987}, Case{0.10, 12, 0.01295}}) {
    const double onset = foldOnset({c.thinness, c.slenderness, 0.0, kNeoHookean});

    EXPECT_NEAR(onset / (toHalf * c.stress), 1.0, 0.08) << c.thinness << ' ' << c.slenderness;
  }
}

TEST(TubeOnset, UnderPressureIsThatOfCalculixWithinEightInAHundred) {
  // L / R 6, pressure and torque scaled together: load factor of the linear shell's tau / G by CalculiX.
  struct Case {
    double thinness, pressure, shell, factor;
  };
  for (const Case& c :
       {Case{0.05, 0.05, 0.08252, 0.997}, Case{0.05, 0.2, 0.20718, 1.013}, Case{0.10, 0.1, 0.17125, 1.014}}) {
    const double onset = foldOnset({c.thinness, 6.0, c.pressure, kNeoHookean});

    EXPECT_NEAR(onset / (c.shell * c.factor), 1.0, 0.08) << c.thinness << ' ' << c.pressure;
  }
}

TEST(TubeOnset, OfAMembraneIsTheClosedForm) {
  // Without bending the smaller principal stress is 0 at omega = P / sqrt(2) for small strain; finite strain
  // lowers it by these factors (bisection in 60 steps on the hoop balance, neo-Hookean).
  const std::vector<std::pair<double, double>> factors{{0.02, 0.997}, {0.05, 0.994}, {0.1, 0.987},
                                                       {0.2, 0.975},  {0.4, 0.949},  {0.6, 0.924}};
  for (const auto& [pressure, factor] : factors) {
    const double omega = factor * pressure / std::sqrt(2.0);

    EXPECT_LT(tautTube(pressure, kNeoHookean, 0.995 * omega).excess, 0.0) << pressure;
    EXPECT_GT(tautTube(pressure, kNeoHookean, 1.005 * omega).excess, 0.0) << pressure;
  }
}

TEST(TubeOnset, GrowsWithPressureAndThickness) {
  double before = 0.0;
  for (const double pressure : {0.0, 0.01, 0.05, 0.1, 0.3, 0.6, 1.0}) {
    const double onset = foldOnset({0.05, 6.0, pressure, 1.0});
    EXPECT_GT(onset, before) << pressure;
    EXPECT_GT(foldOnset({0.08, 6.0, pressure, 1.0}), onset) << pressure;
    before = onset;
  }
}

TEST(TubeOnset, WavesAreThoseOfTheRunsInThreeDimensions) {
  EXPECT_EQ(foldWaves({0.05, 6, 0.0, 1.0}), 3);
  EXPECT_EQ(foldWaves({0.05, 6, 0.05, 1.0}), 4);
  EXPECT_EQ(foldWaves({0.05, 6, 0.2, 1.0}), 5);
  EXPECT_EQ(foldWaves({0.10, 6, 0.1, 1.0}), 3);
  EXPECT_EQ(foldWaves({0.03, 6, 0.1, 1.0}), 5);
  EXPECT_EQ(foldWaves({0.05, 6, 0.5, 1.0}), 5);
}

TEST(TubeOnset, ATautTubeCarriesTheShearOfItsWall) {
  // P = 0 and small omega: lambda = 1, m = omega.
  const TautTube tube = tautTube(0.0, kNeoHookean, 1e-3);

  EXPECT_NEAR(tube.stretch, 1.0, 1e-6);
  EXPECT_NEAR(tube.torque, 1e-3, 1e-8);
}

TEST(TubeOnset, RestStretchIsTheHoopBalance) {
  // lambda = 1.2, J_m = 1: g = 1 / (1 - (1.44 + 1 / 1.44 - 2)), so that p R / (G t) = g (1.44 - 1 / 1.44).
  const double square = 1.44;
  const double pressure = (square - 1.0 / square) / (1.0 - (square + 1.0 / square - 2.0));

  EXPECT_NEAR(restStretch(pressure, 1.0), 1.2, 1e-12);
  EXPECT_NEAR(restStretch(0.0, 1.0), 1.0, 1e-12);
  EXPECT_LT(restStretch(1e6, 1.0), 1.62);  // locks where lambda^2 + lambda^-2 = 3
}

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
