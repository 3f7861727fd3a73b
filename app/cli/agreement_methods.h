// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/values.h"

namespace torsio::cli {

/// Ratings of targets, in file order, by raters, in the order of their names.
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

// Output of `torsio agreement --method`, one function per method; docs/cli.md lists the keys. Private to
// app/cli.

struct AgreementOptions {
  std::vector<double> categories;       ///< kappa: all categories in order; empty: the scores that occur
  std::string disagreement;             ///< kappa: file with custom disagreements; empty: none
  std::uint64_t seed = 1;               ///< krippendorff
  std::optional<int> resamples;         ///< krippendorff; empty: as many as take about a second
  std::optional<std::int64_t> lowest;   ///< rasch: end of the scale; empty: the lowest score that occurs
  std::optional<std::int64_t> highest;  ///< rasch
  std::vector<double> raters;           ///< generalizability: numbers to plan with; empty: as in the study
  std::vector<double> occasions;
  std::vector<double> tasks;
};

/// Returns ICC, Krippendorff, Kendall, Cronbach and the standard error of measurement.
[[nodiscard]] nlohmann::ordered_json overviewJson(const RatingGrid& grid);
/// Returns the six intraclass correlations with their mean squares and variances.
[[nodiscard]] nlohmann::ordered_json intraclassJson(const RatingGrid& grid);
/// Returns Krippendorff's alpha for every metric, with intervals from resampled targets.
[[nodiscard]] nlohmann::ordered_json krippendorffJson(const RatingGrid& grid,
                                                      const AgreementOptions& options);
/// Returns Cohen's kappa for every pair of raters and Fleiss' kappa for all. Throws Error{kBadData} for a
/// score outside the categories or an invalid file of disagreements.
[[nodiscard]] nlohmann::ordered_json kappaJson(const RatingGrid& grid, const AgreementOptions& options);
/// Returns limits of agreement for every pair of raters, and of each rater against the mean of the others.
[[nodiscard]] nlohmann::ordered_json blandAltmanJson(const RatingGrid& grid);
/// Returns abilities, severities and thresholds of the many-facet rating scale model. Throws Error{kBadData}
/// for a score that is not an integer or is off the scale.
[[nodiscard]] nlohmann::ordered_json raschJson(const RatingGrid& grid, const AgreementOptions& options);
/// Returns variance components and the projection to other numbers of raters, occasions or tasks. The column
/// occasion or task selects the design; throws Error{kBadData} if both are present.
[[nodiscard]] nlohmann::ordered_json generalizabilityJson(const CsvTable& table,
                                                          const AgreementOptions& options);

}  // namespace torsio::cli
