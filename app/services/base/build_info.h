// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Returns the version, such as "0.1.0", which is stored with every trial, result and report.
[[nodiscard]] std::string softwareVersion();

/// Returns the BLAKE2b-256 of the running program file, which identifies the build. Empty if the system does
/// not provide the path. Calculated once.
[[nodiscard]] const std::string& programHash();

}  // namespace torsio
