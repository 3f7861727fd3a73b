// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/tracking.h"

#include <algorithm>
#include <cmath>

#include "assessment/metrics/signal.h"
#include "assessment/statistics/descriptive.h"

namespace torsio {

TargetApproach targetApproach(std::span<const double> angle, double target, double tolerance,
                              double rate_Hz) {
  TORSIO_EXPECTS(target != 0.0 && tolerance > 0.0);
  const double side = target > 0.0 ? 1.0 : -1.0;
  TargetApproach out;
  bool reached = false;
  bool beyond = false;
  std::size_t lastOutside = 0;
  bool everOutside = false;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const double past = side * (angle[i] - target);
    const bool inside = std::abs(past) <= tolerance;
    if (inside && !out.timeToTarget) {
      out.timeToTarget = static_cast<double>(i) / rate_Hz;
    }
    if (!inside) {
      lastOutside = i;
      everOutside = true;
    }
    reached = reached || past >= 0.0;
    if (!reached) {
      continue;
    }
    out.overshoot = std::max(out.overshoot, past);
    if (past > tolerance && !beyond) {
      ++out.excursions;
    }
    beyond = past > tolerance;
  }
  const std::size_t start = everOutside ? lastOutside + 1 : 0;
  if (start < angle.size()) {
    out.settling = static_cast<double>(start) / rate_Hz;
  }
  return out;
}

namespace {

/// Correlates actual[i + lag] with target[i] over their overlap, using every `stride`-th sample.
double correlationAt(std::span<const double> actual, std::span<const double> target, std::ptrdiff_t lag,
                     std::size_t stride) {
  const std::ptrdiff_t n = std::ssize(actual) - std::abs(lag);
  const std::size_t a0 = lag > 0 ? static_cast<std::size_t>(lag) : 0;
  const std::size_t t0 = lag < 0 ? static_cast<std::size_t>(-lag) : 0;
  const std::span<const double> a = actual.subspan(a0, static_cast<std::size_t>(n));
  const std::span<const double> t = target.subspan(t0, static_cast<std::size_t>(n));
  double ma = 0.0;
  double mt = 0.0;
  for (std::size_t i = 0; i < a.size(); i += stride) {
    ma += a[i];
    mt += t[i];
  }
  const double looked = std::ceil(static_cast<double>(n) / static_cast<double>(stride));
  ma /= looked;
  mt /= looked;
  double at = 0.0;
  double aa = 0.0;
  double tt = 0.0;
  for (std::size_t i = 0; i < a.size(); i += stride) {
    at += (a[i] - ma) * (t[i] - mt);
    aa += (a[i] - ma) * (a[i] - ma);
    tt += (t[i] - mt) * (t[i] - mt);
  }
  return aa > 0.0 && tt > 0.0 ? at / std::sqrt(aa * tt) : -2.0;
}

struct LagSearch {
  double best = -2.0;
  std::ptrdiff_t lag = 0;
};

LagSearch searchLag(std::span<const double> actual, std::span<const double> target, std::ptrdiff_t from,
                    std::ptrdiff_t to, std::size_t stride) {
  LagSearch out;
  for (std::ptrdiff_t candidate = from; candidate <= to; candidate += static_cast<std::ptrdiff_t>(stride)) {
    const double r = correlationAt(actual, target, candidate, stride);
    // Near-ties go to the smaller lag.
    if (r > out.best + 1e-12 || (r > out.best - 1e-12 && std::abs(candidate) < std::abs(out.lag))) {
      out.best = std::max(out.best, r);
      out.lag = candidate;
    }
  }
  return out;
}

void addLag(std::span<const double> actual, std::span<const double> target, double rate_Hz,
            TrackingError& out) {
  constexpr std::size_t kLongSignal = 20'000;
  constexpr std::size_t kCoarse = 10;  // 10 ms at 1 kHz: much shorter than changes of a hand's course
  const auto reach =
      std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(kLargestLag_s * rate_Hz), std::ssize(actual) / 2);
  LagSearch search{-2.0, 0};
  if (actual.size() <= kLongSignal) {
    search = searchLag(actual, target, -reach, reach, 1);
  } else {
    const std::ptrdiff_t near = searchLag(actual, target, -reach, reach, kCoarse).lag;
    constexpr auto kStep = static_cast<std::ptrdiff_t>(kCoarse);
    search = searchLag(actual, target, std::max(-reach, near - kStep), std::min(reach, near + kStep), 1);
  }
  const double best = search.best;
  const std::ptrdiff_t lag = search.lag;
  if (best < -1.5) {
    return;
  }
  out.lag_s = static_cast<double>(lag) / rate_Hz;
  double squares = 0.0;
  const std::ptrdiff_t n = std::ssize(actual) - std::abs(lag);
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const std::ptrdiff_t a = i + std::max<std::ptrdiff_t>(lag, 0);
    const std::ptrdiff_t t = i + std::max<std::ptrdiff_t>(-lag, 0);
    const double d = actual[static_cast<std::size_t>(a)] - target[static_cast<std::size_t>(t)];
    squares += d * d;
  }
  out.rmseWithoutLag = std::sqrt(squares / static_cast<double>(n));
}

}  // namespace

Outcome<TrackingError> trackingError(std::span<const double> actual, std::span<const double> target,
                                     double rate_Hz) {
  TORSIO_EXPECTS(actual.size() == target.size());
  if (actual.empty()) {
    return Outcome<TrackingError>::undefined(Text::tr("there are no samples"));
  }
  TrackingError out;
  const double n = static_cast<double>(actual.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    const double d = actual[i] - target[i];
    out.rmse += d * d;
    out.mae += std::abs(d) / n;
    out.bias += d / n;
    out.largest = std::max(out.largest, std::abs(d));
  }
  out.rmse = std::sqrt(out.rmse / n);
  addLag(actual, target, rate_Hz, out);
  return out;
}

Outcome<double> holdSteadiness(std::span<const double> heldAngle) {
  const std::optional<double> deviation = sampleDeviation(heldAngle);
  if (!deviation) {
    return Outcome<double>::undefined(Text::tr("the angle was never held"));
  }
  return *deviation;
}

Outcome<double> releaseRate(std::span<const double> releasedTorque, double rate_Hz) {
  if (releasedTorque.size() < 2) {
    return Outcome<double>::undefined(Text::tr("the organ was never released"));
  }
  std::vector<double> magnitude;
  for (const double torque : releasedTorque) {
    magnitude.push_back(std::abs(torque));
  }
  double fastest = 0.0;
  for (const double rate : derivative(magnitude, rate_Hz)) {
    fastest = std::max(fastest, -rate);
  }
  return fastest;
}

}  // namespace torsio
