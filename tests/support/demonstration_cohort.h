// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/cohort_report.h"

namespace torsio::testing {

/// Returns the inputs of a report of the paper's study, with marks by the demonstration's rule and one
/// recording: thirty trainees in three groups, ten raters, forty raters of three models.
[[nodiscard]] CohortInputs demonstrationCohort();

}  // namespace torsio::testing
