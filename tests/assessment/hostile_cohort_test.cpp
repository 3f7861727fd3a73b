// SPDX-License-Identifier: GPL-3.0-or-later
// Cohorts with which a statistician would test a report: every sentence true, every number valid, every
// interval with its level, and nothing omitted that the data still support.

#include <algorithm>
#include <cstdint>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/study_analysis.h"
#include "assessment/statistics/power.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/strange_cohorts.h"

namespace torsio {

namespace {

using testing::aClassOfRatersIsMissing;
// Unusual cohorts that do occur: hardly any marks, constant marks, many people.

using ::testing::HasSubstr;
using testing::losing;
using testing::marking;
using ::testing::Not;
using testing::scored;
using testing::tableNamed;
using testing::textOfAll;

CohortInputs thirdArmDropsOut() {
  return losing([](const TrainingMark& mark) { return mark.group == 2 && mark.occasion > 0; });
}

CohortInputs oneRaterScoresOneArm() {
  return losing([](const TrainingMark& mark) { return mark.rater == "R110" && mark.group != 0; });
}

CohortInputs ceilingAtTheEnd() {
  return marking([](TrainingMark& mark) { mark.steps = mark.occasion == 2 ? 100 : mark.steps; });
}

CohortInputs twoInAnArm() {
  const std::set<std::string> kept{"x101", "x102", "y101", "y102", "z101", "z102"};
  CohortInputs in = losing([&](const TrainingMark& mark) { return !kept.contains(mark.trainee); });
  std::erase_if(in.trainees, [&](const CohortTrainee& trainee) { return !kept.contains(trainee.code); });
  std::erase_if(in.criterionMarks, [&](const CriterionMark& mark) { return !kept.contains(mark.trainee); });
  return in;
}

/// The first class of raters has weight zero, transferred to the last one.
CohortInputs aWeightOfZero() {
  CohortInputs in = testing::demonstrationCohort();
  in.instrument.classes[2].weight_milli += in.instrument.classes[0].weight_milli;
  in.instrument.classes[0].weight_milli = 0;
  in.evaluations.clear();
  for (const ModelRatings& model : in.ratings) {
    in.evaluations.push_back(evaluateModel(in.instrument, model));
  }
  return in;
}

CohortInputs amendedAfterTheFreeze() {
  CohortInputs in = testing::demonstrationCohort();
  in.freeze = CohortFreeze{"final", std::string(64, 'b'), 1'767'600'000'000'000, "admin", false};
  return in;
}

std::map<std::string, CohortInputs> hostileCohorts() {
  std::map<std::string, CohortInputs> all;
  all["one rater gives constant marks"] =
      marking([](TrainingMark& mark) { mark.steps = mark.rater == "R101" ? 70 : mark.steps; });
  all["one rater scores one arm only"] = oneRaterScoresOneArm();
  all["two trainees have the same marks"] = marking([](TrainingMark& mark) {
    mark.steps = mark.trainee == "x101" || mark.trainee == "y101" ? 50 : mark.steps;
  });
  all["all scores at the ceiling"] = marking([](TrainingMark& mark) { mark.steps = 100; });
  all["all scores at the ceiling at the end"] = ceilingAtTheEnd();
  all["slopes differ"] = marking([](TrainingMark& mark) {
    const std::int64_t person = mark.trainee.back() - '0';
    mark.steps = mark.occasion == 0 ? 20 + 6 * person + (mark.rater.back() - '0')
                 : mark.group == 0  ? 90 - 7 * person + (mark.rater.back() - '0')
                                    : 30 + 6 * person + (mark.rater.back() - '0') + person * person % 4;
  });
  all["two trainees an arm"] = twoInAnArm();
  all["one arm drops out after the first occasion"] = thirdArmDropsOut();
  all["a weight of zero"] = aWeightOfZero();
  all["a class of raters is missing"] = aClassOfRatersIsMissing();
  all["marks amended after the freeze"] = amendedAfterTheFreeze();
  return all;
}

TEST(HostileCohort, NumbersAreValidNoPIsZeroAndIntervalsHaveTheirLevel) {
  for (const auto& [name, in] : hostileCohorts()) {
    SCOPED_TRACE(name);
    testing::expectWellSaid(in);
  }
}

TEST(HostileCohort, ADroppedArmIsNamedWithItsNumberAndTheOthersAreCompared) {
  const CohortInputs in = thirdArmDropsOut();
  const ReportModel report = cohortReport(in);
  for (const char* id : {"table-ancova", "table-mixed-model", "table-gains"}) {
    const ReportTable* table = tableNamed(report, id);
    ASSERT_NE(table, nullptr) << id;
    ASSERT_EQ(table->rows.size(), 1U) << id;
    EXPECT_EQ(table->rows[0][0].str(), "Group 1 - Group 2") << id;
    EXPECT_THAT(table->rows[0][1].str(), Not(HasSubstr("not defined"))) << id;
  }
  EXPECT_THAT(tableNamed(report, "table-mixed-anova")->rows[0][0].str(), HasSubstr("group x occasion"));
  EXPECT_THAT(report.sections.front().paragraphs[4].str(), HasSubstr("Group 1 - Group 2"));
  const std::string said = textOfAll(in);
  EXPECT_THAT(said, HasSubstr("nobody has a score at both occasions: Group 3"));
  EXPECT_THAT(said, Not(HasSubstr("nothing can be compared")));
  EXPECT_THAT(said, Not(HasSubstr("the groups are not compared")));
  const ReportTable* within = tableNamed(report, "table-within-groups");
  ASSERT_NE(within, nullptr);
  EXPECT_EQ(within->rows.at(2).at(1).str(), "0");
  ASSERT_EQ(testing::rowsNamed(in, "adjusted_difference").size(), 1U);
  EXPECT_EQ(testing::rowsNamed(in, "adjusted_difference")[0].group, "Group 1 - Group 2");
  EXPECT_EQ(testing::rowsNamed(in, "mixed_model_difference").size(), 1U);
  EXPECT_EQ(testing::rowsNamed(in, "pairs_left_open").at(0).value, "0");
  EXPECT_THAT(said, Not(HasSubstr("of 3 comparisons")));
  // The whole arm's missing marks are bounded: its trainees were there at the start.
  EXPECT_EQ(testing::rowsNamed(in, "bound_worst").size(), 3U);
}

TEST(HostileCohort, TwoGroupsAreComparedAsIfTheEmptyOneDidNotExist) {
  const StudyAnalysis three = analyseStudy(thirdArmDropsOut());
  CohortInputs in = thirdArmDropsOut();
  std::erase_if(in.trainingMarks, [](const TrainingMark& mark) { return mark.group == 2; });
  std::erase_if(in.trainees, [](const CohortTrainee& trainee) { return trainee.group == 2; });
  in.groups.pop_back();
  const StudyAnalysis two = analyseStudy(scored(std::move(in)));

  ASSERT_TRUE(three.ancova && two.ancova && three.course && two.course);
  EXPECT_EQ(three.ancova->pairs.at(0).difference, two.ancova->pairs.at(0).difference);
  EXPECT_EQ(three.ancova->pairs.at(0).p, two.ancova->pairs.at(0).p);
  EXPECT_EQ(three.ancova->group.df1, 1.0);
  EXPECT_EQ(three.course->interaction->f, two.course->interaction->f);
  ASSERT_TRUE(three.mixed);
  EXPECT_NEAR(three.mixed->pairs.at(0).difference.value, two.ancova->pairs.at(0).difference, 1e-9);
}

TEST(HostileCohort, AMissingMarkIsReportedInGroupSummaries) {
  const CohortInputs in = losing([](const TrainingMark& mark) {
    return mark.rater == "R104" && mark.occasion == 1 && (mark.trainee == "x101" || mark.trainee == "z103");
  });
  const ReportModel report = cohortReport(in);
  const ReportTable* table = tableNamed(report, "table-training-summary");
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->provenance.n.str(), "898");
  EXPECT_EQ(table->provenance.missing.str(), "2");
  EXPECT_THAT(table->notes.back().str(), HasSubstr("Group 1, after 20 min: 1"));
  const std::vector<CohortCsvRow> rows = testing::rowsNamed(in, "marks_missing_at_occasion");
  ASSERT_EQ(rows.size(), 9U);
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.value == "1"; }), 2);
  // A trainee without marks lacks as many as the others have.
  const CohortInputs absent = losing([](const TrainingMark& mark) { return mark.trainee == "y105"; });
  const ReportModel withoutOne = cohortReport(absent);
  EXPECT_EQ(tableNamed(withoutOne, "table-training-summary")->provenance.missing.str(), "30");
  EXPECT_THAT(textOfAll(absent), Not(HasSubstr("physicians scored every trainee")));
}

