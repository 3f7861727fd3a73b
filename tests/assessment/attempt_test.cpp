// SPDX-License-Identifier: GPL-3.0-or-later
// Twists and targets of recorded attempts, and their metrics, with values calculated by hand.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/mastery.h"
#include "assessment/attempt/merit.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/attempt/twist_count.h"

namespace torsio {
namespace {

constexpr double kTolerance_rad = radians(5.0);

/// Samples built stage by stage, one per millisecond.
class Recording {
 public:
  Recording() { header_.targetAngle_rad = radians(60.0); }

  Recording& free(int ticks) { return stage(ExercisePhase::kTracking, ticks, 0.0); }
  Recording& held(int ticks, double angle_deg) { return stage(ExercisePhase::kTwisting, ticks, angle_deg); }
  Recording& released(int ticks) { return stage(ExercisePhase::kReleased, ticks, 0.0); }
  /// A grip held at an angle for 300 ms, released, and back at rest.
  Recording& twist(double angle_deg) { return held(300, angle_deg).released(50).free(50); }
  Recording& target(double angle_deg) {
    next_ = {ServoCommand::Kind::kSetTarget, radians(angle_deg)};
    return *this;
  }
  Recording& missing(int ticks) {
    tick_ += ticks;
    return *this;
  }
  Recording& status(std::uint32_t bits) {
    status_ = bits;
    return *this;
  }

  /// Raises the force on the tissue from here on.
  Recording& pressing(double force_N) {
    press_N_ = force_N;
    return *this;
  }
  /// Limits the device's force from here on.
  Recording& deviceGives(double most_N) {
    device_N_ = most_N;
    return *this;
  }
  Recording& limits(std::uint32_t bits) {
    limits_ = bits;
    return *this;
  }
  Recording& touching(int ticks) { return stage(ExercisePhase::kContact, ticks, 0.0); }

  [[nodiscard]] std::vector<RecordedTwist> twists() const {
    return recordedTwists(samples, sampleTimes(header_, samples).us, targetsInForce(header_, samples));
  }
  [[nodiscard]] AttemptMeasures measured() const {
    return measureAttempt(header_, samples, {.tolerance_rad = kTolerance_rad});
  }
  [[nodiscard]] MeasuredTrial trial() const {
    return measureTwists(header_, samples, {.tolerance_rad = kTolerance_rad});
  }
  [[nodiscard]] const TrialHeader& header() const { return header_; }

  std::vector<Sample> samples;

 private:
  Recording& stage(ExercisePhase phase, int ticks, double angle_deg) {
    for (int i = 0; i < ticks; ++i, ++tick_) {
      Sample sample;
      sample.tick = tick_;
      sample.device.time_us = 1000 * tick_;
      sample.device.status = status_;
      sample.command = next_;
      sample.phase = phase;
      sample.response.angle_rad = radians(angle_deg);
      sample.response.torque_Nm = 0.01 * angle_deg;
      sample.response.force_N = {0.0, 0.02 * angle_deg + press_N_, 0.0};
      sample.force_N = {0.0, std::min(norm(sample.response.force_N), device_N_), 0.0};
      sample.contact = phase == ExercisePhase::kTracking ? kContactNone : kContactJaw;
      sample.limits = limits_;
      samples.push_back(sample);
      next_ = {};
    }
    return *this;
  }

