// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "app/gui/program/screenshot.h"
#include "app/gui/program/screenshots.h"
#include "app/gui/widgets/theme.h"

namespace CLI {
class App;
}

namespace torsio::gui {

/// Options of the window on the command line; `torsio --help` explains each of them.
struct WindowOptions {
  std::optional<ThemeKind> theme;
  ScreenshotRequest picture;          ///< its scene is also the simulator's; without a file: no picture
  std::optional<double> frameRate_s;  ///< duration of a measurement
  bool simulator = false;             ///< an organ, picture or rate was requested
  bool kiosk = false;
  std::string database;  ///< for this run; empty: the station's
};

/// Adds the options of the window, which opens if the command line names no command.
void addWindow(CLI::App& program);
/// Adds `torsio screenshots`.
void addScreenshots(CLI::App& program);

}  // namespace torsio::gui
