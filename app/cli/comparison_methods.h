// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cli/study_table.h"

namespace torsio::cli {

// What `torsio compare-groups` prints; docs/cli.md has the keys. Private to app/cli.

/// How p values of several pairs of groups are adjusted.
enum class Adjustment { kHolm, kHochberg, kBonferroni, kBenjaminiHochberg };

/// Adds every test between the groups at one occasion to `out`. With more than two groups each pair carries p
/// by Holm, and by `adjustment` if that is another.
void addGroupTests(nlohmann::ordered_json& out, const std::vector<std::string>& names, const Groups& groups,
                   Adjustment adjustment);
/// Prints the analysis of covariance of the last occasion on the first.
[[nodiscard]] nlohmann::ordered_json ancovaJson(const Study& study);
/// Prints the analysis of variance of groups by occasions.
[[nodiscard]] nlohmann::ordered_json mixedAnovaJson(const Study& study);

/// Tests of the same subjects at several occasions.
enum class PairedTest { kT, kSignedRank, kPermutation, kFriedman };

/// Prints, for every group, the test of the last occasion against the first (Friedman: of all occasions) and
/// the correlation of the two.
[[nodiscard]] nlohmann::ordered_json pairedJson(const Study& study, PairedTest test);

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
