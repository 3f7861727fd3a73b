// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/page.h"

namespace torsio::gui {

/// The pages of the administrator, allocator and statistician, in the order of the navigation; the first one
/// is home.
[[nodiscard]] std::vector<PageEntry> administratorPages();
/// Screens of these pages for the user guide.
[[nodiscard]] std::vector<ScreenEntry> administratorScreens();
/// Screens of dialogs on these pages. A dialog keeps the language in which it was opened.
[[nodiscard]] std::vector<ScreenEntry> administratorDialogs();

}  // namespace torsio::gui
