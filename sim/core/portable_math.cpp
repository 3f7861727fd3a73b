// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/portable_math.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace torsio {

namespace {

// pi/2 as a sum of three doubles of 33 significant bits each: n * part is exact for n < 2^20.
constexpr double kHalfPi1 = 0x1.921fb544p+0;
constexpr double kHalfPi2 = 0x1.0b4611a6p-34;
constexpr double kHalfPi3 = 0x1.3198a2e037073p-69;
constexpr double kLargestArgument = 1e5;

// ln 2 split so that k * kLn2High is exact for |k| < 2^11.
constexpr double kLn2High = 0x1.62e42feep-1;
constexpr double kLn2Low = 0x1.a39ef35793c76p-33;

// Taylor series on [-pi/4, pi/4]: the first term left out is below 1e-17 of the result.
double sineKernel(double r) {
  const double z = r * r;
  double p = 1.0 / 355687428096000.0;  // 1/17!
  p = -1.0 / 1307674368000.0 + z * p;
  p = 1.0 / 6227020800.0 + z * p;
  p = -1.0 / 39916800.0 + z * p;
  p = 1.0 / 362880.0 + z * p;
  p = -1.0 / 5040.0 + z * p;
  p = 1.0 / 120.0 + z * p;
  p = -1.0 / 6.0 + z * p;
  return r + r * (z * p);
}

double cosineKernel(double r) {
  const double z = r * r;
  double p = 1.0 / 20922789888000.0;  // 1/16!
  p = -1.0 / 87178291200.0 + z * p;
  p = 1.0 / 479001600.0 + z * p;
  p = -1.0 / 3628800.0 + z * p;
  p = 1.0 / 40320.0 + z * p;
  p = -1.0 / 720.0 + z * p;
  p = 1.0 / 24.0 + z * p;
  const double half = 0.5 * z;
  const double leading = 1.0 - half;
  return leading + (((1.0 - leading) - half) + z * z * p);
}

// arctan on [0, tan(pi/16)]: odd Taylor terms to t^23.
double arctanKernel(double t) {
  const double z = t * t;
  double p = 0.0;
  for (int k = 11; k >= 1; --k) {
    const double term = 1.0 / static_cast<double>(2 * k + 1);
    p = (k % 2 == 0 ? term : -term) + z * p;
  }
  return t + t * (z * p);
}

double scaleByPowerOfTwo(double value, int exponent) {
  // In two steps, so that the factor itself never leaves the range of normal numbers.
  const int first = exponent / 2;
  const auto power = [](int e) { return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + e) << 52); };
  return value * power(first) * power(exponent - first);
}

}  // namespace

SinCos portableSinCos(double x) noexcept {
  if (!(std::abs(x) <= kLargestArgument)) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return {nan, nan};
  }
  const double n = std::floor(x * (2.0 / kPi) + 0.5);
  const double r = ((x - n * kHalfPi1) - n * kHalfPi2) - n * kHalfPi3;
  const double s = sineKernel(r);
  const double c = cosineKernel(r);
  switch (static_cast<std::int64_t>(n) & 3) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double portableAtan2(double y, double x) noexcept {
  if (std::isnan(x) || std::isnan(y)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  if (ax == 0.0 && ay == 0.0) {
    return 0.0;
  }
  const bool steep = ay > ax;
  const double t = steep ? ax / ay : ay / ax;  // in [0, 1]
  // Fold [0, 1] onto [-tan(pi/16), tan(pi/16)] about the tabled angles 0, pi/8, pi/4.
  constexpr double kTanPi8 = 0.41421356237309504880;
  constexpr double kTanPi16 = 0.19891236737965800691;
  double base = 0.0;
  double u = t;
  if (t > 0.66817863791929891999) {  // tan(3 pi / 16)
    base = kPi / 4.0;
    u = (t - 1.0) / (1.0 + t);
  } else if (t > kTanPi16) {
    base = kPi / 8.0;
    u = (t - kTanPi8) / (1.0 + t * kTanPi8);
  }
  double angle = base + (u < 0.0 ? -arctanKernel(-u) : arctanKernel(u));
  if (steep) {
    angle = kPi / 2.0 - angle;
  }
  if (std::signbit(x) && x != 0.0) {
    angle = kPi - angle;
  }
  return y < 0.0 ? -angle : angle;
}

double portableExp(double x) noexcept {
  if (std::isnan(x)) {
    return x;
  }
  if (x < -708.0) {
    return 0.0;
  }
  if (x > 709.0) {
    return std::numeric_limits<double>::infinity();
  }
  const double k = std::floor(x / 0.69314718055994530942 + 0.5);
  const double r = (x - k * kLn2High) - k * kLn2Low;  // |r| <= ln(2) / 2
  double p = 1.0;
  for (int i = 14; i >= 2; --i) {
    p = 1.0 + r * p / static_cast<double>(i);
  }
  return scaleByPowerOfTwo(1.0 + r * p, static_cast<int>(k));
}

double portableLog(double x) noexcept {
  if (x == 0.0) {
    return -std::numeric_limits<double>::infinity();
  }
  if (!(x > 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  if (std::isinf(x)) {
    return x;
  }
  int exponent = 0;
  double m = std::frexp(x, &exponent);  // [0.5, 1)
  if (m < 0.70710678118654752440) {
    m *= 2.0;
    --exponent;
  }
  const double t = (m - 1.0) / (m + 1.0);  // log m = 2 artanh t, |t| <= 0.1716
  const double z = t * t;
  double p = 0.0;
  for (int k = 10; k >= 1; --k) {
    p = 1.0 / static_cast<double>(2 * k + 1) + z * p;
  }
  const double e = static_cast<double>(exponent);
  return e * kLn2High + (2.0 * (t + t * (z * p)) + e * kLn2Low);
}

double unwrapNear(double angle_rad, double reference_rad) noexcept {
  return angle_rad - 2.0 * kPi * std::floor((angle_rad - reference_rad) / (2.0 * kPi) + 0.5);
}

}  // namespace torsio
