// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/shell/desk.h"

namespace torsio::gui {

/// All pages, by role and in the order of the navigation. The desk keeps those that its actor may open.
[[nodiscard]] std::vector<PageGroup> allPages();

/// All page screenshots of the user guide.
[[nodiscard]] std::vector<ScreenEntry> allScreens();
/// Screenshots of dialogs, which keep the language in which they were opened.
[[nodiscard]] std::vector<ScreenEntry> allDialogs();

}  // namespace torsio::gui
