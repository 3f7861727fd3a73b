// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio::cli {

/// True when standard error is a terminal, so that a person watches it (terminal_posix.cpp,
/// terminal_windows.cpp).
[[nodiscard]] bool standardErrorIsTerminal() noexcept;

/// Asks a person at the terminal for a secret that is not shown while they type. Throws Error (kUsage) when
/// the program has no terminal.
[[nodiscard]] std::string typedSecret(const std::string& question);

/// The first line of an open file descriptor, for a secret that another program hands over. Throws Error
/// (kUsage) when nothing can be read there.
[[nodiscard]] std::string secretFrom(int descriptor);

/// Whether the account that runs the program owns the file.
[[nodiscard]] bool ownsFile(const std::string& file);

/// The account of the operating system that runs the program, by number or name.
[[nodiscard]] std::string systemAccount();

}  // namespace torsio::cli
