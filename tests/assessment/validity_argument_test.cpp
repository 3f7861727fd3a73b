// SPDX-License-Identifier: GPL-3.0-or-later
// The validity argument: verdicts, and the results of the ledger that they rest on.
#include "assessment/results/validity_argument.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

using testing::demonstrationCohort;

const ValidityLine& lineNamed(const std::vector<ValidityLine>& lines, std::string_view id) {
  const auto found =
      std::find_if(lines.begin(), lines.end(), [id](const ValidityLine& one) { return one.id == id; });
  EXPECT_NE(found, lines.end()) << id;
  return found == lines.end() ? lines.front() : *found;
}

std::vector<ValidityLine> argumentOf(const CohortInputs& in) {
  return validityArgument(analysedCohort(in));
}

/// The demonstration with the errors of a trainee's two twists, in degrees.
CohortInputs withErrors(const std::function<double(const CohortTrainee&)>& error_deg) {
  CohortInputs in = demonstrationCohort();
  const TrialSummaryRow pattern = in.trials.front();
  in.trials.clear();
  for (const CohortTrainee& trainee : in.trainees) {
    TrialSummaryRow run = pattern;
    run.trialId = TrialId("run of " + trainee.code);
    run.trainee = trainee.code;
    run.group = trainee.group;
    run.attempts = {{error_deg(trainee), false}, {error_deg(trainee), false}};
    in.trials.push_back(run);
  }
  return in;
}

double scoreAtEnd(const CohortInputs& in, const std::string& trainee) {
  const auto found = std::find_if(in.scores.begin(), in.scores.end(), [&](const TraineeScore& one) {
    return one.trainee == trainee && one.occasion + 1 == in.occasions.size();
  });
  return found->score;
}

TEST(ValidityVerdict, IsDecidedByTheIntervalAndNotByTheEstimate) {
  using enum ValidityVerdict;
  const ValidityThreshold atLeast{ThresholdSide::kAtLeast, 0.8};
  EXPECT_EQ(verdictOf(atLeast, Interval{0.8, 0.9}), kSupported);
  EXPECT_EQ(verdictOf(atLeast, Interval{0.79, 0.99}), kNotShown);
  EXPECT_EQ(verdictOf(atLeast, Interval{0.1, 0.79}), kNotSupported);
  EXPECT_EQ(verdictOf(atLeast, std::nullopt), kNotShown);
  const ValidityThreshold atMost{ThresholdSide::kAtMost, -0.5};
  EXPECT_EQ(verdictOf(atMost, Interval{-0.9, -0.5}), kSupported);
  EXPECT_EQ(verdictOf(atMost, Interval{-0.9, 0.2}), kNotShown);
  EXPECT_EQ(verdictOf(atMost, Interval{-0.4, 0.2}), kNotSupported);
  const ValidityThreshold within{ThresholdSide::kWithin, 0.5};
  EXPECT_EQ(verdictOf(within, Interval{-0.5, 0.5}), kSupported);
  EXPECT_EQ(verdictOf(within, Interval{-0.6, 0.1}), kNotShown);
  EXPECT_EQ(verdictOf(within, Interval{-0.9, 0.9}), kNotShown);
  EXPECT_EQ(verdictOf(within, Interval{0.6, 0.9}), kNotSupported);
  EXPECT_EQ(verdictOf(within, Interval{-0.9, -0.6}), kNotSupported);
}

TEST(ValidityVerdict, OfACountIsDecidedByTheCount) {
  const ValidityThreshold none{ThresholdSide::kAtMost, 0.0};
  EXPECT_EQ(verdictOfCount(none, 0.0), ValidityVerdict::kSupported);
  EXPECT_EQ(verdictOfCount(none, 1.0), ValidityVerdict::kNotSupported);
}