TEST(HostileCohort, ARaterOfASingleArmIsNamedAsPartOfItsDifference) {
  const std::string said = textOfAll(oneRaterScoresOneArm());
  EXPECT_THAT(said, HasSubstr("R110"));
  EXPECT_THAT(said, HasSubstr("scored trainees of some groups only"));
  EXPECT_THAT(said, HasSubstr("a difference between groups may be one between raters"));
  EXPECT_THAT(textOfAll(testing::demonstrationCohort()), Not(HasSubstr("of some groups only")));
}

TEST(HostileCohort, ScoresAtTheCeilingAreNotCalledAnExactCourse) {
  const std::string said = textOfAll(ceilingAtTheEnd());
  EXPECT_THAT(said, HasSubstr("the scores after do not vary within groups"));
  EXPECT_THAT(said, Not(HasSubstr("follow the scores before exactly")));
  EXPECT_THAT(said, Not(HasSubstr("Groups are compared by")));
}

TEST(HostileCohort, ASingleGroupIsNotSaidToBeCompared) {
  CohortInputs in = testing::demonstrationCohort();
  std::erase_if(in.trainingMarks, [](const TrainingMark& mark) { return mark.group > 0; });
  EXPECT_THAT(textOfAll(scored(std::move(in))), Not(HasSubstr("Groups are compared by")));
}

