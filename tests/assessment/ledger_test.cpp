// SPDX-License-Identifier: GPL-3.0-or-later
// The ledger of results: each number once, with what it is made of.
#include "assessment/results/ledger.h"

#include <functional>
#include <set>

#include <gtest/gtest.h>

#include "assessment/results/analysed_cohort.h"
#include "sim/core/contracts.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/said_cohort.h"

namespace torsio {
namespace {

using testing::demonstrationCohort;

Result resultAt(ResultKey key, double value = 1.0) {
  return {std::move(key), value, 1, "", partsOf({RecordRef{RecordKind::kMark, "m1"}})};
}

TEST(Ledger, RefusesTheSameKeyTwiceAndAResultMadeOfNothing) {
  Ledger ledger;
  ledger.add(resultAt({.statistic = "score", .of = "T-01", .occasion = 0}));
  ledger.add(resultAt({.statistic = "score", .of = "T-01", .occasion = 1}));
  EXPECT_THROW(ledger.add(resultAt({.statistic = "score", .of = "T-01", .occasion = 1}, 2.0)), ContractError);
  EXPECT_THROW(ledger.add({{.statistic = "mean"}, 1.0, 1, "", partsOf({})}), ContractError);
  EXPECT_EQ(ledger.every().size(), 2U);
}

TEST(Ledger, SelectsSinglePeopleButNoSummaryWhereAPatternAsksForEach) {
  Ledger ledger;
  ledger.add(resultAt({.statistic = "criterion_mean", .group = 0}));
  ledger.add(resultAt({.statistic = "criterion_mean", .of = "T-01", .group = 0}));
  ledger.add(resultAt({.statistic = "criterion_mean", .of = "T-02", .group = 1}));

  EXPECT_EQ(ledger.select({.statistic = "criterion_mean", .of = kEach}).size(), 2U);
  EXPECT_EQ(ledger.select({.statistic = "criterion_mean", .of = kEach, .group = 1}).size(), 1U);
  EXPECT_EQ(ledger.select({.statistic = "criterion_mean"}).size(), 1U);
  EXPECT_EQ(ledger.select({.statistic = "criterion_mean", .of = "T-02"}).front()->key.group, 1U);
  EXPECT_TRUE(ledger.select({.section = ResultSection::kTrial, .statistic = "criterion_mean"}).empty());
}

TEST(Ledger, KeyReadsAsItsLineOfTheTableOfNumbers) {
  const ResultNames names{{Text::verbatim("Group %1", 1), Text::verbatim("Group %1", 2)},
                          {Text::verbatim("before"), Text::verbatim("after, in all")}};
  EXPECT_EQ(keyAddress({.section = ResultSection::kComparison,
                        .statistic = "p_holm",
                        .group = 0,
                        .against = 1,
                        .occasion = 1},
                       names),
            "comparison,all,Group 1 - Group 2,,,\"after, in all\",p_holm");
  EXPECT_EQ(keyAddress({.section = ResultSection::kTrial,
                        .statistic = "twist_error_deg",
                        .of = "T-01",
                        .number = 3,
                        .when = "virtual",
                        .record = "t1"},
                       names),
            "trial,T-01,,,3,virtual,twist_error_deg");
}

/// Fails where a result does not lead down to the record by every way, or leads back to itself.
void expectEveryResultLeadsToTheRecord(const CohortInputs& in) {
  const Ledger ledger = analysedCohort(in).ledger;
  std::set<ResultKey> sound;
  std::set<ResultKey> open;
  const std::function<bool(const Result&)> follow = [&](const Result& result) {
    if (sound.contains(result.key)) {
      return true;
    }
    bool ends = open.insert(result.key).second;
    bool leads = false;
    for (const ResultPart& part : *result.madeOf) {
      const auto* pattern = std::get_if<ResultPattern>(&part);
      const auto others = pattern != nullptr ? ledger.select(*pattern) : std::vector<const Result*>{};
      leads = leads || pattern == nullptr || !others.empty();
      for (const Result* other : others) {
        ends = ends && follow(*other);
      }
    }
    open.erase(result.key);
    if (ends && leads) {
      sound.insert(result.key);
    }
    return ends && leads;
  };
  for (const Result& result : ledger.every()) {
    EXPECT_TRUE(follow(result)) << keyAddress(result.key, ledger.names());
  }
}

TEST(Ledger, EveryResultOfACohortLeadsToRowsOfTheRecord) {
  CohortInputs in = demonstrationCohort();
  in.equivalenceMargin = 1.0;
  in.programHash = std::string(64, 'e');
  in.auditHead = std::string(64, 'f');
  in.deviations = {{0, "x101", "late", "came late"}, {0, "x101", "late", "came late again"}};
  in.trials.front().attempts = {{3.0, true}, {2.0, true}};
  CohortCompetence verdict;
  verdict.trainee = "x101";
  verdict.exercise = Text::verbatim("twist");
  verdict.level = Text::verbatim("not shown");
  verdict.runs = {"t1"};
  in.competence = {verdict, verdict};  // two exercises of one title
  expectEveryResultLeadsToTheRecord(in);
  const TrainingMark lost = in.trainingMarks.back();
  expectEveryResultLeadsToTheRecord(testing::losing([&](const TrainingMark& mark) {
    return mark.trainee == lost.trainee && mark.rater == lost.rater && mark.occasion == 2;
  }));
  expectEveryResultLeadsToTheRecord(testing::withUntwistings());
  expectEveryResultLeadsToTheRecord(testing::aClassOfRatersIsMissing());
}

TEST(Ledger, AGroupMeanIsMadeOfTheScoresOfItsTrainees) {
  const Ledger ledger = analysedCohort(demonstrationCohort()).ledger;
  const Result* mean = ledger.find({.statistic = "mean", .group = 1, .occasion = 2});
  ASSERT_NE(mean, nullptr);
  double sum = 0.0;
  const auto scores = ledger.select(std::get<ResultPattern>(mean->madeOf->front()));
  for (const Result* score : scores) {
    sum += numberIn(score->value).value();
  }
  ASSERT_EQ(scores.size(), 10U);
  EXPECT_NEAR(numberIn(mean->value).value(), sum / 10.0, 1e-12);
}

}  // namespace
}  // namespace torsio
