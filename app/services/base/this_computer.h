// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <string_view>

namespace torsio {

/// Returns whether a host name or address is this computer's own, so that traffic to it does not leave the
/// computer. A name that merely begins like an address ("127.0.0.1.example.org") is not. An IPv6 address may
/// be in brackets, as in a URL.
[[nodiscard]] inline bool isThisComputer(std::string_view host) {
  if (host == "localhost" || host == "::1" || host == "[::1]") {
    return true;
  }
  // 127.0.0.0/8: digits and three dots only, since a name ends in a letter.
  return host.starts_with("127.") && std::count(host.begin(), host.end(), '.') == 3 && host.back() != '.' &&
         std::all_of(host.begin(), host.end(), [](char c) { return c == '.' || (c >= '0' && c <= '9'); });
}

}  // namespace torsio