TEST(HostileCohort, TheDetectableDifferenceFollowsFromTheGroups) {
  const CohortInputs in = testing::demonstrationCohort();
  const std::string said = cohortReport(in).sections.front().paragraphs.back().str();
  double least = 9.0;
  const StudyAnalysis study = analyseStudy(in);
  for (const AdjustedDifference& pair : study.ancova->spread.pairs) {
    least = std::min(least, pair.error * detectableStandardErrors(pair.df, 0.8, 0.05 / 3.0));
  }
  EXPECT_THAT(said, HasSubstr("a difference of " + formatFixed(least, 1) + " to "));
  EXPECT_THAT(said, HasSubstr("shared among the pairs as in Holm's first step"));
}

TEST(HostileCohort, PointsHaveTheDecimalsThatTellThemFromZeroAndFromEachOther) {
  EXPECT_EQ(decimalsOf({-1.5, 2.5}), 1);
  EXPECT_EQ(decimalsOf({0.02, 1.5}), 2) << "0.0 would include zero";
  EXPECT_EQ(decimalsOf({-0.013, 0.02}), 2) << "-0.0 to 0.0 says nothing";
  EXPECT_EQ(decimalsOf({0.0, 0.87}), 1) << "a detectable difference";
  EXPECT_EQ(decimalsOf({0.0, 0.003}), 3);
}

TEST(HostileCohort, AClassOfWeightZeroIsReportedAsNotCounting) {
  const std::string said = textOfAll(aWeightOfZero());
  EXPECT_THAT(said, HasSubstr("A class of weight 0 enters neither M nor s2"));
  EXPECT_THAT(textOfAll(testing::demonstrationCohort()), Not(HasSubstr("of weight 0 enters")));
}

TEST(HostileCohort, MarksAmendedAfterTheFreezeAreReportedOnTheFirstPage) {
  std::string first;
  const ReportModel report = cohortReport(amendedAfterTheFreeze());
  for (const Text& paragraph : report.sections.front().paragraphs) {
    first += paragraph.str();
  }
  EXPECT_THAT(first, HasSubstr("The record has changed since it was frozen as \"final\""));
  CohortInputs same = amendedAfterTheFreeze();
  same.freeze->unchanged = true;
  EXPECT_THAT(textOfAll(same), Not(HasSubstr("has changed since")));
}

TEST(HostileCohort, ARaterWithoutASheetForAModelIsNotARaterOfEveryModel) {
  CohortInputs in = testing::demonstrationCohort();
  EXPECT_THAT(textOfAll(in), HasSubstr("Each rater scored every model"));
  in.ratings[1].sheets.pop_back();
  in.evaluations[1] = evaluateModel(in.instrument, in.ratings[1]);
  const std::string said = textOfAll(in);
  EXPECT_THAT(said, Not(HasSubstr("Each rater scored every model")));
  EXPECT_THAT(said, HasSubstr("9 marks are missing"));
}

