// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string_view>

namespace torsio {

/// Whether a host's name or address is this computer's own: nothing that goes there leaves it. A name that
/// only begins like an address ("127.0.0.1.example.org") is another computer's. An IPv6 address may stand in
/// brackets, as in a URL.
[[nodiscard]] inline bool isThisComputer(std::string_view host) {
  if (host == "localhost" || host == "::1" || host == "[::1]") {
    return true;
  }
  // Nothing but digits and three dots is an address, 127.0.0.0/8; a name ends in a letter.
  return host.starts_with("127.") && std::count(host.begin(), host.end(), '.') == 3 && host.back() != '.' &&
         std::all_of(host.begin(), host.end(), [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
}

}  // namespace torsio
