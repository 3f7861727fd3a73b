// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::cli {

/// True if the arguments ask for the command line: the first word is not an option, or --help or --version.
/// Otherwise the window starts.
[[nodiscard]] bool wantsCommandLine(int argc, char** argv);

/// Runs one command and returns the exit code (docs/cli.md). Results go to standard output; messages and
/// progress to standard error.
[[nodiscard]] int runCommandLine(int argc, char** argv);

/// Runs one command without the process's Qt application, which draws reports and loads database drivers;
/// repeatable within one process.
[[nodiscard]] int runCommand(int argc, char** argv);

/// Prints the current exception in one line to standard error and returns its exit code. Call it in a catch
/// block.
[[nodiscard]] int reportFailure() noexcept;

}  // namespace torsio::cli
