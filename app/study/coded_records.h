// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/access/session_context.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/trial/trial_repository.h"

namespace torsio {

/// Recordings under their codes, newest first. kTrialViewCoded.
[[nodiscard]] std::vector<TrialListing> codedTrials(SessionContext& session, const TrialFilter& filter = {});

/// Every newest mark of a cohort under the codes of trainee and rater. kMarkViewCoded.
[[nodiscard]] std::vector<StoredTrainingMark> codedMarks(SessionContext& session,
                                                         const std::string& cohortId);

}  // namespace torsio
