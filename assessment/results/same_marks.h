// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/results/study_analysis.h"

namespace torsio {

/// Two trainees whose marks are the same, or nearly so. Private to assessment/results.
struct AlikeTrainees {
  std::string first;
  std::string second;
  std::int64_t same = 0;    ///< equal marks by the same rater at the same occasion
  std::int64_t shared = 0;  ///< marks by the same rater at the same occasion
};

/// Returns the pairs of trainees of whom nine in ten shared marks or more are equal, if chance would give
/// that to any pair of the cohort in less than one of twenty cohorts, even if both were always equally good.
/// Chance: two marks are equal as often as two of the same trainee would be, by the residual variance of the
/// occasion, or as often as any two of that rater there, whichever is more. `trainees`: codes, in the order
/// of the marks.
[[nodiscard]] std::vector<AlikeTrainees> traineesMarkedAlike(const std::vector<std::string>& trainees,
                                                             const std::vector<OccasionMarks>& occasions);

}  // namespace torsio
