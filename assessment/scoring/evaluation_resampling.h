// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "assessment/scoring/model_ratings.h"

namespace torsio {

/// Number of resamples and seed.
struct EvaluationResampling {
  std::int64_t resamples = 9999;
  std::uint64_t seed = 1;
};

/// Range of the comprehensive score over resampled panels, in points.
struct ScoreRange {
  double lower = 0.0;  ///< of the middle 95 %
  double upper = 0.0;
};

/// Resamples the raters of each weighted class with replacement, evaluates each panel (Eqs. 25 and 27) and
/// returns the middle 95 % of N (quantiles of type 1). Too narrow for few raters in a class. The same seed
/// gives the same range on every machine. Throws Error{kBadData} if a mark of a weighted class is missing or
/// a weighted class has no rater, Error{kBadParameter} for zero resamples.
[[nodiscard]] ScoreRange resampledScore(const EvaluationInstrument& instrument, const ModelRatings& ratings,
                                        const EvaluationResampling& resampling = {});

}  // namespace torsio
