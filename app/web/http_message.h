// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace torsio::web {

/// One request as it came, within the limits of HttpLimits. Names of headers in lower case.
struct HttpRequest {
  std::string method{};  ///< "GET"
  std::string path{};    ///< "/api/queue": decoded, begins with a slash, without the query
  std::map<std::string, std::string> headers{};
  std::string body{};
  std::string address{};  ///< of the peer as the socket knows it
  bool encrypted = false;

  /// Returns the header, or an empty text.
  [[nodiscard]] std::string header(const std::string& name) const;
  /// Returns the value of a cookie, or an empty text.
  [[nodiscard]] std::string cookie(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";  ///< Content-Type
  std::string body{};
  std::vector<std::pair<std::string, std::string>> headers{};
};

}  // namespace torsio::web
