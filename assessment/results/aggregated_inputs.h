// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio {

/// Returns the inputs without groups and rater classes of fewer than kSmallestCell people, so that no number
/// of an aggregated report concerns only a few people. `left`: one sentence per omission.
[[nodiscard]] CohortInputs withoutSmallGroups(const CohortInputs& inputs, std::vector<Text>& left);

/// Removes figures and tables about single people from the report.
void removeIndividuals(ReportModel& report);

/// Lists counts ("female 4, male 6"), or a text if one of them is below kSmallestCell: hiding only the small
/// one would be useless, as the row's sum is known.
[[nodiscard]] Text countsText(const std::vector<std::pair<Text, std::int64_t>>& counts,
                              ReportIdentity identity);

}  // namespace torsio
