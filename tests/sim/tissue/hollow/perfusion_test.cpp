// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/perfusion.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "tests/support/allocation_count.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr double kHour_s = 3600.0;

/// (P_a - max(P_v, P_1 (a / 360)^k)) / (P_a - P_v) with 90, 5, 35 mmHg and k 1.28, of the C library's power.
double flowByPower(double angle_deg) {
  return (90.0 - std::fmin(90.0, std::fmax(5.0, 35.0 * std::pow(angle_deg / 360.0, 1.28)))) / 85.0;
}

TEST(Perfusion, ATurnThrottlesTheFlowAsTheFormulaSays) {
  // The first and last measured: rat testes at 720 degrees keep 6 % (PubMed 8373967). The list by hand:
  // P_c(360) = 35, so Q = 55/85 = .647; P_c(720) = 35 * 2^1.28 = 84.99, so Q = 5.01/85 = .059.
  const Perfusion vessels{PerfusionParameters{}};
  const std::pair<double, double> listed[] = {{90, 0.989},  {180, 0.889}, {270, 0.774}, {360, 0.647},
                                              {450, 0.511}, {540, 0.367}, {720, 0.059}, {750, 0.006}};

  for (const auto& [angle_deg, flow] : listed) {
    EXPECT_NEAR(vessels.steadyFlow(radians(angle_deg), 0.0), flow, 1e-3) << angle_deg;
    EXPECT_EQ(vessels.steadyFlow(radians(-angle_deg), 0.0), vessels.steadyFlow(radians(angle_deg), 0.0));
  }
  for (double angle_deg = 0.0; angle_deg < 1000.0; angle_deg += 0.7) {
    EXPECT_NEAR(vessels.steadyFlow(radians(angle_deg), 0.0), flowByPower(angle_deg), 1e-5) << angle_deg;
  }
  EXPECT_EQ(vessels.steadyFlow(0.0, 0.0), 1.0);
  EXPECT_EQ(vessels.steadyFlow(radians(753.0), 0.0), 0.0);  // 360 (90/35)^(1/1.28) = 752.92
  EXPECT_GT(vessels.steadyFlow(radians(752.9), 0.0), 0.0);
}

TEST(Perfusion, ThePowerFromAStaticReopeningPressureGivesTheOtherListOfTheSource) {
  // P_1 22 mmHg with k 1.95: (90 - 22)/85 = .800; P_c(540) = 22 * 1.5^1.95 = 48.5, so .488.
  const Perfusion vessels{PerfusionParameters{.shutAtTurn_mmHg = 22.0, .shutPower = 1.95}};

  EXPECT_NEAR(vessels.steadyFlow(radians(360.0), 0.0), 0.800, 1e-3);
  EXPECT_NEAR(vessels.steadyFlow(radians(540.0), 0.0), 0.488, 1e-3);
}

TEST(Perfusion, PressureInTheLumenThrottlesFromThirtyMillimetresAndLeavesAFloor) {
  // (90 - (p - 25))/85: 30: 1, 40: 75/85, 60: 55/85, 90: 25/85; beyond 93.75 mmHg the floor of .25.
  const Perfusion vessels{PerfusionParameters{}};

  EXPECT_EQ(vessels.steadyFlow(0.0, 30.0), 1.0);
  EXPECT_NEAR(vessels.steadyFlow(0.0, 40.0), 0.882, 1e-3);
  EXPECT_NEAR(vessels.steadyFlow(0.0, 60.0), 0.647, 1e-3);
  EXPECT_NEAR(vessels.steadyFlow(0.0, 90.0), 0.294, 1e-3);
  EXPECT_EQ(vessels.steadyFlow(0.0, 150.0), 0.25);
}

TEST(Perfusion, TheFloorHoldsForTheLumenAloneNotForATurn) {
  const Perfusion vessels{PerfusionParameters{}};

  EXPECT_NEAR(vessels.steadyFlow(radians(720.0), 150.0), 0.059, 1e-3);
  EXPECT_EQ(vessels.steadyFlow(radians(800.0), 150.0), 0.0);
}

TEST(Perfusion, ALongPedicleBearsTheSameTurnBetter) {
  // Twice the length: 720 degrees are to it what 360 are to the reference.
  const Perfusion lengthy{PerfusionParameters{.pedicle_m = 0.12}};
  const Perfusion half{PerfusionParameters{.pedicleShare = 0.5}};
  const Perfusion still{PerfusionParameters{.pedicleShare = 0.0}};

  EXPECT_NEAR(lengthy.steadyFlow(radians(720.0), 0.0), 0.647, 1e-3);
  EXPECT_NEAR(half.steadyFlow(radians(720.0), 0.0), 0.647, 1e-3);
  EXPECT_EQ(still.steadyFlow(radians(2000.0), 0.0), 1.0);
}

