// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cli.h"
#include "app/gui/window_main.h"

int main(int argc, char** argv) {
  if (torsio::cli::wantsCommandLine(argc, argv)) return torsio::cli::runCommandLine(argc, argv);
  try {
    return torsio::gui::runWindow(argc, argv);
  } catch (...) {
    return torsio::cli::reportFailure();
  }
}
