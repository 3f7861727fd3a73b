// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

class Connection;

/// The cohort of this name; the oldest one for an empty name. Throws Error{kBadParameter}: there is none.
[[nodiscard]] CohortId cohortNamed(Connection& connection, const std::string& name);

/// The evaluation of models of this name; for an empty name the oldest one that has marks, or none. Throws
/// Error{kBadParameter}: there is none of that name.
[[nodiscard]] CampaignId campaignNamed(Connection& connection, const std::string& name);

}  // namespace torsio
