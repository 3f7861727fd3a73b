// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::cli {

/// True when standard error is a terminal, so that a person watches it (terminal_posix.cpp,
/// terminal_windows.cpp).
[[nodiscard]] bool standardErrorIsTerminal() noexcept;

}  // namespace torsio::cli
