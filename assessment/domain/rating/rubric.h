// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/rating/instrument.h"

namespace torsio {

/// What a score of a row means, in words.
struct RubricAnchor {
  std::int64_t score_steps = 0;
  std::string meaning{};
};

/// Of a row whose weight nobody chose.
inline constexpr std::int64_t kDefaultWeight_milli = 1000;

/// One line of a rubric.
struct RubricLine {
  std::string code{};  ///< "proficiency"
  std::string label{};
  ScoreScale scale{};
  std::vector<RubricAnchor> anchors{};
  std::int64_t weight_milli = kDefaultWeight_milli;  ///< in the mean of the criteria; 0: left out
};

/// A rubric as it was at one time. Never changes once stored.
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

/// A rubric in a list.
struct Rubric {
  RubricId id{};
  std::string name{};  ///< unique
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

}  // namespace torsio
