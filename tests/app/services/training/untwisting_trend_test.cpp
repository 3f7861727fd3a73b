// SPDX-License-Identifier: GPL-3.0-or-later
// Progress of a trainee in untwisting: metrics, units, and what passes.
#include <gtest/gtest.h>

#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"
#include "assessment/catalogue/quantity.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

using testing::TrainingCentre;

TrainingCentre::Setup undone(std::vector<MasteryCriterion> rules) {
  TrainingCentre::Setup setup;
  setup.sceneId = "testis";
  setup.patternId = "detorse";
  setup.mastery = std::move(rules);
  return setup;
}

const MasteryCriterion kUndone{.metric = idOf(Quantity::kUntwisted), .threshold = 1.0, .unit = "1"};
const MasteryCriterion kSmallDose{
    .metric = idOf(Quantity::kDose), .comparison = "at_most", .threshold = 0.9, .unit = "1"};

TEST(UntwistingTrend, FollowsTheDoseAndPassesByAllRulesOfTheModule) {
  TrainingCentre centre(undone({kUndone, kSmallDose}));
  centre.untwist("first", "practice");
  centre.untwist("first", "practice", 1);  // one turn of the hand is left

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));

  EXPECT_TRUE(way.untwisting);
  EXPECT_EQ(way.quantity, Quantity::kDose);  // the first rule that has a scale
  EXPECT_TRUE(way.lowerIsBetter);
  EXPECT_EQ(way.threshold, 0.9);
  ASSERT_EQ(way.points.size(), 2U);
  ASSERT_TRUE(way.points[0].value);
  ASSERT_TRUE(way.points[1].value);
  EXPECT_LT(*way.points[1].value, 0.9);  // the dose alone would pass
  EXPECT_EQ(way.points[0].outcome, RunOutcome::kPassed);
  EXPECT_EQ(way.points[1].outcome, RunOutcome::kNotPassed);
}

TEST(UntwistingTrend, ShowsOnlySuccessIfNoRuleHasAScale) {
  TrainingCentre centre(undone({kUndone}));
  centre.untwist("first", "practice", 1);

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));
  const Trend residual =
      trend(centre.session(), centre.person(), centre.module("first"), Quantity::kResidual);

  EXPECT_EQ(way.quantity, Quantity::kUntwisted);
  EXPECT_FALSE(way.lowerIsBetter);
  ASSERT_TRUE(way.distance);
  EXPECT_EQ(*way.distance, 1.0);  // wanted 1, was 0
  EXPECT_TRUE(way.curve.empty());
  EXPECT_FALSE(way.noCurveReason.empty());
  ASSERT_TRUE(residual.points.at(0).value);
  EXPECT_GT(*residual.points[0].value, 1.57);  // omitted: at least 360 degrees / 3 turns; some slips back
}

TEST(UntwistingTrend, KnowsBeforeTheFirstAttemptThatTheModuleIsAboutUntwisting) {
  TrainingCentre centre(undone({kUndone}));

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));

  EXPECT_TRUE(way.untwisting);
  EXPECT_TRUE(way.points.empty());
}

TEST(UntwistingTrend, MastersAModuleByItsRules) {
  TrainingCentre centre(undone({kUndone, kSmallDose}));
  centre.untwist("first", "practice", 1);
  EXPECT_EQ(nextSteps(centre.session(), centre.person()).modules.at(0).state, StepState::kOpen);

  centre.untwist("first", "practice");

  EXPECT_EQ(nextSteps(centre.session(), centre.person()).modules.at(0).state, StepState::kMastered);
}

}  // namespace
}  // namespace torsio
