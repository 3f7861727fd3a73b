// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "assessment/domain/ids.h"

namespace torsio {

class Connection;
class IdSource;

/// What was laid out for the trainee of the demonstration.
struct DemonstrationStation {
  CohortId cohortId{};
  PersonId personId{};
  ModuleId firstModuleId{};
  TrialId newestTrialId{};
};

/// A second demonstration cohort that follows the curriculum "First steps" of `assets`: the first simulated
/// trainee has agreed to be recorded, has mastered the first module after some attempts, has begun the
/// second, and a simulated physician has remarked on a run. Every row carries the demonstration flag. Needs
/// storeDemonstrationPeople() before; does nothing the second time. One transaction. Throws Error.
DemonstrationStation storeDemonstrationStation(Connection& connection, IdSource& ids,
                                               const std::filesystem::path& assets, std::int64_t utc_us);

}  // namespace torsio
