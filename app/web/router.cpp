// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/router.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "app/services/access/signing.h"
#include "app/web/page_files.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"

namespace torsio::web {

namespace {

constexpr int kDeepest = 16;

[[noreturn]] void refuseField(const std::string& field) {
  refuseParameter(Text::tr("the page sent something that cannot be used"), field,
                  Text::tr("Load the page again"));
}

}  // namespace

JsonBody JsonBody::parse(const std::string& text) {
  // Reading a value recurses into it, so nesting deeper than any page's is rejected.
  bool tooDeep = false;
  const auto keep = [&](int depth, nlohmann::json::parse_event_t, nlohmann::json&) {
    tooDeep = tooDeep || depth > kDeepest;
    return !tooDeep;
  };
  nlohmann::json json = nlohmann::json::parse(text, keep, false);
  if (tooDeep || !json.is_object()) {
    refuseField("");
  }
  return JsonBody(std::move(json));
}

bool JsonBody::has(const char* field) const {
  const auto found = object_.find(field);
  return found != object_.end() && !found->is_null();
}

const nlohmann::json& JsonBody::at(const char* field) const {
  const auto found = object_.find(field);
  if (found == object_.end()) {
    refuseField(field);
  }
  return *found;
}

std::string JsonBody::text(const char* field, std::size_t most) const {
  const nlohmann::json& value = at(field);
  if (!value.is_string() || value.get_ref<const std::string&>().size() > most) {
    refuseField(field);
  }
  return value.get<std::string>();
}

std::string JsonBody::textOrNone(const char* field, std::size_t most) const {
  return has(field) ? text(field, most) : std::string();
}

std::int64_t JsonBody::whole(const char* field, std::int64_t least, std::int64_t most) const {
  const nlohmann::json& value = at(field);
  const bool tooLarge =
      value.is_number_unsigned() && value.get<std::uint64_t>() > static_cast<std::uint64_t>(INT64_MAX);
  if (!value.is_number_integer() || tooLarge || value.get<std::int64_t>() < least ||
      value.get<std::int64_t>() > most) {
    refuseField(field);
  }
  return value.get<std::int64_t>();
}

std::optional<std::int64_t> JsonBody::wholeOrNone(const char* field, std::int64_t least,
                                                  std::int64_t most) const {
  return has(field) ? std::optional(whole(field, least, most)) : std::nullopt;
}

double JsonBody::number(const char* field, double least, double most) const {
  const nlohmann::json& value = at(field);
  if (!value.is_number()) {
    refuseField(field);
  }
  const auto number = value.get<double>();
  if (!std::isfinite(number) || number < least || number > most) {
    refuseField(field);
  }
  return number;
}

JsonBody JsonBody::object(const char* field) const {
  const nlohmann::json& value = at(field);
  if (!value.is_object()) {
    refuseField(field);
  }
  return JsonBody(value);
}

std::vector<JsonBody> JsonBody::objects(const char* field, std::size_t most) const {
  const nlohmann::json& value = at(field);
  if (!value.is_array() || value.size() > most) {
    refuseField(field);
  }
  std::vector<JsonBody> bodies;
  for (const nlohmann::json& one : value) {
    if (!one.is_object()) {
      refuseField(field);
    }
    bodies.emplace_back(one);
  }
  return bodies;
}

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

std::string said(const Call& call, const Text& text) {
  return call.wording(text).toStdString();
}

std::optional<std::string> objectOf(const Call& call, const std::string& handle, std::string_view kind) {
  const std::string what = call.session->objectOf(handle);
  return what.starts_with(kind) ? std::optional(what.substr(kind.size())) : std::nullopt;
}

AssignmentId caseOf(const Call& call) {
  const auto found = call.session->caseOf(call.parts.front());
  if (!found) {
    throw Error(ErrorCode::kPermission, Text::tr("this case is not yours"), Text::tr("the queue"),
                Text::tr("Open a case from your own queue"));
  }
  return *found;
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

HttpResponse refusal(const Call& call, int status, ErrorCode code, const Text& what, const Text& remedy,
                     nlohmann::json more) {
  return refusal(status, Error(code, what, "", remedy), call.wording, std::move(more));
}

namespace {

constexpr std::size_t kLongestPassword_bytes = 1024;

/// Checks the password sent with a sealing act, if any.
void checkShownPassword(Call& call) {
  if (!call.body.has("password")) {
    return;
  }
  showPassword(call.context, call.body.text("password", kLongestPassword_bytes));
}

}  // namespace

HttpResponse sealing(Call& call, SignatureMeaning meaning, const std::function<HttpResponse()>& act) {
  try {
    checkShownPassword(call);
    return act();
  } catch (const PasswordDue& due) {
    return refusal(403, due, call.wording,
                   {{"need_password", true}, {"meaning", said(call, labelOf(meaning))}});
  }
}

Route sealingRoute(const char* path, HttpResponse (*answer)(Call&)) {
  return {.method = "POST", .path = path, .answer = answer, .hashing = Hashing::kIfSent};
}

HttpResponse binaryAnswer(const Call& call, const std::string& packed) {
  HttpResponse response;
  response.type = "application/octet-stream";
  response.headers = {{"Cache-Control", "no-store"}};
  putPacked(response, call.request, packed, nullptr);
  return response;
}

std::vector<Route> withPicture(std::vector<Route> routes, const std::string& path,
                               std::shared_ptr<const CasePicture> (*picture)(Call&)) {
  const auto recording = [picture](Call& call) { return binaryAnswer(call, picture(call)->recording); };
  const auto organ = [picture](Call& call) {
    const std::shared_ptr<const CasePicture> shown = picture(call);
    if (shown->organ.empty()) {
      return refusal(call, 404, ErrorCode::kBadData,
                     Text::tr("the organ of this recording is not on this machine"),
                     Text::tr("Score from the traces, or ask an administrator for the organ file"));
    }
    return binaryAnswer(call, shown->organ);
  };
  routes.push_back({"GET", path + "/recording", RouteAccess::kSignedIn, recording, true});
  routes.push_back({"GET", path + "/organ", RouteAccess::kSignedIn, organ, true});
  return routes;
}

}  // namespace torsio::web
