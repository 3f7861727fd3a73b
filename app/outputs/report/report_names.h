// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

class Connection;

/// Returns the cohort of this name, or the oldest for an empty name. Throws Error{kBadParameter} if there is
/// none.
[[nodiscard]] CohortId cohortNamed(Connection& connection, const std::string& name);

/// Returns the evaluation of this name; for an empty name the oldest with marks, or none. Throws
/// Error{kBadParameter} for an unknown name.
[[nodiscard]] CampaignId campaignNamed(Connection& connection, const std::string& name);

}  // namespace torsio
