// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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
  CompetenceRule inForce{};                    ///< for who begins now: the newest design
};

/// The exercises of a published version in their order; no version: of all that were published.
/// kPersonViewCoded. Throws Error{kBadData} for an unknown version.
[[nodiscard]] std::vector<ExerciseDesigns> competenceDesigns(SessionContext& session,
                                                             const CurriculumVersionId& versionId = {});

/// Registers a design for an exercise: the limit is chosen here, both error rates must be kept. It counts for
/// those who begin later. Audited. Returns what was stored. kCurriculumEdit. Throws Error{kBadParameter}
/// (plannedCompetence, requireFalseFailKept; a tolerance chosen by hand without a reason), {kBadData} for an
/// unknown exercise.
CompetenceDesign registerCompetence(SessionContext& session, const CompetenceDesign& design);

/// Fewer experts say too little of what experts do.
inline constexpr std::size_t kMinExperts = 8;

/// Derives a tolerance from experts: the people of a cohort, each with the mean absolute error, in degrees,
/// of the twists made at the scene and pattern of an exercise. kCurriculumEdit. Throws Error{kBadData} for an
/// unknown exercise, or with fewer than kMinExperts who have a finished run there.
[[nodiscard]] ProficiencyThreshold expertTolerance_deg(SessionContext& session, const ModuleId& moduleId,
                                                       const CohortId& expertCohortId);

}  // namespace torsio
