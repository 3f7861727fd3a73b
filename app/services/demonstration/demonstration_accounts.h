// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "app/services/access/first_run.h"
#include "app/services/base/progress.h"

namespace torsio {

/// Stores the demonstration cohort with what a trainee and a physician find at their desks, and makes one
/// account for each of the two. `assets`: where the organs are. Runs in the caller's transaction; throws what
/// `progress` and the repositories throw.
std::vector<StartAccount> addDemonstration(SessionContext& session, const std::filesystem::path& assets,
                                           const ProgressCallback& progress);

}  // namespace torsio
