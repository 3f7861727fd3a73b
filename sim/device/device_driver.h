// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/device/haptic_device.h"

namespace torsio {

/// Everything that any driver may need to look for a device or to open it; each driver reads its part.
struct DeviceRequest {
  Pose start;                          ///< of what moves from where it was: the pose before the first input
  Vec3 workspaceCentre_m;              ///< world point for the centre of the usable workspace
  std::string name;                    ///< which of several devices; "" for the usual one
  std::string library;                 ///< path or name of the vendor's library; "" for the usual ones
  bool inThisProcess = false;          ///< for tests that steer a fake library
  std::function<bool()> cancelled;     ///< asked while the device is waited for; may be empty
  std::vector<DeviceSample> recorded;  ///< replay
  DeviceCapabilities recordedWith;     ///< replay
};

/// What came of looking for a device or its library.
struct DriverFinding {
  bool available = false;
  Text sentence;            ///< why, or why not; no full stop
  Text remedy;              ///< what to do; "" when available
  std::vector<Text> notes;  ///< usable all the same; sentences
};

/// What a driver is for.
enum class DriverUse {
  kStation,  ///< a hand's device that is plugged in: a station may choose it
  kPointer,  ///< mouse and keyboard: always there
  kNoHand,   ///< script, recording, nothing
};

/// One way to get a HapticDevice.
struct DeviceDriver {
  std::string id;    ///< "pointer": for options and settings
  std::string name;  ///< "Mouse and keyboard"
  Text needs;        ///< what must be there, in plain words; "" for nothing
  DriverUse use = DriverUse::kStation;
  bool rendersForce = false;
  bool takesLibrary = false;  ///< reads DeviceRequest::library
  /// Looks whether it could be used now; opens no device. May take seconds. Throws nothing.
  std::function<DriverFinding(const DeviceRequest&)> look;
  /// Opens the device; it still has to be served (HapticDevice::serve). Throws Error{kDevice} or
  /// Error{kBadParameter}.
  std::function<std::unique_ptr<HapticDevice>(const DeviceRequest&)> open;
};

}  // namespace torsio
