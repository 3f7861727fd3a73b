// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// Minimum number of marks behind a number for readers who may not see single marks.
inline constexpr std::int64_t kMinMarks = 3;

/// Returns the inputs without what must not be shown yet: all marks, scores and means of the training study
/// while its sheets are neither complete nor frozen; likewise for the models; and if single marks are hidden,
/// scores by fewer than kMinMarks raters and means of fewer than kMinMarks trainees. `left`: one sentence per
/// omission.
[[nodiscard]] CohortInputs shownInputs(const CohortInputs& inputs, std::vector<Text>& left);

}  // namespace torsio
