// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/live_types.h"

namespace torsio {

/// Returns whether the hand felt the measured force. A drive led around the organ is a stylus with motors;
/// one that turns on the spot (mouse, game controller, puck) gives no force: its force measures are computed
/// by the model and marked as such wherever they are shown.
[[nodiscard]] constexpr bool forceFelt(TwistDrive drive) noexcept {
  return drive == TwistDrive::kTangential;
}

}  // namespace torsio
