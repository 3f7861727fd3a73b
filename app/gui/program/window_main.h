// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/gui/program/screenshot.h"
#include "app/gui/program/screenshots.h"
#include "app/gui/shell/desk.h"
#include "app/gui/widgets/theme.h"

namespace CLI {
class App;
}

class QApplication;

namespace torsio::gui {

/// All pages, by role and in the order of the navigation. The desk keeps those that its actor may open.
[[nodiscard]] std::vector<PageGroup> allPages();

/// All page screenshots of the user guide.
[[nodiscard]] std::vector<ScreenEntry> allScreens();
/// Screenshots of dialogs, which keep the language in which they were opened.
[[nodiscard]] std::vector<ScreenEntry> allDialogs();

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

/// Creates the application object of a process with windows.
[[nodiscard]] std::unique_ptr<QApplication> makeWindowApplication();

/// Opens the window and returns when it is closed: sign-in, stations, review, administration. The simulator
/// runs without record and sign-in; its recordings are the user's files. For a picture, a scripted hand
/// twists the organ on a manual clock to the angle. Throws Error for unusable files and a display that cannot
/// draw.
void runWindow(const WindowOptions& options);

}  // namespace torsio::gui
