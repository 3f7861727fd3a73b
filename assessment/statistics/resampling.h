// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "assessment/statistics/values.h"

namespace torsio {

/// A statistic of the trainees with these indices, possibly repeated. Must be finite.
using ResampledStatistic = std::function<double(std::span<const std::size_t> trainees)>;

struct Jackknife {
  double error = 0.0;
  double acceleration = 0.0;
};
/// Leaves out one trainee at a time; error and acceleration are 0 if that changes nothing. Undefined for
/// fewer
/// than three.
[[nodiscard]] Outcome<Jackknife> jackknife(std::size_t trainees, const ResampledStatistic& statistic);

struct BootstrapOptions {
  std::uint64_t seed = 1;
  std::int64_t resamples = 9999;
  bool everyResample = false;  ///< all n^n ordered resamples instead of random ones; n^n <= 1e6
  double confidence = kDefaultConfidence;
};

/// Bootstrap intervals by resampling trainees. Quantiles are of type 1 (inverse of the empirical
/// distribution); ties in z0 count half; the variance has divisor `resamples`. With about ten trainees these
/// intervals are too short. The acceleration is 0 if leaving out any one trainee changes nothing (a median
/// among equals). Undefined for fewer than three trainees, or if no resample changes the statistic.
struct Bootstrap {
  double estimate = 0.0;
  std::int64_t resamples = 0;
  double error = 0.0;
  double z0 = 0.0;
  double acceleration = 0.0;
  Interval percentile;
  Interval basic;
  Interval bca;
  Interval bcaLevels;
};
[[nodiscard]] Outcome<Bootstrap> bootstrap(std::size_t trainees, const ResampledStatistic& statistic,
                                           const BootstrapOptions& options = {});

struct Correlation {
  double r = 0.0;
  std::optional<Interval> fisherInterval;  ///< empty for fewer than four pairs or |r| = 1
};
[[nodiscard]] Outcome<Correlation> pearson(std::span<const double> x, std::span<const double> y,
                                           double confidence = kDefaultConfidence);

}  // namespace torsio
