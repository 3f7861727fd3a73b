// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/services/devices/device_check.h"
#include "app/services/devices/device_readiness.h"
#include "sim/device/haptic_device.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Returns the device of this station: the one remembered, else the first available. May take seconds.
[[nodiscard]] DeviceChoice stationChoice();
/// Returns whether this station has the chosen device, or its library, and may try it. Opens nothing.
[[nodiscard]] bool deviceInstalled(const DeviceChoice& choice = {});

/// Summarises a device check for a trainee: one light per subject, from its worst finding.
[[nodiscard]] DeviceReadiness hapticReadiness(const DeviceCheckResult& check);
/// Returns a probe that runs the whole check without the force self-test, which needs consent (`torsio device
/// check`).
[[nodiscard]] DeviceProbe hapticProbe(const DeviceChoice& choice = {});

/// During its lifetime, openHapticDevice in this thread gives up as soon as `unwanted` returns true, since a
/// driver may hang.
class WhileWanted {
 public:
  explicit WhileWanted(std::function<bool()> unwanted);
  ~WhileWanted();
  WhileWanted(const WhileWanted&) = delete;
  WhileWanted& operator=(const WhileWanted&) = delete;
};

/// Opens this station's haptic device with its force on and its workspace centred on the scene's grasping
/// point. The caller's servo drives it through mailboxes. May take seconds. Throws Error{kDevice}.
[[nodiscard]] std::unique_ptr<HapticDevice> openHapticDevice(const Scene& scene,
                                                             const DeviceChoice& choice = {});

}  // namespace torsio
