// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/outputs/wording/wording.h"
#include "app/web/case_picture.h"
#include "app/web/http_server.h"
#include "app/web/web_sessions.h"
#include "assessment/domain/people/signature.h"
#include "sim/core/error.h"

namespace torsio::web {

/// Reads a JSON object from a browser field by field. A missing field, a wrong type or a value out of range
/// throws Error{kBadParameter} naming the field.
class JsonBody {
 public:
  /// Throws Error{kBadParameter} if `text` is not a JSON object.
  [[nodiscard]] static JsonBody parse(const std::string& text);
  explicit JsonBody(nlohmann::json object) : object_(std::move(object)) {}

  [[nodiscard]] bool has(const char* field) const;
  /// At most `most` bytes.
  [[nodiscard]] std::string text(const char* field, std::size_t most) const;
  /// Like text(); empty if the field is missing or null.
  [[nodiscard]] std::string textOrNone(const char* field, std::size_t most) const;
  [[nodiscard]] std::int64_t whole(const char* field, std::int64_t least, std::int64_t most) const;
  /// Empty if the field is missing or null.
  [[nodiscard]] std::optional<std::int64_t> wholeOrNone(const char* field, std::int64_t least,
                                                        std::int64_t most) const;
  [[nodiscard]] double number(const char* field, double least, double most) const;
  [[nodiscard]] JsonBody object(const char* field) const;
  /// Returns the objects of an array of at most `most`.
  [[nodiscard]] std::vector<JsonBody> objects(const char* field, std::size_t most) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* field) const;

  nlohmann::json object_;
};

class WebDesk;

/// A request being passed to a service.
struct Call {
  const HttpRequest& request;
  WebDesk& desk;
  /// Signed in as the session's actor; nobody for an open route.
  SessionContext& context;
  WebSession* session;                    ///< null for an open route
  const std::vector<std::string>& parts;  ///< matches of `*` in the route's path
  const JsonBody& body;                   ///< empty for GET
  const Wording& wording;
  SteadyTime now;
};

/// Whether a route hashes a password: such requests wait for one thread, because each takes a quarter of a
/// gigabyte. kIfSent: if the body contains one.
enum class Hashing { kNever, kIfSent, kAlways };

/// Who may use a route; services check rights in addition. kAlways: anybody, also while the record cannot be
/// reached.
enum class RouteAccess { kAlways, kOpen, kSignedIn };

struct Route {
  std::string method{};
  std::string path{};  ///< "/api/cases/*/sheet"
  RouteAccess access = RouteAccess::kSignedIn;
  std::function<HttpResponse(Call&)> answer{};
  /// Takes up to seconds of a core: runs beside the session's other requests without blocking them, and must
  /// not change the session.
  bool heavy = false;
  /// Answers kNothingNew if there is nothing to tell; then it is asked again at news, and by the page after
  /// half a minute.
  bool waits = false;
  Hashing hashing = Hashing::kNever;
  bool isOfHealth = false;  ///< answers whatever name the desk is called by: it tells nothing
  /// Of kAlways: answers at once, without the record.
  HttpResponse (*atOnce)(WebDesk& desk, const HttpRequest& request) = nullptr;
};
/// HTTP: no content.
inline constexpr int kNothingNew = 204;

/// All routes of the desk, except its pages. Any other address is 404.
class Router {
 public:
  explicit Router(std::vector<Route> routes) : routes_(std::move(routes)) {}

  struct Match {
    const Route* route = nullptr;
    std::vector<std::string> parts{};
    bool otherMethod = false;  ///< the address exists with another method
  };
  [[nodiscard]] Match find(const std::string& method, const std::string& path) const;
  [[nodiscard]] const std::vector<Route>& routes() const noexcept { return routes_; }

 private:
  std::vector<Route> routes_;
};

