// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "app/services/recording/recorded_run.h"
#include "app/services/training/attempts.h"
#include "app/services/training/debrief.h"
#include "app/services/training/trend.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/catalogue/quantity.h"
#include "db/repository/trial/digest_repository.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"
#include "sim/servo/replay_trial.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

constexpr double kBeginner = 0.1;
constexpr double kExpert = 1.0;

TEST(ExpertRun, IsOneTwistThatReachesTheTargetAndReplaysBitForBit) {
  const Trial trial = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  const std::vector<Sample> samples = decodeTrial(trial);

  const auto farthest = std::max_element(
      samples.begin(), samples.end(),
      [](const Sample& a, const Sample& b) { return a.response.angle_rad < b.response.angle_rad; });
  EXPECT_NEAR(farthest->response.angle_rad, trainingBar().pattern.targetAngle_rad, radians(5.0));
  EXPECT_EQ(trial.header.phaseLabel, kExpertPhase);
  EXPECT_EQ(trial.summary.outcome, TrialOutcome::kCompleted);
  EXPECT_TRUE(replayTrial(trainingBar(), trial).identical());
}

TEST(Debrief, ShowsEarlierMeasuresNextToTheCurrentVerdict) {
  TrainingCentre centre;
  const TrialId trial = centre.attempt("first", "practice", kExpert);
  static_cast<void>(attemptOf(centre, trial));
  const DigestRepository digests(centre.connection());
  TrialDigest older = digests.ofTrial(trial, kMetricsVersion).at(0);
  const double judged_N = older.measures.values.at(Quantity::kPeakForce);
  older.formulaVersion = kMetricsVersion - 1;
  older.measures.values.at(Quantity::kPeakForce) = 0.88;  // what the device could render
  DigestRepository(centre.connection()).add({&older, 1});

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_TRUE(told.earlier);
  EXPECT_EQ(told.earlier->version, kMetricsVersion - 1);
  EXPECT_EQ(told.earlier->peakForce_N, 0.88);
  EXPECT_TRUE(told.earlier->withinLimits);
  const auto force =
      std::find_if(told.verdict.checks.begin(), told.verdict.checks.end(),
                   [](const TargetCheck& check) { return check.quantity == Quantity::kPeakForce; });
  ASSERT_NE(force, told.verdict.checks.end());
  EXPECT_EQ(force->value, judged_N);
  EXPECT_GT(judged_N, 0.88);
}

TEST(Debrief, ShowsWhatWasReachedAndWhereToLook) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kBeginner, 30.0);

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_FALSE(told.twists.empty());
  EXPECT_EQ(told.moduleTitle, "Quarter turn, first");
  EXPECT_NEAR(told.duration_s, 30.0, 0.01);
  ASSERT_EQ(told.strengths.size(), 2U);
  ASSERT_EQ(told.weaknesses.size(), 2U);
  std::set<Quantity> metrics;
  for (const auto* list : {&told.strengths, &told.weaknesses}) {
    for (const DebriefFinding& finding : *list) {
      metrics.insert(finding.quantity);
      const TwistResult& twist = told.twists.at(finding.twist);
      EXPECT_GE(finding.when.from_s, twist.when.from_s - 0.5) << idOf(finding.quantity);
      EXPECT_LE(finding.when.to_s, twist.when.to_s + 0.5) << idOf(finding.quantity);
      EXPECT_LT(finding.when.from_s, finding.when.to_s) << idOf(finding.quantity);
    }
  }
  EXPECT_EQ(metrics.size(), 4U);  // no metric is both a strength and a weakness
  EXPECT_GE(told.strengths[0].merit, told.weaknesses[0].merit);
  EXPECT_LT(told.weaknesses[0].merit, 0.0);  // a beginner is worse than the expert in something
}

TEST(Debrief, StatesWhetherTheForceWasFelt) {
  const Trial led = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  TrialHeader turned = led.header;
  turned.drive = TwistDrive::kRoll;  // mouse, game controller, puck: they turn on the spot without force
  const std::vector<Sample> samples = decodeTrial(led);

  EXPECT_TRUE(makeDebrief(led.header, samples, {}, nullptr).forceFelt);
  EXPECT_FALSE(makeDebrief(turned, samples, {}, nullptr).forceFelt);
}

