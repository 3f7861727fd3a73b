// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/generalizability.h"
#include "assessment/statistics/missing_marks.h"
#include "assessment/statistics/mixed_anova.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/rasch.h"
#include "assessment/statistics/reliability.h"
#include "assessment/statistics/resampling.h"

namespace torsio {

/// Agreement of the raters in one group at one occasion.
struct GroupAgreement {
  std::size_t group = 0;
  std::int64_t trainees = 0;  ///< with a mark of every rater
  Outcome<IccResult> icc = Outcome<IccResult>::undefined(Text::tr("not computed"));
};

/// What pairs of raters have in common at one occasion where marks are taken in whole points.
struct PointAgreement {
  std::size_t pairs = 0;       ///< of the raters present
  std::vector<double> kappas;  ///< quadratic weights, of the pairs for which it is defined
  std::int64_t shared = 0;     ///< marks of the same trainee by two raters
  std::int64_t same = 0;
  std::int64_t withinOne = 0;
};

/// The marks of one occasion, trainees x raters in the order of StudyAnalysis; a mark that was not given is
/// empty.
struct OccasionMarks {
  std::vector<std::vector<std::optional<double>>> marks;
  std::vector<std::size_t> present;  ///< raters with a mark here; what the others did not give is not missing
  std::int64_t n = 0;
  std::int64_t missing = 0;
  std::int64_t completeTrainees = 0;  ///< with a mark of every rater present: what `icc` is made from
  Outcome<IccResult> icc = Outcome<IccResult>::undefined(Text::tr("not computed"));
  std::vector<GroupAgreement> groups;
  Outcome<IncompleteReliability> reliability =
      Outcome<IncompleteReliability>::undefined(Text::tr("not computed"));
  Outcome<KrippendorffResult> alpha = Outcome<KrippendorffResult>::undefined(Text::tr("not computed"));
  PointAgreement points;
};

/// What another number of raters would give (G- and D-study of the last occasion).
struct RatersNeeded {
  std::int64_t marks = 0;  ///< of the trainees whom every rater scored
  Outcome<GStudy> components = Outcome<GStudy>::undefined(Text::tr("not computed"));
  std::vector<std::pair<std::size_t, Outcome<DStudy>>> planned;  ///< by number of raters, ascending
  std::optional<std::size_t> fewest;  ///< whose mean has a dependability of kWantedDependability or more
};
inline constexpr double kWantedDependability = 0.8;
inline constexpr std::size_t kMaxRaters = 100;  ///< that are tried

/// What one group gained by itself from the first occasion to the last.
struct GroupGain {
  std::int64_t n = 0;  ///< trainees with a score at both
  Outcome<Bootstrap> median = Outcome<Bootstrap>::undefined(Text::tr("not computed"));
  Outcome<SignedRank> ranks = Outcome<SignedRank>::undefined(Text::tr("not computed"));
  Outcome<Friedman> occasions = Outcome<Friedman>::undefined(Text::tr("not computed"));  ///< all of them
};

/// Gains by group, as whole numbers, and what their ranks say.
struct GainAnalysis {
  Groups gains;
  std::vector<GroupGain> within;  ///< by group
  Outcome<KruskalWallis> between = Outcome<KruskalWallis>::undefined(Text::tr("not computed"));
  std::vector<Outcome<MannWhitney>> pairs;  ///< in the order of between->pairs
};

/// A trainee of whom marks or scores are missing at the first or the last occasion.
struct MissingTrainee {
  std::string trainee;
  std::size_t group = 0;
  MissingCount marks;
  bool leftOut = false;  ///< without any mark at one of the two
};

/// How far a rater scores above (positive: lenient) or below the others, over all trainees and occasions
/// that the rater shares with at least one other.
struct RaterSeverity {
  std::string rater;
  std::int64_t n = 0;
  double offset = 0.0;               ///< mean of mark minus mean of the other raters, points
  std::optional<Interval> interval;  ///< 95 %, Student's t over the trainees; empty with fewer than two
};

/// A difference of the primary comparison: of the mixed model where marks are missing and it is defined, else
/// of the analysis of covariance.
struct PrimaryDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double value = 0.0;  ///< first minus second, points, adjusted for the score before
  double error = 0.0;
  double df = 0.0;
  double pHolm = 0.0;
  Interval interval;  ///< not adjusted for the number of pairs
};

