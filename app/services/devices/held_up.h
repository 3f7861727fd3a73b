// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/clock.h"
#include "sim/core/text.h"

namespace torsio {

/// Tells a computer that is too busy from a device that does not answer: how long this thread slept beyond
/// what it asked for in the last two seconds. One thread.
class HeldUp {
 public:
  /// Blocks this thread for a time.
  void pause_s(double seconds);
  /// Whether a silence of the device is the computer's, which gave Torsio no time either.
  [[nodiscard]] bool starved() const;
  /// "the computer was too busy: ..." and what to do.
  [[nodiscard]] Text sentence() const;
  [[nodiscard]] static Text remedy();

 private:
  [[nodiscard]] bool recently() const;

  MonotonicClock clock_;
  std::int64_t late_us_ = 0;
  std::int64_t newest_us_ = 0;  // when this thread was last late
};

}  // namespace torsio
