// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/report/cohort_report.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/mixed_anova.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/reliability.h"

namespace torsio {

/// The marks of one occasion, trainees x raters in the order of StudyAnalysis; a mark that was not given is
/// empty.
struct OccasionMarks {
  std::vector<std::vector<std::optional<double>>> marks;
  std::int64_t n = 0;
  std::int64_t missing = 0;
  Outcome<IccResult> icc = Outcome<IccResult>::undefined(Text::tr("not computed"));
  Outcome<KrippendorffResult> alpha = Outcome<KrippendorffResult>::undefined(Text::tr("not computed"));
};

/// How far a rater scores above (positive: lenient) or below the others, over all trainees and occasions
/// that the rater shares with at least one other.
struct RaterSeverity {
  std::string rater;
  std::int64_t n = 0;
  double offset = 0.0;               ///< mean of mark minus mean of the other raters, points
  std::optional<Interval> interval;  ///< 95 %, Student's t over the trainees; empty with fewer than two
};

/// Analysis of the training marks for the report, its figures and its table of numbers; computed once.
struct StudyAnalysis {
  std::vector<std::string> trainees;  ///< codes, ascending
  std::vector<std::string> raters;
  std::vector<OccasionMarks> occasions;
  std::vector<RaterSeverity> severity;                   ///< in the order of the raters
  std::vector<Outcome<BlandAltmanResult>> againstPanel;  ///< last scoring point; empty with marks missing
  std::vector<std::optional<Groups>> scores;             ///< by scoring point; empty when a trainee lacks one
  Outcome<Ancova> ancova = Outcome<Ancova>::undefined(Text::tr("scores are missing at some scoring point"));
  Outcome<MixedAnova> course =
      Outcome<MixedAnova>::undefined(Text::tr("scores are missing at some scoring point"));
  std::vector<Groups> wholeGains;  ///< one entry: exact gains by group; none when they cannot be formed
};

/// Gives the mean of the marks that others than `rater` gave a trainee, points; empty: nobody else scored.
[[nodiscard]] std::optional<double> meanOfOthers(const std::vector<std::optional<double>>& marks,
                                                 std::size_t rater);

[[nodiscard]] StudyAnalysis analyseStudy(const CohortInputs& inputs);

}  // namespace torsio
