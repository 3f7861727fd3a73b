// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/movement.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <mutex>
#include <numbers>
#include <vector>

namespace torsio {

namespace {

using Complex = std::complex<double>;

constexpr std::size_t kLongestMovement = 65'536;  // samples: one minute at 1 kHz
constexpr std::size_t kKeptSizes = 17;            // cached roots for transforms up to 65,536 points

/// Real and imaginary parts in separate arrays.
struct Spectrum {
  std::vector<double> re;
  std::vector<double> im;
};

/// Returns roots of unity for each stage of a transform of n points: the stage that joins halves of h points
/// begins at h - 1.
Spectrum rootsOf(std::size_t n) {
  Spectrum roots{std::vector<double>(n - 1), std::vector<double>(n - 1)};
  for (std::size_t i = 0; i < n / 2; ++i) {
    const Complex root =
        std::polar(1.0, -2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n));
    for (std::size_t half = n / 2, k = i;; half /= 2, k /= 2) {
      roots.re[half - 1 + k] = root.real();
      roots.im[half - 1 + k] = root.imag();
      if (k % 2 != 0 || half == 1) {
        break;
      }
    }
  }
  return roots;
}

/// Like rootsOf(), from a cached table; any thread. `own` receives roots too long for the cache.
const Spectrum& keptRootsOf(std::size_t n, Spectrum& own) {
  static std::array<std::once_flag, kKeptSizes> made;
  static std::array<Spectrum, kKeptSizes> kept;
  const auto power = static_cast<std::size_t>(std::countr_zero(n));
  if (power >= kKeptSizes) {
    own = rootsOf(n);
    return own;
  }
  std::call_once(made[power], [&] { kept[power] = rootsOf(n); });
  return kept[power];
}

/// Transforms a real signal, zero-padded to `size` points, a power of two; radix 2. The first stages only
/// copy each value to its neighbours while these are zeros.
Spectrum transformed(std::span<const double> signal, std::size_t size) {
  Spectrum x{std::vector<double>(size), std::vector<double>(size)};
  const std::size_t spread = size / std::bit_ceil(signal.size());
  for (std::size_t i = 0, j = 0; i < signal.size(); ++i) {  // j: the bits of i reversed
    std::fill_n(x.re.begin() + static_cast<std::ptrdiff_t>(j), spread, signal[i]);
    std::size_t bit = size >> 1;
    for (; (j & bit) != 0; bit >>= 1) {
      j ^= bit;
    }
    j ^= bit;
  }
  Spectrum own;
  const Spectrum& roots = keptRootsOf(size, own);
  for (std::size_t half = spread; half < size; half *= 2) {
    const double* rootRe = roots.re.data() + half - 1;
    const double* rootIm = roots.im.data() + half - 1;
    for (std::size_t start = 0; start < size; start += 2 * half) {
      double* re = x.re.data() + start;
      double* im = x.im.data() + start;
      for (std::size_t k = 0; k < half; ++k) {
        const double oddRe = re[k + half] * rootRe[k] - im[k + half] * rootIm[k];
        const double oddIm = re[k + half] * rootIm[k] + im[k + half] * rootRe[k];
        re[k + half] = re[k] - oddRe;
        im[k + half] = im[k] - oddIm;
        re[k] += oddRe;
        im[k] += oddIm;
      }
    }
  }
  return x;
}

double amplitudeOf(const Spectrum& spectrum, std::size_t i) {
  return std::abs(Complex(spectrum.re[i], spectrum.im[i]));
}

double largestAmplitude(const Spectrum& spectrum) {
  // Take square roots only of candidates for the maximum, or of all if the squares overflow or underflow.
  constexpr double kNear = 1.0 - 1e-12;
  std::vector<double> squares(spectrum.re.size());
  double most = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    squares[i] = spectrum.re[i] * spectrum.re[i] + spectrum.im[i] * spectrum.im[i];
    most = std::max(most, squares[i]);
  }
  const double least = most > 1e-200 && std::isfinite(most) ? kNear * most : 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < squares.size(); ++i) {
    if (!(squares[i] < least)) {
      largest = std::max(largest, amplitudeOf(spectrum, i));
    }
  }
  return largest;
}

double peakOf(std::span<const double> speed) {
  double peak = 0.0;
  for (const double v : speed) {
    peak = std::max(peak, std::abs(v));
  }
  return peak;
}

/// Height above the higher of the two valleys between the peak and higher ones (or the ends).
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
  const std::size_t size = std::bit_ceil(speed.size()) << options.paddingLevel;
  const Spectrum spectrum = transformed(speed, size);
  const double step_Hz = rate_Hz / static_cast<double>(size);
  const double largest = largestAmplitude(spectrum);
  std::vector<double> amplitude;
  for (std::size_t i = 0; i < size && static_cast<double>(i) * step_Hz <= options.cutoff_Hz; ++i) {
    amplitude.push_back(amplitudeOf(spectrum, i) / largest);
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
    std::size_t end = i;  // a flat top counts once, at its centre
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
