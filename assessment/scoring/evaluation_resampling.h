// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "assessment/scoring/model_ratings.h"

namespace torsio {

/// How often and from which seed the raters are drawn anew.
struct EvaluationResampling {
  std::int64_t resamples = 9999;
  std::uint64_t seed = 1;
};

/// Range of the comprehensive score over resampled panels, points.
struct ScoreRange {
  double lower = 0.0;  ///< of the middle 95 %
  double upper = 0.0;
};

/// Draws the raters of every class of a weight anew, with replacement and in their number, evaluates each
/// such panel (Eqs. 25 and 27) and returns the middle 95 % of N (quantiles of type 1). With few raters in a
/// class the range is too short. The same seed gives the same range on every machine. Throws Error{kBadData}
/// when a mark of a weighted class is missing or a weighted class has no rater, {kBadParameter} for no
/// resample.
[[nodiscard]] ScoreRange resampledScore(const EvaluationInstrument& instrument, const ModelRatings& ratings,
                                        const EvaluationResampling& resampling = {});

}  // namespace torsio
