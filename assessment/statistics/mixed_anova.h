// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

/// Departure from sphericity, from the covariance pooled within groups.
struct Sphericity {
  double greenhouseGeisser = 1.0;
  double huynhFeldt = 1.0;          ///< Lecoutre's correction for groups; may exceed 1, applied as at most 1
  double huynhFeldtOriginal = 1.0;  ///< for comparison with older programs
  double mauchlyW = 1.0;
  double mauchlyChiSquared = 0.0;
  double mauchlyDf = 0.0;
  double mauchlyP = 1.0;
};

/// One effect with its error term.
struct AnovaEffect {
  double ss = 0.0;
  double df = 0.0;
  double ssError = 0.0;
  double dfError = 0.0;
  double f = 0.0;
  double p = 0.0;
  std::optional<double> pGreenhouseGeisser;  ///< within-subject effects only
  std::optional<double> pHuynhFeldt;
  double partialEtaSquared = 0.0;
  double generalizedEtaSquared = 0.0;
};

/// Groups x repeated measures. A training study asks about the interaction, not about the effect of time.
struct MixedAnova {
  std::optional<AnovaEffect> group;        ///< empty with one group
  AnovaEffect time;                        ///< type III: equal weight per group
  AnovaEffect timeTypeII;                  ///< equal weight per trainee; identical for equal groups
  std::optional<AnovaEffect> interaction;  ///< empty with one group
  Sphericity sphericity;
};

/// Analyses groups x repeated measures. `groups[g]`: trainees x occasions, complete; empty groups are left
/// out.
/// One group gives the repeated-measures analysis. Undefined for fewer than two occasions, fewer trainees
/// than
/// the covariance requires, or no residual variation.
[[nodiscard]] Outcome<MixedAnova> mixedAnova(const std::vector<NumberTable>& groups);

}  // namespace torsio
