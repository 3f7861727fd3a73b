// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/contact_coupling.h"

#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"

namespace torsio {
namespace {

constexpr double kSurface_N_per_m = 500.0;

TEST(ContactCoupling, MeetsASteadyPushWithTheSpringsInSeries) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);

  for (int i = 0; i < 50; ++i) {
    (void)coupling.step(0.002);
  }

  // 500 and 2000 N/m in series are 400 N/m; the surface takes 2000 / 2500 of the way.
  EXPECT_NEAR(coupling.force_N(), 400.0 * 0.002, 1e-12);
  EXPECT_NEAR(coupling.indentation_m(), 0.8 * 0.002, 1e-15);
}

TEST(ContactCoupling, NeverRendersMoreThanTheSurfacesStiffness) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);
  double depth_m = 0.0;
  for (int i = 1; i < 200; ++i) {
    depth_m = 0.003 * (1.0 - std::cos(0.1 * i));
    (void)coupling.step(depth_m);
    ASSERT_LE(coupling.force_N(), kSurface_N_per_m * 0.006);
    ASSERT_GE(coupling.force_N(), 0.0);
  }
}

TEST(ContactCoupling, TakesInMoreWorkThanItGivesBackOverEveryCycle) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);
  double work_J = 0.0;
  double before_m = 0.0;
  double before_N = 0.0;
  for (int i = 0; i <= 1000; ++i) {
    const double depth_m = 0.002 + 0.001 * std::sin(2.0 * 3.14159265358979 * i / 100.0);
    (void)coupling.step(depth_m);
    // Trapezoid: the continuous coupling's own work, without the hold between ticks.
    if (i > 100) {
      work_J += 0.5 * (coupling.force_N() + before_N) * (depth_m - before_m);
    }
    before_m = depth_m;
    before_N = coupling.force_N();
  }
  EXPECT_GT(work_J, 0.0);
}

TEST(ContactCoupling, EndsWithTheContact) {
  ContactCoupling coupling(kSurface_N_per_m, 1000);
  (void)coupling.step(0.002);

  EXPECT_EQ(coupling.step(-0.001), 0.0);
  EXPECT_EQ(coupling.force_N(), 0.0);
  ContactCoupling fresh(kSurface_N_per_m, 1000);
  EXPECT_EQ(coupling.step(0.001), fresh.step(0.001));
}

constexpr ContactPatch kPatch{{0.1, 0.2, 0.3}, {0.0, 0.0, 1.0}, 0.002, 0.0025, 0.015};
constexpr double kRounding_m = 1e-15;

double depthAt(double r_m) {
  return -indentationAt(kPatch, kPatch.point_m + Vec3{r_m, 0.0, 0.0}).z;
}

TEST(Indentation, FollowsTheMembraneLaw) {
  EXPECT_EQ(depthAt(0.0), kPatch.depth_m);
  EXPECT_NEAR(depthAt(0.0025), kPatch.depth_m, kRounding_m);
  // Half way in the logarithm: r = sqrt(a R).
  EXPECT_NEAR(depthAt(std::sqrt(0.0025 * 0.015)), 0.5 * kPatch.depth_m, kRounding_m);
  EXPECT_NEAR(depthAt(0.005), 0.002 * std::log(3.0) / std::log(6.0), kRounding_m);
  EXPECT_NEAR(depthAt(0.0149999), 0.0, 1e-7);
  EXPECT_EQ(depthAt(0.015), 0.0);
  EXPECT_EQ(depthAt(0.1), 0.0);
}

TEST(Indentation, PushesBackWithTheForceOfItsTension) {
  // F = 2 pi S w0 / ln(R / a) must be the contact force k w0.
  // So S = 500 N/m ln(0.015 / 0.0025) / 2 pi, and the slope of the dent carries F = 2 pi r S |dw/dr| at any r
  // beyond the tip.
  const double tension = 500.0 * std::log(6.0) / (2.0 * kPi);
  const double r_m = 0.006;
  const double step_m = 1e-7;
  const double slope = (depthAt(r_m - step_m) - depthAt(r_m + step_m)) / (2.0 * step_m);
  EXPECT_NEAR(2.0 * kPi * r_m * tension * slope, 500.0 * kPatch.depth_m, 1e-6);
}

TEST(Indentation, MovesTheVerticesOfAViewUnderBothPartsAndNoOthers) {
  LiveState state;
  state.patches = {kPatch, ContactPatch{{0.1, 0.2, 0.4}, {1.0, 0.0, 0.0}, 0.001, 0.0025, 0.015}};
  std::vector<Vec3> vertices_m{{0.1, 0.2, 0.3}, {0.1, 0.2, 0.4}, {0.0, 0.0, 0.0}};

  EXPECT_TRUE(indentSurface(state, vertices_m));

  EXPECT_NEAR(vertices_m[0].z, 0.298, kRounding_m);
  EXPECT_NEAR(vertices_m[1].x, 0.099, kRounding_m);
  EXPECT_EQ(vertices_m[2], Vec3{});
}

TEST(Indentation, MovesNothingOutOfContact) {
  std::vector<Vec3> vertices_m{{0.1, 0.2, 0.3}};

  EXPECT_FALSE(indentSurface(LiveState{}, vertices_m));

  EXPECT_EQ(vertices_m[0], (Vec3{0.1, 0.2, 0.3}));
  EXPECT_EQ(indentationAt(ContactPatch{}, {}), Vec3{});
}

}  // namespace
}  // namespace torsio
