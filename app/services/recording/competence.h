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
#include "sim/core/text.h"

namespace torsio {

class Connection;

/// Returns whether the rules of a module are about untwisting.
[[nodiscard]] bool asksForUntwisting(const TrainingModule& module);

/// Returns whether a trainee must be competent at a module to be competent altogether: the graded modules of
/// a curriculum, or all if none is graded.
[[nodiscard]] bool isRequired(const CurriculumVersion& version, const TrainingModule& module);

/// Returns whether a run in this mode counts for a module: graded, or any mode in a practice module.
[[nodiscard]] bool countsAt(const TrainingModule& module, std::optional<AttemptMode> mode) noexcept;

/// Returns a module's rule of competence for a design.
[[nodiscard]] CompetenceRule ruleOf(const TrainingModule& module, const CompetenceDesign& design);

/// Returns the verdict on a trainee at one module: the design in use, its error rates, the level. Trainee's
/// screen, transcript, report and export all use it. Measures recordings not measured yet and stores the
/// results. Ignores runs that began after `lastUtc_us`, to show past states. Throws Error, DbError.
[[nodiscard]] CompetenceVerdict competenceOf(
    Connection& connection, const std::string& traineeCode, const TrainingModule& module,
    ExerciseRules& rules, std::int64_t now_us,
    std::int64_t lastUtc_us = std::numeric_limits<std::int64_t>::max());

/// Estimates how the runs of one trainee at a module depend on each other; empty with too few runs.
[[nodiscard]] EstimatedDependence centreDependence(Connection& connection, const TrainingModule& module,
                                                   ExerciseRules& rules, std::int64_t now_us);

/// Returns the verdicts on everybody at every required or attempted module of a curriculum version, for the
/// report. Empty without a version.
[[nodiscard]] std::vector<CohortCompetence> competenceOfCohort(Connection& connection,
                                                               const CurriculumVersionId& versionId,
                                                               const std::vector<CohortTrainee>& trainees,
                                                               ExerciseRules& rules, std::int64_t now_us);

// Texts of a competence verdict, the same everywhere.

/// Returns "4.9 %"; "below 0.1 %" for less than a twentieth of a percent.
[[nodiscard]] std::string percentText(double share);

/// Describes the whole rule: design, what a run needs to pass, failure rates, runs.
[[nodiscard]] Text competenceRuleText(const CompetenceRule& rule);
/// Sums up how often chance decides, "About 1 in 41 ..., about 1 in 12 ...": what stands beside every level.
[[nodiscard]] Text competenceChanceText(const CompetenceDesign& design);
/// Describes how probable it is to be declared competent within the runs planned, by the true failure rate,
/// and what this assumes.
[[nodiscard]] Text competenceErrorText(const CompetenceDesign& design);
/// Describes how probable it is to be declared competent within the runs made.
[[nodiscard]] Text competenceMadeText(const CompetenceVerdict& verdict);
/// Both of the above.
[[nodiscard]] Text competenceErrorText(const CompetenceVerdict& verdict);
/// Names the level, and the number of attempts that it is based on.
[[nodiscard]] Text competenceLevelText(const CompetenceVerdict& verdict);

}  // namespace torsio
