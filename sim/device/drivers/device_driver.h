// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/text.h"
#include "sim/device/haptic_device.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/virtual/scripted_hand.h"

namespace torsio {

/// Everything that any driver may need to open a device; each driver reads its part.
struct DeviceRequest {
  Pose start;                          ///< pointer, idle: the pose before the first input
  ScriptedHandOptions hand;            ///< scripted
  std::vector<DeviceSample> recorded;  ///< replay
  DeviceCapabilities recordedWith;     ///< replay
  HdapiOptions hdapi;                  ///< hdapi: name, placement, tip
};

/// One way to get a HapticDevice.
struct DeviceDriver {
  std::string id;     ///< "hdapi": for options and settings
  std::string name;   ///< "PHANTOM Omni or Touch"
  std::string needs;  ///< what must be there, in plain words; "" for nothing
  bool available = false;
  Text finding;  ///< why, or why not; a sentence without a full stop
  Text remedy;   ///< what to do; "" when available
  /// Opens the device. Throws Error{kDevice} or Error{kBadParameter}. An hdapi device still has to be
  /// started (StylusDriver::serve).
  std::function<std::unique_ptr<HapticDevice>(const DeviceRequest&)> open;
};

/// Lists all drivers, best first, and whether each could be used now. The device process looks whether the
/// vendor's library loads; no device is opened. `library`: its path or name, "" for the usual ones.
[[nodiscard]] std::vector<DeviceDriver> deviceDrivers(const std::string& library = "");

}  // namespace torsio
