// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/study_table.h"
#include "assessment/statistics/rank_tests.h"

namespace torsio::cli {

// What `torsio compare-groups` prints; docs/cli.md has the keys. Private to app/cli.

/// How p values of several pairs of groups are adjusted.
enum class Adjustment { kHolm, kHochberg, kBonferroni, kBenjaminiHochberg };

/// How the tests of groups at one occasion are made.
struct GroupRequest {
  Adjustment adjustment = Adjustment::kHolm;
  std::optional<double> margin;  ///< of equivalence, in the unit of the scores; empty: not tested
  std::uint64_t seed = 1;        ///< of permutations that are too many to count
};
/// Adds every test between the groups at one occasion to `out`. With more than two groups each pair carries p
/// by Holm, and by `adjustment` if that is another; intervals are not adjusted unless their name says so.
void addGroupTests(nlohmann::ordered_json& out, const std::vector<std::string>& names, const Groups& groups,
                   const GroupRequest& request);
/// Prints a difference tested for equivalence.
[[nodiscard]] nlohmann::ordered_json equivalenceJson(double difference, double error, double df,
                                                     double margin);
/// What groups are compared by when somebody has scores at two occasions.
struct CovarianceRequest {
  std::string covariate;
  std::string outcome;            ///< another occasion
  std::optional<double> margin;   ///< of equivalence, points; empty: not tested
  std::optional<Interval> scale;  ///< lowest and highest mark, for bounds; empty: none
  bool residuals = false;         ///< what is left of each subject, for plots
};
/// Prints the analysis of covariance of the outcome on the covariate.
[[nodiscard]] nlohmann::ordered_json ancovaJson(const Study& study, const CovarianceRequest& request);
/// Prints the same by the mixed model of single marks, whose marks are missing, and the bounds of that.
[[nodiscard]] nlohmann::ordered_json mixedModelJson(const Study& study, const CovarianceRequest& request);
/// Prints the analysis of variance of groups by occasions.
[[nodiscard]] nlohmann::ordered_json mixedAnovaJson(const Study& study);

/// Tests of the same subjects at several occasions.
enum class PairedTest { kT, kSignedRank, kPermutation, kFriedman };

/// Returns how permutations are made so that `tests` tests of `size` numbers each take some tenths of a
/// second in all: how many are counted, and how many random ones stand for those that are too many.
[[nodiscard]] MonteCarlo permutationsWithin(std::uint64_t seed, double size, double tests);
/// Says whether every permutation was counted, and of random ones how far p may be off.
void addMonteCarlo(bool exact, double error, const MonteCarlo& choice, nlohmann::ordered_json& out);

/// Prints, for every group, the test of the last occasion against the first (Friedman: of all occasions) and
/// the correlation of the two.
[[nodiscard]] nlohmann::ordered_json pairedJson(const Study& study, PairedTest test, std::uint64_t seed);

/// Which statistic is resampled, and how.
struct BootstrapRequest {
  bool median = false;         ///< otherwise the mean
  bool everyResample = false;  ///< all n^n resamples instead of a random choice
  std::uint64_t seed = 1;
  std::int64_t resamples = 9999;
};

/// Prints bootstrap intervals for every list of values, labelled by the name of its group.
[[nodiscard]] nlohmann::ordered_json bootstrapJson(const std::vector<std::string>& names,
                                                   const Groups& values, const BootstrapRequest& request);
/// The gains of each group: last occasion minus first, of the subjects with both.
[[nodiscard]] Groups gainsOf(const Study& study);

}  // namespace torsio::cli