TEST(Debrief, ShowsTheExpertsCurveAtEachGrip) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kBeginner, 30.0);

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_FALSE(told.expert.empty());
  EXPECT_DOUBLE_EQ(told.expert.time_s.front(), 0.0);
  EXPECT_EQ(told.grips_s.size(), told.twists.size());
  const double top = *std::max_element(told.expert.angle_rad.begin(), told.expert.angle_rad.end());
  EXPECT_NEAR(top, told.target_rad, told.tolerance_rad);
}

TEST(Debrief, PassesAnExpertAndFailsATraineeWhoDidNothing) {
  TrainingCentre centre;
  const std::string good = centre.attempt("first", "practice", kExpert);
  const std::string idle = centre.attempt("first", "practice", kExpert, 0.5);

  const Debrief passed = debrief(centre.session(), good, {}, &trainingBar());
  const Debrief failed = debrief(centre.session(), idle, {}, &trainingBar());

  for (const TargetCheck& check : passed.verdict.checks) {
    EXPECT_TRUE(check.passed) << check.text();
  }
  EXPECT_TRUE(passed.verdict.passed());
  EXPECT_FALSE(failed.verdict.passed());
  EXPECT_TRUE(failed.twists.empty());
  EXPECT_TRUE(failed.strengths.empty());
  EXPECT_EQ(failed.verdict.checks.front().quantity, Quantity::kTargetsReached);
  EXPECT_FALSE(failed.verdict.checks.front().passed);
}

TEST(Debrief, ATwistCutOffByTheEndOfTheRunIsNotJudged) {
  Trial trial = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  std::vector<Sample> samples = decodeTrial(trial);
  const auto gripped = std::find_if(samples.begin(), samples.end(), [](const Sample& sample) {
    return sample.response.angle_rad > 0.5 * trainingBar().pattern.targetAngle_rad;
  });
  samples.erase(gripped, samples.end());

  const Debrief told = makeDebrief(trial.header, samples, {}, &trial);
  const AttemptMeasures measures = measureAttempt(trial.header, samples, {.tolerance_rad = radians(5.0)});

  EXPECT_TRUE(told.twists.empty());
  EXPECT_TRUE(told.strengths.empty());
  EXPECT_EQ(told.unfinishedTwists, 1);
  EXPECT_TRUE(measures.twists.empty());
  EXPECT_EQ(measures.unfinished, 1);
}

TEST(Debrief, ReportsLostSamplesOnlyIfTheyBelongToATwist) {
  const Trial trial = expertRun(trainingBar(), trainingBar().pattern.targetAngle_rad);
  const std::vector<Sample> whole = decodeTrial(trial);
  const auto without = [&](double angle) {
    std::vector<Sample> torn = whole;
    const auto at = std::find_if(torn.begin(), torn.end(), [angle](const Sample& sample) {
      return sample.response.angle_rad > angle * trainingBar().pattern.targetAngle_rad;
    });
    torn.erase(at, at + 50);
    return torn;
  };
  std::vector<Sample> before = whole;  // the hand is still approaching
  before.erase(before.begin() + 10, before.begin() + 60);

  EXPECT_TRUE(makeDebrief(trial.header, without(0.5), {}, &trial).verdict.torn);
  EXPECT_FALSE(makeDebrief(trial.header, whole, {}, &trial).verdict.torn);
  EXPECT_FALSE(makeDebrief(trial.header, before, {}, &trial).verdict.torn) << "no twist was touched";
}

TEST(Debrief, MasteryCountsTheAttemptsUpToThisOne) {
  TrainingCentre centre;
  const std::string first = centre.attempt("first", "practice", kExpert);
  const std::string second = centre.attempt("first", "practice", kExpert);

  const auto streakOf = [&](const std::string& trial) {
    const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());
    return told.verdict.checks.back();
  };

  EXPECT_EQ(streakOf(first).streak, 1);
  EXPECT_EQ(streakOf(second).streak, 2);
  EXPECT_EQ(streakOf(second).consecutive, 2);
}