TEST(Perfusion, AStepIsTheClosedFormOfAFirstOrderLag) {
  // tau_q 60 s, Q(360) = 55/85: q(t) = Q + (1 - Q) e^(-t/60), whatever the steps.
  const Perfusion vessels{PerfusionParameters{}};
  const double angle = radians(360.0);

  for (const double step_s : {0.06, 1.0, 30.0, 60.0, 240.0}) {
    PerfusionState state;
    for (double t = step_s; t < 601.0; t += step_s) {
      vessels.step(state, angle, 0.0, step_s);
      EXPECT_NEAR(state.flow, 55.0 / 85.0 + 30.0 / 85.0 * std::exp(-t / 60.0), 1e-3) << step_s << " " << t;
    }
  }
}

TEST(Perfusion, ATwistedRatTestisIsUnhurtAfterHalfAnHourAndLostAfterOne) {
  // tau_i .62 h, flow .0589: (.5 - .0589)/.5/.62 = 1.423 an hour; .71 after half, 1.42 after one (0.5 h
  // unhurt, 1 h hurt: PubMed 8373967). Here the flow has fallen before the clock starts.
  const Perfusion vessels{PerfusionParameters{.lossTime_s = 0.62 * kHour_s}};
  PerfusionState state{.flow = vessels.steadyFlow(radians(720.0), 0.0)};

  for (int i = 0; i < 30'000; ++i) {
    vessels.step(state, radians(720.0), 0.0, 0.06);
  }
  EXPECT_NEAR(state.dose, 0.711, 1e-3);
  for (int i = 0; i < 30'000; ++i) {
    vessels.step(state, radians(720.0), 0.0, 0.06);
  }
  EXPECT_NEAR(state.dose, 1.423, 1e-3);
  EXPECT_NEAR(state.saturation, 0.36, 1e-3);
}

TEST(Perfusion, WhatHasLainTwistedIsWhatTheStepsWouldHaveMadeOfIt) {
  for (const double angle_deg : {0.0, 200.0, 480.0, 540.0, 720.0, 800.0}) {
    const Perfusion vessels{PerfusionParameters{}};
    PerfusionState stepped;
    for (int i = 0; i < 36'000; ++i) {
      vessels.step(stepped, radians(angle_deg), 0.0, 0.1);
    }

    const PerfusionState lain = vessels.after(radians(angle_deg), 0.0, kHour_s);

    EXPECT_NEAR(lain.flow, stepped.flow, 1e-6) << angle_deg;
    EXPECT_NEAR(lain.congestion, stepped.congestion, 1e-6) << angle_deg;
    EXPECT_NEAR(lain.dose, stepped.dose, 1e-6) << angle_deg;
    EXPECT_NEAR(lain.saturation, stepped.saturation, 1e-6) << angle_deg;
  }
}

TEST(Perfusion, NothingHappensInNoTime) {
  const Perfusion vessels{PerfusionParameters{}};
  PerfusionState state{.flow = 0.3, .congestion = 0.4, .dose = 0.6, .saturation = 0.467};

  vessels.step(state, radians(360.0), 10.0, 0.0);

  EXPECT_EQ(state.flow, 0.3);
  EXPECT_EQ(state.congestion, 0.4);
  EXPECT_EQ(state.dose, 0.6);
  EXPECT_EQ(vessels.after(radians(720.0), 0.0, 0.0).flow, 1.0);
  EXPECT_EQ(vessels.after(radians(720.0), 0.0, 0.0).dose, 0.0);
}

TEST(Perfusion, AnHourOfFlowHealsWhatIsNotLostYet) {
  // D falls by e^(-t / 2 tau_i); 2 tau_i = 2 h here: an hour leaves e^-.5 = .607 of it. At 1 it stays.
  const Perfusion vessels{PerfusionParameters{.lossTime_s = kHour_s}};
  PerfusionState hurt{.dose = 0.8};
  PerfusionState lost{.dose = 1.0};

  for (int i = 0; i < 3600; ++i) {
    vessels.step(hurt, 0.0, 0.0, 1.0);
    vessels.step(lost, 0.0, 0.0, 1.0);
  }

  EXPECT_NEAR(hurt.dose, 0.8 * 0.6065, 1e-3);
  EXPECT_EQ(lost.dose, 1.0);
}

