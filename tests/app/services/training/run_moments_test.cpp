// SPDX-License-Identifier: GPL-3.0-or-later
// Each requirement that a run missed says where it was missed and what to try next.
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/training/debrief.h"
#include "sim/core/angle.h"

namespace torsio {
namespace {

constexpr double kTarget_deg = 90.0;

/// A run at 1 kHz, written step by step; the force is 1 N while the organ is held.
class WrittenRun {
 public:
  [[nodiscard]] double now_s() const { return 1e-3 * static_cast<double>(samples_.size()); }
  [[nodiscard]] const std::vector<Sample>& samples() const { return samples_; }

  void wait(double duration_s) {
    for (int i = 0; i < std::lround(1e3 * duration_s); ++i) {
      add(ExercisePhase::kTracking, 0.0);
    }
  }
  /// Turns for one second, holds and lets go; returns when it let go.
  double twist(double to_deg, double hold_s) {
    for (int i = 0; i < 1'000; ++i) {
      add(ExercisePhase::kTwisting, to_deg * i / 1'000.0);
    }
    for (int i = 0; i < std::lround(1e3 * hold_s); ++i) {
      add(ExercisePhase::kTwisting, to_deg);
    }
    const double letGo_s = now_s();
    for (int i = 300; i > 0; --i) {
      add(ExercisePhase::kReleased, to_deg * i / 300.0);
    }
    return letGo_s;
  }
  Sample& at(double time_s) { return samples_.at(static_cast<std::size_t>(std::lround(1e3 * time_s))); }

 private:
  void add(ExercisePhase phase, double angle_deg) {
    Sample sample;
    sample.tick = static_cast<std::int64_t>(samples_.size());
    sample.device.time_us = 1'000 * sample.tick;
    sample.phase = phase;
    sample.response.angle_rad = radians(angle_deg);
    sample.response.torque_Nm = 0.004 * angle_deg;
    if (phase == ExercisePhase::kTwisting) {
      sample.response.force_N = {1.0, 0.0, 0.0};
    }
    samples_.push_back(sample);
  }

  std::vector<Sample> samples_;
};

TrialHeader header() {
  TrialHeader made;
  made.targetAngle_rad = radians(kTarget_deg);
  return made;
}

const MissedTarget* missedOf(const Debrief& told, Quantity quantity) {
  for (std::size_t i = 0; i < told.verdict.checks.size(); ++i) {
    if (told.verdict.checks[i].quantity == quantity) {
      return told.missed.at(i) ? &*told.missed[i] : nullptr;
    }
  }
  ADD_FAILURE() << idOf(quantity) << " is not asked for";
  return nullptr;
}

/// Expects a moment of a second around `time_s`.
void expectAround(const MissedTarget* missed, double time_s, const char* what) {
  ASSERT_NE(missed, nullptr) << what;
  ASSERT_TRUE(missed->when) << what;
  EXPECT_NEAR(missed->when->from_s, time_s - 0.5, 0.005) << what;
  EXPECT_NEAR(missed->when->to_s, time_s + 0.5, 0.005) << what;
  EXPECT_FALSE(missed->advice.empty()) << what;
}

TEST(MissedTargets, EachHasItsMomentAndOneAdvice) {
  WrittenRun run;
  run.wait(1.0);
  const double onTarget_s = run.twist(kTarget_deg, 0.5);
  run.wait(3.0);
  const double secondGrip_s = run.now_s();
  const double short_s = run.twist(60.0, 0.1);
  run.wait(1.0);
  run.at(1.6).response.force_N = {0.0, 6.43, 0.0};
  run.at(2.2).response.torque_Nm = -0.9;
  AttemptRules rules;
  rules.tolerance_rad = radians(5.0);
  rules.hold_s = 1.0;
  rules.leastTwists = 3;
  rules.forceLimit_N = 3.3;
  rules.torqueLimit_Nm = 0.5;
  rules.mastery = {{.quantity = Quantity::kTime, .atMost = true, .threshold = 1.0}};

  const Debrief told = makeDebrief(header(), run.samples(), rules, nullptr);

  expectAround(missedOf(told, Quantity::kTargetsReached), short_s, "the twist that missed by 30 degrees");
  expectAround(missedOf(told, Quantity::kShortestHold), onTarget_s, "the hold of half a second");
  expectAround(missedOf(told, Quantity::kPeakForce), 1.6, "6.43 N");
  expectAround(missedOf(told, Quantity::kPeakTorque), 2.2, "0.9 N m");
  const MissedTarget* few = missedOf(told, Quantity::kCompletedTwists);
  ASSERT_NE(few, nullptr);
  EXPECT_NEAR(few->when.value().from_s, onTarget_s, 0.005) << "the longest time without a twist";
  EXPECT_NEAR(few->when.value().to_s, secondGrip_s, 0.005);
  const MissedTarget* slow = missedOf(told, Quantity::kTime);
  ASSERT_NE(slow, nullptr);
  EXPECT_NEAR(slow->when.value().from_s, 1.0, 0.005) << "the twist that took longest";
  EXPECT_NEAR(slow->when.value().to_s, onTarget_s, 0.005);
}

TEST(MissedTargets, WhatWasMetHasNone) {
  WrittenRun run;
  run.wait(1.0);
  run.twist(kTarget_deg, 0.5);
  run.wait(1.0);
  AttemptRules rules;
  rules.forceLimit_N = 3.3;

  const Debrief told = makeDebrief(header(), run.samples(), rules, nullptr);

  ASSERT_EQ(told.missed.size(), told.verdict.checks.size());
  EXPECT_TRUE(told.verdict.passed());
  EXPECT_TRUE(
      std::none_of(told.missed.begin(), told.missed.end(), [](const auto& one) { return one.has_value(); }));
}

TEST(MissedTargets, AnAdviceIsGivenOnce) {
  WrittenRun run;
  run.wait(1.0);
  run.twist(60.0, 0.1);
  run.wait(1.0);
  AttemptRules rules;
  rules.mastery = {{.quantity = Quantity::kOnTarget, .threshold = 0.5}};

  const Debrief told = makeDebrief(header(), run.samples(), rules, nullptr);

  ASSERT_NE(missedOf(told, Quantity::kTargetsReached), nullptr);
  EXPECT_EQ(missedOf(told, Quantity::kOnTarget), nullptr) << "the same was said above";
}

TEST(MissedTargets, ARunWithoutATwistIsShownWhole) {
  WrittenRun run;
  run.wait(4.0);
  AttemptRules rules;
  rules.leastTwists = 2;

  const Debrief told = makeDebrief(header(), run.samples(), rules, nullptr);

  const MissedTarget* few = missedOf(told, Quantity::kCompletedTwists);
  ASSERT_NE(few, nullptr);
  EXPECT_EQ(few->when.value().from_s, 0.0);
  EXPECT_NEAR(few->when.value().to_s, 4.0, 0.005);
  const MissedTarget* none = missedOf(told, Quantity::kTargetsReached);
  ASSERT_NE(none, nullptr);
  EXPECT_FALSE(none->when) << "no twist shows it";
  EXPECT_FALSE(none->advice.empty());
}

TEST(MissedTargets, OfAnUntwistingAreAtItsEventsAndExtremes) {
  DetorsionStory story;
  story.time_s = {0.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0};
  story.angle_rad = {3.0, 3.4, 2.8, 3.0, 0.2, 1.5, 1.6};
  story.dose = {0.0, 0.1, 0.2, 0.3, 0.7, 0.6, 0.5};
  story.events = {{4.0, DetorsionMoment::kGrip},
                  {10.0, DetorsionMoment::kLetGo},
                  {15.0, DetorsionMoment::kGrip},
                  {20.0, DetorsionMoment::kLetGo},
                  {22.5, DetorsionMoment::kRelapse}};
  const std::vector<std::pair<Quantity, double>> expected{
      {Quantity::kFirstDirection, 4.0}, {Quantity::kWrongWay, 5.0},   {Quantity::kDose, 20.0},
      {Quantity::kSlipBack, 10.0},      {Quantity::kInStages, 15.0},  {Quantity::kUntwisted, 22.5},
      {Quantity::kResidual, 20.0},      {Quantity::kTimeToFlow, 17.0}};
  RunVerdict verdict;
  for (const auto& [quantity, at_s] : expected) {
    verdict.checks.push_back({.quantity = quantity, .value = 17.0, .wanted = 1.0});
  }
  verdict.checks.push_back({.quantity = Quantity::kRelapse, .passed = true, .value = 0.0});

  WrittenRun run;
  run.wait(1.0);
  run.at(0.7).response.force_N = {5.0, 0.0, 0.0};
  verdict.checks.push_back({.quantity = Quantity::kPeakForce, .value = 5.0, .wanted = 4.0, .atLeast = false});

  const auto missed = missedTargets(verdict, Timeline(header(), run.samples()), story);

  ASSERT_EQ(missed.size(), expected.size() + 2);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_TRUE(missed[i] && missed[i]->when) << idOf(expected[i].first);
    EXPECT_DOUBLE_EQ(missed[i]->when->from_s + 0.5, expected[i].second) << idOf(expected[i].first);
    EXPECT_EQ(missed[i]->advice.empty(), expected[i].first == Quantity::kWrongWay)
        << idOf(expected[i].first) << ": each advice once";
  }
  EXPECT_FALSE(missed[expected.size()]) << "it was met";
  expectAround(&missed.back().value(), 0.7, "the largest force");
}

}  // namespace
}  // namespace torsio
