// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace torsio {

/// Decompresses a gzip stream.
[[nodiscard]] std::string unpackedGzip(const std::string& bytes);

/// A server's answer. Status 0: the connection was closed without one.
struct DeskAnswer {
  int status = 0;
  std::map<std::string, std::string> headers{};  ///< lower-case names; the first of each
  std::vector<std::string> cookies{};            ///< "name=value", of every Set-Cookie
  std::string body{};                            ///< decompressed
  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
};

/// A minimal browser: plain HTTP over a new socket for each request; keeps cookie and token.
class WebClient {
 public:
  explicit WebClient(std::uint16_t port) : port_(port) {}

  [[nodiscard]] DeskAnswer get(const std::string& path);
  /// Sends JSON by PUT or POST, like a page of the desk.
  [[nodiscard]] DeskAnswer send(const std::string& method, const std::string& path,
                                const nlohmann::json& body);
  [[nodiscard]] DeskAnswer raw(const std::string& bytes) const;
  /// Signs in; false if refused.
  bool signIn(const std::string& login, const std::string& password);

  int patience_ms = 60'000;  ///< timeout of an answer
  std::string cookie{};
  std::string token{};
  std::vector<std::pair<std::string, std::string>> headers{};  ///< additional headers of every request

 private:
  [[nodiscard]] DeskAnswer exchange(const std::string& head, const std::string& body);
  std::uint16_t port_;
};

}  // namespace torsio
