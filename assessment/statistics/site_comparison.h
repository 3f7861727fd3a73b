// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "assessment/statistics/adjusted_difference.h"
#include "assessment/statistics/site_trainees.h"
#include "assessment/statistics/values.h"

namespace torsio {

/// How the centre enters the comparison.
enum class SiteTerm : std::uint8_t { kFixed, kRandom };
/// With fewer centres their variance cannot be estimated, and each centre has a level of its own (fixed).
inline constexpr std::size_t kMinRandomSites = 5;
/// Returns the term for so many centres.
[[nodiscard]] constexpr SiteTerm siteTermFor(std::size_t sites) noexcept {
  return sites < kMinRandomSites ? SiteTerm::kFixed : SiteTerm::kRandom;
}

/// Comparison of groups within centres: score after on score before, group and centre, with a common slope.
struct SiteComparison {
  SiteTerm term = SiteTerm::kFixed;
  std::size_t trainees = 0;
  std::size_t sites = 0;
  /// Of the groups with trainees, (0,1), (0,2), ..., by index among all groups. Fixed centres: errors of HC3
  /// with the degrees of freedom of Bell and McCaffrey; random ones: those of the model, restricted maximum
  /// likelihood, degrees of freedom after Satterthwaite.
  std::vector<AdjustedDifference> pairs;
  double residualVariance = 0.0;
  double siteVariance = 0.0;  ///< of random centres; otherwise 0
};

/// Compares the groups of `trainees`. `withLevels`: with their levels as a further fixed factor. Undefined
/// for fewer than two groups or sites, too few trainees, no variation, or factors that cannot be told apart.
[[nodiscard]] Outcome<SiteComparison> compareWithinSites(const std::vector<SiteTrainee>& trainees,
                                                         SiteTerm term, bool withLevels = false,
                                                         double confidence = kDefaultConfidence);

}  // namespace torsio
