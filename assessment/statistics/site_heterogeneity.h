// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "assessment/statistics/site_trainees.h"
#include "assessment/statistics/values.h"

namespace torsio {

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

/// Returns for each pair of groups how its differences vary between the centres. Undefined
/// for fewer than two groups or sites, too few trainees, no variation, or if no pair is at two centres.
[[nodiscard]] Outcome<std::vector<Heterogeneity>> heterogeneityOfSites(
    const std::vector<SiteTrainee>& trainees, double confidence = kDefaultConfidence);

}  // namespace torsio
