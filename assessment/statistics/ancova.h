// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/values.h"

namespace torsio {

struct AdjustedMean {
  double mean = 0.0;  ///< at the grand mean of the covariate
  double error = 0.0;
  Interval interval;
};

struct AdjustedDifference {
  std::size_t first = 0;
  std::size_t second = 0;
  double difference = 0.0;  ///< adjusted mean of first minus that of second
  double error = 0.0;
  double t = 0.0;
  double p = 0.0;
  double pHolm = 0.0;
  Interval interval;  ///< not adjusted for the number of pairs
};

/// Analysis of covariance: score after on score before and group, one pooled slope. The primary analysis of
/// randomised groups with a score before and after training.
struct Ancova {
  double slope = 0.0;
  double slopeError = 0.0;
  FTest group;
  double residualVariance = 0.0;
  double residualDf = 0.0;
  std::vector<AdjustedMean> adjusted;
  std::vector<AdjustedDifference> pairs;  ///< (0,1), (0,2), ..., (1,2)
  Outcome<FTest> equalSlopes = Outcome<FTest>::undefined(Text::tr("not computed"));
  double partialEtaSquared = 0.0;
};

/// Compares groups by analysis of covariance. `before[g][i]` and `after[g][i]` belong to the same trainee;
/// means over raters, never single marks. Undefined for fewer than two groups, an empty group, too few
/// trainees, or when the scores before do not vary within groups.
[[nodiscard]] Outcome<Ancova> ancova(const Groups& before, const Groups& after,
                                     double confidence = kUsualConfidence);

}  // namespace torsio
