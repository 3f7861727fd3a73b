// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/base/csv_table.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/values.h"

namespace torsio::cli {

/// Who was rated by whom, in the order in which the file names them.
struct RatingGrid {
  std::vector<std::string> targets;
  std::vector<std::string> raters;
  IncompleteRatings ratersByTarget;
  std::size_t given = 0;  ///< scores that are not missing
};

/// Reads the columns target, rater and score. Throws Error{kBadData} for a second score of one rater for one
/// target.
[[nodiscard]] RatingGrid readRatingGrid(const CsvTable& table);

/// Lays out the scores as targets x raters; undefined when one is missing.
[[nodiscard]] Outcome<NumberTable> completeTable(const RatingGrid& grid);

/// Lists the scores that occur, smallest first, each once.
[[nodiscard]] std::vector<double> distinctScores(const RatingGrid& grid);

/// Scores of two raters for the targets that both have rated, in the order of the targets.
struct SharedScores {
  std::vector<double> first;
  std::vector<double> second;
};
/// Gathers the scores of the raters numbered `first` and `second`.
[[nodiscard]] SharedScores sharedScores(const RatingGrid& grid, std::size_t first, std::size_t second);

/// One complete table, targets x raters, for each occasion or task.
struct FacetTables {
  std::vector<std::string> levels;
  std::size_t targets = 0;
  std::size_t raters = 0;  ///< on each level
  Outcome<std::vector<NumberTable>> tables =
      Outcome<std::vector<NumberTable>>::undefined(Text::tr("not read"));
};

/// Reads target, rater, score and the column that names the level. Raters are the same on every level
/// (`crossed`) or others on each. The tables are undefined when a score is missing or the levels have
/// different numbers of raters. Throws Error{kBadData} for a second score of one rater for one target on one
/// level.
[[nodiscard]] FacetTables readFacetTables(const CsvTable& table, const std::string& levelColumn,
                                          bool crossed);

}  // namespace torsio::cli
