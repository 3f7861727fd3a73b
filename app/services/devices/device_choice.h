// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "sim/core/text.h"
#include "sim/device/device_driver.h"

namespace torsio {

/// A choice of device. Empty: the one remembered by this station, or the default.
struct DeviceChoice {
  std::string driver{};        ///< DeviceDriver::id
  std::string library{};       ///< path or name of the vendor's library, if the driver needs one
  std::string name{};          ///< of one of several devices, as named by the driver
  bool inThisProcess = false;  ///< for tests with a fake library; otherwise torsio-device drives the device
};

/// Returns the request for opening the chosen device.
[[nodiscard]] DeviceRequest deviceRequest(const DeviceChoice& choice,
                                          const std::function<bool()>& cancelled = {});
/// Returns the driver of a choice: the one named; else the one for the named library; else the one remembered
/// by this station; else the first one available, or the first in the list. May take seconds. Throws
/// Error{kBadParameter} for an unknown driver.
[[nodiscard]] const DeviceDriver& chosenDriver(const DeviceChoice& choice);
/// Reads the choice remembered by this station (settings of the account that runs Torsio), else that of the
/// computer's configuration; empty: none.
[[nodiscard]] DeviceChoice rememberedDevice();
/// Stores driver and name for this station; an empty driver forgets them. Throws like chosenDriver().
void rememberDevice(const DeviceChoice& choice);
/// Throws Error{kBadParameter}, naming the time as `what`, unless 0 < `seconds` <= `longest`.
void requireTime(double seconds, double longest, Phrase what);
/// Blocks this thread for a time.
void pause_s(double seconds);

}  // namespace torsio
