// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace torsio {

/// What a web server is asked for.
struct WebRequest {
  std::string address{};                 ///< http:// or https://
  std::vector<std::string> headers{};    ///< "Name: value", without line ends
  std::optional<std::string> body{};     ///< sent by POST; none: GET
  std::chrono::milliseconds patience{};  ///< longest wait for all of the answer
  std::size_t most_bytes = 0;            ///< most bytes of its headers and body together
  /// Once another thread sets it, the wait ends within about a second. May be null; outlives the call.
  const std::atomic<bool>* stop = nullptr;
};

/// What a web server answered.
struct WebAnswer {
  int status = 0;            ///< HTTP status; 0: no answer, for the reason in `body`
  std::string body{};        ///< bytes as they came: nothing is unpacked
  std::string retryAfter{};  ///< that header; empty: none
};

/// Asks a web server outside: the one way in which Torsio does. Checks certificates, follows no redirects,
/// speaks nothing but HTTP, and goes through no proxy to this computer. What is later or longer than the
/// request allows is no answer. Any thread; needs no event loop.
[[nodiscard]] WebAnswer askWeb(const WebRequest& request);

}  // namespace torsio
