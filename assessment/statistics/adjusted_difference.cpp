// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/adjusted_difference.h"

#include <vector>

#include "assessment/statistics/distributions.h"
#include "assessment/statistics/multiplicity.h"

namespace torsio {

AdjustedDifference adjustedDifference(std::size_t first, std::size_t second, double difference, double error,
                                      double df) {
  AdjustedDifference out;
  out.first = first;
  out.second = second;
  out.difference = difference;
  out.error = error;
  out.df = df;
  out.t = difference / error;
  out.p = tTwoSided(out.t, df);
  return out;
}

void addIntervals(std::span<AdjustedDifference> pairs, double confidence) {
  std::vector<double> p;
  for (const AdjustedDifference& pair : pairs) {
    p.push_back(pair.p);
  }
  const std::vector<double> adjusted = adjustHolm(p);
  const std::vector<double> factors = holmFactors(p);
  const double together = 1.0 - (1.0 - confidence) / static_cast<double>(pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    AdjustedDifference& pair = pairs[i];
    const auto with = [&pair](double level) {
      const double reach = tQuantile(0.5 * (1.0 + level), pair.df) * pair.error;
      return Interval{pair.difference - reach, pair.difference + reach};
    };
    pair.interval = with(confidence);
    pair.simultaneous = with(together);
    pair.pHolm = adjusted[i];
    pair.asHolm = holmInterval(pair.difference, pair.error, pair.df, factors[i], confidence);
  }
}

}  // namespace torsio
