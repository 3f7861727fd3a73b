// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/statistics/rating_plan.h"
#include "assessment/statistics/values.h"

namespace torsio {

struct RaschPerson {
  RaschStatus status = RaschStatus::kEstimated;
  std::optional<double> ability;      ///< logits
  std::optional<double> error;        ///< given the raters and thresholds
  std::optional<double> jointError;   ///< from the inverse of the full information
  std::optional<double> fairAverage;  ///< expected rating by a rater of severity 0, in categories
  std::optional<double> infit;        ///< information-weighted mean square; about 1
  std::optional<double> outfit;       ///< unweighted; sensitive to single surprises
};

struct RaschRater {
  RaschStatus status = RaschStatus::kEstimated;
  std::optional<double> severity;  ///< logits; severities sum to 0
  std::optional<double> error;
  std::optional<double> infit;
  std::optional<double> outfit;
};

struct RaschResult {
  std::vector<RaschPerson> persons;
  std::vector<RaschRater> raters;
  std::vector<double> thresholds;  ///< tau_1 .. tau_K, sum 0
  double logLikelihood = 0.0;
  int iterations = 0;
};

/// Many-facet rating scale model, ln(P_k / P_(k-1)) = ability - severity - tau_k, by joint maximum likelihood
/// (Newton). `ratings`: persons x raters, categories 0 .. `highest`, missing values allowed. `codes`: of the
/// raters, for the reason of an undefined result; empty: their numbers, from 1. Persons and raters with only
/// extreme ratings are removed iteratively and reported. Undefined if the rating plan falls into disconnected
/// parts, if a category is never used (collapse categories first), or if the likelihood has no finite
/// maximum, which is decided exactly beforehand. Joint estimates are too spread out for short designs: see
/// correctedSeverities().
[[nodiscard]] Outcome<RaschResult> manyFacetRasch(const CategoryRatings& ratings, int highest,
                                                  std::span<const std::string> codes = {});

/// A rater's severity without most of the bias of joint estimation, with an interval that can be believed.
struct CorrectedSeverity {
  double severity = 0.0;  ///< joint estimate times (m - 1) / m for m ratings per person (Wright 1988), logits
  double error = 0.0;     ///< of it
  Interval interval;
};
/// Corrects the severities of manyFacetRasch(ratings, highest), in the order of its raters; empty for a rater
/// without an estimate. Errors come from a jackknife over persons, in at most 50 groups; with more than 5,000
/// ratings, where that would take long, from the information.
[[nodiscard]] std::vector<std::optional<CorrectedSeverity>> correctedSeverities(
    const CategoryRatings& ratings, const RaschResult& result, double confidence = kDefaultConfidence);

}  // namespace torsio
