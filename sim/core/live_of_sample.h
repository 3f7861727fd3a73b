// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/live_types.h"

namespace torsio {

/// Gives what a view sees of a tick, live or played back: time, tool, phase, answer and contact. What only
/// the servo loop knows (target, device status, delays, patches) is left as it is at rest.
[[nodiscard]] LiveState liveStateOf(const Sample& sample) noexcept;

}  // namespace torsio
