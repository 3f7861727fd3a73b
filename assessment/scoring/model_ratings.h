// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// One mark: a rater scores one index of one model. Empty steps are a mark that was not given.
struct EvaluationRating {
  std::string model;
  std::string rater;
  std::size_t raterClass = 0;  ///< position in EvaluationInstrument::classes
  std::size_t index = 0;       ///< position in EvaluationInstrument::indices
  std::optional<std::int64_t> steps;
};

/// All marks of one rater for one model.
struct RaterSheet {
  std::string rater;
  std::size_t raterClass = 0;
  std::vector<std::optional<std::int64_t>> steps;  ///< one an index
};

struct ModelRatings {
  std::string model;
  std::vector<RaterSheet> sheets;  ///< ordered by class, then by rater
};

/// Groups marks by model, in the order in which the models first appear. Throws Error{kBadData} that names
/// rater, index and model when a mark lies outside the scale, appears twice, or when a rater appears in two
/// classes.
[[nodiscard]] std::vector<ModelRatings> groupRatings(const EvaluationInstrument& instrument,
                                                     std::span<const EvaluationRating> ratings);

}  // namespace torsio
