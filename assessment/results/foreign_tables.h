// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/results/cohort_report.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// Tables about recordings of other equipment: medians by group and phase, and the course of each trainee
/// from recording to recording. Empty: there are none.
[[nodiscard]] std::vector<ReportTable> foreignTables(const CohortInputs& in);

}  // namespace torsio
