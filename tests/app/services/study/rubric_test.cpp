// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/rubric.h"

#include <functional>

#include <gtest/gtest.h>

#include "app/services/study/rubric_service.h"
#include "assessment/domain/rating/criteria_mean.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

/// Care from 0 to 5 has twice the weight of time from 1 to 10.
RubricRevision twoRows() {
  RubricRevision rubric{.overall = {10, 100, 10}};
  rubric.rows = {{"time", "Time", {10, 100, 10}, {{10, "slow"}, {100, "brisk"}}, 1000},
                 {"care", "Care", {0, 5, 1}, {}, 2000}};
  return rubric;
}

TEST(RubricText, SurvivesARoundTrip) {
  RubricRevision rubric = twoRows();
  rubric.rows[0].anchors[0].meaning = "\u6162, \"slow\"";
  rubric.rows.push_back({"hold", "Hold", {-4, 6, 4}, {{-3, "below"}}, 0});

  const RubricTemplate read = parseRubric(rubricText("My sheet", rubric), "file");

  EXPECT_EQ(read.title, "My sheet");
  EXPECT_EQ(rubricText("My sheet", read.revision), rubricText("My sheet", rubric));
  ASSERT_EQ(read.revision.rows.size(), 3U);
  EXPECT_EQ(read.revision.rows[2].scale.lo, -4);
  EXPECT_EQ(read.revision.rows[2].anchors.at(0).score_steps, -3);
  EXPECT_EQ(read.revision.rows[1].weight_milli, 2000);
  EXPECT_EQ(read.revision.rows[2].weight_milli, 0);
}

TEST(RubricText, TheShippedSheetHasEqualWeights) {
  StudyCentre centre;

  for (const RubricTemplate& shipped : rubricTemplates(centre.assets())) {
    for (const RubricLine& row : shipped.revision.rows) {
      EXPECT_EQ(row.weight_milli, kDefaultWeight_milli) << shipped.id << ", " << row.code;
    }
  }
}

TEST(Rubric, StoresItsWeightsInTheRecord) {
  StudyCentre centre;
  centre.addPaperRubric();
  SessionContext& session = centre.as("administrator");
  const RubricRow before = rubrics(session).at(0);

  reviseRubric(session, before.id, twoRows(), "care counts twice");

  const RubricRow after = rubrics(session).at(0);
  ASSERT_EQ(after.revisions.size(), 2U);
  EXPECT_EQ(after.revisions[0].rows.at(0).weight_milli, 1000);
  EXPECT_EQ(after.revisions[1].rows.at(1).weight_milli, 2000);
  EXPECT_EQ(after.revisions[1].note, "care counts twice");
}

TEST(Rubric, RejectsASheetThatNobodyCanFillIn) {
  const auto refused = [](const std::function<void(RubricRevision&)>& spoil) {
    RubricRevision rubric = twoRows();
    spoil(rubric);
    EXPECT_THROW(checkRubric(rubric), Error);
  };
  EXPECT_NO_THROW(checkRubric(twoRows()));

  refused([](RubricRevision& r) { r.rows.clear(); });
  refused([](RubricRevision& r) { r.rows[0].label.clear(); });
  refused([](RubricRevision& r) { r.rows[1].code = r.rows[0].code; });
  refused([](RubricRevision& r) { r.rows[0].scale.hi = r.rows[0].scale.lo; });
  refused([](RubricRevision& r) { r.rows[0].anchors[0].score_steps = 101; });
  refused([](RubricRevision& r) { r.rows[0].anchors[1].score_steps = 10; });
  refused([](RubricRevision& r) { r.rows[0].anchors[0].meaning.clear(); });
  refused([](RubricRevision& r) { r.rows[0].weight_milli = r.rows[1].weight_milli = 0; });
  refused([](RubricRevision& r) { r.rows[0].weight_milli = -1; });
  refused([](RubricRevision& r) { r.rows[0].weight_milli = 100'001; });
}

TEST(Rubric, CreatesAUniqueCodeForEachCriterion) {
  const RubricRevision rubric = twoRows();

  EXPECT_EQ(codeForCriterion(rubric, "Grip, of the organ!"), "grip_of_the_organ");
  EXPECT_EQ(codeForCriterion(rubric, "TIME"), "time_2");
  EXPECT_EQ(codeForCriterion(rubric, "\u65f6\u95f4"), "criterion");
}

TEST(CriteriaMean, WeighsEachCriterionOnItsOwnScale) {
  const RubricRevision rubric = twoRows();

  // Time 5.5 of 1..10 is 0.5 of it, care 4 of 0..5 is 0.8: (0.5 + 2 * 0.8) / 3 = 0.7; 1 + 9 * 0.7 = 7.3
  const std::optional<double> mean =
      criteriaMean(rubric, std::vector<SheetRow>{{"time", 55, ""}, {"care", 4, ""}});

  ASSERT_TRUE(mean);
  EXPECT_NEAR(*mean, 7.3, 1e-12);
}

TEST(CriteriaMean, IsEmptyIfAWeightedCriterionWasNotScored) {
  RubricRevision rubric = twoRows();
  const std::vector<SheetRow> careMissing{{"time", 55, ""}, {"care", std::nullopt, "not seen"}};

  EXPECT_FALSE(criteriaMean(rubric, careMissing));
  EXPECT_FALSE(criteriaMean(rubric, std::vector<SheetRow>{{"time", 55, ""}}));
  rubric.rows[1].weight_milli = 0;
  EXPECT_DOUBLE_EQ(criteriaMean(rubric, careMissing).value(), 5.5);
}

}  // namespace
}  // namespace torsio
