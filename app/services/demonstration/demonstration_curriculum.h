// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/demonstration/demonstration_people.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/scene/scene.h"

namespace torsio {

inline constexpr const char* kDemonstrationName = "demonstration";  ///< who made what the demonstration makes

class Connection;
class IdSource;

/// Where a simulated trial belongs in the curriculum, and when it begins; empty ids: nowhere.
struct DemonstrationPlace {
  ModuleId moduleId;
  PhaseId phaseId;
  std::int64_t startedUtc_us = 0;
};

/// Stores the paper's protocol as a curriculum of its own that runs, with what `training` twists as its
/// exercise, and lets the cohort follow it. Its ids come from a stream of their own: everything else keeps
/// the ids that the seed gives it. Throws Error{kFileMissing} when the template is not among the assets.
[[nodiscard]] CurriculumVersion storeDemonstrationCurriculum(Connection& connection,
                                                             const DemonstrationStudy& study,
                                                             const Scene& training,
                                                             const std::filesystem::path& assets,
                                                             std::uint64_t seed, std::int64_t utc_us);

/// Stores a shipped curriculum as one of the demonstration's that runs: its modules, with these arms in place
/// of its own and without occasions. Throws Error{kFileMissing} when it is not among the assets.
[[nodiscard]] CurriculumVersion storeDemonstrationTemplate(Connection& connection, IdSource& ids,
                                                           const std::filesystem::path& assets,
                                                           const std::string& templateId,
                                                           std::vector<StudyArm> arms, std::int64_t utc_us);

/// The trainees in the order in which they come: the groups take turns.
[[nodiscard]] std::vector<DemonstrationTrainee> inOrderOfComing(std::vector<DemonstrationTrainee> trainees);

/// When each phase of a trainee begins, and at the end when the last one is over. One trainee an hour, six a
/// day from `utc_us` on; every second trainee of a group rests between the first two phases.
[[nodiscard]] std::vector<std::int64_t> demonstrationTimes(const CurriculumVersion& curriculum,
                                                           const DemonstrationTrainee& trainee,
                                                           std::int64_t utc_us);

/// The phase with this label in the arm of a trainee, its exercise and when it begins.
[[nodiscard]] DemonstrationPlace demonstrationPlace(const CurriculumVersion& curriculum,
                                                    const DemonstrationTrainee& trainee,
                                                    const std::string& phaseLabel, std::int64_t utc_us);

/// The time that everybody spent: each phase of the arm in full length, and for every second trainee the rest
/// between the first two.
void storeDemonstrationExposures(Connection& connection, const DemonstrationStudy& study,
                                 const CurriculumVersion& curriculum, std::uint64_t seed,
                                 std::int64_t utc_us);

/// The stated rule of these times, for the report.
[[nodiscard]] Text demonstrationTimeRule();

}  // namespace torsio
