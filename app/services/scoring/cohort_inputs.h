// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/scoring/scoring_service.h"
#include "assessment/domain/ids.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

class Connection;

/// Collects people, groups, allocation and scores of a cohort report from the record. Replays the allocation
/// from its seed to verify it; the caller adds trials, facts and title.
[[nodiscard]] CohortInputs cohortInputs(Connection& connection, const CohortId& cohortId,
                                        const CampaignResult& campaign, const TrainingResult& training);

}  // namespace torsio
