// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/values.h"

namespace torsio {

/// A trainee of a trial of several centres.
struct SiteTrainee {
  std::size_t group = 0;
  std::size_t site = 0;
  double before = 0.0;
  double after = 0.0;
  std::size_t level = 0;  ///< of a further factor: device, station
};

/// How the centre enters the comparison.
enum class SiteTerm : std::uint8_t { kFixed, kRandom };
/// With fewer centres their variance cannot be estimated, and each centre has a level of its own (fixed).
inline constexpr std::size_t kFewestRandomSites = 5;
/// Returns the term for so many centres.
[[nodiscard]] constexpr SiteTerm siteTermFor(std::size_t sites) noexcept {
  return sites < kFewestRandomSites ? SiteTerm::kFixed : SiteTerm::kRandom;
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

/// A difference at one centre, adjusted with the slope and the residual variance of all.
struct SiteDifference {
  std::size_t site = 0;
  std::size_t first = 0;   ///< number of trainees of the first group
  std::size_t second = 0;  ///< of the second
  double difference = 0.0;
  double error = 0.0;
  Interval interval;
};

/// How far a difference varies from centre to centre.
struct Heterogeneity {
  std::size_t first = 0;  ///< group
  std::size_t second = 0;
  std::vector<SiteDifference> sites;  ///< that have both groups
  double q = 0.0;                     ///< Cochran
  double p = 0.0;
  double iSquared = 0.0;    ///< share of the variation that is not chance, 0 to 1 (Higgins and Thompson 2002)
  double tauSquared = 0.0;  ///< variance of the true differences, points squared (Paule and Mandel 1982)
  Interval tauInterval;     ///< of it, by profiling Q (Viechtbauer 2007)
  double average = 0.0;     ///< of the true differences of centres like these
  Interval averageInterval;  ///< of it (Hartung and Knapp 2001; never shorter than with equal centres)
};

/// Returns for each pair of groups how its differences vary between the centres. Undefined like
/// compareWithinSites(), and if no pair is at two centres.
[[nodiscard]] Outcome<std::vector<Heterogeneity>> heterogeneityOfSites(
    const std::vector<SiteTrainee>& trainees, double confidence = kDefaultConfidence);

}  // namespace torsio
