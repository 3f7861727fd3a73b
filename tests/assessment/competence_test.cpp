// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/attempt/competence.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/random.h"

namespace torsio {
namespace {

/// Number of simulated trainees for attempts of this number.
int traineesFor(std::int64_t count) {
  return static_cast<int>(200'000 / count);
}

std::vector<bool> attempts(Random& random, double failureRate, std::int64_t count) {
  std::vector<bool> failed;
  for (std::int64_t i = 0; i < count; ++i) {
    failed.push_back(random.uniform() < failureRate);
  }
  return failed;
}

/// Share of simulated trainees declared competent within `count` attempts.
double declaredAble(const CompetenceDesign& design, double failureRate, std::int64_t count) {
  Random random(20251121);
  const int trainees = traineesFor(count);
  int able = 0;
  for (int i = 0; i < trainees; ++i) {
    able += judgeCompetence(design, attempts(random, failureRate, count)).ableAt ? 1 : 0;
  }
  return static_cast<double>(able) / trainees;
}

/// Four standard errors of a simulated share.
double bound(double share, std::int64_t count) {
  return 4.0 * std::sqrt(share * (1.0 - share) / traineesFor(count)) + 1e-4;
}

CompetenceDesign designOf(double adequate, double inadequate, std::int64_t count, double falsePass) {
  CompetenceDesign design;
  design.adequate = adequate;
  design.inadequate = inadequate;
  design.attempts = count;
  design.falsePassMost = falsePass;
  design.falseFailMost = 0.9;
  return plannedCompetence(design);
}

TEST(Competence, SimulatedErrorRatesMatchThePrintedOnes) {
  for (const CompetenceDesign& design :
       {shippedCompetence("m", radians(5.0)), designOf(0.1, 0.4, 30, 0.05), designOf(0.05, 0.2, 100, 0.01)}) {
    const CompetenceErrors errors = competenceErrors(design, design.attempts);
    const double pass = declaredAble(design, design.inadequate, design.attempts);
    const double fail = 1.0 - declaredAble(design, design.adequate, design.attempts);
    EXPECT_NEAR(pass, errors.falsePass, bound(errors.falsePass, design.attempts)) << design.attempts;
    EXPECT_NEAR(fail, errors.falseFail, bound(errors.falseFail, design.attempts)) << design.attempts;
    EXPECT_LE(errors.falsePass, design.falsePassMost);
  }
}

/// Share of simulated trainees who count as competent after `count` attempts.
double stillAble(const CompetenceDesign& design, double failureRate, std::int64_t count) {
  Random random(20251122);
  const int trainees = traineesFor(count);
  int able = 0;
  for (int i = 0; i < trainees; ++i) {
    able += isAble(judgeCompetence(design, attempts(random, failureRate, count)).level) ? 1 : 0;
  }
  return static_cast<double>(able) / trainees;
}

TEST(Competence, FalseAlarmsOfTheRelapseMonitoringAreReportedToo) {
  for (const std::int64_t count : {50, 200}) {
    const CompetenceDesign design = shippedCompetence("m", radians(5.0));
    const CompetenceErrors errors = competenceErrors(design, count);
    const double lost = errors.falseFail + errors.falseAlarm;
    EXPECT_NEAR(1.0 - stillAble(design, design.adequate, count), lost, bound(lost, count)) << count;
  }
  // Every competent trainee is eventually declared so, but at any time one in 27 is under a false alarm.
  EXPECT_LT(competenceErrors(shippedCompetence("m", 0.1), 500).falseFail, 1e-8);
  EXPECT_NEAR(competenceErrors(shippedCompetence("m", 0.1), 200).falseAlarm, 0.0367, 5e-5);
  EXPECT_NEAR(competenceErrors(shippedCompetence("m", 0.1), 5000).falseAlarm,
              competenceErrors(shippedCompetence("m", 0.1), 1000).falseAlarm, 1e-9);
}

TEST(Competence, TheReportedRatesAreThoseOfTheAttemptsMade) {
  const CompetenceDesign design = shippedCompetence("m", radians(5.0));
  const CompetenceVerdict few = judgeCompetence(design, std::vector<bool>(10, true));
  const CompetenceVerdict many = judgeCompetence(design, std::vector<bool>(200, true));

  EXPECT_EQ(few.errors.attempts, design.attempts);
  EXPECT_EQ(many.errors.attempts, 200);
  EXPECT_GT(many.errors.falsePass, few.errors.falsePass);  // more attempts make passing easier
  EXPECT_NEAR(declaredAble(design, design.inadequate, 200), many.errors.falsePass,
              bound(many.errors.falsePass, 200));
}

// Limits and rates of the shipped design from an independent enumeration of all sums.
TEST(Competence, TheShippedDesignKeepsBothOfItsRates) {
  const CompetenceDesign design = plannedCompetence(shippedCompetence("m", radians(5.0)));
  EXPECT_EQ(design, shippedCompetence("m", radians(5.0)));  // its limit is the chosen one
  const CompetenceErrors errors = competenceErrors(design, design.attempts);
  EXPECT_NEAR(errors.falsePass, 0.0491, 5e-5);
  EXPECT_NEAR(errors.falseFail, 0.094, 5e-4);
  EXPECT_NO_THROW(requireFalseFailKept(design));
  EXPECT_EQ(fewestForAble(design), 17U);
}

TEST(Competence, DesignsThatMissTheirRatesAreRejected) {
  const auto refused = [](auto change) {
    CompetenceDesign design = shippedCompetence("m", radians(5.0));
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
  refused([](CompetenceDesign& d) { d.attempts = 2; });  // two attempts cannot suffice at 5 %
  // Rates of an earlier report within 50 attempts: half of the competent would not pass.
  CompetenceDesign weak = shippedCompetence("m", radians(5.0));
  weak.inadequate = 0.2;
  const CompetencePreview preview = previewOfCompetence(weak);
  EXPECT_FALSE(preview.falseFailKept);
  EXPECT_NEAR(preview.errors.falseFail, 0.503, 5e-4);
  EXPECT_THROW(requireFalseFailKept(preview.design), Error);
}

TEST(Competence, ADesignAppliesToThoseWhoBeginAfterIt) {
  const CompetenceDesign shipped = shippedCompetence("m", 0.1);
  std::vector<CompetenceDesign> registered(2, shipped);
  registered[0].version = 1;
  registered[0].registeredUtc_us = 100;
  registered[1].version = 2;
  registered[1].registeredUtc_us = 200;

  EXPECT_EQ(designInForce({}, shipped, 50).version, 0);
  EXPECT_EQ(designInForce(registered, shipped, 50).version, 0);
  EXPECT_EQ(designInForce(registered, shipped, 100).version, 1);
  EXPECT_EQ(designInForce(registered, shipped, 199).version, 1);
  EXPECT_EQ(designInForce(registered, shipped, 300).version, 2);
  EXPECT_EQ(designInForce(registered, shipped, std::nullopt).version, 2);  // before the first attempt
}

TEST(Competence, AnAttemptIsATwistWithinTheToleranceOrAWholeUntwisting) {
  CompetenceDesign design = shippedCompetence("m", radians(2.0));
  CompetenceRun run;
  run.tolerance_rad = radians(2.0);
  run.twists = {{1.9, true}, {2.1, false}};
  CompetenceRun rough = run;
  rough.withinLimits = false;
  CompetenceRun undone;
  undone.untwisting = true;
  undone.outcome = RunOutcome::kPassed;

  EXPECT_EQ(failedAttempts(design, std::vector<CompetenceRun>{run, rough, undone}),
            (std::vector<bool>{false, true, true, true, false}));
  design.tolerance_rad = radians(3.0);  // wider than the exercise's
  EXPECT_EQ(failedAttempts(design, std::vector<CompetenceRun>{run}), (std::vector<bool>{false, false}));
}

TEST(Competence, TheLevelFollowsTheSums) {
  const CompetenceDesign design = shippedCompetence("m", 0.1);
  EXPECT_EQ(judgeCompetence(design, {}).attemptsUntilLevel, 17U);
  const CompetenceVerdict one = judgeCompetence(design, {false});
  EXPECT_EQ(one.attemptsUntilLevel, 16U);
  EXPECT_EQ(one.level, SkillLevel::kNotShown);
  EXPECT_EQ(judgeCompetence(design, std::vector<bool>(20, true)).level, SkillLevel::kLearning);

  const std::vector<bool> able(17, false);
  EXPECT_EQ(judgeCompetence(design, able).level, SkillLevel::kSteady);
  EXPECT_EQ(judgeCompetence(design, able).ableAt, 17U);
  std::vector<bool> doubt = able;
  doubt.insert(doubt.end(), 2, true);  // 2 ln 3 = 2.2 of 4.09
  EXPECT_EQ(judgeCompetence(design, doubt).level, SkillLevel::kWatch);
  std::vector<bool> alarm = able;
  alarm.insert(alarm.end(), 4, true);  // 4 ln 3 = 4.4
  const CompetenceVerdict relapsed = judgeCompetence(design, alarm);
  EXPECT_EQ(relapsed.level, SkillLevel::kRelapsed);
  EXPECT_EQ(relapsed.sums.size(), alarm.size());
  EXPECT_EQ(relapsed.failed, 4U);
  std::vector<bool> again = alarm;
  again.insert(again.end(), 17, false);
  EXPECT_EQ(judgeCompetence(design, again).level, SkillLevel::kSteady);
}

}  // namespace
}  // namespace torsio
