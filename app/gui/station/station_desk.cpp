// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/station/station_desk.h"

#include <utility>

#include "app/session/care/station_line.h"
#include "app/session/training/haptic_station.h"

namespace torsio::gui {

void StationDesk::announce(StationLine* line) {
  if (line == nullptr || std::exchange(announced_, true)) return;
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
