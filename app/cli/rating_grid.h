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

/// Who was rated by whom, in the order in which the file names them.
struct RatingGrid {
  std::vector<std::string> targets;
  std::vector<std::string> raters;
  IncompleteRatings ratersByTarget;
  std::size_t given = 0;             ///< scores that are not missing
  std::vector<std::string> groups;   ///< of the targets; empty: the table has no column group
  std::vector<std::size_t> groupOf;  ///< for each target, where there are groups
};

/// Reads the columns target, rater and score, and group where there is one. Throws Error{kBadData} for a
/// second score of one rater for one target, and for a target in two groups.
[[nodiscard]] RatingGrid readRatingGrid(const CsvTable& table);

/// The targets that every rater scored (complete cases).
struct CompleteTargets {
  Outcome<NumberTable> table =
      Outcome<NumberTable>::undefined(Text::tr("not read"));  ///< targets x raters; undefined: there are none
  std::vector<std::string> leftOut;                           ///< the other targets
};

/// Lays out the scores of the targets that every rater scored; `group`: only those of one.
[[nodiscard]] CompleteTargets completeTargets(const RatingGrid& grid,
                                              std::optional<std::size_t> group = std::nullopt);

/// Lists the scores that occur, smallest first, each once.
[[nodiscard]] std::vector<double> distinctScores(const RatingGrid& grid);

/// Scores of two raters for the targets that both have rated, in the order of the targets.
struct SharedScores {
  std::vector<double> first;
  std::vector<double> second;
};
/// Gathers the scores of the raters numbered `first` and `second`.
[[nodiscard]] SharedScores sharedScores(const RatingGrid& grid, std::size_t first, std::size_t second);

/// One table without holes, targets x raters, for each occasion or task.
struct FacetTables {
  std::vector<std::string> levels;
  std::vector<std::string> leftOut;  ///< targets without a score by every rater on every level
  std::size_t raters = 0;            ///< on each level
  Outcome<std::vector<NumberTable>> tables =
      Outcome<std::vector<NumberTable>>::undefined(Text::tr("not read"));
};

/// Reads target, rater, score and the column that names the level. Raters are the same on every level
/// (`crossed`) or others on each. The tables hold the targets that every rater scored on every level;
/// undefined when there are none or the levels have different numbers of raters. Throws Error{kBadData} for a
/// second score of one rater for one target on one level.
[[nodiscard]] FacetTables readFacetTables(const CsvTable& table, const std::string& levelColumn,
                                          bool crossed);

}  // namespace torsio::cli
