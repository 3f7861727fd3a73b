// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "app/services/demonstration/demonstration_people.h"
#include "app/services/recording/pipeline.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// A simulated untwisting, ready to record.
struct DemonstrationUntwisting {
  std::size_t group = 0;  ///< of the trainee in the demonstration's study
  SceneId sceneId;
  PatternId patternId;
  ScriptedTrial trial{};  ///< with trainee, enrolment, module and time
};

/// Stores a separate cohort in which four trainees of the study follow the shipped curriculum "Volvulus and
/// torsion: undo it", and returns their trials in order. Ids come from a separate random stream, so the
/// seed's other ids do not change. Runs in the caller's transaction. Throws Error{kFileMissing} if the
/// curriculum is not among the assets.
[[nodiscard]] std::vector<DemonstrationUntwisting> storeDemonstrationUntwisting(
    Connection& connection, const DemonstrationStudy& study, const std::filesystem::path& assets,
    std::uint64_t seed, std::int64_t utc_us);

/// Describes the rule of these simulated hands, for the report.
[[nodiscard]] Text demonstrationUntwistingRule();

}  // namespace torsio
