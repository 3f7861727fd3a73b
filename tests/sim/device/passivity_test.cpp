// SPDX-License-Identifier: GPL-3.0-or-later
// The energy test: a mass on a stiff wall that is rendered with delay. The physics of the hand is integrated
// in steps of 10 us, the wall answers once a millisecond.
#include "sim/device/safety/passivity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/device/safety/force_governor.h"

namespace torsio {
namespace {

struct Wall {
  double stiffness_N_per_m = 500.0;
  int delay_ticks = 0;  // between the way that the tissue sees and its answer
  double bias_N = 0.0;  // with which the hand pushes
};

struct Outcome {
  double leastEnergy_J = 0.0;  // that the hand has put in; below 0 it got more back
  double finalSpeed_m_per_s = 0.0;
  double largestDepth_m = 0.0;  // in the last fifth
  int damped = 0;               // ticks
};

constexpr double kMass_kg = 0.1;  // finger and stylus
constexpr double kDamping_Ns_per_m = 0.1;
constexpr int kTicks = 5'000;

/// A mass flies into the wall with 0.1 m/s and stays there, pushed by the bias.
Outcome bounce(const Wall& wall, std::optional<PassivityOptions> options) {
  PassivityController controller(options.value_or(PassivityOptions{}));
  Outcome outcome;
  double x_m = 0.002;
  double v_m_per_s = -0.1;
  double energy_J = 0.0;
  double sent_N = 0.0;
  std::array<double, 32> past_m{};
  past_m.fill(x_m);
  for (int tick = 0; tick < kTicks; ++tick) {
    std::copy_backward(past_m.begin(), past_m.end() - 1, past_m.end());
    past_m[0] = x_m;
    const double depth_m = std::max(0.0, -past_m[static_cast<std::size_t>(wall.delay_ticks)]);
    double force_N = wall.stiffness_N_per_m * depth_m;
    std::uint32_t limits = kForceFull;
    if (options) {
      force_N = controller.control(1000LL * tick, {x_m, 0.0, 0.0}, {force_N, 0.0, 0.0}, true, limits).x;
      controller.sent({force_N, 0.0, 0.0});
    }
    outcome.damped += (limits & kForcePassivity) != 0 ? 1 : 0;
    sent_N = force_N;
    for (int i = 0; i < 100; ++i) {
      const double acceleration = (sent_N - wall.bias_N - kDamping_Ns_per_m * v_m_per_s) / kMass_kg;
      v_m_per_s += acceleration * 1e-5;
      x_m += v_m_per_s * 1e-5;
      energy_J -= sent_N * v_m_per_s * 1e-5;
    }
    outcome.leastEnergy_J = std::min(outcome.leastEnergy_J, energy_J);
    if (tick > kTicks * 4 / 5) {
      outcome.largestDepth_m = std::max(outcome.largestDepth_m, -x_m);
    }
  }
  outcome.finalSpeed_m_per_s = std::abs(v_m_per_s);
  return outcome;
}

// Kinetic energy of the mass at the first touch: 0.5 mJ. The controller sees an excess only when it is there
// and damps by 4 N s/m at most: what a few bounces overlook.
constexpr double kTouch_J = 0.5 * kMass_kg * 0.1 * 0.1;
constexpr double kOverlooked_J = 5.0 * kTouch_J;

TEST(PassivityController, KeepsADelayedStiffWallFromGivingEnergy) {
  const Wall wall{.stiffness_N_per_m = 500.0, .delay_ticks = 5, .bias_N = 0.5};

  const Outcome without = bounce(wall, std::nullopt);
  const Outcome with = bounce(wall, PassivityOptions{});

  EXPECT_LT(without.leastEnergy_J, -1.0);  // the wall drives the hand, faster and faster
  EXPECT_GT(without.finalSpeed_m_per_s, 0.5);
  EXPECT_GT(with.leastEnergy_J, -kOverlooked_J);
  EXPECT_GT(with.damped, 0);
  // It comes to rest where the bias holds it: 0.5 N over 500 N/m.
  EXPECT_LT(with.finalSpeed_m_per_s, 0.03);
  EXPECT_NEAR(with.largestDepth_m, 0.001, 0.0005);
}

TEST(PassivityController, KeepsAWallAboveTheBoundOfTheSampledSpring) {
  // b > k T / 2 (Colgate and Schenkel 1994): 2000 N/m at 1 ms want 1 N s/m, the hand has 0.1.
  const Wall wall{.stiffness_N_per_m = 2000.0, .bias_N = 1.0};

  const Outcome without = bounce(wall, std::nullopt);
  const Outcome with = bounce(wall, PassivityOptions{});

  EXPECT_LT(without.leastEnergy_J, -0.1);
  EXPECT_GT(with.leastEnergy_J, -kOverlooked_J);
  EXPECT_LT(with.finalSpeed_m_per_s, 0.03);
}

TEST(PassivityController, LeavesAHandAloneThatPutsInMoreThanItGetsBack) {
  PassivityController controller({});
  for (int tick = 0; tick < 4'000; ++tick) {
    // Presses 4 mm deep and moves to and fro between 2 and 4 mm.
    const double t_s = 1e-3 * tick;
    const double depth_m = tick < 500 ? 0.008 * t_s : 0.003 + 0.001 * std::cos(20.0 * (t_s - 0.5));
    std::uint32_t limits = kForceFull;
    const Vec3 wanted_N{400.0 * depth_m, 0.0, 0.0};

    const Vec3 force_N = controller.control(1000LL * tick, {-depth_m, 0.0, 0.0}, wanted_N, true, limits);

    ASSERT_EQ(force_N, wanted_N);
    ASSERT_EQ(limits, static_cast<std::uint32_t>(kForceFull));
    controller.sent(force_N);
  }
}

TEST(PassivityController, AddsNothingToAZeroForce) {
  PassivityController controller({});
  std::uint32_t limits = kForceFull;
  (void)controller.control(0, {}, {1.0, 0.0, 0.0}, true, limits);
  controller.sent({1.0, 0.0, 0.0});
  const Vec3 force_N = controller.control(1000, {0.001, 0.0, 0.0}, {}, true, limits);
  controller.sent(force_N);
  const Vec3 later_N = controller.control(2000, {0.002, 0.0, 0.0}, {}, true, limits);

  EXPECT_EQ(force_N, Vec3{});
  EXPECT_EQ(later_N, Vec3{});
  EXPECT_NEAR(controller.energy_J(), -0.001, 1e-15);  // still owed
}

TEST(PassivityController, CountsTheEnergyOfAHeldForceExactly) {
  PassivityController controller({});
  std::uint32_t limits = kForceFull;
  // 1 N outwards while the hand goes 3 mm in, then 2 N while it comes 1 mm out: 3 mJ - 2 mJ.
  (void)controller.control(0, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, true, limits);
  controller.sent({1.0, 0.0, 0.0});
  (void)controller.control(1000, {-0.003, 0.0, 0.0}, {2.0, 0.0, 0.0}, true, limits);
  controller.sent({2.0, 0.0, 0.0});
  (void)controller.control(2000, {-0.002, 0.0, 0.0}, {1.0, 0.0, 0.0}, true, limits);

  EXPECT_NEAR(controller.energy_J(), 0.001, 1e-15);
  EXPECT_EQ(limits, static_cast<std::uint32_t>(kForceFull));
}

TEST(PassivityController, PairsAForceWithTheWayThatItActsOnWhenTheDeviceIsLate) {
  PassivityController controller({.latency_ticks = 1});
  std::uint32_t limits = kForceFull;
  (void)controller.control(0, {0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, true, limits);
  controller.sent({1.0, 0.0, 0.0});
  (void)controller.control(1000, {-0.003, 0.0, 0.0}, {5.0, 0.0, 0.0}, true, limits);
  controller.sent({5.0, 0.0, 0.0});
  const double nothingYet_J = controller.energy_J();
  (void)controller.control(2000, {-0.005, 0.0, 0.0}, {5.0, 0.0, 0.0}, true, limits);

  EXPECT_EQ(nothingYet_J, 0.0);
  EXPECT_NEAR(controller.energy_J(), 1.0 * 0.002, 1e-15);
}

TEST(PassivityController, DampsAgainstTheMotionAndNeverBeyondItsLimit) {
  Random random(4);
  PassivityController controller({});
  Vec3 tip_m;
  int damped = 0;
  for (int i = 0; i < 20'000; ++i) {
    tip_m += Vec3{random.normal(), random.normal(), random.normal()} * 2e-5;
    const Vec3 wanted_N{random.normal(), random.normal(), random.normal()};
    std::uint32_t limits = kForceFull;
    const Vec3 force_N = controller.control(1000LL * i, tip_m, wanted_N, true, limits);
    ASSERT_TRUE(isFinite(force_N));
    const bool acted = (limits & kForcePassivity) != 0;
    damped += acted ? 1 : 0;
    ASSERT_TRUE(acted || force_N == wanted_N);
    // Four ticks of at most some 1e-4 m: 4 N s/m times 0.1 m/s.
    ASSERT_LT(norm(force_N - wanted_N), kLargestDamping_Ns_per_m * 0.15);
    controller.sent(force_N);
  }
  EXPECT_GT(damped, 100);
}

TEST(PassivityController, ResetsOutOfContactAndWhenTheHandIsLost) {
  std::uint32_t limits = kForceFull;
  for (const bool lost : {false, true}) {
    PassivityController controller({});
    (void)controller.control(0, {}, {1.0, 0.0, 0.0}, true, limits);
    controller.sent({1.0, 0.0, 0.0});
    (void)controller.control(1000, {-0.003, 0.0, 0.0}, {}, true, limits);
    ASSERT_GT(controller.energy_J(), 0.0);
    controller.sent({});
    (void)controller.control(2000, {0.5, 0.0, 0.0}, {}, !lost, limits);

    EXPECT_EQ(controller.energy_J(), 0.0);
  }
}

TEST(PassivityController, RefusesOptionsOutOfRange) {
  EXPECT_THROW(PassivityController({.tickPeriod_us = 0}), Error);
  EXPECT_THROW(PassivityController({.latency_ticks = 17}), Error);
  EXPECT_THROW(PassivityController({.largestDamping_Ns_per_m = std::nan("")}), Error);
}

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
      force_N = limit.limited(tip_m, force_N, HandReading::kFresh, bits);
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

    const Vec3 force_N = limit.limited({-depth_m, 0.0, 0.0}, wanted_N, HandReading::kFresh, bits);

    ASSERT_EQ(force_N, wanted_N) << tick;
    ASSERT_EQ(bits, static_cast<std::uint32_t>(kForceFull));
  }
}

TEST(StoredEnergyLimit, CountsTheEnergyOfAHeldForceExactly) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;
  // 0.1 N outwards while the hand goes 3 mm in, then 0.2 N while it comes 1 mm out: 0.3 mJ - 0.2 mJ.
  (void)limit.limited({0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, HandReading::kFresh, bits);
  (void)limit.limited({-0.003, 0.0, 0.0}, {0.2, 0.0, 0.0}, HandReading::kFresh, bits);
  (void)limit.limited({-0.002, 0.0, 0.0}, {0.1, 0.0, 0.0}, HandReading::kFresh, bits);

  EXPECT_NEAR(limit.energy_J(), 1e-4, 1e-15);
  EXPECT_EQ(bits, static_cast<std::uint32_t>(kForceFull));
}

TEST(StoredEnergyLimit, WithholdsAForceWithoutStoredEnergy) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;

