// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace torsio {

/// What a web server answered.
struct WebAnswer {
  int status = 0;      ///< HTTP status; 0: no answer, for the reason in `body`
  std::string body{};  ///< bytes
};

/// Sends `body` to an http:// or https:// address by POST and returns the answer. Certificates are checked,
/// redirects not followed. Waits at most `patience` in all, and takes at most `most_bytes` of headers and
/// body together: what is later or longer is no answer. Any thread; needs no event loop.
[[nodiscard]] WebAnswer postedTo(const std::string& address, const std::string& contentType,
                                 const std::string& body, std::chrono::milliseconds patience,
                                 std::size_t most_bytes);

}  // namespace torsio
