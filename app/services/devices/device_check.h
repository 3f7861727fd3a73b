// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/services/devices/device_choice.h"
#include "sim/core/text.h"
#include "sim/device/haptic_device.h"

namespace torsio {

enum class FindingGrade {
  kGood,
  kNote,  ///< usable, but somebody should know
  kBad,   ///< not usable
};

/// One thing that was looked at, in words for the people of a centre.
struct DeviceFinding {
  std::string subject;  ///< "Library", "Device", "Calibration" ...
  FindingGrade grade = FindingGrade::kGood;
  Text sentence;  ///< what was found; no full stop
  Text remedy;    ///< what to do; "" when nothing
};

struct DeviceCheckRequest {
  DeviceChoice choice;
  double seconds = 2.0;                  ///< for which the servo is measured
  double calibrationWait_s = 30.0;       ///< for which the user may take the stylus to the inkwell
  bool forceTest = false;                ///< the user holds the stylus and agrees to feel a force
  std::function<void(const Text&)> say;  ///< what the user should do now; may be empty
  std::function<bool()> cancelled;       ///< may be empty
};

/// Force of the self-test: below the sustained force of an Omni, clearly felt.
inline constexpr double kSelfTestForce_N = 0.5;
/// Time over which the force of the self-test swells and fades.
inline constexpr double kSelfTestTime_s = 2.0;

struct DeviceCheckResult {
  std::vector<DeviceFinding> findings;  ///< in the order in which things were looked at
  DeviceCapabilities capabilities;      ///< of the device, once it was found
  DeviceIdentity identity;              ///< the same
  TickStatistics timing;                ///< of the whole check
  double rate_Hz = 0.0;                 ///< over the measurement
  double regularShare = 0.0;  ///< of the ticks of the measurement: 0.9 to 1.1 ms after the one before
  bool calibrated = false;
  bool rollReferenced = false;
  /// True when nothing was found that forbids a scored run.
  [[nodiscard]] bool usable() const;
  /// The first bad finding; null when usable.
  [[nodiscard]] const DeviceFinding* worst() const;
};

/// Looks at library, device, calibration, servo rate, jitter and, with consent, force, and closes the device
/// again. Takes as long as the request says; call it from a worker thread, never while the device is in use.
/// Everything that goes wrong with the device is a finding; throws Error{kBadParameter} for times out of
/// range.
[[nodiscard]] DeviceCheckResult checkDevice(const DeviceCheckRequest& request);

}  // namespace torsio