TEST(ValidityArgument, GivesEveryClaimAVerdictAndSaysWhatIsMissing) {
  const std::vector<ValidityLine> lines = argumentOf(demonstrationCohort());
  std::set<std::string_view> ids;
  std::set<Inference> inferences;
  std::set<EvidenceSource> sources;
  for (const ValidityLine& line : lines) {
    EXPECT_TRUE(ids.insert(line.id).second) << line.id;
    inferences.insert(line.inference);
    sources.insert(line.source);
    EXPECT_TRUE(line.id.starts_with(nameOf(line.inference))) << line.id;
    EXPECT_TRUE(line.claim.ends_with('.')) << line.claim;
    EXPECT_FALSE(line.threshold && line.threshold->source.empty()) << line.id;
    EXPECT_EQ(line.verdict == ValidityVerdict::kNotCollected, line.results == 0) << line.id;
    EXPECT_FALSE(line.verdict == ValidityVerdict::kNotCollected && line.note.empty()) << line.id;
    EXPECT_FALSE(line.verdict == ValidityVerdict::kSupported && !line.number) << line.id;
  }
  EXPECT_EQ(inferences.size(), 4U);
  EXPECT_EQ(sources.size(), 5U);
}

TEST(ValidityArgument, TakesEachNumberFromTheLedger) {
  const AnalysedCohort analysed = analysedCohort(demonstrationCohort());
  std::map<std::string, const Result*> byCell;
  for (const Result& result : analysed.ledger.every()) {
    byCell[keyAddress(result.key)] = &result;
  }
  const std::set<std::string_view> shares{"scoring.sheet", "scoring.blinding", "scoring.missing"};
  int numbers = 0;
  for (const ValidityLine& line : validityArgument(analysed)) {
    if (line.results == 0) {
      continue;
    }
    ASSERT_TRUE(byCell.contains(line.cell)) << line.id;
    const Result& result = *byCell[line.cell];
    ASSERT_EQ(line.number.has_value(), numberIn(result.value).has_value()) << line.id;
    EXPECT_EQ(line.n, result.n) << line.id;
    if (line.number) {
      ++numbers;
      EXPECT_EQ(*line.number * (shares.contains(line.id) ? static_cast<double>(result.n) : 1.0),
                *numberIn(result.value))
          << line.id;
    }
    ResultKey place = result.key;
    const PrimaryStatistics primary = primaryStatistics(analysed.study->primaryMethod());
    place.statistic = place.statistic == primary.difference ? primary.interval : place.statistic + "_95";
    const Result* interval = analysed.ledger.find(place);
    ASSERT_EQ(line.interval.has_value(), interval != nullptr) << line.id;
    if (interval != nullptr) {
      EXPECT_EQ(line.interval->lower, std::get<Interval>(interval->value).lower) << line.id;
      EXPECT_EQ(line.interval->upper, std::get<Interval>(interval->value).upper) << line.id;
    }
  }
  EXPECT_GE(numbers, 6);
}

TEST(ValidityArgument, RestsOnTheResultThatSpeaksMostAgainstTheClaim) {
  const AnalysedCohort analysed = analysedCohort(demonstrationCohort());
  const ValidityLine line = lineNamed(validityArgument(analysed), "scoring.severity");
  double furthest = 0.0;
  for (const Result* one : analysed.ledger.select(
           {.section = ResultSection::kAgreement, .statistic = "severity_offset", .of = kEach})) {
    furthest = std::max(furthest, std::abs(*numberIn(one->value)));
  }
  EXPECT_EQ(line.results, 10);
  EXPECT_EQ(std::abs(*line.number), furthest);
  EXPECT_EQ(line.verdict, ValidityVerdict::kNotSupported);
}

TEST(ValidityArgument, OfARecordWithoutMarksSaysThatNoneWereCollected) {
  CohortInputs in = demonstrationCohort();
  in.trainingMarks.clear();
  in.markWays = {};
  in = testing::scored(in);
  in.trials.clear();
  in.competence.clear();
  for (const ValidityLine& line : argumentOf(in)) {
    EXPECT_EQ(nameOf(line.verdict), "not collected") << line.id;
    EXPECT_FALSE(line.number.has_value()) << line.id;
    EXPECT_FALSE(line.note.empty()) << line.id;
  }
}

