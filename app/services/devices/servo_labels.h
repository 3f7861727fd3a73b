// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/core/servo_health.h"
#include "sim/core/text.h"

namespace torsio {

/// Share of the ticks of a run that may be skipped without a word: nobody feels one in a thousand.
inline constexpr double kSkippedForgiven = 0.001;

/// What the system refuses to a servo, without a full stop; empty: nothing.
[[nodiscard]] Text refusedToServo(bool priority, bool memory);
/// What to do about it.
[[nodiscard]] Text grantRealTime();

/// What was wrong with the time of a run of so many ticks, with what the system refused to its servo; without
/// a full stop. Empty when its force was never cut and hardly a tick skipped: then a refusal did no harm.
[[nodiscard]] Text servoTrouble(const ServoHealth& health, std::int64_t ticks);
/// What to do about that.
[[nodiscard]] Text servoRemedy(const ServoHealth& health);

}  // namespace torsio
