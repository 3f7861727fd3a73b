// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// Returns tables on recordings of other equipment: medians by group and phase, and each trainee's course
/// over the recordings. Empty if there are none.
[[nodiscard]] std::vector<ReportTable> foreignTables(const CohortInputs& in);

}  // namespace torsio
