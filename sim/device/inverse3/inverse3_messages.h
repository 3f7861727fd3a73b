// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "sim/core/pose.h"

namespace torsio {

/// Longest way of the cursor from the device's origin that is believed, m.
inline constexpr double kInverse3Reach_m = 1.0;

/// One message of the service (version 3, JSON), as far as the driver reads it. Frame of the device: x to the
/// right, y away from the user, z up; metres. What is not in the message stays empty.
struct Inverse3Message {
  std::string deviceId;             ///< of the Inverse3; "": none is connected
  std::string firmware;             ///< config.device_info, in the first message only
  std::optional<Vec3> cursor_m;     ///< state.cursor_position; empty when not finite or out of reach
  std::optional<Quat> orientation;  ///< of the (wireless) VerseGrip; empty without one
  std::uint32_t buttons = 0;        ///< DeviceButton bits: a the jaw, b the second, c the bookmark
};

/// Reads a message. `wanted`: the device of this id; "": the first one. Empty for what is no JSON object.
[[nodiscard]] std::optional<Inverse3Message> inverse3Message(const std::string& json,
                                                             const std::string& wanted);
/// Writes the command that renders a force at the cursor until the next one, N, frame of the device.
[[nodiscard]] std::string inverse3Force(const std::string& deviceId, const Vec3& force_N);

}  // namespace torsio