/// Analysis of the training marks for the report, its figures and its table of numbers; computed once.
struct StudyAnalysis {
  std::vector<std::string> trainees;  ///< codes of those with a mark, ascending
  std::vector<std::string> raters;
  std::vector<OccasionMarks> occasions;
  std::vector<RaterSeverity> severity;  ///< in the order of the raters
  std::vector<Outcome<BlandAltmanResult>>
      againstPanel;    ///< by rater, last occasion; trainees with every mark
  CompleteCases ends;  ///< scores before and at the end, of the trainees with both
  std::vector<std::vector<std::string>> endCodes;  ///< whose those are
  std::vector<MissingTrainee> missing;             ///< by code
  std::int64_t endMarks = 0;                       ///< given at the first and the last occasion
  std::int64_t endMissing = 0;                     ///< missing there
  Outcome<Ancova> ancova = Outcome<Ancova>::undefined(Text::tr("there are fewer than two occasions"));
  Outcome<SeparateSlopes> slopes = Outcome<SeparateSlopes>::undefined(
      Text::tr("the slopes do not differ"));  ///< where the test of equal slopes asks for it
  Outcome<MixedComparison> mixed =
      Outcome<MixedComparison>::undefined(Text::tr("no mark is missing"));  ///< where one is missing
  std::vector<MissingBounds> bounds;                                        ///< where a mark is missing
  Outcome<MixedAnova> course = Outcome<MixedAnova>::undefined(Text::tr("there are fewer than two occasions"));
  std::vector<NumberTable> courses;          ///< by group: trainees with a score at each occasion x occasions
  std::vector<std::string> leftOutOfCourse;  ///< codes of those without a score at some occasion
  std::optional<GainAnalysis> gains;         ///< empty: there are too many different numbers of marks
  RatersNeeded needed;
  Outcome<RaschResult> rasch = Outcome<RaschResult>::undefined(Text::tr("not computed"));  ///< last occasion
  bool sameRaters = true;  ///< at the last occasion every trainee with a mark has one of each rater present

  /// Whether the planned analysis, of covariance, has every mark it was planned with, of the same raters.
  [[nodiscard]] bool asPlanned() const noexcept { return missing.empty() && sameRaters; }
};

/// Counts the marks short of the number that most trainees have at an occasion: groups x occasions.
[[nodiscard]] std::vector<std::vector<std::int64_t>> missingByGroup(const CohortInputs& inputs);

/// Returns the groups of which nobody has a score at both ends, by number.
[[nodiscard]] std::vector<std::size_t> groupsWithoutEnds(const StudyAnalysis& study);

/// Returns the marks of the trainees whom every rater who is present scored, trainees x such raters;
/// `groupOf` and `only`: those of one group.
[[nodiscard]] NumberTable completeMarks(const OccasionMarks& occasion,
                                        const std::vector<std::size_t>& groupOf = {},
                                        std::optional<std::size_t> only = std::nullopt);

/// Gives the mean of the marks that others than `rater` gave a trainee, points; empty: nobody else scored.
[[nodiscard]] std::optional<double> meanOfOthers(const std::vector<std::optional<double>>& marks,
                                                 std::size_t rater);

/// Gives the differences of the primary comparison, (0,1), (0,2), ..., (1,2); none where it is not defined.
[[nodiscard]] std::vector<PrimaryDifference> primaryDifferences(const StudyAnalysis& study);

[[nodiscard]] StudyAnalysis analyseStudy(const CohortInputs& inputs);

}  // namespace torsio
