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
#include "assessment/statistics/site_comparison.h"
#include "assessment/statistics/site_heterogeneity.h"

namespace torsio {

/// Pairwise agreement of raters in one group at one occasion, for marks in whole points.
struct PointAgreement {
  std::size_t pairs = 0;       ///< of the raters with marks
  std::vector<double> kappas;  ///< quadratic weights, for pairs that define it
  std::int64_t shared = 0;     ///< marks of the same trainee by both raters
  std::int64_t same = 0;
  std::int64_t withinOne = 0;
};

/// Agreement of the raters in one group at one occasion.
struct GroupAgreement {
  std::size_t group = 0;
  std::int64_t trainees = 0;  ///< with marks by every rater
  Outcome<IccResult> icc = Outcome<IccResult>::undefined(Text::tr("not computed"));
  PointAgreement points;
};

/// Marks of one occasion, trainees x raters in the order of StudyAnalysis; missing ones are empty.
struct OccasionMarks {
  std::vector<std::vector<std::optional<double>>> marks;
  std::vector<std::size_t> present;  ///< raters with marks here; the others' marks do not count as missing
  std::int64_t n = 0;
  std::int64_t missing = 0;
  std::int64_t completeTrainees = 0;  ///< with marks by every rater present; input of `within`
  /// Trainees and raters within the groups: an effect of the training would pass for agreement.
  Outcome<GStudy> within = Outcome<GStudy>::undefined(Text::tr("not computed"));
  std::vector<GroupAgreement> groups;
  Outcome<IncompleteReliability> reliability =
      Outcome<IncompleteReliability>::undefined(Text::tr("not computed"));
};

/// Results for other numbers of raters (G- and D-study of the last occasion, within the groups).
struct RatersNeeded {
  struct Planned {
    std::size_t raters = 0;
    Outcome<DStudy> study = Outcome<DStudy>::undefined(Text::tr("not computed"));
    std::optional<Interval> dependability;
  };
  std::int64_t marks = 0;                       ///< of trainees scored by every rater
  std::vector<Planned> planned;                 ///< by number of raters, ascending
  std::optional<std::size_t> fewest;            ///< whose interval lies at or above kWantedDependability
  std::optional<std::size_t> fewestByEstimate;  ///< whose estimate does
};
inline constexpr double kWantedDependability = 0.8;
inline constexpr std::size_t kMaxRaters = 100;  ///< maximum tried

/// A group's gain from the first to the last occasion.
struct GroupGain {
  std::int64_t n = 0;  ///< trainees with a score at both
  Outcome<Bootstrap> median = Outcome<Bootstrap>::undefined(Text::tr("not computed"));
  Outcome<SignedRank> ranks = Outcome<SignedRank>::undefined(Text::tr("not computed"));
  Outcome<Friedman> occasions = Outcome<Friedman>::undefined(Text::tr("not computed"));  ///< over all of them
};

/// Gains by group, as whole numbers, and their rank statistics.
struct GainAnalysis {
  Groups gains;
  std::vector<GroupGain> within;  ///< by group
  Outcome<KruskalWallis> between = Outcome<KruskalWallis>::undefined(Text::tr("not computed"));
  std::vector<Outcome<MannWhitney>> pairs;  ///< in the order of between->pairs
};

/// A trainee with missing marks or scores at the first or last occasion.
struct MissingTrainee {
  std::string trainee;
  std::size_t group = 0;
  MissingCount marks;
  bool leftOut = false;  ///< without any marks at one of the two
};

/// How far a rater's marks are above (positive: lenient) or below the others', over all trainees and
/// occasions shared with at least one other.
struct RaterSeverity {
  std::string rater;
  std::int64_t n = 0;
  double offset = 0.0;               ///< mean of mark minus mean of the other raters, points
  std::optional<Interval> interval;  ///< 95 %, Student's t over the trainees; empty for fewer than two
};

/// How the groups are compared, and why.
enum class PrimaryMethod : std::uint8_t {
  kNone,
  kCovariance,  ///< analysis of covariance
  kRobust,      ///< the same with the errors of HC3, which hold for unequal spreads; kCovariance without them
  kMixed,       ///< linear mixed model, as marks are missing or raters differ
  kCentres,     ///< analysis of covariance within centres (SiteComparison), if there are several
};

/// A difference of the primary comparison.
struct PrimaryDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double value = 0.0;  ///< first minus second, points, adjusted for the score before
  double error = 0.0;
  double df = 0.0;
  double pHolm = 0.0;
  Interval interval;  ///< adjusted like pHolm
};

/// Power for which a detectable difference is stated.
inline constexpr double kWantedPower = 0.8;
/// Groups whose scores before differ by this many standard deviations or more are called unlike.
inline constexpr double kUnlikeBefore_sd = 0.5;

/// The comparison within the centres of a pooled record, of trainees with scores at both ends.
struct SiteAnalysis {
  std::vector<SiteTrainee> trainees;      ///< `site`: index in CohortInputs::sites
  std::vector<std::string> traineeCodes;  ///< of `trainees`
  std::vector<std::size_t> sites;         ///< with such trainees, ascending
  SiteTerm term = SiteTerm::kFixed;
  Outcome<SiteComparison> together = Outcome<SiteComparison>::undefined(Text::tr("not computed"));
  std::vector<Outcome<SiteComparison>> without;  ///< one of `sites` left out; same term
  Outcome<std::vector<Heterogeneity>> heterogeneity =
      Outcome<std::vector<Heterogeneity>>::undefined(Text::tr("not computed"));
  /// With the device, or station, of most of a trainee's runs; of trainees with a run.
  Outcome<SiteComparison> withDevice = Outcome<SiteComparison>::undefined(Text::tr("not computed"));
  Outcome<SiteComparison> withStation = Outcome<SiteComparison>::undefined(Text::tr("not computed"));
};

