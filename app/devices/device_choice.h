// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "sim/base/text.h"
#include "sim/device/process/device_process.h"

namespace torsio {

/// Which haptic device: path or name of the vendor's library, and the name that the vendor's set-up tool gave
/// the device. Empty: the usual ones.
struct DeviceChoice {
  std::string library;
  std::string name;
  bool inThisProcess = false;  ///< for tests that steer a fake library; else torsio-device drives
};

/// Returns the request that opens the chosen device; `onlyLibrary`: that looks at the library alone.
[[nodiscard]] StylusRequest stylusRequest(const DeviceChoice& choice, const std::function<bool()>& cancelled,
                                          bool onlyLibrary = false);
/// Refuses a time that a device is to be watched for unless 0 < `seconds` <= `longest`. Throws
/// Error{kBadParameter} that names it as `what`.
void requireTime(double seconds, double longest, Phrase what);
/// Waits so long in this thread.
void pause_s(double seconds);

}  // namespace torsio
