// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the cases (F1 to F7) are those of the haptics plan: what a force must never do.
#include "sim/device/safety/force_governor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr std::int64_t kTick_us = 1000;
constexpr double kSlewStep_N = kSlewLimit_N_per_s * 1e-3;
// Sums of a few rounded doubles of the size of one newton.
constexpr double kRounding_N = 1e-12;

/// A governor with its own time, driven tick by tick.
class Bench {
 public:
  explicit Bench(const GovernorLimits& limits = {}) : governor(limits) {}

  ForceCommand tick(const Vec3& wanted_N, std::uint32_t status = kDeviceOk, const Vec3& tip_m = {}) {
    now_us += kTick_us;
    return governor.govern({now_us, now_us, wanted_N, tip_m, status});
  }
  ForceCommand run(std::int64_t ticks, const Vec3& wanted_N) {
    ForceCommand last;
    for (std::int64_t i = 0; i < ticks; ++i) {
      last = tick(wanted_N);
    }
    return last;
  }
  /// Engaged, with the slew limiter settled on the wanted force.
  static Bench engaged(const Vec3& wanted_N = {}, const GovernorLimits& limits = {}) {
    Bench bench(limits);
    bench.run(kEngageTime_us / kTick_us + 100, wanted_N);
    return bench;
  }

  ForceGovernor governor;
  std::int64_t now_us = 0;
};

TEST(ForceGovernor, LetsASmallForceThroughUnchangedOnceEngaged) {
  Bench bench = Bench::engaged({0.1, -0.2, 0.3});

  const ForceCommand sent = bench.tick({0.1, -0.2, 0.3});

  EXPECT_EQ(bench.governor.state(), GovernorState::kEngaged);
  EXPECT_EQ(sent.limits, static_cast<std::uint32_t>(kForceFull));
  EXPECT_NEAR(norm(sent.force_N - Vec3{0.1, -0.2, 0.3}), 0.0, kRounding_N);
}

TEST(ForceGovernor, F1ClampsTheNormAndKeepsTheDirection) {
  Bench bench = Bench::engaged();
  const Vec3 wanted_N = Vec3{10.0, 10.0, 10.0} / std::sqrt(3.0);

  const ForceCommand sent = bench.run(40, wanted_N);  // 3.3 N at 0.1 N a tick

  EXPECT_NEAR(norm(sent.force_N), 3.3, kRounding_N);
  EXPECT_NEAR(norm(cross(normalized(sent.force_N), normalized(wanted_N))), 0.0, kRounding_N);
  EXPECT_TRUE(sent.limits & kForceSaturated);
}

/// How far a force rises over the last one: the way from the part of the last one that the next one keeps.
double rise_N(const Vec3& last_N, const Vec3& next_N) {
  const double square = dot(last_N, last_N);
  const double kept = square > 0.0 ? std::clamp(dot(last_N, next_N) / square, 0.0, 1.0) : 0.0;
  return norm(next_N - last_N * kept);
}

TEST(ForceGovernor, F2HoldsTheSlewLimitInEveryTickOfAStepAndASignFlip) {
  Bench bench = Bench::engaged();
  Vec3 before_N;
  double largest_N = 0.0;
  for (int i = 0; i < 400; ++i) {
    const Vec3 wanted_N{i < 100 ? 3.0 : (i < 250 ? -3.0 : 0.0), 0.0, 0.0};
    const ForceCommand sent = bench.tick(wanted_N);
    largest_N = std::max(largest_N, rise_N(before_N, sent.force_N));
    before_N = sent.force_N;
    // What is wanted no more is gone at once.
    ASSERT_TRUE(i < 250 || sent.force_N == Vec3{}) << i;
  }

  EXPECT_LE(largest_N, kSlewStep_N + kRounding_N);
  EXPECT_GE(largest_N, kSlewStep_N - kRounding_N);  // it was at work
}

TEST(ForceGovernor, F2HoldsTheSlewLimitWhileRampsRunAndForcesJumpAtRandom) {
  for (const bool fallsFreely : {true, false}) {
    Bench bench;
    bench.governor = ForceGovernor({.fallsFreely = fallsFreely});
    Random random(5);
    Vec3 wanted_N;
    Vec3 before_N;
    for (int i = 0; i < 20'000; ++i) {
      if (random.bounded(50) == 0) {
        wanted_N = {4.0 * random.normal(), 4.0 * random.normal(), 4.0 * random.normal()};
      }
      if (random.bounded(300) == 0) {
        bench.governor.enable(random.bounded(2) == 0);
      }
      const Vec3 sent_N = bench.tick(wanted_N).force_N;
      const double step_N = fallsFreely ? rise_N(before_N, sent_N) : norm(sent_N - before_N);
      ASSERT_LE(step_N, kSlewStep_N + kRounding_N) << "tick " << i;
      ASSERT_LE(norm(sent_N), 3.3 + kRounding_N);
      before_N = sent_N;
    }
  }
}

