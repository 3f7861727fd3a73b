// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio::cli {

/// True if standard error is a terminal (terminal_posix.cpp, terminal_windows.cpp).
[[nodiscard]] bool standardErrorIsTerminal() noexcept;

/// Asks for a secret at the terminal without echo. Throws Error (kUsage) if there is no terminal.
[[nodiscard]] std::string typedSecret(const std::string& question);

/// Returns the next line of an open file descriptor, for a secret passed by another program. Throws Error
/// (kUsage) if nothing can be read.
[[nodiscard]] std::string secretFrom(int descriptor);

/// True if the account that runs the program owns the file.
[[nodiscard]] bool ownsFile(const std::string& file);

/// Returns the operating system account that runs the program, by number or name.
[[nodiscard]] std::string systemAccount();

}  // namespace torsio::cli
