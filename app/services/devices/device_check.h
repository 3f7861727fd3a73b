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
  kNote,  ///< usable, but worth knowing
  kBad,   ///< not usable
};

/// One finding, in words for the centre's staff.
struct DeviceFinding {
  std::string subject;  ///< "Library", "Device", "Calibration" ...
  FindingGrade grade = FindingGrade::kGood;
  Text sentence;  ///< the finding, without a full stop
  Text remedy;    ///< what to do; "" if nothing
};

struct DeviceCheckRequest {
  DeviceChoice choice;
  double seconds = 2.0;                  ///< duration of the servo measurement
  double calibrationWait_s = 30.0;       ///< time for the user to put the stylus into the inkwell
  bool forceTest = false;                ///< the user holds the stylus and consents to feel a force
  bool buttons = false;                  ///< the user holds the stylus and is asked to press its buttons
  std::function<void(const Text&)> say;  ///< called with instructions for the user; may be empty
  std::function<bool()> cancelled;       ///< may be empty
};

/// Force of the self-test: below the sustained force of an Omni, but clearly felt.
inline constexpr double kSelfTestForce_N = 0.5;
/// Time over which the force of the self-test rises and falls.
inline constexpr double kSelfTestTime_s = 2.0;

struct DeviceCheckResult {
  std::vector<DeviceFinding> findings;  ///< in the order of checking
  DeviceCapabilities capabilities;      ///< of the device, if found
  DeviceIdentity identity;              ///< of the device, if found
  TickStatistics timing;                ///< of the whole check
  double rate_Hz = 0.0;                 ///< during the measurement
  double regularShare = 0.0;  ///< share of the measurement's ticks that came 0.9 to 1.1 ms after the previous
                              ///< one
  bool calibrated = false;
  bool rollReferenced = false;
  /// Returns whether no finding forbids a scored run.
  [[nodiscard]] bool usable() const;
  /// Returns the first bad finding; null if usable.
  [[nodiscard]] const DeviceFinding* worst() const;
};

/// Checks library, device, calibration, servo rate, jitter and, with consent, force, then closes the device.
/// Takes as long as the request says; call it from a worker thread, never while the device is in use.
/// Problems of the device are findings; throws Error{kBadParameter} only for times out of range.
[[nodiscard]] DeviceCheckResult checkDevice(const DeviceCheckRequest& request);

}  // namespace torsio