TEST(ForceGovernor, F3SendsZeroAndInhibitsForForcesThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  for (const Vec3& bad_N : {Vec3{kNan, 0, 0}, Vec3{0, kInfinite, 0}, Vec3{0, 0, 1e200}}) {
    Bench bench = Bench::engaged({1.0, 0.0, 0.0});

    const ForceCommand sent = bench.tick(bad_N);

    EXPECT_EQ(sent.force_N, Vec3{});
    EXPECT_EQ(bench.governor.state(), GovernorState::kInhibited);
    EXPECT_EQ(sent.limits, static_cast<std::uint32_t>(kForceNotFinite | kForceInhibited));
  }
}

TEST(ForceGovernor, F3InhibitsForAnInvalidPoseAndEngagesByRampAfterASoundSecond) {
  Bench bench = Bench::engaged({1.0, 0.0, 0.0});

  EXPECT_EQ(bench.tick({1.0, 0.0, 0.0}, kDeviceInvalid).force_N, Vec3{});
  const ForceCommand stillOff = bench.run(kInhibitTime_us / kTick_us - 1, {1.0, 0.0, 0.0});
  const ForceCommand first = bench.tick({1.0, 0.0, 0.0});
  const ForceCommand last = bench.run(kEngageTime_us / kTick_us, {1.0, 0.0, 0.0});

  EXPECT_EQ(stillOff.force_N, Vec3{});
  EXPECT_TRUE(first.limits & kForceEngaging);
  EXPECT_LT(norm(first.force_N), 0.001);
  EXPECT_NEAR(last.force_N.x, 1.0, kRounding_N);
}

TEST(ForceGovernor, F3StaysInhibitedAfterRepeatedFaultsUntilSwitchedOffAndOn) {
  Bench bench = Bench::engaged();
  for (int fault = 0; fault <= kFaultsForgiven; ++fault) {
    (void)bench.tick({1.0, 0.0, 0.0}, kDeviceInvalid);
    (void)bench.run(2 * kInhibitTime_us / kTick_us, {1.0, 0.0, 0.0});
  }
  ASSERT_EQ(bench.governor.state(), GovernorState::kInhibited);

  bench.governor.enable(false);
  bench.governor.enable(true);
  (void)bench.run(kEngageTime_us / kTick_us, {1.0, 0.0, 0.0});

  EXPECT_EQ(bench.governor.state(), GovernorState::kEngaged);
}

TEST(ForceGovernor, F4EngagesInsideTheOrganFromZeroWithAMonotoneRamp) {
  Bench bench;
  const Vec3 wanted_N{0.0, 10.0, 0.0};  // 20 mm deep at 500 N/m

  double before_N = 0.0;
  double first_N = -1.0;
  for (std::int64_t i = 0; i < kEngageTime_us / kTick_us; ++i) {
    const double sent_N = bench.tick(wanted_N).force_N.y;
    if (first_N < 0.0) {
      first_N = sent_N;
    }
    ASSERT_GE(sent_N, before_N);
    before_N = sent_N;
  }

  EXPECT_LT(first_N, 0.001);
  EXPECT_NEAR(before_N, 3.3, kRounding_N);
}

/// What is sent of 1 N that is not computed anew for 100 ms, tick by tick from then on for 300 ms.
std::vector<double> stalled_N(bool fadesAtOnce, int firstLate) {
  Bench bench = Bench::engaged({1.0, 0.0, 0.0}, {.fadesAtOnce = fadesAtOnce});
  const std::int64_t stalledAt_us = bench.now_us;
  std::vector<double> sent_N;
  for (int i = 0; i < 300; ++i) {
    bench.now_us += kTick_us;
    const std::int64_t computed_us = i < 100 ? stalledAt_us : bench.now_us;
    const ForceCommand sent = bench.governor.govern({bench.now_us, computed_us, {1.0, 0.0, 0.0}, {}, 0});
    sent_N.push_back(sent.force_N.x);
    EXPECT_EQ((sent.limits & kForceStale) != 0, i >= firstLate && i < 199) << i;
  }
  for (std::size_t i = 101; i < 200; ++i) {
    EXPECT_GE(sent_N[i], sent_N[i - 1]);
  }
  EXPECT_NEAR(sent_N[149], 0.5, 0.02);  // 100 ms of recovery, half done
  EXPECT_NEAR(sent_N[250], 1.0, kRounding_N);
  return sent_N;
}

