// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "sim/core/text.h"
#include "sim/device/device_driver.h"

namespace torsio {

/// Which device. Empty: what this station remembers, else the usual ones.
struct DeviceChoice {
  std::string driver{};        ///< DeviceDriver::id
  std::string library{};       ///< path or name of the vendor's library, of a driver that needs one
  std::string name{};          ///< of one of several devices, as the driver names them
  bool inThisProcess = false;  ///< for tests that steer a fake library; else torsio-device drives
};

/// Returns the request that opens the chosen device.
[[nodiscard]] DeviceRequest deviceRequest(const DeviceChoice& choice,
                                          const std::function<bool()>& cancelled = {});
/// Returns the driver of a choice: the one that is named; the one that takes a library that is named; the one
/// that this station remembers; else the first of the list that is there now, or the first. May take seconds.
/// Throws Error{kBadParameter} for a name that no driver of a station has.
[[nodiscard]] const DeviceDriver& chosenDriver(const DeviceChoice& choice);
/// Reads what this station remembers (settings of the user who runs Torsio); empty: nothing.
[[nodiscard]] DeviceChoice rememberedDevice();
/// Remembers driver and name for this station; an empty driver forgets. Throws as chosenDriver does.
void rememberDevice(const DeviceChoice& choice);
/// Refuses a time that a device is to be watched for unless 0 < `seconds` <= `longest`. Throws
/// Error{kBadParameter} that names it as `what`.
void requireTime(double seconds, double longest, Phrase what);
/// Waits so long in this thread.
void pause_s(double seconds);

}  // namespace torsio
