// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/core/live_types.h"
#include "sim/device/device_state.h"

namespace torsio {

/// What a device can do. A driver that assumes a value says so.
struct DeviceCapabilities {
  std::string model;        ///< "Scripted hand", "Mouse and keyboard", "Touch" ...
  double maxForce_N = 3.3;  ///< nominal, norm
  double continuousForce_N = 0.88;
  double maxStiffness_N_per_m = 500.0;
  Vec3 workspaceMin_m{-10.0, -10.0, -10.0};  ///< usable box, world frame; the default means "no box"
  Vec3 workspaceMax_m{10.0, 10.0, 10.0};
  bool rendersForce = false;  ///< false: force is shown, not felt
  bool realTime = true;       ///< false: may be driven faster than the wall clock
  /// How its motion becomes the twist. Not every device can be led round an organ.
  TwistDrive drive = TwistDrive::kTangential;
};

/// A hand-held device with up to six sensed degrees of freedom and a three-axis force. Vendor types never
/// appear here. Drivers convert to SI and to the world frame, quantise at their border (device_sample.h), and
/// honour any force they cannot render by ignoring it.
///
/// The stylus points along the -z axis of its pose; the position is that of its tip.
///
/// Life: opened by a DeviceDriver with its force off, served, closed. serve, close and destruction belong to
/// one thread; enableForce, snapshot and nextEvent to one (the same or another); read and write to the servo.
/// What needs no hardware is always ready: it overrides the readings only.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  [[nodiscard]] virtual const DeviceCapabilities& capabilities() const noexcept = 0;
  /// Returns the reading for servo time `time_us`, which never decreases from call to call. Servo thread;
  /// no allocation, no lock, no log.
  [[nodiscard]] virtual DeviceSample read(std::int64_t time_us) noexcept = 0;
  /// Sets the force to render until the next write. Servo thread; no allocation, no lock, no log.
  virtual void write(const ForceCommand& command) noexcept = 0;
  /// Lets go of the hand at once and until the next write: a watchdog calls it when the tick stalls, from a
  /// thread of its own while read or write may hang. Never waits. A device whose force ends by itself when
  /// nobody writes, or that renders none, has nothing to do.
  virtual void dropForce() noexcept {}

  /// Starts the driver's thread; readings and forces go over mailboxes. Once. Throws Error{kDevice}.
  virtual void serve() {}
  /// Lets go of the hand and ends the driver. False when the device did not let go by itself.
  virtual bool close() { return true; }
  /// Asks for force output. Force is granted while the device is calibrated, quick and cool, and always
  /// ramped; a device that renders none stays without.
  virtual void enableForce(bool) noexcept {}
  /// Returns the newest state that the device confirmed.
  [[nodiscard]] virtual DeviceSnapshot snapshot() noexcept {
    DeviceSnapshot ready;
    ready.state = DeviceState::kReady;
    ready.calibration = CalibrationState::kCalibrated;
    return ready;
  }
  /// Takes the oldest event not yet taken; false when there is none.
  [[nodiscard]] virtual bool nextEvent(DeviceEvent&) noexcept { return false; }
  /// Says why the device was lost (DeviceSnapshot::lostBecause), without a full stop.
  [[nodiscard]] virtual Text lossText(std::uint32_t) const {
    return Text::tr("the connection to the device broke off");
  }
  /// Returns what the device says about itself; empty of one without hardware.
  [[nodiscard]] virtual const DeviceIdentity& identity() const noexcept {
    static const DeviceIdentity kNothing;
    return kNothing;
  }
};

}  // namespace torsio
