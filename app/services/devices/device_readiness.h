// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/study/station_state.h"
#include "sim/core/servo_health.h"
#include "sim/core/text.h"

namespace torsio {

enum class Light {
  kGreen,
  kAmber,  ///< good enough to practise, not to be judged by
  kRed,    ///< no scored run
};

/// One line of the device check.
struct ReadinessFinding {
  std::string code{};  ///< "connected", "docked", "calibrated", "force", "rate", "seat"; the window has words
  Light light = Light::kGreen;
  Text detail{};  ///< what was measured, for people who know the device: "0.8 mm", "driver 2023.1"
  Text remedy{};  ///< what to do; empty when nothing
};

/// What is known of the device at this station.
struct DeviceReadiness {
  Text device{};        ///< "Mouse and keyboard", "Touch", "Scripted hand"
  bool haptic = false;  ///< renders force
  std::vector<ReadinessFinding> findings{};

  /// The worst light; red without any finding: a device that was not checked is not ready.
  [[nodiscard]] Light light() const noexcept;
};

/// Looks at the device now. May take seconds; any thread.
using DeviceProbe = std::function<DeviceReadiness()>;

/// Mouse and keyboard: no force is felt, so that runs are practice unless the centre grades without force.
[[nodiscard]] DeviceReadiness pointerReadiness(bool gradedWithoutForce);
/// The same rule for a device that was checked: one that renders force is returned as it is.
[[nodiscard]] DeviceReadiness judgedByForce(DeviceReadiness readiness, bool gradedWithoutForce);

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