  const Vec3 first_N = limit.limited({}, {3.0, 0.0, 0.0}, HandReading::kFresh, bits);

  // sqrt(2 K e) of a hand at rest: sqrt(2 x 1000 N/m x 0.1 mJ).
  EXPECT_NEAR(first_N.x, std::sqrt(0.2), 1e-12);
  EXPECT_EQ(bits, static_cast<std::uint32_t>(kForcePassivity));
}

TEST(StoredEnergyLimit, ReturnsTheEnergyThatTheTissueLends) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;
  (void)limit.limited({}, {}, HandReading::kFresh, bits);
  limit.lend(0.02);

  EXPECT_EQ(limit.limited({}, {3.0, 0.0, 0.0}, HandReading::kFresh, bits).x,
            3.0);  // sqrt(2 x 1000 x 0.0201) = 6.3 N
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
  (void)limit.limited({-depth_m, 0.0, 0.0}, {2.0, 0.0, 0.0}, HandReading::kFresh, bits);
  // Out by half a millimetre a tick until nothing is left, then in again.
  for (int i = 0; i < 4; ++i) {
    depth_m -= 0.0005;
    (void)limit.limited({-depth_m, 0.0, 0.0}, {500.0 * depth_m, 0.0, 0.0}, HandReading::kFresh, bits);
  }
  EXPECT_LT(limit.energy_J(), 0.0);
  double last_N = 0.0;
  for (int i = 0; i < 40; ++i) {
    depth_m += 0.00005;
    last_N = limit.limited({-depth_m, 0.0, 0.0}, {500.0 * depth_m, 0.0, 0.0}, HandReading::kFresh, bits).x;
    ASSERT_GE(last_N, kLeastResistance_N * 0.999) << i;
  }
  EXPECT_NEAR(last_N, 500.0 * depth_m, 0.2 * last_N);  // a millimetre or two on, the surface is itself again
}

