// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/outputs/wording/wording.h"
#include "app/web/case_picture.h"
#include "app/web/http_message.h"
#include "app/web/json_body.h"
#include "app/web/web_sessions.h"
#include "sim/core/error.h"

namespace torsio::web {

class WebDesk;

/// One request on its way to a service.
struct Call {
  const HttpRequest& request;
  WebDesk& desk;
  /// Signed in as the session's actor; nobody for an open route.
  SessionContext& context;
  WebSession* session;                    ///< null for an open route
  const std::vector<std::string>& parts;  ///< what stands for `*` in the route's path
  const JsonBody& body;                   ///< empty for GET
  const Wording& wording;
  SteadyTime now;
};

/// Who may use a route at all; the services ask for rights on top.
enum class RouteAccess { kOpen, kSignedIn };

struct Route {
  std::string method{};
  std::string path{};  ///< "/api/cases/*/sheet"
  RouteAccess access = RouteAccess::kSignedIn;
  std::function<HttpResponse(Call&)> answer{};
  /// May take seconds of a core: done beside the others, and never while its session waits for it. Its answer
  /// changes nothing of the session.
  bool heavy = false;
};

/// All addresses of the desk but those of its pages. What stands nowhere here does not exist.
class Router {
 public:
  explicit Router(std::vector<Route> routes) : routes_(std::move(routes)) {}

  struct Match {
    const Route* route = nullptr;
    std::vector<std::string> parts{};
    bool otherMethod = false;  ///< the address exists, for another method
  };
  [[nodiscard]] Match find(const std::string& method, const std::string& path) const;
  [[nodiscard]] const std::vector<Route>& routes() const noexcept { return routes_; }

 private:
  std::vector<Route> routes_;
};

/// The routes of signing in and out, and of what a page needs before (sign_in_routes.cpp).
[[nodiscard]] std::vector<Route> signInRoutes();
/// Who is signed in with a browser (session_routes.cpp).
[[nodiscard]] std::vector<Route> sessionRoutes();
/// Links of invitation (invitation_routes.cpp).
[[nodiscard]] std::vector<Route> invitationRoutes();
/// The form of an evaluation, calibration and own severity, own records, the boards (the files of these
/// names).
[[nodiscard]] std::vector<Route> evaluationRoutes();
[[nodiscard]] std::vector<Route> raterRoutes();
[[nodiscard]] std::vector<Route> ownRoutes();
[[nodiscard]] std::vector<Route> boardRoutes();
/// The picture of an own case, made or kept; asks for the right each time (case_routes.cpp).
[[nodiscard]] std::shared_ptr<const CasePicture> pictureOf(WebDesk& desk, SessionContext& context,
                                                           const AssignmentId& assignmentId);
/// The routes of a rater's cases (case_routes.cpp).
[[nodiscard]] std::vector<Route> caseRoutes();

[[nodiscard]] HttpResponse jsonAnswer(const nlohmann::json& json, int status = 200);
/// What went wrong, in the language of the page; `status` as docs/server.md lists them.
[[nodiscard]] HttpResponse refusal(int status, const Error& error, const Wording& wording,
                                   nlohmann::json more = nlohmann::json::object());

}  // namespace torsio::web
