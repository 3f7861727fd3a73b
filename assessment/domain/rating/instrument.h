// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// The scale of an instrument. Marks are whole steps, so sums are exact and decimals such as 7.3 are not
/// rounded on input: points = steps / stepsPerPoint.
struct ScoreScale {
  std::int64_t lo = 0;    ///< lowest score, steps
  std::int64_t hi = 100;  ///< highest score, steps
  std::int64_t stepsPerPoint = 10;
};

/// Checks a scale. Throws Error{kBadParameter} unless lo < hi, 1 <= stepsPerPoint <= 1000 and |lo|, |hi| <=
/// 1e6.
void validateScale(const ScoreScale& scale);

[[nodiscard]] constexpr bool isOnScale(std::int64_t steps, const ScoreScale& scale) noexcept {
  return steps >= scale.lo && steps <= scale.hi;
}

/// Converts a decimal number of points ("7.5") to steps. Throws Error{kBadData} with `where` if the text is
/// not a plain decimal (a decimal comma, "nan", an exponent), lies between two steps, or is off the scale.
[[nodiscard]] std::int64_t stepsFromText(std::string_view text, const ScoreScale& scale,
                                         const std::string& where);

/// Converts points to steps. The value must be the double nearest to a step. Throws Error{kBadData} like
/// stepsFromText.
[[nodiscard]] std::int64_t stepsFromPoints(double points, const ScoreScale& scale, const std::string& where);

/// Checks that marks use their scale (Stated::kScaleUsed): scores out of 10 on a scale to 100 do not. Fewer
/// than ten marks, and marks that are all equal, say nothing. Throws Error{kBadData} with `where` and
/// `remedy`.
void requireScaleUsed(std::span<const std::int64_t> steps, const ScoreScale& scale, const std::string& where,
                      const Text& remedy);

[[nodiscard]] inline double pointsFromSteps(std::int64_t steps, const ScoreScale& scale) {
  return static_cast<double>(steps) / static_cast<double>(scale.stepsPerPoint);
}

/// A class of raters: interns, deputy chief physicians, chief physicians.
struct RaterClass {
  std::string id;    ///< "A"
  std::string name;  ///< "interns"
  std::int64_t weight_milli = 0;
};

/// One property of a model that raters score: effectiveness, force feedback ...
struct EvaluationIndex {
  std::string id;
  std::string name;
  std::int64_t weight_milli = 0;
};

inline constexpr std::int64_t kWeightSum_milli = 1000;

/// The indices put to the raters, and the weights of classes and indices. Weights in 1/1000 sum to exactly
/// 1000.
struct EvaluationInstrument {
  ScoreScale scale;
  std::vector<RaterClass> classes;
  std::vector<EvaluationIndex> indices;
};

/// Checks an instrument. Throws Error{kBadParameter} naming the invalid weight, class or index. Never
/// rescales.
void validateInstrument(const EvaluationInstrument& instrument);

/// Converts weights given as numbers (0.15) to 1/1000. Throws Error{kBadParameter} when one is negative,
/// not finite or no multiple of 0.001, or when they do not sum to 1 within 1e-12.
[[nodiscard]] std::vector<std::int64_t> weightsInMilli(const std::vector<double>& weights);

/// Returns the instrument of the paper, section 5.3: classes A, B, C with 0.2, 0.3, 0.5; nine indices with
/// 0.15 x4, 0.10 x3, 0.05 x2; marks from 0 to 10 in tenths.
[[nodiscard]] EvaluationInstrument paperInstrument();

/// Definition of an evaluation index in one sentence, with the meaning of its lowest, middle and highest
/// mark. The paper (section 5.3) names the nine indices without defining them: the wording is ours.
struct IndexMeaning {
  Text definition;
  Text lowest;
  Text middle;
  Text highest;
};

/// Returns the meaning of an index of paperInstrument(); empty for any other index.
[[nodiscard]] std::optional<IndexMeaning> indexMeaning(std::string_view indexId);

}  // namespace torsio
