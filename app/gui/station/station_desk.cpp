// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/station/station_desk.h"

#include "app/gui/shell/shell_context.h"
#include "app/session/care/station_line.h"
#include "app/session/training/haptic_station.h"

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
