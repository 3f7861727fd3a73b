// SPDX-License-Identifier: GPL-3.0-or-later
// Unusual cohorts that do occur: hardly any marks, constant marks, many people.
#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/said_cohort.h"

namespace torsio {
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
    EXPECT_EQ(row.at(3), "not defined");  // two different marks would give 0, whoever gave them
  }
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
  const std::string answer = cohortReport(in).sections.front().paragraphs[2].str();
  EXPECT_THAT(answer, HasSubstr("Group 1 - Group 2: -1.2 points [-2.0; -0.4]"));
  EXPECT_THAT(answer, HasSubstr("Not shown to differ: Group 1 - Group 3: 0.6 points [-0.2; 1.4], p = "));
}

TEST(StrangeCohort, TheEndsOfANarrowIntervalDoNotReadTheSame) {
  const CohortInputs in = marking([](TrainingMark& mark) {
    const std::int64_t person = mark.trainee.back() - '0';
    mark.steps = 30 + 4 * person +
                 (person + mark.rater.back() + static_cast<std::int64_t>(mark.occasion)) % 2 +
                 (mark.occasion == 2 ? static_cast<std::int64_t>(mark.group) + person % 2 : 0);
  });
  const std::string answer = cohortReport(in).sections.front().paragraphs[2].str();
  EXPECT_THAT(answer, HasSubstr("Group 1 - Group 2: -0.1"));
  EXPECT_FALSE(std::regex_search(answer, std::regex(R"(\[(-?[0-9.]+); \1\])"))) << answer;
}

TEST(StrangeCohort, EveryNumberIsValidAndHasItsLevel) {
  for (const auto& [name, in] : strangeCohorts()) {
    SCOPED_TRACE(name);
    testing::expectWellSaid(in);
  }
}

}  // namespace
}  // namespace torsio
