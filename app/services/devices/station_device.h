// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include "app/services/devices/device_readiness.h"
#include "assessment/domain/study/station_state.h"
#include "sim/core/text.h"

namespace torsio {

/// What a station says about its device: which one it is, and what the last check found.
struct StationDevice {
  Text device{};                   ///< "Mouse and keyboard", "Touch"; empty: no training station
  bool haptic = false;             ///< renders force
  std::optional<Light> light{};    ///< of the last check; empty: not checked since the program started
  Text problem{};                  ///< why it is not green; no full stop
  std::int64_t checkedUtc_us = 0;  ///< 0: not checked
  friend bool operator==(const StationDevice&, const StationDevice&) = default;
};

/// As a check at `checkedUtc_us` found it; the problem is the first of the worst findings.
[[nodiscard]] StationDevice stationDevice(const DeviceReadiness& readiness, std::int64_t checkedUtc_us);
/// A device that was not checked yet; an empty name: mouse and keyboard.
[[nodiscard]] StationDevice uncheckedDevice(const Text& device, bool haptic);

/// Between what is shown and what is stored beside the heartbeat. A problem that cannot be read is empty.
void storeDevice(const StationDevice& device, StationState& state);
[[nodiscard]] StationDevice storedDevice(const StationState& state);

}  // namespace torsio
