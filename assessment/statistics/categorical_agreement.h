// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

enum class AlphaMetric { kNominal, kOrdinal, kInterval, kRatio };

struct KrippendorffResult {
  double alpha = 0.0;
  double observed = 0.0;      ///< disagreement within units
  double expected = 0.0;      ///< disagreement between all values
  std::int64_t pairable = 0;  ///< values in units that have at least two
};

using IncompleteRatings = std::vector<std::vector<std::optional<double>>>;  ///< coders x units

/// Computes Krippendorff's alpha for any pattern of missing ratings in O(n log n) of n ratings. Undefined if
/// fewer than two values can be paired, all are equal (agreement without variation is not perfect
/// reliability) or their squares overflow.
[[nodiscard]] Outcome<KrippendorffResult> krippendorffAlpha(const IncompleteRatings& codersByUnit,
                                                            AlphaMetric metric);

/// Percentile interval from resampled units. Resamples without variation are skipped and counted. Undefined
/// like krippendorffAlpha, and for kRatio with more than 300 distinct values.
struct AlphaBootstrap {
  Interval interval;
  std::int64_t resamples = 0;
  std::int64_t undefined = 0;
};
[[nodiscard]] Outcome<AlphaBootstrap> krippendorffInterval(const IncompleteRatings& codersByUnit,
                                                           AlphaMetric metric, std::uint64_t seed,
                                                           int resamples = 9999,
                                                           double confidence = kDefaultConfidence);

enum class KappaWeights { kUnweighted, kLinear, kQuadratic };

struct KappaResult {
  double kappa = 0.0;
  double observed = 0.0;  ///< weighted agreement; shown beside kappa because of the prevalence effect
  double expected = 0.0;
  double error = 0.0;           ///< standard error for intervals
  double errorUnderNull = 0.0;  ///< standard error for the test
  std::optional<double> z;
  Interval interval;
};

/// Computes Cohen's kappa of two raters. `table`: counts, categories of the first rater x those of the
/// second, including unused ones. Undefined for an empty table or if both raters use a single category.
[[nodiscard]] Outcome<KappaResult> cohenKappa(const NumberTable& table, KappaWeights weights,
                                              double confidence = kDefaultConfidence);
/// Computes Cohen's kappa with custom disagreements (0 on the diagonal); agreement is 1 - disagreement /
/// largest disagreement.
[[nodiscard]] Outcome<KappaResult> cohenKappa(const NumberTable& table, const NumberTable& disagreement,
                                              double confidence = kDefaultConfidence);

/// Computes Cohen's kappa with quadratic weights from two raters' integers for the same targets, without a
/// table of all categories. Undefined for fewer than two targets or if all numbers are equal.
[[nodiscard]] Outcome<double> quadraticKappa(std::span<const double> first, std::span<const double> second);

struct FleissResult {
  double kappa = 0.0;
  double observed = 0.0;
  double expected = 0.0;
  double errorUnderNull = 0.0;
  double z = 0.0;
  std::vector<std::optional<double>> byCategory;  ///< empty for a category used by nobody or by everybody
  double errorByCategory = 0.0;
};

/// Computes Fleiss' kappa of exchangeable raters. `counts`: subjects x categories, with the same number of
/// raters (at least two) in every row. Throws Error{kBadData} if the row sums differ. Undefined if only one
/// category was used.
[[nodiscard]] Outcome<FleissResult> fleissKappa(const NumberTable& counts);

}  // namespace torsio
