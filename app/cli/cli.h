// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::cli {

/// True when the arguments ask for the command line: a first word that is no option, --help or --version.
/// Otherwise the window starts.
[[nodiscard]] bool wantsCommandLine(int argc, char** argv);

/// Runs one command and returns the exit code (docs/cli.md). Standard output is the command's; messages and
/// progress go to standard error.
[[nodiscard]] int runCommandLine(int argc, char** argv);

/// The same without the Qt application of the process, which draws reports and loads database drivers: for
/// commands that need neither, as often as wanted in one process.
[[nodiscard]] int runCommand(int argc, char** argv);

/// One line on standard error for whatever is being thrown, and its exit code. Call inside a catch block.
[[nodiscard]] int reportFailure() noexcept;

}  // namespace torsio::cli
