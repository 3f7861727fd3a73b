// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace torsio::web {

/// A request within HttpLimits. Header names are lower-case.
struct HttpRequest {
  std::string method{};  ///< "GET"
  std::string path{};    ///< "/api/queue": decoded, with leading slash, without query
  std::map<std::string, std::string> headers{};
  std::string body{};
  std::string address{};  ///< of the peer, from the socket
  bool encrypted = false;

  /// Returns a header; empty if absent.
  [[nodiscard]] std::string header(const std::string& name) const;
  /// Returns the value of a cookie; empty if absent.
  [[nodiscard]] std::string cookie(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";  ///< Content-Type
  std::string body{};
  std::vector<std::pair<std::string, std::string>> headers{};
};

}  // namespace torsio::web
