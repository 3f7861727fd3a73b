// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace torsio::testing {

/// What a gzip stream holds.
[[nodiscard]] std::string unpackedGzip(const std::string& bytes);

/// What a server sent back. A connection that was closed without an answer has status 0.
struct WebAnswer {
  int status = 0;
  std::map<std::string, std::string> headers{};  ///< names in lower case
  std::string body{};                            ///< unpacked
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
};

/// A browser of few words: plain HTTP over a socket of its own for each request, keeps the cookie and the
/// token.
class WebClient {
 public:
  explicit WebClient(std::uint16_t port) : port_(port) {}

  [[nodiscard]] WebAnswer get(const std::string& path);
  /// PUT or POST of JSON, as a page of the desk does it.
  [[nodiscard]] WebAnswer send(const std::string& method, const std::string& path,
                               const nlohmann::json& body);
  /// Bytes as they are, and what comes back.
  [[nodiscard]] WebAnswer raw(const std::string& bytes) const;
  /// Signs in; false when that was refused.
  bool signIn(const std::string& login, const std::string& password);

  int patience_ms = 60'000;  ///< for an answer
  std::string cookie{};
  std::string token{};
  std::vector<std::pair<std::string, std::string>> headers{};  ///< more of them, sent with every request

 private:
  [[nodiscard]] WebAnswer exchange(const std::string& head, const std::string& body);
  std::uint16_t port_;
};

}  // namespace torsio::testing