// Twenty peaks are not close to twelve, although nothing else in the run was closer.
TEST(Debrief, CallsOnlyCloseResultsClose) {
  DebriefFinding finding{
      .quantity = Quantity::kSubMovements, .value = 20.0, .expert = 12.0, .merit = -0.45, .strength = true};
  EXPECT_NE(finding.text().str().find("closest to the expert"), std::string::npos);
  finding.value = 13.0;
  finding.merit = -0.07;
  EXPECT_NE(finding.text().str().find("close to the expert"), std::string::npos);
  finding.value = 8.0;
  finding.merit = 0.3;
  EXPECT_NE(finding.text().str().find("better than the expert"), std::string::npos);
}

TEST(Debrief, HasNoExpertIfTheOrganIsNoLongerAvailable) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kExpert);

  const Debrief told = debrief(centre.session(), trial, centre.folder() / "no assets here");

  EXPECT_TRUE(told.expert.empty());
  EXPECT_TRUE(told.strengths.empty());
  EXPECT_FALSE(told.twists.empty());
}

TEST(Debrief, IsOnlyForTheTrainee) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kExpert);
  centre.become("T-02");
  EXPECT_THROW(static_cast<void>(debrief(centre.session(), trial, {}, &trainingBar())), Error);
}

TEST(Debrief, StoresBookmarks) {
  TrainingCentre centre;
  const std::string trial = centre.attempt("first", "practice", kExpert);
  addBookmark(centre.session(), trial, 2.5, "good grip");

  const Debrief told = debrief(centre.session(), trial, {}, &trainingBar());

  ASSERT_EQ(told.bookmarks.size(), 1U);
  EXPECT_DOUBLE_EQ(told.bookmarks[0].at_s, 2.5);
  EXPECT_EQ(told.bookmarks[0].text, "good grip");
  EXPECT_THROW(addBookmark(centre.session(), trial, -1.0, ""), Error);
}

TEST(Trend, ShowsEveryAttemptAndTheDistanceToTheThreshold) {
  TrainingCentre centre;
  centre.attempt("first", "practice", kExpert);
  centre.attempt("first", "practice", kExpert, 0.5);

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));

  ASSERT_EQ(way.points.size(), 2U);
  EXPECT_EQ(way.quantity, Quantity::kOnTarget);
  EXPECT_EQ(way.points[0].outcome, RunOutcome::kPassed);
  EXPECT_EQ(way.points[1].outcome, RunOutcome::kNotPassed);
  EXPECT_FALSE(way.points[1].value);  // no share without twists
  EXPECT_EQ(way.threshold, 0.5);
  ASSERT_TRUE(way.distance);
  EXPECT_LE(*way.distance, 0.0);
  EXPECT_EQ(way.competence.level, SkillLevel::kNotShown);
  EXPECT_GT(way.competence.attempts, 0U);  // twists
  EXPECT_EQ(way.competence.attemptsUntilLevel, 17U - way.competence.attempts);
  EXPECT_EQ(way.competence.design.version, 0);
  EXPECT_TRUE(way.curve.empty());
  EXPECT_FALSE(way.noCurveReason.empty());
}

TEST(Trend, FitsALearningCurveFromEightAttemptsOn) {
  TrainingCentre centre;
  for (int i = 0; i < 9; ++i) {
    centre.attempt("first", "practice", 1.0 - 0.9 * std::exp(-0.4 * i), 10.0);
  }

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"), Quantity::kTime);

  EXPECT_TRUE(way.lowerIsBetter);
  ASSERT_FALSE(way.curve.empty()) << way.noCurveReason;
  EXPECT_GT(way.curve.front().value, way.curve.back().value);
  EXPECT_LE(way.curve.front().lower, way.curve.front().value);
}

}  // namespace
}  // namespace torsio