TEST(HostileCohort, AMissingClassOfRatersIsNamedLineByLineAndNothingElseIsLost) {
  const CohortInputs in = aClassOfRatersIsMissing();
  const ReportModel report = cohortReport(in);
  const ReportTable* unscored = tableNamed(report, "table-evaluation-unscored");
  ASSERT_NE(unscored, nullptr);
  ASSERT_EQ(unscored->rows.size(), 3U);
  EXPECT_EQ(unscored->rows[0][0].str(), in.instrument.classes[2].name);
  EXPECT_EQ(unscored->rows[0][2].str(), "all 9");
  const ReportTable* classes = tableNamed(report, "table-evaluation-classes");
  ASSERT_NE(classes, nullptr);
  EXPECT_EQ(classes->rows.size(), 9U);
  // With all three classes, M is the weighted sum of the single classes' values.
  const CohortInputs whole = testing::demonstrationCohort();
  EvaluationInstrument interns = whole.instrument;
  interns.classes[0].weight_milli = 1000;
  interns.classes[1].weight_milli = interns.classes[2].weight_milli = 0;
  const std::vector<CohortCsvRow> scores = testing::rowsNamed(in, "class_score_eq27");
  ASSERT_EQ(scores.size(), 9U);
  EXPECT_EQ(std::stod(scores[0].value), evaluateModel(interns, whole.ratings[0]).n27);
  EXPECT_TRUE(scores[2].value.empty());
  EXPECT_EQ(testing::rowsNamed(in, "mark").size(), 3U * 9U * 30U);
  EXPECT_TRUE(testing::rowsNamed(in, "N_eq27").empty());
  for (const char* id :
       {"table-ancova", "table-agreement", "table-training-summary", "table-within-groups"}) {
    EXPECT_NE(tableNamed(report, id), nullptr) << id;
  }
}

TEST(HostileCohort, AFourthOccasionDoesNotReplaceAFigureOfThePaper) {
  CohortInputs in = testing::demonstrationCohort();
  in.occasions.push_back(Text::verbatim("after a month"));
  const std::vector<TrainingMark> before = in.trainingMarks;
  for (TrainingMark mark : before) {
    if (mark.occasion == 2) {
      mark.occasion = 3;
      in.trainingMarks.push_back(mark);
    }
  }
  const ReportModel report = cohortReport(scored(std::move(in)));
  std::set<std::string> ids;
  for (const ReportSection& section : report.sections) {
    for (const ReportFigure& figure : section.figures) {
      EXPECT_TRUE(ids.insert(figure.id).second) << figure.id;
      for (const Text& note : figure.notes) {
        EXPECT_TRUE(!note.str().starts_with("Corresponds to Fig. 2") || figure.id == "figure-23")
            << figure.id;
      }
    }
  }
  EXPECT_TRUE(ids.contains("figure-scores-4"));
}

TEST(HostileCohort, ACriterionThatNobodyCouldAssessHasNoMark) {
  CohortInputs in = testing::demonstrationCohort();
  in.criterionMarks.front().points.reset();
  EXPECT_THAT(textOfAll(in), HasSubstr("for each criterion that they could assess"));
  EXPECT_THAT(textOfAll(testing::demonstrationCohort()),
              HasSubstr("a mark for each criterion and an overall"));
}

TEST(HostileCohort, AnUnrepeatableDrawIsNotCalledRandom) {
  CohortInputs in = testing::demonstrationCohort();
  in.allocation.method = Text::verbatim("complete permutation");
  EXPECT_THAT(textOfAll(in), Not(HasSubstr("any difference is due to chance"))) << "nobody repeated the draw";
  in.allocation.replayed = true;
  EXPECT_THAT(textOfAll(in), HasSubstr("any difference is due to chance"));
  in.allocation.replayed = false;
  in.allocation.replayDiffers = true;
  EXPECT_THAT(textOfAll(in), Not(HasSubstr("any difference is due to chance")));
  in.allocation = {};
  EXPECT_THAT(textOfAll(in), Not(HasSubstr("seed 0")));
}