TEST(ValidityArgument, WithholdsWhatTheReportWithholds) {
  CohortInputs in = demonstrationCohort();
  in.sheetsAsked = 900;
  in.sheetsPresent = 899;
  const ValidityLine line = lineNamed(argumentOf(in), "generalisation.raters");
  EXPECT_EQ(line.verdict, ValidityVerdict::kNotShown);
  EXPECT_FALSE(line.number.has_value());
  EXPECT_THAT(line.note, ::testing::HasSubstr("once every sheet is in"));
}

TEST(ValidityArgument, ShowsNothingWhereTheIntervalSpansTheThreshold) {
  const ValidityLine spanning = lineNamed(argumentOf(demonstrationCohort()), "generalisation.one_rater");
  ASSERT_TRUE(spanning.interval.has_value());
  const ValidityVerdict expected = spanning.interval->upper < 0.75    ? ValidityVerdict::kNotSupported
                                   : spanning.interval->lower >= 0.75 ? ValidityVerdict::kSupported
                                                                      : ValidityVerdict::kNotShown;
  EXPECT_EQ(spanning.verdict, expected);

  const CohortInputs scores = demonstrationCohort();
  const ValidityLine noise = lineNamed(argumentOf(withErrors([&](const CohortTrainee& trainee) {
                                         return 3.0 + (trainee.code.back() % 2 == 0 ? 1.0 : 0.0);
                                       })),
                                       "extrapolation.simulator");
  ASSERT_TRUE(noise.interval.has_value());
  ASSERT_LT(noise.interval->lower, -0.5);
  ASSERT_GT(noise.interval->upper, -0.5);
  EXPECT_EQ(noise.verdict, ValidityVerdict::kNotShown);
  const ValidityLine related = lineNamed(argumentOf(withErrors([&](const CohortTrainee& trainee) {
                                           return 20.0 - scoreAtEnd(scores, trainee.code) +
                                                  (trainee.code.back() % 2 == 0 ? 0.01 : 0.0);
                                         })),
                                         "extrapolation.simulator");
  EXPECT_EQ(related.verdict, ValidityVerdict::kSupported);
  EXPECT_EQ(related.results, 3);
}

TEST(ValidityArgument, ReadsTheMarginOfThePlanAndSaysWhichThresholdsWereNotSealed) {
  CohortInputs in = demonstrationCohort();
  in.equivalenceMargin = 9.0;
  in.imported.reset();
  const ValidityLine planned = lineNamed(argumentOf(in), "scoring.severity");
  EXPECT_EQ(planned.threshold->value, 9.0);
  EXPECT_TRUE(planned.threshold->sealed);
  EXPECT_EQ(thresholdText(*planned.threshold), "within -9 to 9 points");
  EXPECT_EQ(planned.verdict, ValidityVerdict::kSupported);
  in.equivalenceMargin.reset();
  const ValidityLine unplanned = lineNamed(argumentOf(in), "scoring.severity");
  EXPECT_FALSE(unplanned.threshold->sealed);
  EXPECT_THAT(unplanned.threshold->source, ::testing::HasSubstr("no published value"));
}

TEST(ValidityArgument, DoesNotCallARuleSafeThatNobodyCouldPass) {
  CohortInputs in = demonstrationCohort();
  CohortCompetence one;
  one.trainee = in.trainees.front().code;
  one.exercise = Text::verbatim("Pronation");
  one.attempts = 2;
  one.fewestAttempts = 38;
  one.level = Text::verbatim("not shown yet");
  in.competence = {one};
  const ValidityLine early = lineNamed(argumentOf(in), "implications.false_pass");
  EXPECT_EQ(early.number, 0.0);
  EXPECT_EQ(early.verdict, ValidityVerdict::kNotShown);
  EXPECT_EQ(early.note, "Verdicts on too few runs: 1 of 1");
  in.competence.front().attempts = 40;
  EXPECT_EQ(lineNamed(argumentOf(in), "implications.false_pass").verdict, ValidityVerdict::kSupported);
}

TEST(ValidityArgument, IsATableWithOneLineForEachClaim) {
  const std::vector<ValidityLine> lines = argumentOf(demonstrationCohort());
  const std::string text = validityCsvText(lines);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::ssize(lines) + 1);
  EXPECT_TRUE(text.starts_with("id,inference,source,claim,threshold,"));
}

}  // namespace
}  // namespace torsio
