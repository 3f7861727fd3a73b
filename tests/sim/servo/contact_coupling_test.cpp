// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/contact_coupling.h"

#include <cmath>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace torsio
