// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

// How a section widens on the inside of a bend so that volumes stay (docs/model.md R.8). `k`: bend over
// stretch of the axis, 1/m, towards the inside.
namespace torsio {

namespace bend {
inline constexpr double kLimitFrom = 0.455;      ///< z from which on a bend is let in less and less
inline constexpr double kLimit = 0.495;          ///< z that no bend reaches; at 1/2 the inside has no length
inline constexpr double kMaxOfLimit = 0.9;       ///< of the way between them that a point at rest may lie
inline constexpr double kStraight_per_m = 1e-9;  ///< a bend that does nothing
}  // namespace bend

/// Brings a point of a section bent by `k` to a straight axis, so that the area along a fibre stays.
[[nodiscard]] inline std::array<double, 2> straightened(const std::array<double, 2>& u,
                                                        const std::array<double, 2>& k) noexcept {
  const double k2 = k[0] * k[0] + k[1] * k[1];
  if (k2 < bend::kStraight_per_m * bend::kStraight_per_m) {
    return u;
  }
  const double inside = std::min(1.0, u[0] * k[0] + u[1] * k[1]);  // k times the way towards the centre
  double z = inside - 0.5 * inside * inside;
  if (z > bend::kLimitFrom) {
    const double share =
        std::min(bend::kMaxOfLimit, (z - bend::kLimitFrom) / (bend::kLimit - bend::kLimitFrom));
    z = bend::kLimitFrom + (bend::kLimit - bend::kLimitFrom) * share / (1.0 - share);
  }
  const double by = (z - (u[0] * k[0] + u[1] * k[1])) / k2;
  return {u[0] + by * k[0], u[1] + by * k[1]};
}

/// The inverse of straightened().
[[nodiscard]] inline std::array<double, 2> bent(const std::array<double, 2>& w,
                                                const std::array<double, 2>& k) noexcept {
  const double k2 = k[0] * k[0] + k[1] * k[1];
  if (k2 < bend::kStraight_per_m * bend::kStraight_per_m) {
    return w;
  }
  const double straight = w[0] * k[0] + w[1] * k[1];
  double z = straight;
  if (z > bend::kLimitFrom) {
    const double y = (z - bend::kLimitFrom) / (bend::kLimit - bend::kLimitFrom);
    z = bend::kLimitFrom + (bend::kLimit - bend::kLimitFrom) * y / (1.0 + y);
  }
  const double by = (2.0 * z / (1.0 + std::sqrt(1.0 - 2.0 * z)) - straight) / k2;
  return {w[0] + by * k[0], w[1] + by * k[1]};
}

}  // namespace torsio