TEST(Perfusion, ThrottledVeinsDamUpBloodAndAShutArteryLeavesThePartPale) {
  // P_cap = 90 - .6 * 85 Q: at 360 degrees 57, 18 above the 39 of rest: c = 18/48 = .375; at 720 degrees
  // 48/48.
  const Perfusion vessels{PerfusionParameters{}};

  EXPECT_NEAR(vessels.after(radians(360.0), 0.0, 10.0 * kHour_s).congestion, 0.375, 1e-3);
  EXPECT_NEAR(vessels.after(radians(720.0), 0.0, 10.0 * kHour_s).congestion, 1.0, 1e-3);
  EXPECT_EQ(vessels.after(radians(760.0), 0.0, 10.0 * kHour_s).congestion, 0.0);
  EXPECT_EQ(vessels.after(0.0, 0.0, 10.0 * kHour_s).congestion, 0.0);
}

TEST(Perfusion, ATickTakesNoMemoryAndHardlyAnyTime) {
  const Perfusion vessels{PerfusionParameters{}};
  PerfusionState state;
  constexpr int kTicks = 200'000;

  const std::int64_t before = testing::allocationCount();
  const auto begun = std::chrono::steady_clock::now();
  for (int i = 0; i < kTicks; ++i) {
    vessels.step(state, 1e-4 * i, 20.0, 0.06);
  }
  const std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - begun;

  EXPECT_EQ(testing::allocationCount(), before);
  EXPECT_LT(taken.count() / kTicks, 1000.0);  // about 25 ns; the bound is for a loaded machine
  RecordProperty("ns_per_tick", std::to_string(taken.count() / kTicks));
}

TEST(Perfusion, NumbersThatNoVesselHasAreRefused) {
  const auto refused = [](const PerfusionParameters& parameters) {
    return testing::refusalCode([&] { return Perfusion(parameters); }) == ErrorCode::kBadParameter;
  };

  EXPECT_TRUE(refused({.arterial_mmHg = 4.0}));
  EXPECT_TRUE(refused({.shutAtTurn_mmHg = 0.0}));
  EXPECT_TRUE(refused({.shutPower = 0.5}));
  EXPECT_TRUE(refused({.pedicle_m = 0.0}));
  EXPECT_TRUE(refused({.pedicleShare = -0.1}));
  EXPECT_TRUE(refused({.lumenFloor = 1.5}));
  EXPECT_TRUE(refused({.flowTime_s = 0.0}));
  EXPECT_TRUE(refused({.lossTime_s = std::numeric_limits<double>::quiet_NaN()}));
  EXPECT_TRUE(refused({.enoughFlow = 1.0}));
}

TissueColour settledAt(double angle_deg) {
  PerfusionState state = Perfusion{PerfusionParameters{}}.after(radians(angle_deg), 0.0, 3600.0);
  state.dose = 0.0;
  return colourOf(state);
}

TEST(TissueColour, ASoundOrganIsPink) {
  EXPECT_EQ(colourOf(PerfusionState{}), kSerosaPink);
}

TEST(TissueColour, ATurnMakesItDarkerAndPurpler) {
  TissueColour before = settledAt(0.0);
  for (const double angle_deg : {180.0, 360.0, 540.0, 720.0}) {
    const TissueColour now = settledAt(angle_deg);

    EXPECT_LT(now.red + now.green + now.blue, before.red + before.green + before.blue) << angle_deg;
    EXPECT_GT(now.blue / now.red, before.blue / before.red) << angle_deg;
    before = now;
  }
}

// 270 degrees: flow 0.77, a quarter of the largest congestion. The vein shuts first: purple though fed.
TEST(TissueColour, ATurnThatHardlyStarvesIsPurpleAllTheSame) {
  const TissueColour dammed = settledAt(270.0);

  EXPECT_NEAR(purpleShare(0.25), 0.372, 1e-3);
  EXPECT_EQ(purpleShare(0.0), 0.0);
  EXPECT_EQ(purpleShare(1.0), kMaxPurple);
  EXPECT_LT(dammed.green, 0.70 * kSerosaPink.green);
  EXPECT_GT(dammed.blue, 1.10 * dammed.green);
}

TEST(TissueColour, AShutArteryLeavesItPaleNotPurple) {
  const TissueColour purple = settledAt(720.0);
  const TissueColour pale = settledAt(760.0);

  EXPECT_NEAR(pale.red, kSerosaPale.red, 1e-9);
  EXPECT_NEAR(pale.blue, kSerosaPale.blue, 1e-9);
  EXPECT_GT(pale.green, purple.green + 0.4);
}

TEST(TissueColour, ADoseBelowSevenTenthsDoesNotShowAndOneAndAFifthIsBlack) {
  EXPECT_EQ(colourOf({.dose = 0.7}), kSerosaPink);
  EXPECT_EQ(blackShare(0.95), 0.5);  // half-way of the smoothstep
  EXPECT_EQ(colourOf({.dose = 1.2}), kSerosaBlack);
  EXPECT_EQ(colourOf({.dose = 3.0}), kSerosaBlack);
}

}  // namespace
}  // namespace torsio
