// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/station_desk.h"

#include <utility>

#include "app/devices/haptic_station.h"
#include "app/recording/station_writer.h"

namespace torsio::gui {

void StationDesk::announce(StationWriter* line) {
  if (line == nullptr || std::exchange(announced_, true)) {
    return;
  }
  line->showDevice(uncheckedDevice(probe != nullptr));
}

std::shared_ptr<StationDesk> deskOfThisStation() {
  auto desk = std::make_shared<StationDesk>();
  if (hapticLibraryInstalled()) {
    desk->probe = hapticProbe();
    desk->openDevice = [](const Scene& scene, double) { return openHapticDevice(scene); };
  }
  return desk;
}

}  // namespace torsio::gui
