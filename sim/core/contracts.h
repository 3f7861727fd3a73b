// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

/// Throws ContractError. Called by TORSIO_EXPECTS only.
[[noreturn]] void contractBroken(const char* condition, const char* file, int line);

}  // namespace torsio

/// Checks a precondition on our own code; always on. Not for user input (throw Error), not in the servo
/// tick.
#define TORSIO_EXPECTS(condition)                                               \
  do {                                                                          \
    if (!(condition)) ::torsio::contractBroken(#condition, __FILE__, __LINE__); \
  } while (false)
