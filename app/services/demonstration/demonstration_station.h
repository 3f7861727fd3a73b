// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

class Connection;
class IdSource;

/// Content for the demonstration's trainee.
struct DemonstrationStation {
  CohortId cohortId{};
  PersonId personId{};
  ModuleId firstModuleId{};
  TrialId newestTrialId{};
};

/// Stores a second demonstration cohort that follows the curriculum "First steps" of `assets`: the first
/// simulated trainee has consented to recording, mastered the first module after some attempts and begun the
/// second, and a simulated physician has commented on a run. Every row has the demonstration flag. Needs
/// storeDemonstrationPeople() before; does nothing if called again. One transaction. Throws Error.
DemonstrationStation storeDemonstrationStation(Connection& connection, IdSource& ids,
                                               const std::filesystem::path& assets, std::int64_t utc_us);

}  // namespace torsio
