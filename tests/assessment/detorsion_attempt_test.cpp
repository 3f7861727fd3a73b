// SPDX-License-Identifier: GPL-3.0-or-later
// Measurements of a recorded untwisting.
#include <gtest/gtest.h>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/mastery.h"
#include "assessment/attempt/recorded_detorsion.h"
#include "assessment/attempt/run_verdict.h"

namespace torsio {
namespace {

/// Samples of an organ twisted by 200 degrees initially, built stage by stage, one per millisecond.
class RecordedUntwisting {
 public:
  RecordedUntwisting() {
    now_.rules = kRulesOfDetorsion;
    now_.response.angle_rad = radians(200.0);
    now_.hollow = {.pressure_Pa = 0.0, .patency = 0.4, .flow = 0.3, .dose = 0.1};
  }

  Sample& now() { return now_; }
  RecordedUntwisting& stage(ExercisePhase phase, int ticks, double angle_deg) {
    const double from_rad = now_.response.angle_rad;
    now_.phase = phase;
    for (int i = 1; i <= ticks; ++i) {
      now_.response.angle_rad = from_rad + (radians(angle_deg) - from_rad) * i / ticks;
      now_.tick = std::ssize(samples);
      now_.device.time_us = 1000 * now_.tick;
      samples.push_back(now_);
      now_.command = {};
    }
    return *this;
  }
  RecordedUntwisting& command(ServoCommand::Kind kind, double value) {
    now_.command = {kind, value};
    return *this;
  }

  [[nodiscard]] AttemptRules rules() const {
    return {.tolerance_rad = radians(15.0), .detorsion = DetorsionRules{.jaw_Pa = 400e3, .vent = true}};
  }
  [[nodiscard]] MeasuredTrial trial() const { return measureTwists({}, samples, rules()); }
  [[nodiscard]] AttemptMeasures measured() const { return measureAttempt({}, samples, rules()); }

  std::vector<Sample> samples;