TEST(HostileCohort, TheTableOfNumbersContainsKappaDependabilityRaschAndGains) {
  const CohortInputs in = testing::demonstrationCohort();
  EXPECT_EQ(testing::rowsNamed(in, "kappa_quadratic_median").size(), 9U);
  EXPECT_EQ(testing::rowsNamed(in, "share_same_point").size(), 9U);
  EXPECT_EQ(testing::rowsNamed(in, "dependability").size(), 5U);
  EXPECT_EQ(testing::rowsNamed(in, "variance_of_raters").size(), 1U);
  EXPECT_EQ(testing::rowsNamed(in, "raters_needed").size(), 1U);
  EXPECT_EQ(testing::rowsNamed(in, "rasch_severity").size(), 10U);
  EXPECT_EQ(testing::rowsNamed(in, "median_gain_upper_95").size(), 3U);
  EXPECT_EQ(testing::rowsNamed(in, "gain_signed_rank_p").size(), 3U);
  EXPECT_EQ(testing::rowsNamed(in, "gain_dunn_p_holm").size(), 3U);
  EXPECT_EQ(testing::rowsNamed(in, "gain_kruskal_wallis_p").size(), 1U);
  EXPECT_EQ(testing::rowsNamed(in, "mixed_time_p_greenhouse_geisser").size(), 1U);
  EXPECT_EQ(testing::rowsNamed(in, "mean_rank").size(), 3U);
}

}  // namespace

