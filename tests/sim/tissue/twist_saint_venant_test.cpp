// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/tissue/saint_venant.h"

namespace torsio {
namespace {

constexpr double kRounding = 1e-14;
constexpr double kLength = 2.0;
constexpr int kNodes = 1001;

// Compliance of a uniform bar: 3 rad per N m and metre.
std::vector<double> uniformCompliance() {
  std::vector<double> c;
  for (int i = 0; i < kNodes; ++i) c.push_back(3.0 * kLength * i / (kNodes - 1));
  return c;
}

// A bar that grows softer towards its far end.
std::vector<double> softeningCompliance() {
  std::vector<double> c;
  for (int i = 0; i < kNodes; ++i) {
    const double s = kLength * i / (kNodes - 1);
    c.push_back(s + 0.7 * s * s * s);
  }
  return c;
}

TorsionTable table(std::vector<double> compliance, EndCondition ends, double foundation = 0.0) {
  return {0.0, kLength / (kNodes - 1), std::move(compliance), ends, {foundation}};
}

TEST(HermiteTable, IsExactAtItsNodesAndForCubics) {
  const auto cubic = [](double x) { return 2.0 - x + 0.5 * x * x - 0.25 * x * x * x; };
  std::vector<double> values;
  for (int i = 0; i <= 10; ++i) values.push_back(cubic(1.0 + 0.25 * i));

  const HermiteTable smooth(1.0, 0.25, values, false);

  for (int i = 0; i <= 10; ++i)
    EXPECT_EQ(smooth.value(1.0 + 0.25 * i), values[static_cast<std::size_t>(i)]) << i;
  for (double x = 1.0; x <= 3.5; x += 0.07) {
    EXPECT_NEAR(smooth.at(x).value, cubic(x), 1e-13);  // values of up to 12
    EXPECT_NEAR(smooth.at(x).slope, -1.0 + x - 0.75 * x * x, 1e-12);
  }
}

TEST(HermiteTable, NeverOvershootsAStepWhenMonotone) {
  const HermiteTable step(0.0, 1.0, {0, 0, 0, 1, 1, 1}, true);

  double before = 0.0;
  for (double x = 0.0; x <= 5.0; x += 0.01) {
    const double here = step.value(x);
    EXPECT_GE(here, before);
    EXPECT_LE(here, 1.0);
    before = here;
  }
}

TEST(HermiteTable, KeepsItsEndValuesOutside) {
  const HermiteTable line(0.0, 1.0, {1.0, 3.0}, false);

  EXPECT_EQ(line.at(-5.0).value, 1.0);
  EXPECT_EQ(line.at(-5.0).slope, 0.0);
  EXPECT_EQ(line.at(9.0).value, 3.0);
  EXPECT_EQ(line.at(9.0).slope, 0.0);
}

TEST(TorsionTable, AClampedBarTurnsByTheSmallerComplianceAndTheKinkIsExact) {
  const TorsionTable bar = table(softeningCompliance(), EndCondition::kClampedFree);
  const auto c = [](double s) { return s + 0.7 * s * s * s; };

  for (const double g : {0.5, 1.234567, 2.0}) {
    EXPECT_NEAR(bar.compliance(g), c(g), 1e-9);
    for (double s = 0.0; s <= kLength; s += 0.031) {
      EXPECT_NEAR(bar.share(s, g).value, std::min(c(s), c(g)) / c(g), 1e-9) << s << " " << g;
    }
    EXPECT_EQ(bar.share(g, g).value, 1.0);
    EXPECT_EQ(bar.share(std::nextafter(g, 9.0), g).value, 1.0);
    EXPECT_NEAR(bar.share(std::nextafter(g, 0.0), g).value, 1.0, kRounding);
  }
}

TEST(TorsionTable, BothEndsHeldIsSymmetricInGraspAndPoint) {
  // Maxwell-Betti: the angle at x for a torque at g equals the angle at g for a torque at x.
  const TorsionTable bar = table(softeningCompliance(), EndCondition::kBothHeld);

  for (double g = 0.1; g < 1.95; g += 0.17) {
    for (double x = 0.1; x < 1.95; x += 0.13) {
      const double here = bar.share(x, g).value * bar.compliance(g);
      const double there = bar.share(g, x).value * bar.compliance(x);
      EXPECT_NEAR(here, there, kRounding * 10.0);
    }
  }
}

TEST(TorsionTable, BothEndsHeldGivesTheGreenFunctionOfTheBar) {
  const TorsionTable bar = table(uniformCompliance(), EndCondition::kBothHeld);

  // C = 3 s, C_tot = 6: phi(s) = C_< (1 - C_> / 6).
  EXPECT_NEAR(bar.compliance(1.0), 3.0 * 0.5, kRounding);
  EXPECT_NEAR(bar.share(0.5, 1.0).value, 0.5, kRounding);
  EXPECT_NEAR(bar.share(1.5, 1.0).value, 0.5, kRounding);
  EXPECT_EQ(bar.share(0.0, 1.0).value, 0.0);
  EXPECT_NEAR(bar.share(kLength, 1.0).value, 0.0, kRounding);
  // A mirrored grasp gives the mirrored profile.
  for (double x = 0.0; x <= kLength; x += 0.1) {
    EXPECT_NEAR(bar.share(x, 0.6).value, bar.share(kLength - x, kLength - 0.6).value, 1e-13);
  }
}

TEST(TorsionTable, AFoundationGivesTheHyperbolicProfile) {
  // phi(H) / phi_end = sinh(H / l) / sinh(H_end / l); at half length 0.0815 (l / H_end = 0.2), 0.324 (0.5),
  // 0.443 (1), 0.485 (2).
  const std::vector<std::pair<double, double>> middle{
      {0.2, 0.0815}, {0.5, 0.324}, {1.0, 0.443}, {2.0, 0.485}};
  // Second order in the node distance: (h / l)^2 / 12 = 2e-6 for the shortest foundation.
  constexpr double kDiscretisation = 1e-5;
  for (const auto& [share, expected] : middle) {
    const double l = share * kLength;
    const TorsionTable bar = table(uniformCompliance(), EndCondition::kClampedFree, l);

    EXPECT_NEAR(bar.share(0.5 * kLength, kLength).value, expected, 6e-4);  // the table's last digit
    for (double x = 0.0; x <= kLength; x += 0.05) {
      EXPECT_NEAR(bar.share(x, kLength).value, std::sinh(x / l) / std::sinh(kLength / l), kDiscretisation);
    }
    // Torque that turns the end by one radian: (G J / l) coth(H_end / l), G J = 1/3.
    EXPECT_NEAR(1.0 / bar.compliance(kLength) * 3.0 * l, 1.0 / std::tanh(kLength / l), 1e-4);
    // Beyond a grasp in the middle the free part is held back by the foundation: cosh towards the free end.
    EXPECT_NEAR(bar.share(kLength, 1.0).value, 1.0 / std::cosh(1.0 / l), 1e-4);
  }
}

TEST(TorsionTable, AFoundationWithBothEndsHeldIsSymmetricToo) {
  const TorsionTable bar = table(softeningCompliance(), EndCondition::kBothHeld, 0.4);

  for (double g = 0.1; g < 1.95; g += 0.37) {
    for (double x = 0.1; x < 1.95; x += 0.23) {
      EXPECT_NEAR(bar.share(x, g).value * bar.compliance(g), bar.share(g, x).value * bar.compliance(x),
                  1e-13);
    }
  }
}

TEST(TorsionTable, AVeryLongFoundationLengthIsNoFoundation) {
  const TorsionTable with = table(softeningCompliance(), EndCondition::kClampedFree, 1e4);
  const TorsionTable without = table(softeningCompliance(), EndCondition::kClampedFree);

  for (double x = 0.0; x <= kLength; x += 0.1) {
    EXPECT_NEAR(with.share(x, 1.3).value, without.share(x, 1.3).value, 1e-7);
  }
}

TEST(TorsionTable, AGraspOnAHeldEndActsJustInside) {
  const TorsionTable bar = table(uniformCompliance(), EndCondition::kBothHeld);

  EXPECT_EQ(bar.graspAt(0.0), TorsionTable::kHeldMargin * kLength);
  EXPECT_EQ(bar.graspAt(9.0), (1.0 - TorsionTable::kHeldMargin) * kLength);
  EXPECT_GT(bar.compliance(0.0), 0.0);
  EXPECT_TRUE(std::isfinite(bar.share(1.0, 0.0).value));
}

TEST(TorsionTable, TheBlendedRateJoinsBothSidesSmoothly) {
  const TorsionTable bar = table(uniformCompliance(), EndCondition::kBothHeld);
  constexpr double kWidth = 0.2;

  // Far from the grasp the slopes are those of the two branches: 1 / g below, -1 / (L - g) above (g = 0.8).
  EXPECT_NEAR(bar.blendedShare(0.6, 0.8, kWidth).slope, 1.0 / 0.8, 1e-12);
  EXPECT_NEAR(bar.blendedShare(1.0, 0.8, kWidth).slope, -1.0 / 1.2, 1e-12);
  // Between them no step is larger than the blend allows: 1.5 (range) (step / width).
  double before = bar.blendedShare(0.6, 0.8, kWidth).slope;
  for (double x = 0.601; x <= 1.0; x += 0.001) {
    const double here = bar.blendedShare(x, 0.8, kWidth).slope;
    EXPECT_LE(std::abs(here - before), 1.6 * (1.0 / 0.8 + 1.0 / 1.2) * 0.001 / kWidth);
    before = here;
  }
}

}  // namespace
}  // namespace torsio
