// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/safety/stored_energy.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/device/safety/force_governor.h"

namespace torsio {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;

/// What a wall at x = 0 gives a hand that goes to and fro through it, J a cycle, once it has settled: the
/// governor in between, and the limit behind it or not.
double givenByAWall_J(double stiffness_N_per_m, double frequency_Hz, double amplitude_m, bool limited,
                      bool fallsFreely) {
  constexpr int kSteps = 20;  // a tick
  ForceGovernor governor({.fallsFreely = fallsFreely});
  StoredEnergyLimit limit({});
  const int cycleTicks = static_cast<int>(std::lround(1000.0 / frequency_Hz));
  double given_J = 0.0;
  for (int tick = 0; tick < 20 * cycleTicks; ++tick) {
    const auto place_m = [&](double part) {
      return -amplitude_m * std::sin(kTwoPi * (tick + part) / cycleTicks);
    };
    const Vec3 tip_m{place_m(0.0), 0.0, 0.0};
    const double wanted_N = stiffness_N_per_m * std::max(0.0, -tip_m.x);
    std::uint32_t bits = kForceFull;
    Vec3 force_N = governor
                       .govern({.now_us = 1000LL * tick,
                                .computed_us = 1000LL * tick,
                                .wanted_N = {wanted_N, 0.0, 0.0},
                                .tip_m = tip_m})
                       .force_N;
    if (limited) {
      force_N = limit.limited(tip_m, force_N, true, bits);
    }
    if (tick >= 10 * cycleTicks) {  // the governor lets the force in over half a second
      for (int i = 0; i < kSteps; ++i) {
        given_J += force_N.x * (place_m((i + 1.0) / kSteps) - place_m(1.0 * i / kSteps));
      }
    }
  }
  return given_J / 10.0;
}

TEST(StoredEnergyLimit, KeepsASlewLimiterFromMakingAWallActive) {
  // 10 Hz, 8 mm: the hand comes in with 0.5 m/s, a spring of 400 N/m wants 200 N/s.
  const double before_J = givenByAWall_J(400.0, 10.0, 0.008, false, false);
  const double after_J = givenByAWall_J(400.0, 10.0, 0.008, true, true);

  EXPECT_GT(before_J, 5e-3);
  EXPECT_LE(after_J, 1e-3);
}

TEST(StoredEnergyLimit, NeverChangesAPassiveSpring) {
  StoredEnergyLimit limit({});
  for (int tick = 0; tick < 2'000; ++tick) {
    // A finger presses 4 mm deep and comes back, at most 13 mm/s, on 500 N/m.
    const double depth_m = 0.002 * (1.0 - std::cos(kTwoPi * tick / 1'000.0));
    const Vec3 wanted_N{500.0 * depth_m, 0.0, 0.0};
    std::uint32_t bits = kForceFull;

    const Vec3 force_N = limit.limited({-depth_m, 0.0, 0.0}, wanted_N, true, bits);

    ASSERT_EQ(force_N, wanted_N) << tick;
    ASSERT_EQ(bits, static_cast<std::uint32_t>(kForceFull));
  }
}

TEST(StoredEnergyLimit, CountsTheEnergyOfAHeldForceExactly) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;
  // 0.1 N outwards while the hand goes 3 mm in, then 0.2 N while it comes 1 mm out: 0.3 mJ - 0.2 mJ.
  (void)limit.limited({0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, true, bits);
  (void)limit.limited({-0.003, 0.0, 0.0}, {0.2, 0.0, 0.0}, true, bits);
  (void)limit.limited({-0.002, 0.0, 0.0}, {0.1, 0.0, 0.0}, true, bits);

  EXPECT_NEAR(limit.energy_J(), 1e-4, 1e-15);
  EXPECT_EQ(bits, static_cast<std::uint32_t>(kForceFull));
}

TEST(StoredEnergyLimit, WithholdsAForceWithoutStoredEnergy) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;

  const Vec3 first_N = limit.limited({}, {3.0, 0.0, 0.0}, true, bits);

  // sqrt(2 K e) of a hand at rest: sqrt(2 x 1000 N/m x 0.1 mJ).
  EXPECT_NEAR(first_N.x, std::sqrt(0.2), 1e-12);
  EXPECT_EQ(bits, static_cast<std::uint32_t>(kForcePassivity));
}

TEST(StoredEnergyLimit, ReturnsTheEnergyThatTheTissueLends) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;
  (void)limit.limited({}, {}, true, bits);
  limit.lend(0.02);

  EXPECT_EQ(limit.limited({}, {3.0, 0.0, 0.0}, true, bits).x, 3.0);  // sqrt(2 x 1000 x 0.0201) = 6.3 N
}

TEST(StoredEnergyLimit, ForgetsCreditButNotDebtAtARelease) {
  StoredEnergyLimit limit({});
  limit.lend(0.02);

  limit.forget();

  EXPECT_EQ(limit.energy_J(), 0.0);
}

TEST(StoredEnergyLimit, NeverLeavesAContactWithoutResistance) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;
  double depth_m = 0.004;
  (void)limit.limited({-depth_m, 0.0, 0.0}, {2.0, 0.0, 0.0}, true, bits);
  // Out by half a millimetre a tick until nothing is left, then in again.
  for (int i = 0; i < 4; ++i) {
    depth_m -= 0.0005;
    (void)limit.limited({-depth_m, 0.0, 0.0}, {500.0 * depth_m, 0.0, 0.0}, true, bits);
  }
  EXPECT_LT(limit.energy_J(), 0.0);
  double last_N = 0.0;
  for (int i = 0; i < 40; ++i) {
    depth_m += 0.00005;
    last_N = limit.limited({-depth_m, 0.0, 0.0}, {500.0 * depth_m, 0.0, 0.0}, true, bits).x;
    ASSERT_GE(last_N, kLeastResistance_N * 0.999) << i;
  }
  EXPECT_NEAR(last_N, 500.0 * depth_m, 0.2 * last_N);  // a millimetre or two on, the surface is itself again
}

TEST(StoredEnergyLimit, RefusesOptionsOutOfRange) {
  EXPECT_THROW(StoredEnergyLimit({.tickPeriod_us = 0}), Error);
  EXPECT_THROW(StoredEnergyLimit({.latency_ticks = -1}), Error);
  EXPECT_THROW(StoredEnergyLimit({.latency_ticks = 17}), Error);
}

}  // namespace
}  // namespace torsio
