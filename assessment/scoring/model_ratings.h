// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// One mark of a rater for an index of a model. Empty steps: missing.
struct EvaluationRating {
  std::string model;
  std::string rater;
  std::size_t raterClass = 0;  ///< position in EvaluationInstrument::classes
  std::size_t index = 0;       ///< position in EvaluationInstrument::indices
  std::optional<std::int64_t> steps;
  EvaluationMarkId id{};  ///< empty: it is not in the record
};

/// The marks of one rater for one model.
struct RaterSheet {
  std::string rater;
  std::size_t raterClass = 0;
  std::vector<std::optional<std::int64_t>> steps;  ///< one per index
  std::vector<EvaluationMarkId> marks{};           ///< one per index, or none

  /// Returns the mark of an index; empty: it is not in the record.
  [[nodiscard]] EvaluationMarkId markOf(std::size_t index) const {
    return index < marks.size() ? marks[index] : EvaluationMarkId();
  }
};

struct ModelRatings {
  std::string model;
  std::vector<RaterSheet> sheets;  ///< ordered by class, then by rater
};

/// Groups marks by model in order of first appearance. Throws Error{kBadData} naming rater, index and model
/// if a mark is off the scale or duplicate, or a rater appears in two classes.
[[nodiscard]] std::vector<ModelRatings> groupRatings(const EvaluationInstrument& instrument,
                                                     std::span<const EvaluationRating> ratings);

}  // namespace torsio
