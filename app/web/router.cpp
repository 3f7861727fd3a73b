// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/router.h"

#include <algorithm>
#include <string_view>

namespace torsio::web {

namespace {

/// Matches a path against a pattern segment by segment; empty: no match.
std::optional<std::vector<std::string>> partsOf(std::string_view pattern, std::string_view path) {
  std::vector<std::string> parts;
  while (!pattern.empty() && !path.empty()) {
    const std::size_t patternEnd = std::min(pattern.find('/', 1), pattern.size());
    const std::size_t pathEnd = std::min(path.find('/', 1), path.size());
    const std::string_view wanted = pattern.substr(0, patternEnd);
    const std::string_view given = path.substr(0, pathEnd);
    if (wanted == "/*" && given.size() > 1) {
      parts.emplace_back(given.substr(1));
    } else if (wanted != given) {
      return std::nullopt;
    }
    pattern.remove_prefix(patternEnd);
    path.remove_prefix(pathEnd);
  }
  return pattern.empty() && path.empty() ? std::optional(parts) : std::nullopt;
}

}  // namespace

Router::Match Router::find(const std::string& method, const std::string& path) const {
  Match match;
  for (const Route& route : routes_) {
    auto parts = partsOf(route.path, path);
    if (!parts) {
      continue;
    }
    if (route.method == method) {
      return {&route, std::move(*parts), false};
    }
    match.otherMethod = true;
  }
  return match;
}

HttpResponse jsonAnswer(const nlohmann::json& json, int status) {
  HttpResponse response;
  response.status = status;
  response.body = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  response.headers = {{"Cache-Control", "no-store"}};
  return response;
}

HttpResponse refusal(int status, const Error& error, const Wording& wording, nlohmann::json more) {
  more["error"] = {{"code", static_cast<int>(error.code())},
                   {"what", wording(error.happenedText()).toStdString()},
                   {"where", wording(error.whereText()).toStdString()},
                   {"remedy", wording(error.remedyText()).toStdString()}};
  return jsonAnswer(more, status);
}

}  // namespace torsio::web