 private:
  Sample now_;
};

/// Gripped at 1 s, turned to 0 in 2 s with a pull of 3 N, released with the clip on, clip removed.
RecordedUntwisting undone() {
  RecordedUntwisting run;
  run.stage(ExercisePhase::kTracking, 1000, 200.0);
  run.now().device.grip = 1 << 15;  // half closed
  run.now().force_N = {0.0, 3.0, 0.0};
  run.now().response.force_N = {0.0, 3.0, 0.0};
  run.now().response.torque_Nm = 0.05;
  run.stage(ExercisePhase::kTwisting, 2000, 0.0).command(ServoCommand::Kind::kHoldOrgan, 1.0);
  run.stage(ExercisePhase::kTwisting, 100, 0.0);
  run.now().force_N = run.now().response.force_N = {};
  run.now().response.torque_Nm = 0.0;
  run.now().device.grip = 0;
  run.now().hollow = {.pressure_Pa = 0.0, .patency = 1.0, .flow = 0.9, .dose = 0.2};
  run.stage(ExercisePhase::kTracking, 900, 0.0).command(ServoCommand::Kind::kHoldOrgan, 0.0);
  return run;
}

TEST(RecordedDetorsion, IsMeasuredInsteadOfTwists) {
  RecordedUntwisting run = undone();
  run.stage(ExercisePhase::kTracking, 10'000, 0.0);

  const AttemptMeasures got = run.measured();

  EXPECT_EQ(got.duration_us, 14'000'000);
  EXPECT_TRUE(got.twists.empty());
  EXPECT_EQ(got.unfinished, 0);
  EXPECT_FALSE(got.meanAbsoluteError_deg);
  EXPECT_EQ(got.values.at(Quantity::kUntwisted), 1.0);
  EXPECT_EQ(got.values.at(Quantity::kFirstDirection), 1.0);
  EXPECT_EQ(got.values.at(Quantity::kRegrips), 0.0);
  EXPECT_EQ(got.values.at(Quantity::kLeastRegrips), 1.0);
  EXPECT_EQ(got.values.at(Quantity::kDose), 0.2);
  EXPECT_EQ(got.values.at(Quantity::kLeastPatency), 0.4);
  EXPECT_EQ(got.values.at(Quantity::kPeakJaw), 200e3);  // half of 400 kPa
  EXPECT_EQ(got.values.at(Quantity::kVentedFirst), 0.0);
  EXPECT_EQ(got.values.at(Quantity::kTimeToFlow), 3.1);
  EXPECT_NEAR(got.values.at(Quantity::kPeakForce), 3.0, 0.01);
  EXPECT_NEAR(got.values.at(Quantity::kPeakTorque), 0.05, 1e-3);
  EXPECT_NEAR(got.values.at(Quantity::kTime), 13.999, 1e-9);
  for (const auto& [quantity, value] : got.values) {
    EXPECT_NE(idOf(quantity).substr(0, 6), "twist.") << value;
    EXPECT_NE(idOf(quantity).substr(0, 5), "work.") << value;
  }
}

TEST(RecordedDetorsion, HandsOffStartsWhenTheClipIsRemoved) {
  // The clip is removed at 4.0 s, 10 s before the end: a millisecond less is not enough.
  RecordedUntwisting enough = undone();
  RecordedUntwisting tooFew = undone();
  enough.stage(ExercisePhase::kTracking, 10'000, 0.0);
  tooFew.stage(ExercisePhase::kTracking, 9'999, 0.0);

  EXPECT_EQ(enough.measured().values.at(Quantity::kUntwisted), 1.0);
  EXPECT_EQ(tooFew.measured().values.at(Quantity::kUntwisted), 0.0);
  EXPECT_FALSE(tooFew.measured().values.contains(Quantity::kResidual));
}

TEST(RecordedDetorsion, TheSecondButtonTogglesTheClipOnEachPressAtTheOrgan) {
  // Pressed at the organ at 5 s, held for a second, pressed again at 17 s: clipped from 5 to 17 s.
  RecordedUntwisting run = undone();
  run.stage(ExercisePhase::kContact, 1000, 0.0);
  run.now().device.buttons = kButtonSecond;
  run.stage(ExercisePhase::kContact, 1000, 0.0);
  run.now().device.buttons = 0;
  run.stage(ExercisePhase::kContact, 11'000, 0.0);
  const double clipped = run.measured().values.at(Quantity::kUntwisted);
  run.now().device.buttons = kButtonSecond;
  run.stage(ExercisePhase::kContact, 10'000, 0.0);

  EXPECT_EQ(clipped, 0.0);
  EXPECT_EQ(run.measured().values.at(Quantity::kUntwisted), 1.0);
}

TEST(RecordedDetorsion, TheSecondButtonAwayFromTheOrganDoesNothing) {
  RecordedUntwisting run = undone();
  run.stage(ExercisePhase::kTracking, 1000, 0.0);
  run.now().device.buttons = kButtonSecond;
  run.stage(ExercisePhase::kTracking, 9'000, 0.0);

  EXPECT_EQ(run.measured().values.at(Quantity::kUntwisted), 1.0);
}

TEST(RecordedSwitches, ReactOnlyToAPressAtTheOrgan) {
  RecordedSwitches switches;
  Sample sample;
  sample.phase = ExercisePhase::kContact;
  sample.device.buttons = kButtonSecond;
  switches.obey(sample);
  switches.obey(sample);
  const bool heldFromTheStart = switches.clipped();
  sample.device.buttons = 0;
  switches.obey(sample);
  sample.device.buttons = kButtonSecond;

  switches.obey(sample);

  EXPECT_FALSE(heldFromTheStart);
  EXPECT_TRUE(switches.clipped());
}

TEST(RecordedSwitches, ACommandOverridesTheButtonOfItsTick) {
  RecordedSwitches switches;
  Sample sample;
  sample.phase = ExercisePhase::kTwisting;
  switches.obey(sample);
  sample.device.buttons = kButtonSecond;
  sample.command = {.kind = ServoCommand::Kind::kHoldOrgan, .value = 0.0};

  switches.obey(sample);

  EXPECT_FALSE(switches.clipped());  // the button alone would have set it
  EXPECT_FALSE(switches.venting());
}

TEST(RecordedDetorsion, TheGripButtonClosesTheJawFully) {
  RecordedUntwisting run;
  run.now().device.buttons = kButtonGrip;
  run.stage(ExercisePhase::kTwisting, 100, 200.0);

  EXPECT_EQ(run.measured().values.at(Quantity::kPeakJaw), 400e3);
}

TEST(RecordedDetorsion, TheVentOpenedBeforeTheTurnCounts) {
  RecordedUntwisting run;
  run.stage(ExercisePhase::kTracking, 100, 200.0).command(ServoCommand::Kind::kVent, 1.0);
  run.stage(ExercisePhase::kTracking, 3001, 200.0).stage(ExercisePhase::kTwisting, 500, 100.0);

  EXPECT_EQ(run.measured().values.at(Quantity::kVentedFirst), 1.0);
}

TEST(RecordedDetorsion, PassesWhenUndoneUnlessARuleDemandsMore) {
  RecordedUntwisting run = undone();
  run.stage(ExercisePhase::kTracking, 10'000, 0.0);
  RecordedUntwisting notYet = undone();
  const MasteryRule quick{.quantity = Quantity::kTimeToFlow, .atMost = true, .threshold = 3.0};
  const MasteryRule calm{.quantity = Quantity::kDose, .atMost = true, .threshold = 0.2};

  const auto passes = [](const RecordedUntwisting& made, std::vector<MasteryRule> rules) {
    return judgeRun(made.measured().values, {.mastery = std::move(rules)}).passed();
  };

  EXPECT_TRUE(passes(run, {}));
  EXPECT_FALSE(passes(notYet, {}));
  EXPECT_TRUE(passes(run, {calm}));
  EXPECT_FALSE(passes(run, {calm, quick}));  // 3.1 s
}

TEST(RecordedDetorsion, IsCheckedForBeingUndoneAndForItsLoads) {
  RecordedUntwisting run = undone();
  run.stage(ExercisePhase::kTracking, 10'000, 0.0);
  AttemptRules rules = run.rules();
  rules.forceLimit_N = 2.0;
  rules.hold_s = 5.0;  // twists only

  const std::vector<TargetCheck> checks = judgeRun(run.measured().values, rules).checks;

  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0].quantity, Quantity::kUntwisted);
  EXPECT_TRUE(checks[0].passed);
  EXPECT_EQ(checks[0].value, 1.0);
  EXPECT_EQ(checks[1].quantity, Quantity::kPeakForce);
  EXPECT_FALSE(checks[1].passed);  // 3 N
}

TEST(RecordedDetorsion, MissingSamplesOrUnknownLimitsLeaveItUndefined) {
  RecordedUntwisting run = undone();
  run.stage(ExercisePhase::kTracking, 10'000, 0.0);
  RecordedUntwisting torn = run;
  torn.samples.erase(torn.samples.begin() + 5000, torn.samples.begin() + 5050);

  const AttemptMeasures gap = torn.measured();
  const AttemptMeasures unknown = measureAttempt({}, run.samples, {});

  EXPECT_FALSE(gap.values.contains(Quantity::kUntwisted));
  EXPECT_FALSE(unknown.values.contains(Quantity::kUntwisted));
  EXPECT_TRUE(unknown.twists.empty());
  EXPECT_EQ(judgeRun(unknown.values, {}).outcome, RunOutcome::kNotPassed);
  EXPECT_EQ(judgeRun(gap.values, {}).outcome, RunOutcome::kNotJudged);
}

TEST(RecordedDetorsion, AnOrdinaryTwistHasNoneOfItsMetrics) {
  RecordedUntwisting run = undone();
  for (Sample& sample : run.samples) {
    sample.rules = 1;
  }

  const AttemptMeasures got = measureAttempt({}, run.samples, {});

  EXPECT_FALSE(got.values.contains(Quantity::kUntwisted));
  EXPECT_TRUE(got.values.contains(Quantity::kOnTarget));
}

}  // namespace
}  // namespace torsio
