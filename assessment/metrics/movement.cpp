// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/movement.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace torsio {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kLongestMovement = 65'536;  // samples: one minute at 1 kHz

/// In-place radix-2 transform; the size is a power of two.
void transform(std::vector<Complex>& x) {
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; (j & bit) != 0; bit >>= 1) {
      j ^= bit;
    }
    j ^= bit;
    if (i < j) {
      std::swap(x[i], x[j]);
    }
  }
  std::vector<Complex> roots(n / 2);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    roots[i] = std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
  }
  for (std::size_t length = 2; length <= n; length <<= 1) {
    const std::size_t stride = n / length;
    for (std::size_t start = 0; start < n; start += length) {
      for (std::size_t k = 0; k < length / 2; ++k) {
        const Complex even = x[start + k];
        const Complex odd = x[start + k + length / 2] * roots[k * stride];
        x[start + k] = even + odd;
        x[start + k + length / 2] = even - odd;
      }
    }
  }
}

double peakOf(std::span<const double> speed) {
  double peak = 0.0;
  for (const double v : speed) {
    peak = std::max(peak, std::abs(v));
  }
  return peak;
}

/// Height above the higher of the two valleys that separate the peak from a higher one (or from the end).
double prominence(std::span<const double> v, std::size_t peak) {
  double left = v[peak];
  for (std::size_t i = peak; i-- > 0 && v[i] <= v[peak];) {
    left = std::min(left, v[i]);
  }
  double right = v[peak];
  for (std::size_t i = peak + 1; i < v.size() && v[i] <= v[peak]; ++i) {
    right = std::min(right, v[i]);
  }
  return v[peak] - std::max(left, right);
}

}  // namespace

double pathLength(std::span<const Vec3> positions) {
  double sum = 0.0;
  for (std::size_t i = 1; i < positions.size(); ++i) {
    sum += norm(positions[i] - positions[i - 1]);
  }
  return sum;
}

double angularPath(std::span<const double> angles) {
  double sum = 0.0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    sum += std::abs(angles[i] - angles[i - 1]);
  }
  return sum;
}

Outcome<double> economy(double ideal, double actual) {
  if (!(actual > 0.0)) {
    return Outcome<double>::undefined(Text::tr("nothing moved"));
  }
  return ideal / actual;
}

double idleTime(std::span<const double> speed, double threshold, double rate_Hz, double atLeast_s) {
  double total = 0.0;
  std::size_t run = 0;
  for (std::size_t i = 0; i <= speed.size(); ++i) {
    if (i < speed.size() && std::abs(speed[i]) < threshold) {
      ++run;
      continue;
    }
    const double stretch = static_cast<double>(run) / rate_Hz;
    if (stretch >= atLeast_s) {
      total += stretch;
    }
    run = 0;
  }
  return total;
}

Outcome<double> spectralArcLength(std::span<const double> speed, double rate_Hz,
                                  const SparcOptions& options) {
  if (speed.size() < 2 || peakOf(speed) == 0.0) {
    return Outcome<double>::undefined(Text::tr("nothing moved"));
  }
  if (speed.size() > kLongestMovement) {
    return Outcome<double>::undefined(
        Text::tr("the movement is longer than a minute: split it into movements"));
  }
  std::size_t size = 1;
  while (size < speed.size()) {
    size <<= 1;
  }
  size <<= options.paddingLevel;
  std::vector<Complex> spectrum(size, Complex(0.0, 0.0));
  for (std::size_t i = 0; i < speed.size(); ++i) {
    spectrum[i] = speed[i];
  }
  transform(spectrum);
  const double step_Hz = rate_Hz / static_cast<double>(size);
  std::vector<double> amplitude;
  double largest = 0.0;
  for (const Complex& value : spectrum) {
    largest = std::max(largest, std::abs(value));
  }
  for (std::size_t i = 0; i < size && static_cast<double>(i) * step_Hz <= options.cutoff_Hz; ++i) {
    amplitude.push_back(std::abs(spectrum[i]) / largest);
  }
  std::size_t first = amplitude.size();
  std::size_t last = 0;
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    if (amplitude[i] < options.amplitudeThreshold) {
      continue;
    }
    first = std::min(first, i);
    last = i;
  }
  if (first >= last) {
    return Outcome<double>::undefined(Text::tr("the speed has no spectrum below the cut-off"));
  }
  const double df = 1.0 / static_cast<double>(last - first);
  double length = 0.0;
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double d = amplitude[i] - amplitude[i - 1];
    length += std::sqrt(df * df + d * d);
  }
  return -length;
}

Outcome<double> logDimensionlessJerk(std::span<const double> speed, double rate_Hz) {
  const std::size_t n = speed.size();
  const double peak = peakOf(speed);
  if (n < 5 || peak == 0.0) {
    return Outcome<double>::undefined(Text::tr("nothing moved"));
  }
  const auto second = [&](std::size_t i) {
    return (speed[i + 1] - 2.0 * speed[i] + speed[i - 1]) * rate_Hz * rate_Hz;
  };
  const double atStart = 2.0 * second(1) - second(2);
  const double atEnd = 2.0 * second(n - 2) - second(n - 3);
  double integral = 0.5 * (atStart * atStart + atEnd * atEnd);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    integral += second(i) * second(i);
  }
  integral /= rate_Hz;
  if (integral == 0.0) {
    return Outcome<double>::undefined(Text::tr("the speed is constant"));
  }
  const double duration = static_cast<double>(n - 1) / rate_Hz;
  return -std::log(duration * duration * duration / (peak * peak) * integral);
}

std::vector<std::size_t> speedPeaks(std::span<const double> speed, double rate_Hz) {
  const double least = kPeakProminence * peakOf(speed);
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i + 1 < speed.size(); ++i) {
    if (!(speed[i] > speed[i - 1])) {
      continue;
    }
    std::size_t end = i;  // a flat top counts once, at its middle
    while (end + 1 < speed.size() && speed[end + 1] == speed[i]) {
      ++end;
    }
    if (end + 1 < speed.size() && speed[end + 1] < speed[i] && prominence(speed, i) >= least) {
      found.push_back((i + end) / 2);
    }
    i = end;
  }
  std::vector<std::size_t> byHeight = found;
  std::stable_sort(byHeight.begin(), byHeight.end(),
                   [&](std::size_t a, std::size_t b) { return speed[a] > speed[b]; });
  const double distance = kPeakDistance_s * rate_Hz;
  std::vector<std::size_t> kept;
  for (const std::size_t peak : byHeight) {
    const bool near = std::any_of(kept.begin(), kept.end(), [&](std::size_t other) {
      return std::abs(static_cast<double>(peak) - static_cast<double>(other)) < distance;
    });
    if (!near) {
      kept.push_back(peak);
    }
  }
  std::sort(kept.begin(), kept.end());
  return kept;
}

Outcome<double> axisWander(std::span<const Vec3> positions, const Vec3& axisPoint, const Vec3& axis) {
  if (positions.empty()) {
    return Outcome<double>::undefined(Text::tr("the tool never held the organ"));
  }
  std::vector<double> radii;
  double mean = 0.0;
  for (const Vec3& position : positions) {
    const Vec3 d = position - axisPoint;
    radii.push_back(norm(d - axis * dot(d, axis)));
    mean += radii.back() / static_cast<double>(positions.size());
  }
  double squares = 0.0;
  for (const double radius : radii) {
    squares += (radius - mean) * (radius - mean);
  }
  return std::sqrt(squares / static_cast<double>(radii.size()));
}

}  // namespace torsio
