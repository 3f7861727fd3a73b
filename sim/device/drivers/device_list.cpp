// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/drivers/device_list.h"

#include "sim/core/error.h"
#include "sim/device/inverse3/inverse3_device.h"
#include "sim/device/process/device_process.h"
#include "sim/device/steering/game_controller.h"
#include "sim/device/steering/spacemouse.h"
#include "sim/device/virtual/virtual_drivers.h"

namespace torsio {

const std::vector<DeviceDriver>& deviceDrivers() {
  static const std::vector<DeviceDriver> kDrivers = {
      stylusDeviceDriver(), hosted(inverse3Driver()), gameControllerDriver(), spaceMouseDriver(),
      pointerDriver(),      scriptedHandDriver(),     replayDriver(),         idleDriver(),
  };
  return kDrivers;
}

const DeviceDriver& deviceDriver(const std::string& id) {
  std::string ids;
  for (const DeviceDriver& driver : deviceDrivers()) {
    if (driver.id == id) {
      return driver;
    }
    ids.append(ids.empty() ? "" : ", ").append(driver.id);
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("there is no device driver \"%1\"", id), Text::tr("device"),
              Text::tr("Choose one of: %1", ids));
}

}  // namespace torsio
