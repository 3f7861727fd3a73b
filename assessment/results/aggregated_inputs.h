// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// Returns the inputs without groups of fewer than kSmallestCell trainees and without rater classes that
/// small, so that no number of an aggregated report is about a handful of people. `left`: one sentence for
/// each thing that was left out.
[[nodiscard]] CohortInputs withoutSmallGroups(const CohortInputs& inputs, std::vector<Text>& left);

/// Takes figures and tables about single people out of the report.
void removeIndividuals(ReportModel& report);

/// Lists counts ("female 4, male 6"), or words when one of them is below kSmallestCell: with the sum of the
/// row at hand, hiding only the small one would hide nothing.
[[nodiscard]] Text countsText(const std::vector<std::pair<Text, std::int64_t>>& counts,
                              ReportIdentity identity);

}  // namespace torsio
