// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/rating_grid.h"

namespace torsio::cli {

// Output of `torsio agreement --method`, one function per method; docs/cli.md lists the keys. Private to
// app/cli.

/// Options of the methods.
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
