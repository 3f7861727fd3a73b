// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/cli.h"
#include "app/gui/program/window_main.h"
#include "sim/core/file_io.h"

int main(int argc, char** argv) {
  torsio::keepFilesPrivate();
  return torsio::cli::runCommandLine(argc, argv, {torsio::gui::addWindow, torsio::gui::addScreenshots});
}
