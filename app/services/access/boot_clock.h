// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/clock.h"

namespace torsio {

/// Monotonic clock that goes on while the machine sleeps (where the system has one), so that a desk is locked
/// after its lid was closed. Thread-safe.
class BootClock final : public Clock {
 public:
  [[nodiscard]] std::int64_t now_us() const noexcept override;
};

}  // namespace torsio
