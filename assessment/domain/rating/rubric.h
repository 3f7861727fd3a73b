// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// Description of what one score of a row means.
struct RubricAnchor {
  std::int64_t score_steps = 0;
  std::string meaning{};
};

/// Weight of a row unless the author chooses another.
inline constexpr std::int64_t kDefaultWeight_milli = 1000;

/// One row of a rubric.
struct RubricLine {
  std::string code{};  ///< "proficiency"
  std::string label{};
  ScoreScale scale{};
  std::vector<RubricAnchor> anchors{};
  std::int64_t weight_milli = kDefaultWeight_milli;  ///< in the mean of the criteria; 0: left out
};

/// A version of a rubric. Immutable once stored.
struct RubricRevision {
  RubricRevisionId id{};
  RubricId rubricId{};
  std::int64_t number = 1;
  std::string note{};
  ScoreScale overall{};  ///< of the overall mark
  std::vector<RubricLine> rows{};
  std::string createdBy{};
  std::int64_t createdUtc_us = 0;
};

/// A rubric as listed.
struct Rubric {
  RubricId id{};
  std::string name{};  ///< unique
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
