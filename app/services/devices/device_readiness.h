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
  kAmber,  ///< good enough for practice, not for scored runs
  kRed,    ///< no scored runs
};

/// One line of the device check.
struct ReadinessFinding {
  std::string code{};  ///< "connected", "docked", "calibrated", "force", "rate", "seat"; the window has words
  Light light = Light::kGreen;
  Text detail{};  ///< measured value, for people who know the device: "0.8 mm", "driver 2023.1"
  Text remedy{};  ///< what to do; empty if nothing
};

/// Readiness of the device at this station.
struct DeviceReadiness {
  Text device{};        ///< "Mouse and keyboard", "Touch", "Scripted hand"
  bool haptic = false;  ///< renders force
  std::vector<ReadinessFinding> findings{};

  /// Returns the worst light; red without findings, since an unchecked device is not ready.
  [[nodiscard]] Light light() const noexcept;
};

/// Checks the device. May take seconds; any thread.
using DeviceProbe = std::function<DeviceReadiness()>;

/// Returns the readiness of mouse and keyboard: without force, so runs are practice unless the centre grades
/// without force.
[[nodiscard]] DeviceReadiness pointerReadiness(bool gradedWithoutForce);
/// Applies the same rule to a checked device; one that renders force is returned unchanged.
[[nodiscard]] DeviceReadiness judgedByForce(DeviceReadiness readiness, bool gradedWithoutForce);

/// Share of a run's ticks that may be skipped without a warning: one in a thousand is not felt.
inline constexpr double kSkippedForgiven = 0.001;

/// Describes which privileges the system denies to a servo, without a full stop; empty if none.
[[nodiscard]] Text refusedToServo(bool priority, bool memory);
/// Describes the remedy.
[[nodiscard]] Text grantRealTime();

/// Describes timing problems of a run with this number of ticks, and privileges denied to its servo; without
/// a full stop. Empty if its force was never cut and hardly a tick skipped: denied privileges did no harm
/// then.
[[nodiscard]] Text servoTrouble(const ServoHealth& health, std::int64_t ticks);
/// Describes the remedy.
[[nodiscard]] Text servoRemedy(const ServoHealth& health);

/// A station's report on its device and the last check.
struct StationDevice {
  Text device{};                   ///< "Mouse and keyboard", "Touch"; empty: not a training station
  bool haptic = false;             ///< renders force
  std::optional<Light> light{};    ///< of the last check; empty: not checked since program start
  Text problem{};                  ///< why it is not green; without a full stop
  std::int64_t checkedUtc_us = 0;  ///< 0: not checked
  friend bool operator==(const StationDevice&, const StationDevice&) = default;
};

/// Returns the report for a check at `checkedUtc_us`; the problem is the first of the worst findings.
[[nodiscard]] StationDevice stationDevice(const DeviceReadiness& readiness, std::int64_t checkedUtc_us);
/// Returns the report of an unchecked device; an empty name means mouse and keyboard.
[[nodiscard]] StationDevice uncheckedDevice(const Text& device, bool haptic);

/// Converts between the report and the fields stored with the heartbeat. A problem that cannot be parsed is
/// empty.
void storeDevice(const StationDevice& device, StationState& state);
[[nodiscard]] StationDevice storedDevice(const StationState& state);

}  // namespace torsio