/// Names of the results of the primary comparison of a pair.
struct PrimaryStatistics {
  const char* difference = "";
  const char* interval = "";  ///< adjusted like `p`
  const char* p = "";         ///< after Holm
};
[[nodiscard]] PrimaryStatistics primaryStatistics(PrimaryMethod method) noexcept;

/// Analysis of the training marks for the report, its figures and its table of numbers; computed once.
struct StudyAnalysis {
  std::vector<std::string> trainees;  ///< codes of trainees with marks, ascending
  std::vector<std::size_t> groupOf;   ///< of `trainees`
  std::vector<std::string> raters;
  std::vector<OccasionMarks> occasions;
  std::vector<RaterSeverity> severity;                   ///< in rater order
  std::vector<Outcome<BlandAltmanResult>> againstPanel;  ///< by rater, last occasion; trainees with all marks
  CompleteCases ends;                              ///< scores before and at the end, for trainees with both
  std::vector<std::vector<std::string>> endCodes;  ///< trainee codes of `ends`
  std::vector<MissingTrainee> missing;             ///< by code
  std::int64_t endMarks = 0;                       ///< at the first and last occasion
  std::int64_t endMissing = 0;                     ///< at these occasions
  Outcome<Ancova> ancova = Outcome<Ancova>::undefined(Text::tr("there are fewer than two occasions"));
  Outcome<SeparateSlopes> slopes = Outcome<SeparateSlopes>::undefined(
      Text::tr("the slopes do not differ"));  ///< if the test of equal slopes requires it
  Outcome<MixedComparison> mixed =
      Outcome<MixedComparison>::undefined(Text::tr("no mark is missing"));  ///< if a mark is missing
  /// Analysis of covariance of those who were trained as planned; undefined if everybody was.
  Outcome<Ancova> perProtocol = Outcome<Ancova>::undefined(Text::tr("everybody was trained as planned"));
  std::vector<std::string> perProtocolCodes;  ///< of its trainees
  std::vector<MissingBounds> bounds;          ///< if a mark is missing
  Outcome<MixedAnova> course = Outcome<MixedAnova>::undefined(Text::tr("there are fewer than two occasions"));
  std::vector<NumberTable> courses;          ///< by group: trainees with a score at every occasion x
                                             ///< occasions
  std::vector<std::string> leftOutOfCourse;  ///< codes of trainees without a score at some occasion
  std::optional<GainAnalysis> gains;         ///< empty: too many different numbers of marks
  std::optional<SiteAnalysis> sites;         ///< of a pooled record of several centres
  RatersNeeded needed;
  Outcome<RaschResult> rasch = Outcome<RaschResult>::undefined(Text::tr("not computed"));  ///< last occasion
  std::vector<std::optional<CorrectedSeverity>> onOneScale;  ///< by rater, from `rasch`; empty without it
  bool sameRaters = true;  ///< at the last occasion, every trainee with marks has one by each rater present

  [[nodiscard]] PrimaryMethod primaryMethod() const noexcept;
  /// Returns whether the errors of the primary comparison hold for unequal spreads.
  [[nodiscard]] bool allowsForSpreads() const noexcept;
  /// Returns whether the spread of the scores differs between the groups.
  [[nodiscard]] bool spreadsDiffer() const noexcept;
  /// Returns whether the planned analysis (of covariance) has all its marks, by the same raters.
  [[nodiscard]] bool asPlanned() const noexcept { return missing.empty() && sameRaters; }
};

/// Counts missing marks relative to the number that most trainees have at an occasion: groups x occasions.
[[nodiscard]] std::vector<std::vector<std::int64_t>> missingByGroup(const CohortInputs& inputs);

/// Returns the indices of groups without anybody scored at both ends.
[[nodiscard]] std::vector<std::size_t> groupsWithoutEnds(const StudyAnalysis& study);

/// Returns the marks of trainees scored by all raters present, trainees x these raters; `groupOf` and `only`
/// select one group.
[[nodiscard]] NumberTable completeMarks(const OccasionMarks& occasion,
                                        const std::vector<std::size_t>& groupOf = {},
                                        std::optional<std::size_t> only = std::nullopt);

/// Returns the mean of a trainee's marks by raters other than `rater`, points; empty if there are none.
[[nodiscard]] std::optional<double> meanOfOthers(const std::vector<std::optional<double>>& marks,
                                                 std::size_t rater);

/// Names the primary comparison, "analysis of covariance, one pooled slope, HC3".
[[nodiscard]] Text primaryMethodText(const StudyAnalysis& study);

/// Returns the differences of the primary comparison, (0,1), (0,2), ..., (1,2); empty if undefined.
[[nodiscard]] std::vector<PrimaryDifference> primaryDifferences(const StudyAnalysis& study);

/// Compares within the centres; empty for fewer than two. `ends`, `codes`: as in StudyAnalysis.
[[nodiscard]] std::optional<SiteAnalysis> analyseSites(const CohortInputs& inputs, const CompleteCases& ends,
                                                       const std::vector<std::vector<std::string>>& codes);

[[nodiscard]] StudyAnalysis analyseStudy(const CohortInputs& inputs);

}  // namespace torsio
