// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// Fewest marks behind a number that somebody sees who may not see single marks.
inline constexpr std::int64_t kMinMarks = 3;

/// Returns the inputs without what must not be shown yet: every mark, score and mean of the training study
/// while its set of sheets is neither complete nor frozen, and of the models likewise; where single marks may
/// not be seen, scores of fewer than kMinMarks raters and means of fewer than kMinMarks trainees.
/// `left`: one sentence for each thing that was left out.
[[nodiscard]] CohortInputs shownInputs(const CohortInputs& inputs, std::vector<Text>& left);

}  // namespace torsio