namespace {

using ::testing::HasSubstr;
using testing::losing;
using testing::marking;
using ::testing::Not;
using testing::scored;
using testing::textOfAll;

CohortInputs only(const std::set<std::string>& kept) {
  CohortInputs in = losing([&](const TrainingMark& mark) { return !kept.contains(mark.trainee); });
  std::erase_if(in.trainees, [&](const CohortTrainee& trainee) { return !kept.contains(trainee.code); });
  std::erase_if(in.criterionMarks, [&](const CriterionMark& mark) { return !kept.contains(mark.trainee); });
  return in;
}

CohortInputs nothingAssessable() {
  CohortInputs in = losing([](const TrainingMark&) { return true; });
  in.notAssessable = 900;
  in.sheetsAsked = 900;
  in.sheetsPresent = 900;
  for (CriterionMark& mark : in.criterionMarks) {
    mark.points.reset();
  }
  return in;
}

CohortInputs wideScale() {
  CohortInputs in = testing::demonstrationCohort();
  in.trainingScale = {-1'000'000, 1'000'000, 1};
  for (TrainingMark& mark : in.trainingMarks) {
    mark.steps = mark.steps % 3 == 0 ? 1'000'000 : mark.steps % 3 == 1 ? -1'000'000 : mark.steps;
  }
  return scored(std::move(in));
}

CohortInputs inChinese() {
  CohortInputs in = testing::demonstrationCohort();
  const std::string name = "\u6b27\u9633\u5a1c\u5a1c";
  for (CohortTrainee& trainee : in.trainees) {
    trainee.code = name + trainee.code;
  }
  for (TrainingMark& mark : in.trainingMarks) {
    mark.trainee = name + mark.trainee;
    mark.rater = "\u674e\u533b\u751f" + mark.rater;
  }
  for (CriterionMark& mark : in.criterionMarks) {
    mark.trainee = name + mark.trainee;
    mark.rater = "\u674e\u533b\u751f" + mark.rater;
  }
  in.groups[0].name = Text::verbatim("\u7b2c\u4e00\u7ec4, \"A\"");
  return scored(std::move(in));
}

std::map<std::string, CohortInputs> strangeCohorts() {
  std::map<std::string, CohortInputs> all;
  all["all marks equal"] = marking([](TrainingMark& mark) { mark.steps = 50; });
  all["one trainee"] = only({"x103"});
  all["two trainees of two groups"] = only({"x103", "y103"});
  all["one trainee in one group, ten in another"] = [] {
    std::set<std::string> kept{"x103"};
    for (int i = 101; i <= 110; ++i) {
      kept.insert("y" + std::to_string(i));
    }
    return only(kept);
  }();
  all["one rater"] = losing([](const TrainingMark& mark) { return mark.rater != "R105"; });
  all["two raters"] =
      losing([](const TrainingMark& mark) { return mark.rater != "R105" && mark.rater != "R106"; });
  all["an arm without a mark"] = losing([](const TrainingMark& mark) { return mark.group == 1; });
  all["an arm without a mark before"] =
      losing([](const TrainingMark& mark) { return mark.group == 1 && mark.occasion == 0; });
  all["marks at the end only"] = losing([](const TrainingMark& mark) { return mark.occasion < 2; });
  all["marks before only"] = losing([](const TrainingMark& mark) { return mark.occasion > 0; });
  all["one mark"] = losing([](const TrainingMark& mark) {
    return mark.trainee != "z104" || mark.rater != "R102" || mark.occasion != 1;
  });
  all["each trainee has one rater of their own"] =
      losing([](const TrainingMark& mark) { return mark.rater.back() != mark.trainee.back(); });
  all["half of the marks"] = losing([](const TrainingMark& mark) {
    return (mark.steps + mark.trainee.back() + 3 * mark.rater.back()) % 2 == 0;
  });
  all["nothing assessable"] = nothingAssessable();
  all["the widest scale, all at its ends"] = wideScale();
  all["names in Chinese"] = inChinese();
  all["women and men swap by group"] = [] {
    CohortInputs in = testing::demonstrationCohort();
    for (CohortTrainee& trainee : in.trainees) {
      trainee.sex = trainee.group == 0 ? "female" : "";
      trainee.withdrew = trainee.group == 2;
    }
    return in;
  }();
  all["no group has a mark at each occasion"] =
      losing([](const TrainingMark& mark) { return mark.occasion != mark.group; });
  all["all but one mark of a rater equal"] = marking([](TrainingMark& mark) {
    mark.steps = mark.trainee == "x101" && mark.rater == "R101" && mark.occasion == 2 ? 51 : 50;
  });
  return all;
}

TEST(StrangeCohort, OneTraineeHasNoAgreementBeyondChance) {
  const ReportModel report = cohortReport(only({"x103"}));
  for (const std::vector<ReportCell>& row : testing::tableNamed(report, "table-kappa")->rows) {
    EXPECT_EQ(row.at(4), "not defined");  // two different marks would give 0, whoever gave them
  }
}

TEST(StrangeCohort, OnlyADemonstrationIsSaidToBeShortened) {
  EXPECT_THAT(textOfAll(testing::demonstrationCohort()), HasSubstr("shortened for this demonstration"));
  EXPECT_THAT(textOfAll(testing::soundCohort()), Not(HasSubstr("shortened for this demonstration")));
}

TEST(StrangeCohort, OneGroupTakesNoDifferentCourses) {
  EXPECT_THAT(textOfAll(losing([](const TrainingMark& mark) { return mark.group > 0; })),
              Not(HasSubstr("whether the groups take different courses")));
}

TEST(StrangeCohort, TheChecklistLeadsToTheComparisonThatAnswers) {
  const auto answerOf26 = [](const CohortInputs& in) {
    const ReportModel report = cohortReport(in);
    for (const std::vector<ReportCell>& row : tableNamed(report, "table-checklist-consort")->rows) {
      if (row.at(0) == "26") {
        return row.at(2).str();
      }
    }
    return std::string();
  };
  EXPECT_THAT(answerOf26(losing([](const TrainingMark& mark) {  // the mixed model is primary
                return mark.trainee == "x101" && mark.rater == "R101" && mark.occasion == 2;
              })),
              HasSubstr("The answer: differences between the groups"));
  EXPECT_EQ(answerOf26(losing([](const TrainingMark& mark) { return mark.group > 0; })), "not recorded");
}

TEST(StrangeCohort, OneMissingMarkIsOne) {
  const std::string said = textOfAll(losing([](const TrainingMark& mark) {
    return mark.trainee == "x101" && mark.rater == "R101" && mark.occasion == 2;
  }));
  EXPECT_THAT(said, HasSubstr("Of 600 marks of the first and the last occasion 1 is missing, so"));
}

TEST(StrangeCohort, ScoresForWhichGroupsDifferLieOnTheScale) {
  CohortInputs in = testing::soundCohort();
  std::map<std::string, double> before;
  for (const TraineeScore& score : in.scores) {
    if (score.occasion == 0) {
      before[score.trainee] = score.score;
    }
  }
  for (TrainingMark& mark : in.trainingMarks) {  // the first line crosses the others above the highest mark
    if (mark.group == 0 && mark.occasion == 2) {
      mark.steps = 64 + static_cast<std::int64_t>(6.0 * before[mark.trainee]) + mark.rater.back() % 3;
    }
  }
  const ReportModel report = cohortReport(scored(std::move(in)));
  const ReportTable* table = tableNamed(report, "table-slopes");
  ASSERT_NE(table, nullptr);
  const std::regex number(R"(\d+\.\d+)");
  bool below = false;
  for (const std::vector<ReportCell>& row : table->rows) {
    const std::string differ = row.back().str();
    below = below || std::regex_match(differ, std::regex(R"(for a score before below \d\.\d\d)"));
    for (auto at = std::sregex_iterator(differ.begin(), differ.end(), number); at != std::sregex_iterator();
         ++at) {
      EXPECT_GT(std::stod(at->str()), 1.0) << differ;
      EXPECT_LT(std::stod(at->str()), 10.0) << differ;
    }
  }
  EXPECT_TRUE(below) << table->rows.front().back().str();
}

TEST(StrangeCohort, WithoutVariationNoNumberOfRatersIsCalledTooFew) {
  const CohortInputs same = marking([](TrainingMark& mark) { mark.steps = 50; });
  EXPECT_THAT(textOfAll(same), Not(HasSubstr("Not even 100 raters")));
}

TEST(StrangeCohort, ADifferenceThatDependsOnOnePersonIsReportedAsSuch) {
  std::set<std::string> kept{"x103"};
  for (int i = 101; i <= 110; ++i) {
    kept.insert("y" + std::to_string(i));
  }
  EXPECT_THAT(textOfAll(only(kept)),
              HasSubstr("A single trainee has a score at both occasions in: Group 1."));
  EXPECT_THAT(textOfAll(testing::demonstrationCohort()), Not(HasSubstr("A single trainee has")));
}

TEST(StrangeCohort, PairsWithoutAShownDifferenceAreNamedBesideTheOthers) {
  const CohortInputs in = losing([](const TrainingMark& mark) { return mark.rater != "R105"; });
  const std::string answer = cohortReport(in).sections.front().paragraphs[4].str();
  EXPECT_THAT(answer, HasSubstr("Group 1 - Group 2: -1.2 points [-2.2, -0.3], p = 0.013"));
  EXPECT_THAT(answer, HasSubstr("Not shown to differ: Group 1 - Group 3: 0.6 points [-0.3, 1.6], p = "));
}

TEST(StrangeCohort, TheEndsOfANarrowIntervalDoNotReadTheSame) {
  const CohortInputs in = marking([](TrainingMark& mark) {
    const std::int64_t person = mark.trainee.back() - '0';
    mark.steps = 30 + 4 * person +
                 (person + mark.rater.back() + static_cast<std::int64_t>(mark.occasion)) % 2 +
                 (mark.occasion == 2 ? static_cast<std::int64_t>(mark.group) + person % 2 : 0);
  });
  const std::string answer = cohortReport(in).sections.front().paragraphs[4].str();
  EXPECT_THAT(answer, HasSubstr("Group 1 - Group 2: -0.1"));
  EXPECT_FALSE(std::regex_search(answer, std::regex(R"(\[(-?[0-9.]+), \1\])"))) << answer;
}

TEST(StrangeCohort, AnIntervalThatExcludesZeroDoesNotShowZeroAsAnEnd) {
  // An end near zero: the first group is moved until the lower end of its interval is just above zero.
  const auto moved = [](std::int64_t by) {
    return marking(
        [by](TrainingMark& mark) { mark.steps += mark.group == 0 && mark.occasion == 2 ? by : 0; });
  };
  bool found = false;
  for (std::int64_t by = -9; by <= 9; ++by) {
    const CohortInputs in = moved(by);
    const std::string answer = cohortReport(in).sections.front().paragraphs[4].str();
    EXPECT_FALSE(std::regex_search(answer, std::regex(R"(\[-?0\.0,[^\]]*\], p [=<] 0\.0[0-4])"))) << answer;
    EXPECT_FALSE(std::regex_search(answer, std::regex(R"(, -?0\.0\], p [=<] 0\.0[0-4])"))) << answer;
    found = found || std::regex_search(answer, std::regex(R"(\[-?0\.0[0-9])"));
  }
  EXPECT_TRUE(found) << "no interval came near zero";
}

TEST(StrangeCohort, EveryNumberIsValidAndHasItsLevel) {
  for (const auto& [name, in] : strangeCohorts()) {
    SCOPED_TRACE(name);
    testing::expectWellSaid(in);
  }
}

}  // namespace

}  // namespace torsio
