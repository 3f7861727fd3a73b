// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/base/page.h"

namespace torsio::gui {

/// The pages of the physician, in the order of the navigation; the first one is home.
[[nodiscard]] std::vector<PageEntry> reviewPages();
/// Screens of these pages for the user guide.
[[nodiscard]] std::vector<ScreenEntry> reviewScreens();

}  // namespace torsio::gui
