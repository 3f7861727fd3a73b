// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Whether a host's name or address is this computer's own: nothing that goes there leaves it.
[[nodiscard]] inline bool isThisComputer(const std::string& host) {
  return host == "localhost" || host == "::1" || host == "[::1]" || host.starts_with("127.");
}

}  // namespace torsio
