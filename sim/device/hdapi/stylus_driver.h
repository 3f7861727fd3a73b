// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/device/haptic_device.h"
#include "sim/device/hdapi/hdapi_state.h"

namespace torsio {

struct HdapiIdentity;

/// A stylus of the vendor's, wherever its driver runs: in a process of its own (ProcessDevice) or, for tests,
/// in this one (HdapiDevice).
class StylusDriver : public HapticDevice {
 public:
  /// Starts the servo; readings and forces go over mailboxes. Once. Throws Error{kDevice}.
  virtual void serve() = 0;
  /// Lets go of the hand and ends the driver. False when the library did not let go by itself.
  virtual bool close() = 0;
  /// Asks for force output. Force is granted while the device is calibrated, quick and cool, and always
  /// ramped.
  virtual void enableForce(bool on) noexcept = 0;
  /// Returns the newest state that the device confirmed.
  [[nodiscard]] virtual HdapiSnapshot snapshot() noexcept = 0;
  [[nodiscard]] virtual const HdapiIdentity& identity() const noexcept = 0;
};

}  // namespace torsio
