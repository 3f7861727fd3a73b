// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "app/gui/base/page.h"

namespace torsio::gui {

class StationDesk;

/// The pages of the trainee, in the order of the navigation; the first one is home.
[[nodiscard]] std::vector<PageEntry> stationPages(const std::shared_ptr<StationDesk>& desk);
/// Screens of these pages for the user guide.
[[nodiscard]] std::vector<ScreenEntry> stationScreens();

}  // namespace torsio::gui
