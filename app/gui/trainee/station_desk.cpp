// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/station_desk.h"

#include <utility>

#include <QApplication>

#include "app/connectors/tracker/tracker_choice.h"
#include "app/services/devices/haptic_station.h"
#include "app/services/recording/station_writer.h"

namespace torsio::gui {

void soundOfTheSystem() {
  QApplication::beep();
}

void StationDesk::announce(StationWriter* line) {
  if (line == nullptr || std::exchange(announced_, true)) {
    return;
  }
  line->showDevice(uncheckedDevice(device, rendersForce));
}

std::shared_ptr<StationDesk> deskOfThisStation() {
  auto desk = std::make_shared<StationDesk>();
  const DeviceChoice choice = stationChoice();
  if (deviceInstalled(choice)) {
    const DeviceDriver& driver = chosenDriver(choice);
    desk->device = Text(driver.name);
    desk->rendersForce = driver.rendersForce;
    desk->probe = hapticProbe(choice);
    desk->openDevice = [choice](const Scene& scene, double) { return openHapticDevice(scene, choice); };
  }
  desk->tracker = rememberedTracker().tracker;
  desk->outlet = outletOfThisStation();
  return desk;
}

}  // namespace torsio::gui
