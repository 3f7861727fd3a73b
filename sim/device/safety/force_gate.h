// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "sim/core/vec3.h"

namespace torsio {

/// Time over which the driver lets the force back in after an interruption.
inline constexpr std::int64_t kGateOpens_us = 500'000;

/// The driver's own last safeguard, behind the ForceGovernor: closed at once, opened by a ramp. Servo thread;
/// a plain value.
class ForceGate {
 public:
  void close() noexcept { open_us_ = 0; }
  /// Returns the share of the force to send now, and moves the ramp on by `step_us` >= 0 for the next call.
  double advance(std::int64_t step_us) noexcept {
    const double gain = static_cast<double>(open_us_) / static_cast<double>(kGateOpens_us);
    open_us_ = std::min(kGateOpens_us, open_us_ + step_us);
    return gain;
  }

 private:
  std::int64_t open_us_ = 0;
};

/// Largest rise of the sent force: 3.3 N take 33 ms. No published limit exists for the Touch; at the
/// stiffest contact (500 N/m) a hand at 0.2 m/s stays just below it.
inline constexpr double kSlewLimit_N_per_s = 100.0;

/// Returns the part of the last force that the next one keeps: the last one shortened as far as the next asks
/// for. Only the way from there to the next is a rise; a fall is free, because one that is held back gives
/// the hand energy.
[[nodiscard]] inline Vec3 keptForce_N(const Vec3& last_N, const Vec3& next_N) noexcept {
  const double square = dot(last_N, last_N);
  return square > 0.0 ? last_N * std::clamp(dot(last_N, next_N) / square, 0.0, 1.0) : last_N;
}

}  // namespace torsio
