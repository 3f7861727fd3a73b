// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/station_desk.h"

#include "app/devices/haptic_station.h"
#include "app/gui/base/shell_context.h"
#include "app/recording/station_writer.h"

namespace torsio::gui {

StationDesk& StationDesk::of(ShellContext& shell) {
  if (auto* desk = shell.findChild<StationDesk*>(QString(), Qt::FindDirectChildrenOnly)) return *desk;
  auto* desk = new StationDesk(&shell);
  if (hapticLibraryInstalled()) {
    desk->probe = hapticProbe();
    desk->openDevice = [](const Scene& scene, double) { return openHapticDevice(scene); };
  }
  if (shell.line() != nullptr) shell.line()->showDevice(uncheckedDevice(desk->probe != nullptr));
  return *desk;
}

}  // namespace torsio::gui
