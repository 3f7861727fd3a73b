// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/error.h"
#include "sim/device/steering/spacemouse.h"

namespace torsio {

namespace {

Text whyNot() {
  return Text::tr("the daemon spacenavd does not exist on this system");
}

}  // namespace

DeviceDriver spaceMouseDriver() {
  DeviceDriver driver;
  driver.id = "spacemouse";
  driver.name = "SpaceMouse";
  driver.needs = Text::tr("the daemon spacenavd; not confirmed on hardware");
  driver.look = [](const DeviceRequest&) -> DriverFinding {
    return {false, whyNot(), Text::tr("Use another device"), {}};
  };
  driver.open = [](const DeviceRequest&) -> std::unique_ptr<HapticDevice> {
    throw Error(ErrorCode::kDevice, whyNot(), Text::verbatim("SpaceMouse"), Text::tr("Use another device"));
  };
  return driver;
}

}  // namespace torsio
