// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/demonstration/demonstration_people.h"
#include "app/services/recording/recorded_run.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

inline constexpr const char* kDemonstrationName = "demonstration";  ///< author of the demonstration's data

class Connection;
class IdSource;

/// Position of a simulated trial in the curriculum, and its start time; empty ids: none.
struct DemonstrationPlace {
  ModuleId moduleId;
  PhaseId phaseId;
  std::int64_t startedUtc_us = 0;
};

/// Stores the paper's protocol as an active curriculum, with the scene of `training` as its exercise, and
/// assigns it to the cohort. Its ids come from a separate random stream, so the seed's other ids do not
/// change. Throws Error{kFileMissing} if the template is not among the assets.
[[nodiscard]] CurriculumVersion storeDemonstrationCurriculum(Connection& connection,
                                                             const DemonstrationStudy& study,
                                                             const Scene& training,
                                                             const std::filesystem::path& assets,
                                                             std::uint64_t seed, std::int64_t utc_us);

/// Stores a shipped curriculum as an active one of the demonstration: its modules, with the given arms
/// instead of its own and without occasions. Throws Error{kFileMissing} if it is not among the assets.
[[nodiscard]] CurriculumVersion storeDemonstrationTemplate(Connection& connection, IdSource& ids,
                                                           const std::filesystem::path& assets,
                                                           const std::string& templateId,
                                                           std::vector<StudyArm> arms, std::int64_t utc_us);

/// Returns the trainees in order of arrival: the groups alternate.
[[nodiscard]] std::vector<DemonstrationTrainee> inOrderOfComing(std::vector<DemonstrationTrainee> trainees);

/// Returns the start times of a trainee's phases, and finally the end of the last one. One trainee per hour,
/// six per day from `utc_us`; every second trainee of a group rests between the first two phases.
[[nodiscard]] std::vector<std::int64_t> demonstrationTimes(const CurriculumVersion& curriculum,
                                                           const DemonstrationTrainee& trainee,
                                                           std::int64_t utc_us);

/// Returns the phase with this label in the trainee's arm, its exercise and its start time.
[[nodiscard]] DemonstrationPlace demonstrationPlace(const CurriculumVersion& curriculum,
                                                    const DemonstrationTrainee& trainee,
                                                    const std::string& phaseLabel, std::int64_t utc_us);

/// Stores everybody's training times: each phase of the arm in full length, and for every second trainee the
/// rest between the first two.
void storeDemonstrationExposures(Connection& connection, const DemonstrationStudy& study,
                                 const CurriculumVersion& curriculum, std::uint64_t seed,
                                 std::int64_t utc_us);

/// Describes the rule of these times, for the report.
[[nodiscard]] Text demonstrationTimeRule();

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
