// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/training_scores.h"
#include "sim/core/text.h"

namespace torsio {

/// Simulated people. Nothing computed from them is ever presented as a result of real people.
struct DemonstrationPeople {
  std::vector<std::vector<std::string>> groups;        ///< trainee codes of each of the three groups
  std::vector<std::string> raters;                     ///< raters of the trainees
  std::vector<std::vector<std::string>> raterClasses;  ///< raters of the models, one list per rater class
};

/// Simulates marks of the training study at three occasions in whole points, following the model described by
/// demonstrationTrainingRule(). Same seed, same marks. Ordered by occasion, group, trainee, rater.
[[nodiscard]] std::vector<TrainingMark> demonstrationTrainingMarks(const ScoreScale& scale,
                                                                   const DemonstrationPeople& people,
                                                                   std::uint64_t seed);
/// Returns the description of the training model for the report.
[[nodiscard]] Text demonstrationTrainingRule();

/// Simulates the marks of every rater for every index of every model (PM, FEM, MSM; others like MSM) in whole
/// points.
[[nodiscard]] std::vector<EvaluationRating> demonstrationEvaluationMarks(
    const EvaluationInstrument& instrument, const DemonstrationPeople& people,
    std::span<const std::string> models, std::uint64_t seed);
[[nodiscard]] Text demonstrationEvaluationRule();

}  // namespace torsio
