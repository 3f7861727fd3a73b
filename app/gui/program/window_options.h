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

/// What was asked of the window on the command line; `torsio --help` explains each option.
struct WindowOptions {
  std::optional<ThemeKind> theme;
  ScreenshotRequest picture;          ///< its scene is also the simulator's; no file: no picture
  std::optional<double> frameRate_s;  ///< measure this long
  bool simulator = false;             ///< an organ, a picture or a rate was asked for
  bool kiosk = false;
  std::string database;  ///< of this run; empty: the station's
};

/// Adds the options of the window, and opens it when the command line names no command.
void addWindow(CLI::App& program);
/// Adds `torsio screenshots`.
void addScreenshots(CLI::App& program);

}  // namespace torsio::gui
