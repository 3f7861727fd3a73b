// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// "0.1.0": stored with every trial, result and report.
[[nodiscard]] std::string softwareVersion();

}  // namespace torsio
