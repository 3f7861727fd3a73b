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

/// One simulated untwisting, ready to be recorded.
struct DemonstrationUntwisting {
  std::size_t group = 0;  ///< of the trainee in the study of the demonstration
  SceneId sceneId;
  PatternId patternId;
  ScriptedTrial trial{};  ///< with its place: trainee, enrolment, module, time
};

/// Stores a cohort of its own, in which four trainees of the study follow the shipped curriculum "Volvulus
/// and torsion: undo it", and returns what they do there, in order. Ids come from a stream of their own:
/// everything else keeps the ids that the seed gives it. Runs in the caller's transaction. Throws
/// Error{kFileMissing} when the curriculum is not among the assets.
[[nodiscard]] std::vector<DemonstrationUntwisting> storeDemonstrationUntwisting(
    Connection& connection, const DemonstrationStudy& study, const std::filesystem::path& assets,
    std::uint64_t seed, std::int64_t utc_us);

/// The stated rule of these hands, for the report.
[[nodiscard]] Text demonstrationUntwistingRule();

}  // namespace torsio
