// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/live_types.h"

namespace torsio {

/// Tells whether the hand of a recording felt the force that is measured on it. What is led round the organ
/// is a stylus with motors; what turns on the spot (mouse, game controller, puck) gives no force: there the
/// measures of force are computed from the model, shown, and marked wherever they are read.
[[nodiscard]] constexpr bool forceFelt(TwistDrive drive) noexcept {
  return drive == TwistDrive::kTangential;
}

}  // namespace torsio