TEST(StoredEnergyLimit, CountsAHiddenWayAsIfTheHandHadGoneEvenly) {
  StoredEnergyLimit limit({});
  std::uint32_t bits = kForceFull;
  const Vec3 force_N{0.1, 0.0, 0.0};
  // 3 mm in, then out by half a millimetre a tick, two of which the reading hides: 0.3 mJ - 4 x 0.05 mJ.
  (void)limit.limited({}, force_N, HandReading::kFresh, bits);
  (void)limit.limited({-0.003, 0.0, 0.0}, force_N, HandReading::kFresh, bits);
  (void)limit.limited({-0.0025, 0.0, 0.0}, force_N, HandReading::kFresh, bits);
  (void)limit.limited({-0.0025, 0.0, 0.0}, force_N, HandReading::kStandsStill, bits);
  (void)limit.limited({-0.0025, 0.0, 0.0}, force_N, HandReading::kStandsStill, bits);
  (void)limit.limited({-0.001, 0.0, 0.0}, force_N, HandReading::kFresh, bits);

  EXPECT_NEAR(limit.energy_J(), 1e-4, 1e-15);
  EXPECT_EQ(bits, static_cast<std::uint32_t>(kForceFull));
}

/// The energy of a hand that has 1 mJ from the tissue and goes out by a millimetre a tick, is hidden for two
/// ticks, is back where it was, and then goes out by 4 mm.
double leftAfterAHiddenReturn_J(StoredEnergyLimit& limit) {
  std::uint32_t bits = kForceFull;
  (void)limit.limited({}, {}, HandReading::kFresh, bits);
  limit.lend(1e-3);
  (void)limit.limited({}, {0.5, 0.0, 0.0}, HandReading::kFresh, bits);
  (void)limit.limited({0.001, 0.0, 0.0}, {0.4, 0.0, 0.0}, HandReading::kFresh, bits);
  (void)limit.limited({0.001, 0.0, 0.0}, {0.1, 0.0, 0.0}, HandReading::kStandsStill, bits);
  (void)limit.limited({0.001, 0.0, 0.0}, {0.09, 0.0, 0.0}, HandReading::kStandsStill, bits);
  (void)limit.limited({0.001, 0.0, 0.0}, {0.05, 0.0, 0.0}, HandReading::kFresh, bits);
  (void)limit.limited({0.005, 0.0, 0.0}, {0.01, 0.0, 0.0}, HandReading::kFresh, bits);
  return limit.energy_J();
}

