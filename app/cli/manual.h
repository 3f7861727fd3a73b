// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace torsio::cli {

// Private to app/cli's .cpp files. Both know the program by its parser alone, as --help does.

/// Returns the manual page of all commands, as roff (man macros).
[[nodiscard]] std::string manualPage(const CLI::App& program, const std::string& version);

/// Returns a script that completes commands, options and their choices in bash.
[[nodiscard]] std::string bashCompletion(const CLI::App& program);

}  // namespace torsio::cli
