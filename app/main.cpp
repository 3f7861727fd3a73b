// SPDX-License-Identifier: GPL-3.0-or-later
#include <string_view>

#include "app/cli/cli.h"
#include "app/gui/program/screenshots.h"
#include "app/gui/program/window_main.h"
#include "sim/core/private_files.h"

int main(int argc, char** argv) {
  torsio::keepFilesPrivate();
  // The one command that draws the program's own windows.
  const bool screenshots = argc > 1 && std::string_view(argv[1]) == "screenshots";
  if (!screenshots && torsio::cli::wantsCommandLine(argc, argv)) {
    return torsio::cli::runCommandLine(argc, argv);
  }
  try {
    return screenshots ? torsio::gui::runScreenshots(argc, argv) : torsio::gui::runWindow(argc, argv);
  } catch (...) {
    return torsio::cli::reportFailure();
  }
}
