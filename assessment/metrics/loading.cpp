// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/loading.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/signal.h"

namespace torsio {

namespace {

/// Quantile of type 7 by partial ordering: sorting millions of samples would dominate the time.
double quantile95(std::span<const double> values) {
  std::vector<double> x(values.begin(), values.end());
  const double position = 0.95 * static_cast<double>(x.size() - 1);
  const auto below = static_cast<std::ptrdiff_t>(position);
  std::nth_element(x.begin(), x.begin() + below, x.end());
  const double low = x[static_cast<std::size_t>(below)];
  if (below + 1 >= std::ssize(x)) {
    return low;
  }
  const double high = *std::min_element(x.begin() + below + 1, x.end());
  return low + (position - static_cast<double>(below)) * (high - low);
}

}  // namespace

Outcome<Loading> loadingOf(std::span<const double> magnitude, double rate_Hz) {
  if (magnitude.size() < 2) {
    return Outcome<Loading>::undefined(Text::tr("there are fewer than two samples"));
  }
  Loading out;
  const double duration = static_cast<double>(magnitude.size() - 1) / rate_Hz;
  out.impulse = trapezoid(magnitude, rate_Hz);
  out.mean = out.impulse / duration;
  out.peak = *std::max_element(magnitude.begin(), magnitude.end());
  out.p95 = quantile95(magnitude);
  std::vector<double> squares;
  squares.reserve(magnitude.size());
  for (const double value : magnitude) {
    squares.push_back(value * value);
  }
  out.rms = std::sqrt(trapezoid(squares, rate_Hz) / duration);
  std::vector<double> rate = derivative(magnitude, rate_Hz);
  for (double& value : rate) {
    out.largestRate = std::max(out.largestRate, std::abs(value));
    value *= value;
  }
  out.rmsRate = std::sqrt(trapezoid(rate, rate_Hz) / duration);
  return out;
}

Violations violationsOf(std::span<const double> value, double limit, double rate_Hz) {
  struct Stretch {
    std::size_t from = 0;
    std::size_t to = 0;
  };
  std::vector<Stretch> stretches;
  std::vector<double> excess(value.size(), 0.0);
  Violations out;
  std::size_t above = 0;
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!(value[i] > limit)) {
      continue;
    }
    ++above;
    excess[i] = value[i] - limit;
    const bool joins =
        !stretches.empty() && static_cast<double>(i - stretches.back().to) < kMergeViolations_s * rate_Hz;
    if (joins) {
      stretches.back().to = i;
    } else {
      stretches.push_back({i, i});
    }
  }
  for (const Stretch& stretch : stretches) {
    if (static_cast<double>(stretch.to - stretch.from + 1) >= kIgnoreViolations_s * rate_Hz) {
      ++out.count;
    }
  }
  out.time_s = static_cast<double>(above) / rate_Hz;
  out.excessImpulse = trapezoid(excess, rate_Hz);
  return out;
}

Outcome<TwistWork> twistWork(std::span<const double> torque_Nm, std::span<const double> angle_rad) {
  TORSIO_EXPECTS(torque_Nm.size() == angle_rad.size());
  if (torque_Nm.size() < 2) {
    return Outcome<TwistWork>::undefined(Text::tr("there are fewer than two samples"));
  }
  TwistWork out;
  for (std::size_t i = 1; i < torque_Nm.size(); ++i) {
    const double work = 0.5 * (torque_Nm[i] + torque_Nm[i - 1]) * (angle_rad[i] - angle_rad[i - 1]);
    out.delivered_J += std::max(0.0, work);
    out.returned_J += std::max(0.0, -work);
  }
  out.loop_J = out.delivered_J - out.returned_J;
  return out;
}

}  // namespace torsio
