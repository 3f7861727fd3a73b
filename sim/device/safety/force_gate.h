// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

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

}  // namespace torsio