TEST(ForceGovernor, F5FadesAForceThatIsNoLongerComputedAtOnceAndFadesItBack) {
  const std::vector<double> sent_N = stalled_N(true, 0);

  for (std::size_t i = 0; i < 100; ++i) {
    ASSERT_NEAR(sent_N[i], std::max(0.0, 0.75 - 0.25 * static_cast<double>(i)), 1e-9) << i;  // 0 after 4 ms
  }
}

TEST(ForceGovernor, F5FadedAForceFromFiveTo25MillisecondsByEarlierRules) {
  const std::vector<double> sent_N = stalled_N(false, 5);

  EXPECT_NEAR(sent_N[4], 1.0, kRounding_N);  // 5 ms old: still whole
  EXPECT_NEAR(sent_N[14], 0.5, 1e-9);        // 15 ms: half way between 5 and 25 ms
  for (std::size_t i = 25; i < 100; ++i) {
    ASSERT_EQ(sent_N[i], 0.0) << i;
  }
}

TEST(ForceGovernor, F5TreatsADeviceThatSaysNothingNewLikeAStall) {
  Bench bench = Bench::engaged({1.0, 0.0, 0.0});
  ForceCommand sent;

  for (int i = 0; i < 30; ++i) {
    sent = bench.tick({1.0, 0.0, 0.0}, kDeviceStale);
  }

  EXPECT_EQ(sent.force_N, Vec3{});
  EXPECT_TRUE(sent.limits & kForceStale);
}

TEST(ForceGovernor, F5CutsTheForceAfterAGapBetweenTicksAndEngagesAnew) {
  Bench bench = Bench::engaged({1.0, 0.0, 0.0});

  bench.now_us += 100'000;
  const ForceCommand afterGap = bench.tick({1.0, 0.0, 0.0});
  const ForceCommand next = bench.tick({1.0, 0.0, 0.0});

  EXPECT_EQ(afterGap.force_N, Vec3{});
  EXPECT_EQ(bench.governor.state(), GovernorState::kEngaging);
  EXPECT_LT(norm(next.force_N), 0.001);
  EXPECT_NEAR(bench.run(600, {1.0, 0.0, 0.0}).force_N.x, 1.0, kRounding_N);
}

TEST(ForceGovernor, KeepsTheForceAcrossAGapOfThreeMilliseconds) {
  Bench bench = Bench::engaged({1.0, 0.0, 0.0});

  bench.now_us += 2'000;
  const ForceCommand late = bench.tick({3.0, 0.0, 0.0});

  EXPECT_NEAR(late.force_N.x, 1.0 + kSlewStep_N, kRounding_N);  // one step, not three
}

