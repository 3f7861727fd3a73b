// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "app/services/devices/device_choice.h"
#include "sim/core/vec3.h"

namespace torsio {

/// One reading in text form.
struct DeviceReadout {
  double time_s = 0.0;
  std::string state;      ///< "ready", "put the stylus into the inkwell" ...
  Vec3 tip_mm;            ///< world frame, from the centre of the workspace
  double roll_deg = 0.0;  ///< from the docked position
  bool rollAtStop = false;
  double grip = 0.0;
  bool firstButton = false;
  bool secondButton = false;
  bool docked = false;
  double warmest = 0.0;
  double rate_Hz = 0.0;
  std::int64_t lateTicks = 0;
  std::vector<std::string> events;  ///< since the previous reading
};

struct DeviceMonitorRequest {
  DeviceChoice choice;
  double seconds = 10.0;
  double interval_s = 0.25;
  std::function<void(const DeviceReadout&)> show;
  std::function<bool()> cancelled;  ///< may be empty
};

/// Shows readings until the time is over or the user cancels; without force. Throws Error{kDevice} if there
/// is no device or it is lost; always closes it properly.
void monitorDevice(const DeviceMonitorRequest& request);

}  // namespace torsio
