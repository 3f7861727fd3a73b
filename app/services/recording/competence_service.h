// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/attempt/competence.h"
#include "assessment/domain/ids.h"
#include "assessment/statistics/standard_setting.h"

namespace torsio {

/// The competence designs of one exercise version.
struct ExerciseDesigns {
  ModuleId moduleId{};
  std::string curriculum{};  ///< name
  std::int64_t curriculumVersion = 1;
  std::string code{};
  std::string title{};
  CompetenceDesign shipped{};
  std::vector<CompetenceDesign> registered{};  ///< oldest first
  CompetenceRule inForce{};                    ///< for trainees who start now: the latest design
};

/// Returns the exercises of a published version in order; without a version, of all published ones.
/// kPersonViewCoded. Throws Error{kBadData} for an unknown version.
[[nodiscard]] std::vector<ExerciseDesigns> competenceDesigns(SessionContext& session,
                                                             const CurriculumVersionId& versionId = {});

/// Registers a design for an exercise: estimates how runs depend on each other from the exercise's runs, or
/// assumes it, and chooses the limit so that both error rates are met. Applies to trainees who start later.
/// Audited. Returns the stored design. kCurriculumEdit. Throws Error{kBadParameter} (plannedCompetence,
/// requireFalseFailKept; a tolerance set by hand without a reason), {kBadData} for an unknown exercise.
CompetenceDesign registerCompetence(SessionContext& session, const CompetenceDesign& design);

/// Returns how the runs of one trainee at an exercise depend on each other, as a design registered now would
/// use it; empty with too few runs. kCurriculumEdit. Throws Error{kBadData} for an unknown exercise.
[[nodiscard]] EstimatedDependence dependenceOfRuns(SessionContext& session, const ModuleId& moduleId);

/// An interrupted run, which counts as failed for competence unless it is excused.
struct InterruptedRun {
  TrialId trialId{};
  std::string trainee{};  ///< code
  std::int64_t startedUtc_us = 0;
  bool excused = false;
  std::string reason{};
};
/// Returns the interrupted runs at an exercise that count, latest first. kPersonViewCoded.
[[nodiscard]] std::vector<InterruptedRun> interruptedRuns(SessionContext& session, const ModuleId& moduleId);
/// Excuses an interrupted run, so that it does not count as failed. Final. Audited. kStudySetup. Throws
/// Error{kBadParameter} without a reason, {kBadData} for a run that is not interrupted or is excused already,
/// or is one's own.
void excuseRun(SessionContext& session, const TrialId& trialId, const std::string& reason);

/// Minimum number of experts for a meaningful threshold.
inline constexpr std::size_t kMinExperts = 8;

/// Derives a tolerance from experts: the mean absolute errors, in degrees, of a cohort's people at the scene
/// and pattern of an exercise. kCurriculumEdit. Throws Error{kBadData} for an unknown exercise, or if fewer
/// than kMinExperts have a finished run.
[[nodiscard]] ProficiencyThreshold expertTolerance_deg(SessionContext& session, const ModuleId& moduleId,
                                                       const CohortId& expertCohortId);

}  // namespace torsio