TEST(ForceGovernor, F6HoldsASustainedForceToTheContinuousBudget) {
  Bench bench = Bench::engaged();
  const double budget_N2 = 0.88 * 0.88;

  const ForceCommand early = bench.run(1'000, {2.0, 0.0, 0.0});
  double hottest_N2 = 0.0;
  ForceCommand late;
  for (int i = 0; i < 600'000; ++i) {
    late = bench.tick({2.0, 0.0, 0.0});
    hottest_N2 = std::max(hottest_N2, bench.governor.heat_N2());
  }

  EXPECT_NEAR(early.force_N.x, 2.0, kRounding_N);
  EXPECT_NEAR(late.force_N.x, 0.88, 0.88 * 0.01);
  EXPECT_LE(hottest_N2, budget_N2 * (1.0 + 1e-9));
  EXPECT_TRUE(late.limits & kForceEnergy);
}

TEST(ForceGovernor, F6NeverTouchesAForceBelowTheContinuousOne) {
  Bench bench = Bench::engaged({0.87, 0.0, 0.0});

  const ForceCommand late = bench.run(600'000, {0.87, 0.0, 0.0});

  EXPECT_NEAR(late.force_N.x, 0.87, kRounding_N);
  EXPECT_EQ(late.limits, static_cast<std::uint32_t>(kForceFull));
}

TEST(ForceGovernor, F7FadesTheForceOutsideTheUsableWorkspace) {
  GovernorLimits limits{.workspaceMin_m = {-0.08, -0.06, -0.035}, .workspaceMax_m = {0.08, 0.06, 0.035}};
  Bench bench(limits);
  bench.run(600, {1.0, 0.0, 0.0});

  const auto settled = [&bench](const Vec3& tip_m) {
    ForceCommand sent;
    for (int i = 0; i < 50; ++i) {
      sent = bench.tick({1.0, 0.0, 0.0}, kDeviceOk, tip_m);
    }
    return sent;
  };

  EXPECT_NEAR(settled({0.08, 0.0, 0.0}).force_N.x, 1.0, kRounding_N);
  EXPECT_NEAR(settled({0.085, 0.0, 0.0}).force_N.x, 0.5, 1e-9);
  EXPECT_TRUE(settled({0.085, 0.0, 0.0}).limits & kForceWorkspace);
  EXPECT_EQ(settled({0.0, -0.2, 0.0}).force_N, Vec3{});
  EXPECT_NEAR(settled({}).force_N.x, 1.0, kRounding_N);
}

TEST(ForceGovernor, FoldsBackWhileTheMotorsAreWarmAndRecoversSlowly) {
  Bench bench = Bench::engaged({1.2, 0.0, 0.0});

  ForceCommand warm;
  for (int i = 0; i < 2'000; ++i) {
    warm = bench.tick({1.2, 0.0, 0.0}, kDeviceWarm);
  }
  const ForceCommand cooling = bench.run(100, {1.2, 0.0, 0.0});
  const ForceCommand cool = bench.run(1'400, {1.2, 0.0, 0.0});

  // 3.3 * 0.999^n reaches 0.88 after 1322 ticks; 0.88 * 1.001^n reaches 1.2 after 311.
  EXPECT_NEAR(warm.force_N.x, 0.88, kRounding_N);
  EXPECT_TRUE(warm.limits & kForceThermal);
  EXPECT_NEAR(cooling.force_N.x, 0.88 * std::pow(1.001, 100), 1e-9);
  EXPECT_NEAR(cool.force_N.x, 1.2, kRounding_N);
}

TEST(ForceGovernor, IsSilentWhileTheDeviceIsLostAndRampsUpAfterwards) {
  for (const std::uint32_t status : {kDeviceLost, kDeviceUncalibrated, kDeviceEnded}) {
    Bench bench = Bench::engaged({1.0, 0.0, 0.0});

    const ForceCommand lost = bench.tick({1.0, 0.0, 0.0}, status);
    const ForceCommand back = bench.tick({1.0, 0.0, 0.0});

    EXPECT_EQ(lost.force_N, Vec3{});
    EXPECT_TRUE(lost.limits & kForceInhibited);
    EXPECT_EQ(bench.governor.state(), GovernorState::kEngaging);
    EXPECT_LT(norm(back.force_N), 0.001);
  }
}

TEST(ForceGovernor, ReleasesByRampWhenSwitchedOffAndStaysSilent) {
  Bench bench = Bench::engaged({1.0, 0.0, 0.0});
  bench.governor.enable(false);

  const ForceCommand first = bench.tick({1.0, 0.0, 0.0});
  const GovernorState during = bench.governor.state();
  const ForceCommand last = bench.run(kReleaseTime_us / kTick_us, {1.0, 0.0, 0.0});

  EXPECT_NEAR(first.force_N.x, 0.99, 1e-9);  // one of a hundred steps down
  EXPECT_EQ(during, GovernorState::kReleasing);
  EXPECT_EQ(last.force_N, Vec3{});
  EXPECT_EQ(bench.governor.state(), GovernorState::kOff);
  EXPECT_EQ(bench.run(1'000, {1.0, 0.0, 0.0}).force_N, Vec3{});
}

TEST(ForceGovernor, MirrorsItsOutputWhenItsInputIsMirrored) {
  Bench bench;
  Bench mirrored;
  Random random(11);
  for (int i = 0; i < 5'000; ++i) {
    const Vec3 wanted_N{3.0 * random.normal(), 3.0 * random.normal(), 3.0 * random.normal()};
    const Vec3 sent_N = bench.tick(wanted_N).force_N;
    const Vec3 other_N = mirrored.tick({-wanted_N.x, wanted_N.y, wanted_N.z}).force_N;
    ASSERT_EQ(Vec3(-sent_N.x, sent_N.y, sent_N.z), other_N);
  }
}

TEST(ForceGovernor, RepeatsItselfFromACopyOfItsState) {
  Bench bench = Bench::engaged({2.0, 0.5, 0.0});
  Bench copy = bench;

  for (int i = 0; i < 2'000; ++i) {
    const Vec3 wanted_N{i % 7 * 0.5, -1.0, i % 3 * 1.0};
    const ForceCommand a = bench.tick(wanted_N);
    const ForceCommand b = copy.tick(wanted_N);
    ASSERT_EQ(a.force_N, b.force_N);
    ASSERT_EQ(a.limits, b.limits);
  }
}

TEST(ForceGovernor, RefusesLimitsOutOfOrder) {
  GovernorLimits continuousAboveMaximum{.continuousForce_N = 5.0};
  GovernorLimits notANumber{.maxForce_N = std::numeric_limits<double>::quiet_NaN()};
  GovernorLimits emptyBox;
  emptyBox.workspaceMax_m = emptyBox.workspaceMin_m;

  for (const GovernorLimits& bad : {continuousAboveMaximum, notANumber, emptyBox}) {
    EXPECT_EQ(testing::refusal([&] { ForceGovernor governor(bad); }).code(), ErrorCode::kBadParameter);
  }
}

}  // namespace
}  // namespace torsio
