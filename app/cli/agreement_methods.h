// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/rating_grid.h"

namespace torsio::cli {

// What `torsio agreement --method` prints, one function a method; docs/cli.md has the keys. Private to
// app/cli.

/// What the options of the methods say.
struct AgreementOptions {
  std::vector<double> categories;       ///< kappa: the full list in order; empty: the scores that occur
  std::string disagreement;             ///< kappa: file with own weights; empty: none
  std::uint64_t seed = 1;               ///< krippendorff
  std::optional<int> resamples;         ///< krippendorff; empty: as many as take about a second
  std::optional<std::int64_t> lowest;   ///< rasch: of the scale; empty: the lowest score that occurs
  std::optional<std::int64_t> highest;  ///< rasch
  std::vector<double> raters;           ///< generalizability: numbers to plan with; empty: as in the study
  std::vector<double> occasions;
  std::vector<double> tasks;
};

/// Prints ICC, Krippendorff, Kendall, Cronbach and the standard error of measurement.
[[nodiscard]] nlohmann::ordered_json overviewJson(const RatingGrid& grid);
/// Prints the six intraclass correlations with the mean squares and variances behind them.
[[nodiscard]] nlohmann::ordered_json intraclassJson(const RatingGrid& grid);
/// Prints Krippendorff's alpha for every metric, with intervals from resampled targets.
[[nodiscard]] nlohmann::ordered_json krippendorffJson(const RatingGrid& grid,
                                                      const AgreementOptions& options);
/// Prints Cohen's kappa for every pair of raters and Fleiss' kappa for all. Throws Error{kBadData} for a
/// score outside the categories or a faulty file of disagreements.
[[nodiscard]] nlohmann::ordered_json kappaJson(const RatingGrid& grid, const AgreementOptions& options);
/// Prints limits of agreement for every pair of raters, and of each rater against the mean of the others.
[[nodiscard]] nlohmann::ordered_json blandAltmanJson(const RatingGrid& grid);
/// Prints abilities, severities and thresholds of the many-facet rating scale model. Throws Error{kBadData}
/// for a score that is no whole number or lies outside the scale.
[[nodiscard]] nlohmann::ordered_json raschJson(const RatingGrid& grid, const AgreementOptions& options);
/// Prints variance components and what other numbers of raters, occasions or tasks would give. The columns
/// occasion and task choose the design; Throws Error{kBadData} when both are there.
[[nodiscard]] nlohmann::ordered_json generalizabilityJson(const CsvTable& table,
                                                          const AgreementOptions& options);

}  // namespace torsio::cli
