// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/signal.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

Biquad section(double warped) {
  const double k2 = warped * warped;
  const double root = std::numbers::sqrt2 * warped;
  const double scale = 1.0 + root + k2;
  return {k2 / scale, 2.0 * k2 / scale, k2 / scale, 2.0 * (k2 - 1.0) / scale, (1.0 - root + k2) / scale};
}

double warpedFrequency(double cutoff_Hz, double rate_Hz) {
  TORSIO_EXPECTS(cutoff_Hz > 0.0 && cutoff_Hz < 0.5 * rate_Hz);
  return std::tan(std::numbers::pi * cutoff_Hz / rate_Hz);
}

/// Filters once, as if the first value had been constant before.
void runSteady(const Biquad& f, std::vector<double>& x) {
  double z1 = (1.0 - f.b0) * x.front();
  double z2 = (f.b2 - f.a2) * x.front();
  for (double& value : x) {
    const double in = value;
    const double out = f.b0 * in + z1;
    z1 = f.b1 * in - f.a1 * out + z2;
    z2 = f.b2 * in - f.a2 * out;
    value = out;
  }
}

}  // namespace

Biquad butterworthForTwoPasses(double cutoff_Hz, double rate_Hz) {
  const double correction = std::pow(std::numbers::sqrt2 - 1.0, 0.25);
  return section(warpedFrequency(cutoff_Hz, rate_Hz) / correction);
}

std::vector<double> filterZeroPhase(const Biquad& filter, std::span<const double> signal,
                                    std::size_t reflected) {
  const std::size_t n = signal.size();
  if (n < 2) {
    return {signal.begin(), signal.end()};
  }
  const std::size_t pad = std::min(reflected, n - 1);
  std::vector<double> x;
  x.reserve(n + 2 * pad);
  for (std::size_t i = pad; i >= 1; --i) {
    x.push_back(2.0 * signal[0] - signal[i]);
  }
  for (const double value : signal) {
    x.push_back(value);
  }
  for (std::size_t i = 1; i <= pad; ++i) {
    x.push_back(2.0 * signal[n - 1] - signal[n - 1 - i]);
  }
  runSteady(filter, x);
  std::reverse(x.begin(), x.end());
  runSteady(filter, x);
  std::reverse(x.begin(), x.end());
  const auto first = x.begin() + static_cast<std::ptrdiff_t>(pad);
  return {first, first + static_cast<std::ptrdiff_t>(n)};
}

std::vector<double> lowPass(std::span<const double> signal, double cutoff_Hz, double rate_Hz) {
  return filterZeroPhase(butterworthForTwoPasses(cutoff_Hz, rate_Hz), signal);
}

std::vector<double> derivative(std::span<const double> signal, double rate_Hz) {
  const std::size_t n = signal.size();
  std::vector<double> out(n, 0.0);
  if (n < 2) {
    return out;
  }
  out[0] = (signal[1] - signal[0]) * rate_Hz;
  out[n - 1] = (signal[n - 1] - signal[n - 2]) * rate_Hz;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    out[i] = 0.5 * (signal[i + 1] - signal[i - 1]) * rate_Hz;
  }
  return out;
}

std::vector<std::size_t> longGaps(std::span<const std::int64_t> times_us) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i + 1 < times_us.size(); ++i) {
    if (static_cast<double>(times_us[i + 1] - times_us[i]) > 1e6 * kLargestGap_s) {
      out.push_back(i);
    }
  }
  return out;
}

namespace {

/// Returns the number of points of a uniform grid from the first to the last time stamp.
std::size_t gridPoints(std::span<const std::int64_t> times_us, double step_us) {
  const auto span_us = static_cast<double>(times_us.back() - times_us.front());
  return static_cast<std::size_t>(std::floor(span_us / step_us + 1e-9)) + 1;
}

}  // namespace

UniformSignal resampleUniform(std::span<const std::int64_t> times_us,
                              const std::vector<std::vector<double>>& channels, double rate_Hz) {
  TORSIO_EXPECTS(rate_Hz > 0.0);
  UniformSignal out;
  out.rate_Hz = rate_Hz;
  out.channels.resize(channels.size());
  if (times_us.empty()) {
    return out;
  }
  for (std::size_t i = 0; i + 1 < times_us.size(); ++i) {
    if (times_us[i + 1] <= times_us[i]) {
      throw Error(ErrorCode::kBadData, Text::verbatim("time stamps do not rise"),
                  Text::verbatim("sample %1", i + 1), Text::verbatim("Record the run again."));
    }
  }
  if (!longGaps(times_us).empty()) {
    throw Error(ErrorCode::kBadData, Text::verbatim("samples are missing for more than 20 ms"),
                Text::tr("run"), Text::verbatim("Split the run at the gap."));
  }
  const double step_us = 1e6 / rate_Hz;
  const std::size_t count = gridPoints(times_us, step_us);
  for (std::vector<double>& channel : out.channels) {
    channel.reserve(count);
  }
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * step_us;
    while (at + 2 < times_us.size() && static_cast<double>(times_us[at + 1] - times_us.front()) <= t) {
      ++at;
    }
    const std::size_t next = std::min(at + 1, times_us.size() - 1);
    const auto from = static_cast<double>(times_us[at] - times_us.front());
    const auto width = static_cast<double>(times_us[next] - times_us[at]);
    const double share = width > 0.0 ? std::clamp((t - from) / width, 0.0, 1.0) : 0.0;
    if (width > 1.5 * step_us && share > 0.0 && share < 1.0) {
      ++out.lost;
    }
    for (std::size_t c = 0; c < channels.size(); ++c) {
      out.channels[c].push_back(channels[c][at] + share * (channels[c][next] - channels[c][at]));
    }
  }
  return out;
}

std::vector<std::size_t> samplesInForce(std::span<const std::int64_t> times_us, double rate_Hz) {
  std::vector<std::size_t> held;
  if (times_us.empty()) {
    return held;
  }
  const double step_us = 1e6 / rate_Hz;
  const std::size_t count = gridPoints(times_us, step_us);
  held.reserve(count);
  std::size_t at = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * step_us;
    while (at + 1 < times_us.size() && static_cast<double>(times_us[at + 1] - times_us.front()) <= t) {
      ++at;
    }
    held.push_back(at);
  }
  return held;
}

double trapezoid(std::span<const double> signal, double rate_Hz) {
  if (signal.size() < 2) {
    return 0.0;
  }
  double sum = 0.5 * (signal.front() + signal.back());
  for (std::size_t i = 1; i + 1 < signal.size(); ++i) {
    sum += signal[i];
  }
  return sum / rate_Hz;
}

}  // namespace torsio
