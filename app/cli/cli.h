// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>

namespace CLI {
class App;
}

namespace torsio::cli {

/// Adds options or a command to the program.
using ProgramAddition = void (*)(CLI::App& program);

/// Runs the command line and returns the exit code (docs/cli.md). Results go to standard output; messages and
/// progress to standard error. `windows`: options and commands that open windows and create their own Qt
/// application; all other commands use the one of the process, or get one without a display, which draws
/// reports and loads database drivers.
[[nodiscard]] int runCommandLine(int argc, char** argv, std::initializer_list<ProgramAddition> windows);

}  // namespace torsio::cli
