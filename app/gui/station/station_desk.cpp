// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/station/station_desk.h"

#include "app/gui/shell/shell_context.h"

namespace torsio::gui {

StationDesk& StationDesk::of(ShellContext& shell) {
  if (auto* desk = shell.findChild<StationDesk*>(QString(), Qt::FindDirectChildrenOnly)) return *desk;
  return *new StationDesk(&shell);
}

}  // namespace torsio::gui