/// Routes for a supervisor of the server: is it alive, does the record answer (sign_in_routes.cpp). Without
/// personal data.
[[nodiscard]] std::vector<Route> healthRoutes();
/// Routes for signing in and out, and for what pages need before that (sign_in_routes.cpp).
[[nodiscard]] std::vector<Route> signInRoutes();
/// Routes for listing and ending browser sessions (sign_in_routes.cpp).
[[nodiscard]] std::vector<Route> sessionRoutes();
/// Routes for invitation links (invitation_routes.cpp).
[[nodiscard]] std::vector<Route> invitationRoutes();
/// Routes of the evaluation form, calibration and severity, own records, and the boards (files of these
/// names).
[[nodiscard]] std::vector<Route> evaluationRoutes();
[[nodiscard]] std::vector<Route> raterRoutes();
[[nodiscard]] std::vector<Route> ownRoutes();
[[nodiscard]] std::vector<Route> boardRoutes();
/// Routes of calls to the real arm and of live sheets (live_routes.cpp).
[[nodiscard]] std::vector<Route> liveRoutes();
/// Returns the cohort named in the path (board_routes.cpp). Throws Error{kBadParameter}.
[[nodiscard]] CohortId cohortOf(const Call& call);
/// Returns the picture of one of the actor's cases, cached or made; checks the right each time
/// (case_routes.cpp).
[[nodiscard]] std::shared_ptr<const CasePicture> pictureOf(WebDesk& desk, SessionContext& context,
                                                           const AssignmentId& assignmentId);
/// Routes of a rater's cases (case_routes.cpp).
[[nodiscard]] std::vector<Route> caseRoutes();

inline constexpr std::size_t kMaxBytesOfALetter = 4;

/// Returns a text in the page's language.
[[nodiscard]] std::string said(const Call& call, const Text& text);
/// Returns what the object of a handle has after `kind` ("run "); empty if it is of another kind, unknown, or
/// of another session.
[[nodiscard]] std::optional<std::string> objectOf(const Call& call, const std::string& handle,
                                                  std::string_view kind);
/// Returns the case named in the path. Throws Error{kPermission} alike for an unknown handle and one of
/// another session.
[[nodiscard]] AssignmentId caseOf(const Call& call);
/// Returns an array of `show(one)` for each of `all`.
template <typename All, typename Show>
[[nodiscard]] nlohmann::json jsonList(const All& all, const Show& show) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& one : all) {
    list.push_back(show(one));
  }
  return list;
}
template <typename Value>
[[nodiscard]] nlohmann::json orNull(const std::optional<Value>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json(nullptr);
}

[[nodiscard]] HttpResponse jsonAnswer(const nlohmann::json& json, int status = 200);
/// Makes an error response in the page's language; docs/server.md lists the values of `status`.
[[nodiscard]] HttpResponse refusal(int status, const Error& error, const Wording& wording,
                                   nlohmann::json more = nlohmann::json::object());
[[nodiscard]] HttpResponse refusal(const Call& call, int status, ErrorCode code, const Text& what,
                                   const Text& remedy, nlohmann::json more = nlohmann::json::object());

/// Performs a sealing act after checking the password sent with it. If a password is required, answers 403
/// "need_password" with the meaning of the signature.
[[nodiscard]] HttpResponse sealing(Call& call, SignatureMeaning meaning,
                                   const std::function<HttpResponse()>& act);

/// Returns the route of such an act.
[[nodiscard]] Route sealingRoute(const char* path, HttpResponse (*answer)(Call&));

/// Returns `routes` with those of a recording and of its organ below `path`.
[[nodiscard]] std::vector<Route> withPicture(std::vector<Route> routes, const std::string& path,
                                             std::shared_ptr<const CasePicture> (*picture)(Call&));
/// Answers with a gzipped container, unpacked if the browser requires.
[[nodiscard]] HttpResponse binaryAnswer(const Call& call, const std::string& packed);

}  // namespace torsio::web
