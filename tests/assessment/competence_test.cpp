// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/competence.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "assessment/attempt/competence_simulation.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "sim/core/time_units.h"

namespace torsio {
namespace {

/// Number of simulated trainees for runs of this number.
int traineesFor(std::int64_t count) {
  return static_cast<int>(200'000 / count);
}

/// A design whose runs do not depend on each other.
CompetenceDesign independent(CompetenceDesign design) {
  design.sessionCorrelation = 0.0;
  design.lagCorrelation = 0.0;
  return design;
}

CompetenceDesign shipped() {
  return shippedCompetence("m", radians(5.0));
}

/// Runs of one trainee, by the dependence that a design assumes: sessions with rates of their own, of a beta
/// distribution drawn as a share of two gamma variates.
std::vector<bool> runsOf(Random& random, const CompetenceDesign& design, double failureRate,
                         std::int64_t count) {
  const auto gamma = [&random](double shape) {  // Marsaglia and Tsang; below 1 by a power of a uniform number
    const double lift = shape < 1.0 ? std::pow(1.0 - random.uniform(), 1.0 / shape) : 1.0;
    const double d = (shape < 1.0 ? shape + 1.0 : shape) - 1.0 / 3.0;
    for (;;) {
      const double x = random.normal();
      const double v = std::pow(1.0 + x / std::sqrt(9.0 * d), 3);
      if (v > 0.0 && std::log(1.0 - random.uniform()) < 0.5 * x * x + d - d * v + d * std::log(v)) {
        return lift * d * v;
      }
    }
  };
  std::vector<bool> failed;
  double rate = failureRate;
  for (std::int64_t i = 0; i < count; ++i) {
    if (design.sessionCorrelation > 0.0 && i % design.runsPerSession == 0) {
      const double precision = (1.0 - design.sessionCorrelation) / design.sessionCorrelation;
      const double a = gamma(failureRate * precision);
      rate = a / (a + gamma((1.0 - failureRate) * precision));
    }
    const bool before = i == 0 ? random.uniform() < failureRate : failed.back();
    failed.push_back(random.uniform() < design.lagCorrelation ? before : random.uniform() < rate);
  }
  return failed;
}

/// Share of simulated trainees declared competent within `count` runs.
double declaredAble(const CompetenceDesign& design, double failureRate, std::int64_t count) {
  Random random(20251121);
  const int trainees = traineesFor(count);
  int able = 0;
  for (int i = 0; i < trainees; ++i) {
    able += judgeAttempts(design, runsOf(random, design, failureRate, count)).ableAt ? 1 : 0;
  }
  return static_cast<double>(able) / trainees;
}

/// Four standard errors of a simulated share.
double bound(double share, std::int64_t count) {
  return 4.0 * std::sqrt(share * (1.0 - share) / traineesFor(count)) + 1e-4;
}

CompetenceDesign designOf(double adequate, double inadequate, std::int64_t count, double falsePass) {
  CompetenceDesign design = independent(shipped());
  design.adequate = adequate;
  design.inadequate = inadequate;
  design.attempts = count;
  design.falsePassMost = falsePass;
  design.falseFailMost = 0.9;
  return plannedCompetence(design);
}

CompetenceDesign dependent(double session, double lag, std::int64_t perSession) {
  CompetenceDesign design = shipped();
  design.sessionCorrelation = session;
  design.lagCorrelation = lag;
  design.runsPerSession = perSession;
  return plannedCompetence(design);
}

TEST(Competence, SimulatedErrorRatesMatchThePrintedOnes) {
  for (const CompetenceDesign& design :
       {shipped(), designOf(0.1, 0.4, 30, 0.05), designOf(0.05, 0.2, 100, 0.01), dependent(0.0, 0.4, 1),
        dependent(0.3, 0.0, 10), dependent(0.2, 0.2, 3), dependent(0.15, 0.0, 40)}) {
    const CompetenceErrors errors = competenceErrors(design, design.attempts);
    const double pass = declaredAble(design, design.inadequate, design.attempts);
    const double fail = 1.0 - declaredAble(design, design.adequate, design.attempts);
    EXPECT_NEAR(pass, errors.falsePass, bound(errors.falsePass, design.attempts)) << design.limit;
    EXPECT_NEAR(fail, errors.falseFail, bound(errors.falseFail, design.attempts)) << design.limit;
    EXPECT_LE(errors.falsePass, design.falsePassMost);
  }
}

/// Share of simulated trainees who count as competent after `count` runs.
double stillAble(const CompetenceDesign& design, double failureRate, std::int64_t count) {
  Random random(20251122);
  const int trainees = traineesFor(count);
  int able = 0;
  for (int i = 0; i < trainees; ++i) {
    able += isAble(judgeAttempts(design, runsOf(random, design, failureRate, count)).level) ? 1 : 0;
  }
  return static_cast<double>(able) / trainees;
}

TEST(Competence, FalseAlarmsOfTheRelapseMonitoringAreReportedToo) {
  for (const CompetenceDesign& design : {independent(shipped()), dependent(0.15, 0.3, 4)}) {
    for (const std::int64_t count : {50, 202}) {
      const CompetenceErrors errors = competenceErrors(design, count);
      const double lost = errors.falseFail + errors.falseAlarm;
      EXPECT_NEAR(1.0 - stillAble(design, design.adequate, count), lost, bound(lost, count)) << count;
    }
  }
  EXPECT_LT(competenceErrors(independent(shipped()), 500).falseFail, 1e-8);
  EXPECT_NEAR(competenceErrors(shipped(), 5000).falseAlarm, competenceErrors(shipped(), 2500).falseAlarm,
              1e-7);
}

TEST(Competence, TheProbabilitiesAreThoseOfTheRunsMade) {
  const CompetenceDesign design = shipped();
  const CompetenceVerdict few = judgeCompetence(design, std::vector<bool>(10, false));
  const CompetenceVerdict many = judgeCompetence(design, std::vector<bool>(200, true));

  // Fewer runs than anybody needs: no false pass, and everybody adequate is still missed.
  EXPECT_EQ(few.level, SkillLevel::kNotShown);
  EXPECT_EQ(few.errors.attempts, 10);
  EXPECT_EQ(few.errors.falsePass, 0.0);
  EXPECT_EQ(few.errors.falseFail, 1.0);
  EXPECT_EQ(few.made.declared, (std::array<double, 5>{}));
  EXPECT_EQ(few.planned, competenceOdds(design, design.attempts));
  EXPECT_EQ(competenceErrors(design, 0).falseFail, 1.0);
  EXPECT_EQ(many.errors.attempts, 200);
  EXPECT_GT(many.errors.falsePass,
            competenceErrors(design, design.attempts).falsePass);  // more runs make passing easier
  for (std::size_t i = 0; i < kStatedFailureRates.size(); ++i) {
    const double printed = many.made.declared[i];
    EXPECT_NEAR(declaredAble(design, kStatedFailureRates[i], 200), printed, bound(printed, 200));
    EXPECT_GT(printed, many.planned.declared[i]);
  }
}

TEST(Competence, TheShippedDesignKeepsBothOfItsRates) {
  const CompetenceDesign design = plannedCompetence(shipped());
  EXPECT_EQ(design, shipped());  // its limit is the chosen one
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  EXPECT_NEAR(errors.falsePass, 0.0247, 5e-4);
  EXPECT_NEAR(errors.falseFail, 0.081, 5e-4);
  EXPECT_NO_THROW(requireFalseFailKept(design));
  EXPECT_EQ(fewestForAble(design), 38U);
}

// The simulation of the real rule, as torsio competence simulate prints it.
TEST(Competence, IsDeclaredAsOftenAsPrintedHoweverRunsFail) {
  const std::vector<CompetenceScenario> scenarios = simulateCompetence(shipped(), 2'000, 20261129);
  ASSERT_EQ(scenarios.size(), 7U);
  for (const CompetenceScenario& one : scenarios) {
    EXPECT_NEAR(one.inadequate.declared, one.inadequate.printed, 0.01) << one.name;
    EXPECT_LE(one.inadequate.declared, 0.035) << one.name;
    EXPECT_NEAR(one.adequate.declared, one.adequate.printed, 0.02) << one.name;  // three standard errors
    EXPECT_GT(one.design.dependenceRuns, 0) << one.name;
  }
  EXPECT_LT(scenarios[0].design.limit, scenarios[4].design.limit);  // dependent runs ask for more
}

// Before a centre has enough runs, what is printed with the shipped design covers every scenario.
TEST(Competence, PrintsUpperBoundsBeforeTheCentreHasData) {
  for (const CompetenceScenario& one : simulateCompetence(shipped(), 4'000, 20261130)) {
    constexpr double kError = 0.005;  // of a share among 4,000
    EXPECT_LE(one.assumedInadequate.declared, one.assumedInadequate.printed + kError) << one.name;
    EXPECT_GE(one.assumedAdequate.declared, one.assumedAdequate.printed - 2.0 * kError) << one.name;
    EXPECT_LE(one.assumedInadequate.printed, shipped().falsePassMost) << one.name;
    EXPECT_GE(one.assumedAdequate.printed, 1.0 - shipped().falseFailMost) << one.name;
  }
}

TEST(Competence, DesignsThatMissTheirRatesAreRejected) {
  const auto refused = [](auto change) {
    CompetenceDesign design = shipped();
    change(design);
    EXPECT_THROW((void)plannedCompetence(design), Error);
  };
  refused([](CompetenceDesign& d) { d.adequate = 0.0; });
  refused([](CompetenceDesign& d) { d.adequate = std::numeric_limits<double>::quiet_NaN(); });
  refused([](CompetenceDesign& d) { d.inadequate = 1.0; });
  refused([](CompetenceDesign& d) { d.inadequate = d.adequate; });
  refused([](CompetenceDesign& d) { d.attempts = 0; });
  refused([](CompetenceDesign& d) { d.attempts = kMaxCompetenceAttempts + 1; });
  refused([](CompetenceDesign& d) { d.falsePassMost = 1.0; });
  refused([](CompetenceDesign& d) { d.tolerance_rad = 0.0; });
  refused([](CompetenceDesign& d) { d.sessionCorrelation = -0.1; });
  refused([](CompetenceDesign& d) { d.lagCorrelation = 1.0; });
  refused([](CompetenceDesign& d) { d.runsPerSession = 0; });
  refused([](CompetenceDesign& d) { d.runsPerSession = kMaxCompetenceAttempts + 1; });
  refused([](CompetenceDesign& d) { d.validDays = -1; });
  refused([](CompetenceDesign& d) { d.attempts = 2; });  // two runs cannot suffice at 2.5 %
  // Rates of an earlier report within 50 independent attempts: half of the competent would not pass.
  CompetenceDesign weak = independent(shipped());
  weak.attempts = 50;
  weak.adequate = 0.1;
  weak.inadequate = 0.2;
  weak.falsePassMost = 0.05;
  const CompetencePreview preview = previewOfCompetence(weak);
  EXPECT_FALSE(preview.falseFailKept);
  EXPECT_NEAR(preview.errors.falseFail, 0.503, 5e-4);
  EXPECT_THROW(requireFalseFailKept(preview.design), Error);
}

TEST(Competence, ADesignAppliesToThoseWhoBeginAfterIt) {
  const CompetenceDesign own = shippedCompetence("m", 0.1);
  std::vector<CompetenceDesign> registered(2, own);
  registered[0].version = 1;
  registered[0].registeredUtc_us = 100;
  registered[1].version = 2;
  registered[1].registeredUtc_us = 200;

  EXPECT_EQ(designInForce({}, own, 50).version, 0);
  EXPECT_EQ(designInForce(registered, own, 50).version, 0);
  EXPECT_EQ(designInForce(registered, own, 100).version, 1);
  EXPECT_EQ(designInForce(registered, own, 199).version, 1);
  EXPECT_EQ(designInForce(registered, own, 300).version, 2);
  EXPECT_EQ(designInForce(registered, own, std::nullopt).version, 2);  // before the first run
}

/// Measures of a run with these errors at release.
AttemptMeasures measuresOf(const std::vector<double>& errors_deg, double tolerance_deg) {
  AttemptMeasures measures;
  for (const double error_deg : errors_deg) {
    measures.twists.push_back({error_deg, error_deg <= tolerance_deg});
  }
  measures.values = {{Quantity::kCompletedTwists, static_cast<double>(errors_deg.size())},
                     {Quantity::kTargetsReached, static_cast<double>(measures.twistsOnTarget())},
                     {Quantity::kTornTwists, 0.0},
                     {Quantity::kPeakForce, 2.0}};
  return measures;
}

TEST(Competence, ARunPassesOrFailsAsAWhole) {
  CompetenceDesign design = shippedCompetence("m", radians(2.0));
  const AttemptRules rules{.tolerance_rad = radians(2.0), .forceLimit_N = 3.0};
  AttemptMeasures run = measuresOf({1.0, 1.0, 1.0, 1.9, 2.1}, 2.0);
  EXPECT_EQ(competenceOutcome(design, rules, run, radians(2.0)), RunOutcome::kPassed);
  run.values[Quantity::kPeakForce] = 3.5;  // perfect angles, too much force
  EXPECT_EQ(competenceOutcome(design, rules, run, radians(2.0)), RunOutcome::kNotPassed);
  run = measuresOf({1.0, 2.5, 2.5}, 2.0);
  EXPECT_EQ(competenceOutcome(design, rules, run, radians(2.0)), RunOutcome::kNotPassed);
  design.tolerance_rad = radians(3.0);  // wider than the exercise's
  EXPECT_EQ(competenceOutcome(design, rules, run, radians(2.0)), RunOutcome::kPassed);
}

TEST(Competence, ATwistHeldWhenTheRunEndsIsMissed) {
  const CompetenceDesign design = shippedCompetence("m", radians(2.0));
  const AttemptRules rules{.tolerance_rad = radians(2.0)};
  AttemptMeasures run = measuresOf({1.0, 1.0, 1.0, 2.5, 1.0}, 2.0);
  EXPECT_EQ(competenceOutcome(design, rules, run, radians(2.0)), RunOutcome::kPassed);
  run.unfinished = 1;  // a second miss, still held at the end
  EXPECT_EQ(competenceOutcome(design, rules, run, radians(2.0)), RunOutcome::kNotPassed);
  EXPECT_EQ(judgeRun(run, rules).checks.front().outOf, 6);
  run.values[Quantity::kTornTwists] = 1.0;  // the computer lost its release
  EXPECT_EQ(run.twistsCutOff(), 0);
}

TEST(Competence, InterruptedRunsHaveFailedUnlessExcused) {
  const std::vector<CompetenceRun> runs{{.outcome = RunOutcome::kPassed},
                                        {.outcome = RunOutcome::kInterrupted},
                                        {.outcome = RunOutcome::kInterrupted, .excused = true},
                                        {.outcome = RunOutcome::kNotJudged},
                                        {.outcome = RunOutcome::kNotPassed}};
  EXPECT_EQ(failedAttempts(runs), (std::vector<bool>{false, true, true}));
}

TEST(Competence, SessionsAreSeparatedByAPause) {
  constexpr std::int64_t kHour_us = 3'600'000'000;
  std::vector<CompetenceRun> runs;
  for (const std::int64_t hour : {0, 1, 5, 12, 13, 40}) {
    runs.push_back({.outcome = RunOutcome::kPassed, .startedUtc_us = hour * kHour_us});
  }
  runs[1].outcome = RunOutcome::kNotPassed;
  runs[4].outcome = RunOutcome::kNotJudged;
  EXPECT_EQ(sessionsOf(runs), (SessionOutcomes{{false, true, false}, {false}, {false}}));
}

TEST(Competence, ExpiresAfterAPauseAndIsJudgedAnew) {
  CompetenceDesign design = shipped();
  design.validDays = 180;
  std::vector<bool> failed(38, false);
  std::vector<std::int64_t> started_us(38, 0);
  EXPECT_FALSE(isExpired(design, 0, 180 * kDay_us));
  EXPECT_TRUE(isExpired(design, 0, 181 * kDay_us));
  failed.push_back(false);
  started_us.push_back(180 * kDay_us);
  EXPECT_EQ(firstValidAttempt(design, failed, started_us), 0U);
  started_us.back() = 181 * kDay_us;
  EXPECT_EQ(firstValidAttempt(design, failed, started_us), 38U);
  failed[3] = true;  // not competent before the pause: nothing to expire
  EXPECT_EQ(firstValidAttempt(design, failed, started_us), 0U);
  design.validDays = 0;
  EXPECT_FALSE(isExpired(design, 0, 100'000 * kDay_us));
}

TEST(Competence, TheLevelFollowsTheSums) {
  const CompetenceDesign design = shippedCompetence("m", 0.1);
  EXPECT_EQ(judgeCompetence(design, {}).attemptsUntilLevel, 38U);
  const CompetenceVerdict one = judgeCompetence(design, {false});
  EXPECT_EQ(one.attemptsUntilLevel, 37U);
  EXPECT_EQ(one.level, SkillLevel::kNotShown);
  EXPECT_EQ(judgeCompetence(design, std::vector<bool>(40, true)).level, SkillLevel::kLearning);

  const std::vector<bool> able(38, false);
  EXPECT_EQ(judgeCompetence(design, able).level, SkillLevel::kSteady);
  EXPECT_EQ(judgeCompetence(design, able).ableAt, 38U);
  std::vector<bool> doubt = able;
  doubt.insert(doubt.end(), 4, true);  // 4 ln 6 = 7.2 of 11.30
  EXPECT_EQ(judgeCompetence(design, doubt).level, SkillLevel::kWatch);
  std::vector<bool> alarm = able;
  alarm.insert(alarm.end(), 7, true);  // 7 ln 6 = 12.5
  const CompetenceVerdict relapsed = judgeCompetence(design, alarm);
  EXPECT_EQ(relapsed.level, SkillLevel::kRelapsed);
  EXPECT_EQ(relapsed.sums.size(), alarm.size());
  EXPECT_EQ(relapsed.failed, 7U);
  std::vector<bool> again = alarm;
  again.insert(again.end(), 38, false);
  EXPECT_EQ(judgeCompetence(design, again).level, SkillLevel::kSteady);
}

}  // namespace
}  // namespace torsio
