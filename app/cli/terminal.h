// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio::cli {

/// True when a person watches standard error; terminal_posix.cpp or terminal_windows.cpp.
[[nodiscard]] bool standardErrorIsTerminal() noexcept;

}  // namespace torsio::cli
