// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "sim/base/live_types.h"

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
};

}  // namespace torsio
