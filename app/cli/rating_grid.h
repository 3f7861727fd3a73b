// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/values.h"

namespace torsio::cli {

/// Ratings of targets by raters, in file order.
struct RatingGrid {
  std::vector<std::string> targets;
  std::vector<std::string> raters;
  IncompleteRatings ratersByTarget;
  std::size_t given = 0;             ///< number of scores given
  std::vector<std::string> groups;   ///< of the targets; empty: the table has no column group
  std::vector<std::size_t> groupOf;  ///< for each target, if there are groups
};

/// Reads the columns target, rater, score, and group if present. Throws Error{kBadData} for a duplicate score
/// of a rater for a target, and for a target in two groups.
[[nodiscard]] RatingGrid readRatingGrid(const CsvTable& table);

/// Targets scored by every rater (complete cases).
struct CompleteTargets {
  Outcome<NumberTable> table =
      Outcome<NumberTable>::undefined(Text::tr("not read"));  ///< targets x raters; undefined: none complete
  std::vector<std::string> leftOut;                           ///< the other targets
};

/// Returns the scores of the complete targets; `group`: only those of one group.
[[nodiscard]] CompleteTargets completeTargets(const RatingGrid& grid,
                                              std::optional<std::size_t> group = std::nullopt);

/// Returns the distinct scores, ascending.
[[nodiscard]] std::vector<double> distinctScores(const RatingGrid& grid);

/// Scores of two raters for the targets that both rated, in target order.
struct SharedScores {
  std::vector<double> first;
  std::vector<double> second;
};
/// Returns the common scores of raters `first` and `second`.
[[nodiscard]] SharedScores sharedScores(const RatingGrid& grid, std::size_t first, std::size_t second);

/// One complete table, targets x raters, for each occasion or task.
struct FacetTables {
  std::vector<std::string> levels;
  std::vector<std::string> leftOut;  ///< targets without a score by every rater at every level
  std::size_t raters = 0;            ///< at each level
  Outcome<std::vector<NumberTable>> tables =
      Outcome<std::vector<NumberTable>>::undefined(Text::tr("not read"));
};

/// Reads target, rater, score and the level column. Raters are the same at every level (`crossed`) or
/// different at each. The tables contain the targets scored by every rater at every level; undefined if there
/// are none or the numbers of raters differ between levels. Throws Error{kBadData} for a duplicate score of a
/// rater for a target at a level.
[[nodiscard]] FacetTables readFacetTables(const CsvTable& table, const std::string& levelColumn,
                                          bool crossed);

}  // namespace torsio::cli