TEST(StoredEnergyLimit, ForgivesNoLossThatAHiddenWayMayHaveMeantBeforeTheContactEnds) {
  StoredEnergyLimit limit({});

  // 1 - 0.5 (a millimetre) - (0.4 + 0.1 + 0.09) (hidden) - 0.05 x 4 mJ; 0.1 mJ below 0 were forgiven before.
  EXPECT_NEAR(leftAfterAHiddenReturn_J(limit), -2.9e-4, 1e-12);
  std::uint32_t bits = kForceFull;
  (void)limit.limited({0.005, 0.0, 0.0}, {}, HandReading::kFresh, bits);
  (void)limit.limited({0.005, 0.0, 0.0}, {}, HandReading::kFresh, bits);
  EXPECT_EQ(limit.energy_J(), 0.0);
}

TEST(StoredEnergyLimit, ByEarlierRulesAHiddenReturnCostNothing) {
  StoredEnergyLimit limit({.countsHiddenWays = false});

  EXPECT_NEAR(leftAfterAHiddenReturn_J(limit), 3e-4, 1e-12);  // 1 - 0.5 - 0.05 x 4 mJ
}

TEST(StoredEnergyLimit, RefusesOptionsOutOfRange) {
  EXPECT_THROW(StoredEnergyLimit({.tickPeriod_us = 0}), Error);
  EXPECT_THROW(StoredEnergyLimit({.latency_ticks = -1}), Error);
  EXPECT_THROW(StoredEnergyLimit({.latency_ticks = 17}), Error);
}

}  // namespace
}  // namespace torsio
