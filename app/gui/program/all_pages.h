// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/shell/desk.h"

namespace torsio::gui {

/// Every page of the program, by line of work and in the order of the navigation. The desk keeps what its
/// actor may open.
[[nodiscard]] std::vector<PageGroup> allPages();

/// Every picture of the user guide that shows a page.
[[nodiscard]] std::vector<ScreenEntry> allScreens();
/// Pictures of dialogs, which keep the language in which they were opened.
[[nodiscard]] std::vector<ScreenEntry> allDialogs();

}  // namespace torsio::gui
