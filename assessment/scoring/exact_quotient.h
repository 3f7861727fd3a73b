// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>

namespace torsio {

/// Returns the double nearest to numerator / denominator (ties to even) for any magnitude; numerator >= 0,
/// denominator > 0. `Integer` is a built-in unsigned type that converts to double exactly, or an
/// arbitrary-precision one.
template <class Integer>
[[nodiscard]] double nearestQuotient(const Integer& numerator, const Integer& denominator) {
  Integer quotient = numerator / denominator;
  Integer remainder = numerator % denominator;
  int exponent = 0;
  const Integer enoughBits = Integer(1) << 54;  // 53 bits of mantissa, one rounding bit, one sticky bit
  const Integer tooManyBits = Integer(1) << 62;
  while (quotient < enoughBits && remainder != 0 && exponent > -1200) {
    remainder = remainder * 2;
    quotient = quotient * 2;
    if (remainder >= denominator) {
      remainder = remainder - denominator;
      quotient = quotient + 1;
    }
    --exponent;
  }
  bool sticky = remainder != 0;
  while (quotient >= tooManyBits) {
    sticky = sticky || (quotient % 2 != 0);
    quotient = quotient / 2;
    ++exponent;
  }
  std::uint64_t bits = static_cast<std::uint64_t>(quotient);
  if (sticky) {
    bits |= 1U;
  }
  return std::ldexp(static_cast<double>(bits), exponent);  // the conversion rounds once, to nearest even
}

inline constexpr std::int64_t kExactDouble = std::int64_t{1} << 53;

/// Returns the double nearest to numerator / denominator; denominator > 0. Dividing two converted integers
/// would round three times beyond 2^53.
[[nodiscard]] inline double roundedQuotient(std::int64_t numerator, std::int64_t denominator) {
  if (numerator <= kExactDouble && numerator >= -kExactDouble && denominator <= kExactDouble) {
    return static_cast<double>(numerator) / static_cast<double>(denominator);
  }
  const bool negative = numerator < 0;
  const std::uint64_t magnitude =
      negative ? 0 - static_cast<std::uint64_t>(numerator) : static_cast<std::uint64_t>(numerator);
  const double value = nearestQuotient(magnitude, static_cast<std::uint64_t>(denominator));
  return negative ? -value : value;
}

}  // namespace torsio
