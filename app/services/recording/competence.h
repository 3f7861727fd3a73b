// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/services/recording/kept_digests.h"
#include "assessment/attempt/competence.h"
#include "assessment/attempt/mastery.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/protocol_terms.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

class Connection;

/// Whether the rules of a module ask for the untwisting of an organ.
[[nodiscard]] bool asksForUntwisting(const TrainingModule& module);

/// Whether a run in this mode counts at a module: graded, unless the module is there for practice.
[[nodiscard]] bool countsAt(const TrainingModule& module, std::optional<AttemptMode> mode) noexcept;

/// The rule of competence of a module by a design; whether organs are untwisted as far as its rules tell.
[[nodiscard]] CompetenceRule ruleOf(const TrainingModule& module, const CompetenceDesign& design);

/// Judges a trainee at one module: the design in force, its error rates, the level. Trainee's screen,
/// transcript, report and export all show this answer and compute none of their own. Recordings that were not
/// measured yet are measured and kept. Runs that began after `lastUtc_us` do not count: what was so then.
/// Throws Error, DbError.
[[nodiscard]] CompetenceVerdict competenceOf(
    Connection& connection, const std::string& traineeCode, const TrainingModule& module,
    ExerciseRules& rules, std::int64_t now_us,
    std::int64_t lastUtc_us = std::numeric_limits<std::int64_t>::max());

/// Judges everybody at every module of a curriculum version where there is an attempt, for the report. No
/// version: nobody.
[[nodiscard]] std::vector<CohortCompetence> competenceOfCohort(Connection& connection,
                                                               const CurriculumVersionId& versionId,
                                                               const std::vector<CohortTrainee>& trainees,
                                                               ExerciseRules& rules, std::int64_t now_us);

}  // namespace torsio
