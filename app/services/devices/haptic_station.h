// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "app/services/devices/device_check.h"
#include "app/services/devices/device_readiness.h"
#include "sim/device/haptic_device.h"
#include "sim/scene/scene.h"

namespace torsio {

/// What this station works with: what it remembers, else the first device that is there. May take seconds.
[[nodiscard]] DeviceChoice stationChoice();
/// Whether this station has the chosen device, or the library of one, so that it may be asked for. Opens
/// none.
[[nodiscard]] bool deviceInstalled(const DeviceChoice& choice = {});

/// The device check as a trainee reads it: the findings of each subject as one light, the worst one counts.
[[nodiscard]] DeviceReadiness hapticReadiness(const DeviceCheckResult& check);
/// Runs the whole check without the force self-test (which wants consent: `torsio device check`).
[[nodiscard]] DeviceProbe hapticProbe(const DeviceChoice& choice = {});

/// While it lives, openHapticDevice in this thread gives up as soon as `unwanted` says so: a driver may hang.
class WhileWanted {
 public:
  explicit WhileWanted(std::function<bool()> unwanted);
  ~WhileWanted();
  WhileWanted(const WhileWanted&) = delete;
  WhileWanted& operator=(const WhileWanted&) = delete;
};

/// The haptic device of this station, started with its force on, its workspace centred on the point of the
/// scene that is to be grasped. Driven over mailboxes by the caller's servo. Takes up to seconds. Throws
/// Error{kDevice}.
[[nodiscard]] std::unique_ptr<HapticDevice> openHapticDevice(const Scene& scene,
                                                             const DeviceChoice& choice = {});

}  // namespace torsio
