// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/cohort_report.h"

namespace torsio::testing {

/// What a report of the paper's study is made from, with marks by the stated rule of the demonstration and
/// one recording: thirty trainees in three groups, ten raters, forty raters of three models.
[[nodiscard]] CohortInputs demonstrationCohort();

}  // namespace torsio::testing
