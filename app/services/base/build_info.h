// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// "0.1.0": stored with every trial, result and report.
[[nodiscard]] std::string softwareVersion();

/// BLAKE2b-256 of the program file that runs: which build it was, to the last bit. Empty where the system
/// does not tell. Read once.
[[nodiscard]] const std::string& programHash();

}  // namespace torsio
