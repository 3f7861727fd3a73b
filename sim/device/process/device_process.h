// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "sim/device/device_driver.h"
#include "sim/device/haptic_device.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/hdapi/hdapi_session.h"

namespace torsio {

/// How a stylus is opened.
struct StylusRequest {
  std::string library;              ///< path or name of the vendor's library; "" for the usual ones
  HdapiOptions options;             ///< its clock counts within this process only
  bool onlyLibrary = false;         ///< look for the library, open nothing
  bool inThisProcess = false;       ///< for tests that steer a fake library
  std::function<bool()> cancelled;  ///< asked while the library is waited for; may be empty
};

/// The result: a missing library is not an error here.
struct StylusOpening {
  HdapiLibrary library;                  ///< without the functions when the driver runs elsewhere
  std::unique_ptr<HapticDevice> driver;  ///< null unless the library was loaded
};

/// Starts the device process (`torsio-device`, beside the running program, or the one that
/// TORSIO_DEVICE_PROGRAM names), which loads the vendor's library and opens the device; force off. The
/// library may hang, crash or be cut off there: after kChildEnded_us without an answer of a running servo the
/// process is ended and the device reported lost, and a second process takes off the force that it may have
/// left (lossText waits for that). When this process ends in any way, the other lets go of the hand. Takes up
/// to seconds. Throws Error{kDevice}: no device process, no device, no answer, cancelled.
[[nodiscard]] StylusOpening openStylus(const StylusRequest& request);

/// Moves the look and the device of a driver into the device process, which knows the driver by its id;
/// started, watched and ended as a stylus is. Where there is no device process (Windows), the driver itself.
[[nodiscard]] DeviceDriver hosted(const DeviceDriver& driver);

/// PHANTOM Omni and 3D Systems Touch, their vendor's library in the device process.
[[nodiscard]] DeviceDriver stylusDeviceDriver();

}  // namespace torsio
