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

/// People of a demonstration. Nothing made from it is ever presented as a result of real people.
struct DemonstrationPeople {
  std::vector<std::vector<std::string>> groups;        ///< trainee codes of each of the three groups
  std::vector<std::string> raters;                     ///< who marks the trainees
  std::vector<std::vector<std::string>> raterClasses;  ///< who marks the models, one list a rater class
};

/// Simulates marks of the training study at three occasions, whole points on the scale, from the rule that
/// demonstrationTrainingRule() states. Same seed, same marks. Ordered by occasion, group, trainee, rater.
[[nodiscard]] std::vector<TrainingMark> demonstrationTrainingMarks(const ScoreScale& scale,
                                                                   const DemonstrationPeople& people,
                                                                   std::uint64_t seed);
/// States the rule of the training marks in words, for the report.
[[nodiscard]] Text demonstrationTrainingRule();

/// Simulates marks of every rater for every index of every model (PM, FEM, MSM; others like MSM), whole
/// points.
[[nodiscard]] std::vector<EvaluationRating> demonstrationEvaluationMarks(
    const EvaluationInstrument& instrument, const DemonstrationPeople& people,
    std::span<const std::string> models, std::uint64_t seed);
[[nodiscard]] Text demonstrationEvaluationRule();

}  // namespace torsio
