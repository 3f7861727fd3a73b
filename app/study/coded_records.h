// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/access/session_context.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/rating/mark.h"

namespace torsio {

/// Recordings under their codes, newest first. kTrialViewCoded.
[[nodiscard]] std::vector<TrialListing> codedTrials(SessionContext& session, const TrialFilter& filter = {});

/// Every newest mark of a cohort under the codes of trainee and rater. kMarkViewCoded.
[[nodiscard]] std::vector<SubmittedMark> codedMarks(SessionContext& session, const std::string& cohortId);

}  // namespace torsio