  TrialHeader header_;
  ServoCommand next_;
  std::uint32_t status_ = kDeviceOk;
  std::uint32_t limits_ = kForceFull;
  double press_N_ = 0.0;
  double device_N_ = 100.0;
  std::int64_t tick_ = 0;
};

TEST(RecordedTwists, LastFromTheGripToTheEndOfTheReturn) {
  const Recording run = std::move(Recording().free(100).twist(58.0));

  const std::vector<RecordedTwist> twists = run.twists();

  ASSERT_EQ(twists.size(), 1U);
  EXPECT_EQ(twists[0].first, 100U);
  EXPECT_EQ(twists[0].letGo, 400U);
  EXPECT_EQ(twists[0].end, 450U);
  EXPECT_DOUBLE_EQ(twists[0].target_rad, radians(60.0));
  EXPECT_NEAR(twists[0].error_rad(), radians(2.0), 1e-12);
  EXPECT_TRUE(twists[0].onTarget(kTolerance_rad));
  EXPECT_FALSE(twists[0].onTarget(radians(1.9)));
}

TEST(RecordedTwists, AreJudgedByTheTargetAtTheirRelease) {
  // The header sets 60 degrees, a command before the second twist 30, one within the third 90.
  const Recording run =
      std::move(Recording().twist(60.0).target(30.0).twist(30.0).held(100, 20.0).target(90.0).twist(88.0));

  const std::vector<RecordedTwist> twists = run.twists();

  ASSERT_EQ(twists.size(), 3U);
  EXPECT_DOUBLE_EQ(twists[0].target_rad, radians(60.0));
  EXPECT_DOUBLE_EQ(twists[1].target_rad, radians(30.0));
  EXPECT_DOUBLE_EQ(twists[2].target_rad, radians(90.0));
  EXPECT_EQ(run.measured().twistsOnTarget(), 3);
}

TEST(RecordedTwists, IgnoreATargetThatArrivesWithTheRelease) {
  const Recording run = std::move(Recording().held(300, 60.0).target(10.0).released(50));

  EXPECT_DOUBLE_EQ(run.twists().at(0).target_rad, radians(60.0));
}

TEST(RecordedTwists, RequireAMinimumAngle) {
  // Up to 1.9 degrees: a touch. To 40 degrees and back to 1: a twist that missed.
  const Recording run = std::move(Recording().twist(1.9).held(200, 40.0).held(100, 1.0).released(50));

  const std::vector<RecordedTwist> twists = run.twists();

  ASSERT_EQ(twists.size(), 1U);
  EXPECT_NEAR(twists[0].error_rad(), radians(59.0), 1e-12);
}

TEST(RecordedTwists, AreIncompleteIfTheRecordingEndsTheDeviceIsLostOrTheReleaseIsUnseen) {
  const Recording cut = std::move(Recording().twist(60.0).held(300, 60.0));
  const Recording ended = std::move(Recording().held(300, 60.0).status(kDeviceEnded).released(50));
  const Recording lost = std::move(Recording().held(300, 60.0).status(kDeviceLost).released(50));
  const Recording blind = std::move(Recording().held(300, 60.0).missing(20).released(50));
  const Recording seen = std::move(Recording().held(300, 60.0).missing(19).released(50));

  EXPECT_EQ(cut.twists().at(0).ending, TwistEnding::kLetGo);
  EXPECT_EQ(cut.twists().at(1).ending, TwistEnding::kRecordingEnded);
  EXPECT_EQ(ended.twists().at(0).ending, TwistEnding::kRecordingEnded);
  EXPECT_EQ(lost.twists().at(0).ending, TwistEnding::kDeviceFault);
  EXPECT_EQ(blind.twists().at(0).ending, TwistEnding::kNotSeen);  // 21 ms between the two samples
  EXPECT_EQ(seen.twists().at(0).ending, TwistEnding::kLetGo);     // 20 ms
  EXPECT_FALSE(cut.twists().at(1).onTarget(kTolerance_rad));
}

TEST(SampleTimes, AreTheDevicesIfTheyRiseOtherwiseTheTicks) {
  Recording run = std::move(Recording().free(3));
  run.samples[1].device.time_us = 1400;

  EXPECT_EQ(sampleTimes(run.header(), run.samples).us, (std::vector<std::int64_t>{0, 1400, 2000}));
  run.samples[1].device.time_us = 2000;  // stands still
  EXPECT_FALSE(sampleTimes(run.header(), run.samples).deviceClock);
  EXPECT_EQ(sampleTimes(run.header(), run.samples).us, (std::vector<std::int64_t>{0, 1000, 2000}));
  EXPECT_EQ(recordedDuration_us(run.header(), run.samples), 3000);
  EXPECT_EQ(recordedDuration_us(run.header(), {}), 0);
}

TEST(AttemptMeasures, CountCompletedTwistsAndTheOthersSeparately) {
  // Errors of 2, 10 and 4 degrees; the fourth is truncated.
  const Recording run = std::move(Recording().twist(62.0).twist(50.0).twist(56.0).held(400, 60.0));

  const AttemptMeasures measures = run.measured();

  ASSERT_EQ(measures.twists.size(), 3U);
  EXPECT_EQ(measures.twistsOnTarget(), 2);
  EXPECT_EQ(measures.unfinished, 1);
  EXPECT_NEAR(*measures.meanAbsoluteError_deg, (2.0 + 10.0 + 4.0) / 3.0, 1e-9);
  EXPECT_NEAR(measures.values.at(Quantity::kPeakTorque), 0.62, 1e-12);
  EXPECT_NEAR(measures.values.at(Quantity::kPeakForce), 1.24, 1e-12);
  EXPECT_DOUBLE_EQ(measures.values.at(Quantity::kTargetsReached), 2.0);
  EXPECT_DOUBLE_EQ(measures.values.at(Quantity::kOnTarget), 2.0 / 3.0);
  EXPECT_EQ(measures.duration_us, 3 * 400'000 + 400'000);
}

TEST(AttemptMeasures, TakeTheLargestPeakTheSumOfMishapsAndTheMedianOfTheRest) {
  Recording run = std::move(Recording().twist(60.0).twist(50.0).twist(40.0));
  const AttemptMeasures measures =
      measureAttempt(run.header(), run.samples, {.tolerance_rad = kTolerance_rad, .forceLimit_N = 0.9});

  // 0.02 N a degree: 1.2, 1.0 and 0.8 N; the first two stay above 0.9 N.
  EXPECT_NEAR(measures.values.at(Quantity::kPeakForce), 1.2, 1e-12);
  EXPECT_NEAR(measures.values.at(Quantity::kMeanForce), 1.0,
              0.01);  // the filter rounds the edge of the release
  EXPECT_DOUBLE_EQ(measures.values.at(Quantity::kForceViolations), 2.0);
}

TEST(AttemptMeasures, OfARecordingWithoutTwistsContainNoErrors) {
  const AttemptMeasures measures = Recording().free(500).measured();

  EXPECT_FALSE(measures.meanAbsoluteError_deg);
  EXPECT_FALSE(measures.values.contains(Quantity::kPeakForce));  // nothing was touched
  EXPECT_FALSE(measures.values.contains(Quantity::kOnTarget));
  EXPECT_DOUBLE_EQ(measures.values.at(Quantity::kTargetsReached), 0.0);
  EXPECT_EQ(measureAttempt(TrialHeader{}, {}, {}).duration_us, 0);
}

TEST(MeasuredTrial, TheHoldIsTheLastStayOnTargetBeforeTheRelease) {
  // 56 degrees lies within five of 60, 50 does not: the first stay does not count.
  const MeasuredTrial run = Recording().held(200, 56.0).held(100, 50.0).held(250, 61.0).released(50).trial();

  const MeasuredTwist& twist = run.twists.at(0);
  EXPECT_NEAR(twist.held_s, 0.249, 1e-12);  // from the first to the last of 250 samples
  EXPECT_NEAR(twist.letGo_s, 0.549, 1e-12);
  ASSERT_TRUE(twist.metrics);
  EXPECT_TRUE(twist.metrics->at(Quantity::kHoldSteadiness));
}

TEST(MeasuredTrial, AShortStayIsNoHold) {
  const MeasuredTrial run = Recording().held(200, 30.0).held(200, 60.0).released(50).trial();

  EXPECT_NEAR(run.twists.at(0).held_s, 0.199, 1e-12);
  EXPECT_FALSE(run.twists.at(0).metrics->at(Quantity::kHoldSteadiness));
}

TEST(MeasuredTrial, AGapLeavesTheMetricsOfItsTwistUndefinedButCountsTheTwist) {
  const Recording run =
      std::move(Recording().held(100, 60.0).missing(40).held(200, 60.0).released(50).free(50));

  const MeasuredTrial trial = run.trial();

  ASSERT_EQ(trial.twists.size(), 1U);
  EXPECT_TRUE(trial.twists[0].onTarget);
  EXPECT_FALSE(trial.twists[0].metrics);
  EXPECT_EQ(run.measured().twistsOnTarget(), 1);
}

TEST(TrialTrace, HasTheTargetAtEverySample) {
  const Recording run = std::move(Recording().free(2).target(30.0).free(2));

  const TrialTrace trace = trialTrace(run.header(), run.samples, kTolerance_rad);

  const std::vector<double> wanted{radians(60.0), radians(60.0), radians(30.0), radians(30.0)};
  EXPECT_EQ(trace.targetAngle_rad, wanted);
}

TEST(TrialTrace, TracksACourseOnlyWhileTheTargetMovesAndTheOrganIsHeld) {
  const MeasuredTrial fixed = Recording().target(30.0).twist(30.0).trial();
  // 150 samples 10 degrees below the target, 150 on it: mean error 5, root mean square 10 / sqrt(2).
  const MeasuredTrial moved = Recording().held(150, 50.0).target(50.0).held(150, 50.0).released(50).trial();

  EXPECT_FALSE(fixed.twists.at(0).metrics->at(Quantity::kTrackingRms));
  EXPECT_NEAR(*moved.twists.at(0).metrics->at(Quantity::kTrackingMean), radians(5.0), 1e-6);
  EXPECT_NEAR(*moved.twists.at(0).metrics->at(Quantity::kTrackingRms), radians(10.0 / std::sqrt(2.0)), 1e-6);
}

RunVerdict verdictOn(const Recording& run, const AttemptRules& rules) {
  return judgeRun(run.measured().values, rules);
}

TEST(PassRule, RequiresFourTwistsInFive) {
  EXPECT_EQ(wantedOnTarget(0), 1);
  EXPECT_EQ(wantedOnTarget(1), 1);
  EXPECT_EQ(wantedOnTarget(5), 4);
  EXPECT_EQ(wantedOnTarget(6), 5);  // 4.8
}

TEST(PassRule, ChecksTheAngleAlwaysAndOtherDemandsIfMade) {
  const Recording run = std::move(Recording().twist(60.0).twist(58.0));

  const std::vector<TargetCheck> angle = verdictOn(run, {}).checks;
  const std::vector<TargetCheck> all =
      verdictOn(run, {.forceLimit_N = 1.1, .torqueLimit_Nm = 0.7, .hold_s = 0.25}).checks;

  ASSERT_EQ(angle.size(), 1U);
  EXPECT_TRUE(angle[0].passed);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_TRUE(all[1].passed);  // held for 0.299 s
  EXPECT_NEAR(*all[1].value, 0.299, 1e-12);
  EXPECT_FALSE(all[2].passed);  // 1.2 N
  EXPECT_TRUE(all[3].passed);   // 0.6 N m
}

bool withinForce(const Recording& run, double limit_N) {
  return verdictOn(run, {.forceLimit_N = limit_N}).checks.back().passed;
}

// Measured at a station: the tissue bore 3.30 N; the warm device could render only 0.88 N.
TEST(PassRule, JudgesTheForceOnTheTissueWhateverTheDeviceCouldRender) {
  const Recording run = std::move(Recording().deviceGives(0.88).pressing(2.1).twist(60.0));

  const AttemptMeasures measures = run.measured();

  EXPECT_NEAR(*run.trial().loads.tissueForce_N, 3.3, 1e-12);
  EXPECT_NEAR(*run.trial().loads.deviceForce_N, 0.88, 1e-12);
  EXPECT_NEAR(measures.values.at(Quantity::kPeakForce), 3.3, 1e-12);
  EXPECT_NEAR(measures.values.at(Quantity::kDeviceForce), 0.88, 1e-12);
  EXPECT_FALSE(withinForce(run, 3.29));
  EXPECT_TRUE(withinForce(run, 3.31));
}

TEST(PassRule, CountsTheForceFromTheFirstContactNotFromTheGrip) {
  const Recording before = std::move(Recording().pressing(4.0).touching(1).pressing(0.0).twist(60.0));
  const Recording after = std::move(Recording().twist(60.0).pressing(4.0).touching(1));

  EXPECT_FALSE(withinForce(before, 3.9));
  EXPECT_FALSE(withinForce(after, 3.9));
  // The press before the grip belongs to the twist; one sample is enough, however a filter would see it.
  EXPECT_NEAR(*before.trial().twists.at(0).metrics->at(Quantity::kPeakForce), 4.0, 1e-12);
}

TEST(PassRule, CountsTheForceOfIncompleteTwistsToo) {
  const Recording cut = std::move(Recording().twist(60.0).pressing(3.0).held(100, 60.0));

  EXPECT_FALSE(withinForce(cut, 4.1));
  EXPECT_TRUE(withinForce(cut, 4.3));
}

TEST(PassRule, IgnoresReadingsOfALostDevice) {
  const Recording lost =
      std::move(Recording().twist(60.0).status(kDeviceLost).pressing(50.0).held(100, 60.0).released(10));

  EXPECT_TRUE(withinForce(lost, 1.3));
}

TEST(PassRule, AnUnknownForcePassesNoLimit) {
  for (const std::uint32_t why : {kForceNotFinite, kForceModelLate}) {
    const Recording run =
        std::move(Recording().limits(why).held(1, 10.0).limits(kForceFull).held(300, 60.0).released(50));

    EXPECT_FALSE(run.trial().loads.tissueForce_N);
    EXPECT_FALSE(withinForce(run, 100.0));
  }
}

TEST(PassRule, AnInvalidReadingLeavesTheForceKnown) {
  const Recording run = std::move(Recording()
                                      .limits(kForceNotFinite)
                                      .status(kDeviceInvalid)
                                      .held(1, 10.0)
                                      .limits(kForceFull)
                                      .status(kDeviceOk)
                                      .held(300, 60.0)
                                      .released(50));

  EXPECT_NEAR(*run.trial().loads.tissueForce_N, 1.2, 1e-12);
}

TEST(PassRule, RequiresTheExercisesNumberOfTwists) {
  const AttemptRules rules{.tolerance_rad = kTolerance_rad, .leastTwists = 5};
  Recording one = std::move(Recording().twist(60.0));
  Recording four = std::move(Recording().twist(60.0).twist(60.0).twist(60.0).twist(60.0));
  Recording five = std::move(Recording().twist(60.0).twist(60.0).twist(60.0).twist(60.0).twist(40.0));

  const auto checksOf = [&rules](const Recording& run) { return verdictOn(run, rules).checks; };

  ASSERT_EQ(checksOf(one).size(), 2U);
  EXPECT_EQ(checksOf(one)[0].quantity, Quantity::kCompletedTwists);
  EXPECT_DOUBLE_EQ(*checksOf(one)[0].value, 1.0);
  EXPECT_DOUBLE_EQ(checksOf(one)[0].wanted, 5.0);
  EXPECT_FALSE(checksOf(one)[0].passed);
  EXPECT_FALSE(checksOf(one)[1].passed);  // four of five must be on target
  EXPECT_FALSE(checksOf(four)[0].passed);
  EXPECT_TRUE(checksOf(four)[1].passed);
  EXPECT_TRUE(checksOf(five)[0].passed);
  EXPECT_TRUE(checksOf(five)[1].passed);
}

TEST(PassRule, AnAttemptThatFailsADemandIsNoSuccess) {
  const AttemptRules rules{.forceLimit_N = 3.0, .torqueLimit_Nm = 0.5, .leastTwists = 2};
  const auto meets = [&rules](double twists, double force_N, double torque_Nm) {
    return meetsDemands({{Quantity::kCompletedTwists, twists},
                         {Quantity::kPeakForce, force_N},
                         {Quantity::kPeakTorque, torque_Nm}},
                        rules);
  };

  EXPECT_TRUE(meets(2.0, 3.0, 0.5));
  EXPECT_FALSE(meets(1.0, 3.0, 0.5));
  EXPECT_FALSE(meets(2.0, 3.1, 0.5));
  EXPECT_FALSE(meets(2.0, 3.0, 0.6));
  EXPECT_FALSE(meetsDemands({{Quantity::kCompletedTwists, 2.0}, {Quantity::kPeakForce, 3.0}}, rules));
  EXPECT_TRUE(meetsDemands({{Quantity::kUntwisted, 1.0}}, {.leastTwists = 5}));  // no twists to count
}

TEST(RunVerdict, OfARunThatTheComputerToreIsNotJudgedAndNobodysFault) {
  // The samples of the hold are missing: the twist counts, its smoothness is not known.
  const Recording torn = std::move(Recording().held(100, 60.0).missing(40).held(200, 60.0).released(50));
  const AttemptRules smooth{.mastery = {{.quantity = Quantity::kSparc, .threshold = -2.0}}};

  const RunVerdict verdict = verdictOn(torn, smooth);

  EXPECT_EQ(verdict.outcome, RunOutcome::kNotJudged);
  EXPECT_EQ(verdict.sentence(), "Not judged: the computer was too busy");
  EXPECT_NE(verdict.cause().str().find("not your fault"), std::string::npos);
  EXPECT_FALSE(verdict.remedy().empty());
}

TEST(RunVerdict, WhatWasMeasuredAndMissedIsMissedHoweverBusyTheComputerWas) {
  const Recording torn = std::move(Recording().held(100, 60.0).missing(40).held(200, 20.0).released(50));

  const RunVerdict verdict = verdictOn(torn, {});

  EXPECT_EQ(verdict.outcome, RunOutcome::kNotPassed);
  EXPECT_TRUE(verdict.torn);
  EXPECT_EQ(verdict.cause().str().find("not your fault"), std::string::npos);
}

TEST(RunVerdict, OfAnInterruptedRunIsThatItIsKeptAndNotCounted) {
  const QuantityValues values = Recording().twist(60.0).measured().values;

  EXPECT_EQ(judgeRun(values, {}, false).outcome, RunOutcome::kPassed);
  EXPECT_EQ(judgeRun(values, {}, true).outcome, RunOutcome::kInterrupted);
  EXPECT_EQ(judgeRun({{Quantity::kTime, 4.0}}, {}).outcome, RunOutcome::kRefused);  // of a tracker
}

TEST(RunVerdict, SaysEachCheckWithNameValueAndLimit) {
  const Recording run = std::move(Recording().twist(60.0).twist(58.0));

  const std::vector<TargetCheck> checks = verdictOn(run, {.forceLimit_N = 1.1996,
                                                          .torqueLimit_Nm = 0.7,
                                                          .hold_s = 0.25,
                                                          .leastTwists = 2,
                                                          .mastery = {{.quantity = Quantity::kOvershoot,
                                                                       .atMost = true,
                                                                       .threshold = radians(5.0),
                                                                       .consecutive = 3},
                                                                      {}}})
                                              .checks;

  ASSERT_EQ(checks.size(), 7U);
  EXPECT_EQ(checks[0].text(), "Twists completed: 2, at least 2");
  EXPECT_EQ(checks[1].text(), "Targets reached: 2 of 2, at least 2");
  EXPECT_EQ(checks[2].text(), "Shortest hold on target: 0.3 s, at least 0.2 s");
  EXPECT_EQ(checks[3].text(), "Peak force: 1.2000 N, at most 1.20 N");  // 1.2 N is above 1.1996 N
  EXPECT_EQ(checks[4].text(), "Peak torque: 0.600 N m, at most 0.700 N m");
  EXPECT_EQ(checks[5].text(), "Overshoot: 0.0\u00b0, at most 5.0\u00b0 (1 in a row, 3 needed)");
  EXPECT_FALSE(checks[6].passed);
}

TEST(RunVerdict, StatesARequirementOnceIfARuleRepeatsIt) {
  const QuantityValues values{
      {Quantity::kUntwisted, 1.0}, {Quantity::kTornTwists, 0.0}, {Quantity::kPeakForce, 0.4}};

  const RunVerdict verdict =
      judgeRun(values, {.forceLimit_N = 2.0,
                        .mastery = {{.quantity = Quantity::kUntwisted, .threshold = 1.0, .consecutive = 2},
                                    {.quantity = Quantity::kPeakForce, .atMost = true, .threshold = 1.0}}});

  ASSERT_EQ(verdict.checks.size(), 3U);
  EXPECT_EQ(verdict.checks[0].text(), "Peak force: 0.40 N, at most 2.00 N");
  EXPECT_EQ(verdict.checks[1].text(), "Untwisted: yes (yes required) (1 in a row, 2 needed)");
  EXPECT_EQ(verdict.checks[2].text(),
            "Peak force: 0.40 N, at most 1.00 N");  // a stricter limit is another one
}

TEST(TwistCount, AgreesWithTheDebrief) {
  TwistCount count;
  std::int64_t now_us = 0;
  LiveState state;
  const auto grip = [&](double angle_deg, std::uint32_t status = kDeviceOk) {
    for (const double share : {0.0, 1.0, 0.5}) {
      state.phase = ExercisePhase::kTwisting;
      state.deviceStatus = kDeviceOk;
      state.response.angle_rad = radians(angle_deg * share);
      count.see(state);
    }
    state.phase = ExercisePhase::kReleased;
    state.deviceStatus = status;
    state.times.released_us = now_us += 1000;
    count.see(state);
    count.see(state);
  };

  grip(60.0);
  EXPECT_EQ(count.completed(), 1);
  EXPECT_DOUBLE_EQ(count.releasedAt_rad(), radians(30.0));
  grip(1.9);  // a touch
  EXPECT_DOUBLE_EQ(count.releasedAt_rad(), radians(30.0));
  EXPECT_EQ(count.completed(), 1);
  grip(60.0, kDeviceLost);
  EXPECT_EQ(count.completed(), 1);
  grip(-3.0);
  EXPECT_EQ(count.completed(), 2);
}

TEST(PassRule, ARunWithoutTwistsCannotPass) {
  const std::vector<TargetCheck> checks =
      verdictOn(std::move(Recording().free(10)), {.forceLimit_N = 5.0, .hold_s = 0.1}).checks;

  for (const TargetCheck& check : checks) {
    EXPECT_FALSE(check.passed);
  }
}

TEST(Mastery, CountsAttemptsInARowAndIsPermanent) {
  const MasteryRule rule{
      .quantity = Quantity::kPeakForce, .atMost = true, .threshold = 2.0, .consecutive = 2};
  const std::vector<std::optional<double>> broken{1.0, std::nullopt, 2.0, 2.1};
  const std::vector<std::optional<double>> met{1.0, 2.0, 9.0};

  EXPECT_FALSE(masteryProgress(rule, broken).met);
  EXPECT_EQ(masteryProgress(rule, broken).streak, 0);
  EXPECT_TRUE(masteryProgress(rule, met).met);
  EXPECT_EQ(masteryProgress(rule, met).streak, 0);
  EXPECT_DOUBLE_EQ(*masteryProgress(rule, met).last, 9.0);
}

TEST(Mastery, AnAttemptPassesByAllRulesOrByItsShareOnTarget) {
  const AttemptRules rules{.mastery = {{.quantity = Quantity::kEconomy, .threshold = 0.5},
                                       {.quantity = Quantity::kTime, .atMost = true, .threshold = 9.0}}};
  const auto passes = [&rules](double economy, double time_s, double reached) {
    return judgeRun({{Quantity::kTornTwists, 0.0},
                     {Quantity::kCompletedTwists, 5.0},
                     {Quantity::kTargetsReached, reached},
                     {Quantity::kEconomy, economy},
                     {Quantity::kTime, time_s}},
                    rules)
        .passed();
  };

  EXPECT_TRUE(passes(0.5, 9.0, 4.0));
  EXPECT_FALSE(passes(0.4, 9.0, 5.0));
  EXPECT_FALSE(passes(0.5, 9.1, 5.0));
  EXPECT_FALSE(passes(0.5, 9.0, 3.0));
}

TEST(Merit, IsTheLogarithmOfTheRatioToTheExpert) {
  EXPECT_DOUBLE_EQ(merit(Quantity::kSettling, 2.0, 2.0), 0.0);
  EXPECT_NEAR(merit(Quantity::kSettling, 1.5, 3.5), std::log(4.0 / 2.0), 1e-12);  // lower is better
  EXPECT_NEAR(merit(Quantity::kSparc, -3.0, -1.5), 2.0 * std::log(0.5), 1e-12);   // nearer 0 is better
  EXPECT_NEAR(merit(Quantity::kEconomy, 0.9, 0.4), std::log(1.0 / 0.5), 1e-12);   // higher is better
}

TEST(Merit, NamesTheBestAndWorstTwistByCriterionWithoutIncompleteOnes) {
  const MeasuredTrial own = Recording().twist(60.0).twist(50.0).held(400, 89.0).trial();
  const MeasuredTrial expert = Recording().twist(55.0).trial();

  const std::vector<QuantityMerit> all = meritsAgainst(own, expert);

  const auto force = std::find_if(all.begin(), all.end(),
                                  [](const QuantityMerit& m) { return m.quantity == Quantity::kPeakForce; });
  ASSERT_NE(force, all.end());
  EXPECT_EQ(force->best.twist, 1U);
  EXPECT_EQ(force->worst.twist, 0U);
  EXPECT_NEAR(force->expert, 1.1, 1e-12);
  EXPECT_NEAR(force->merit, 0.0, 1e-12);  // median of 1.2 and 1.0 N
  for (std::size_t i = 1; i < all.size(); ++i) {
    EXPECT_GE(all[i - 1].merit, all[i].merit);
  }
}

}  // namespace
}  // namespace torsio
