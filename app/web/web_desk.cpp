// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/web_desk.h"

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "app/services/access/browser_sessions.h"
#include "app/services/access/settings_service.h"
#include "app/services/access/signing.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio::web {

namespace {

constexpr std::size_t kPictures_bytes = 64UL * 1024UL * 1024UL;
constexpr std::size_t kSignInTries = 10;
constexpr std::chrono::seconds kIdleSlack{60};  // pages in use report every half minute
constexpr int kMaxHashers = 4;                  // one running, the others waiting a second or two
constexpr std::size_t kWorkersOfAFile = 4;      // writers to a file wait for each other
constexpr std::size_t kWorkersOfAServer = 8;
constexpr std::size_t kHeavyThreads = 2;  // one makes pictures, the other serves trainees

std::size_t workersFor(const DeskSettings& settings) {
  if (settings.workers > 0) {
    return settings.workers;
  }
  return parseLocator(settings.locator).engine == Engine::kSqlite ? kWorkersOfAFile : kWorkersOfAServer;
}

std::vector<Route> allRoutes() {
  std::vector<Route> routes;
  for (auto* const part : {signInRoutes, sessionRoutes, caseRoutes, evaluationRoutes, raterRoutes, ownRoutes,
                           boardRoutes, invitationRoutes}) {
    std::vector<Route> some = part();
    std::move(some.begin(), some.end(), std::back_inserter(routes));
  }
  return routes;
}

/// See docs/server.md.
void addSecurityHeaders(HttpResponse& response) {
  const std::pair<const char*, const char*> kHeaders[] = {
      {"Content-Security-Policy",
       "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self'; connect-src 'self'; "
       "font-src 'self'; form-action 'self'; base-uri 'none'; frame-ancestors 'none'; "
       "require-trusted-types-for 'script'"},
      {"X-Content-Type-Options", "nosniff"},
      {"Referrer-Policy", "no-referrer"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Permissions-Policy", "camera=(), microphone=(), geolocation=()"},
      {"X-Frame-Options", "DENY"}};
  for (const auto& [name, value] : kHeaders) {
    response.headers.emplace_back(name, value);
  }
}

int statusOf(const Error& error) {
  const auto* database = dynamic_cast<const DbError*>(&error);
  if (database != nullptr) {
    return database->fault() == DbFault::kConflict ? 409 : 503;
  }
  switch (error.code()) {
    case ErrorCode::kPermission:
      return 403;
    case ErrorCode::kUsage:
    case ErrorCode::kBadParameter:
    case ErrorCode::kBadData:
      return 400;
    case ErrorCode::kDatabase:
      return 503;
    default:
      return 500;
  }
}

Error simpleRefusal(const Text& what, const Text& remedy) {
  return {ErrorCode::kPermission, what, "", remedy};
}

HttpResponse refused(int status, const Wording& wording) {
  switch (status) {
    case 401:
      return refusal(status, simpleRefusal(Text::tr("nobody is signed in"), Text::tr("Sign in first")),
                     wording);
    case 503:
      return refusal(status,
                     simpleRefusal(Text::tr("the server is busy"), Text::tr("Try again in a few seconds")),
                     wording);
    case 500:
      return refusal(status,
                     simpleRefusal(Text::tr("Something unexpected happened"),
                                   Text::tr("Try again, or tell an administrator")),
                     wording);
    default:
      return refusal(
          status,
          simpleRefusal(Text::tr("there is nothing at this address"), Text::tr("Load the page again")),
          wording);
  }
}

bool isChange(const std::string& method) {
  return method != "GET" && method != "HEAD";
}

/// Converts a service's exception to an answer.
HttpResponse answerOf(const std::exception_ptr& thrown, const Wording& wording) {
  try {
    std::rethrow_exception(thrown);
  } catch (const PasswordDue& due) {
    return refusal(403, due, wording, {{"need_password", true}});
  } catch (const Error& error) {
    const int status = statusOf(error);
    // Database errors may name rows, so their text is not sent.
    return dynamic_cast<const DbError*>(&error) != nullptr && status == 503 ? refused(status, wording)
                                                                            : refusal(status, error, wording);
  } catch (...) {
    return refused(500, wording);
  }
}

}  // namespace

WebDesk::WebDesk(const DeskSettings& settings)
    : settings_(settings),
      pages_(settings.assets),
      router_(allRoutes()),
      sessions_({}),
      signInTries_(kSignInTries, std::chrono::minutes(1)),
      pictures_(kPictures_bytes),
      workers_(settings.locator, workersFor(settings), settings.passwordCost),
      heavy_(settings.locator, kHeavyThreads, settings.passwordCost) {
  for (const std::string& language : reportLanguages()) {
    languages_.emplace(language, wordingIn(language));
  }
}

WebDesk::~WebDesk() = default;

bool WebDesk::enterHashing() {
  if (hashers_.fetch_add(1) >= kMaxHashers) {
    hashers_.fetch_sub(1);
    return false;
  }
  hashing_.lock();
  return true;
}

void WebDesk::leaveHashing() {
  hashing_.unlock();
  hashers_.fetch_sub(1);
}

void WebDesk::prepare(const Actor& actor, const AssignmentId& assignmentId) {
  if (!heavy_.isIdle()) {
    return;  // somebody who opens a case has priority
  }
  (void)heavy_.take([this, actor, assignmentId](SessionContext& context) {
    context.setActor(actor);
    try {
      (void)pictureOf(*this, context, assignmentId);
    } catch (...) {
      // The error is reported when the case is opened.
    }
  });
}

const Wording& WebDesk::wordingFor(const HttpRequest& request) const {
  const auto asked = languages_.find(request.header("x-torsio-language"));
  if (asked != languages_.end()) {
    return asked->second;
  }
  const bool chinese = request.header("accept-language").rfind("zh", 0) == 0;
  return languages_.at(chinese ? "zh_CN" : "en");
}

bool WebDesk::fromOwnPage(const HttpRequest& request) const {
  const std::string site = request.header("sec-fetch-site");
  if (!site.empty()) {
    return site == "same-origin";
  }
  return request.header("origin") == addressFor(request);
}

std::string WebDesk::addressFor(const HttpRequest& request) const {
  const std::string scheme = request.encrypted ? "https://" : "http://";
  return settings_.publicUrl.empty() ? scheme + request.header("host") : settings_.publicUrl;
}

std::string WebDesk::clientOf(const HttpRequest& request) const {
  const std::string forwarded = request.header("x-forwarded-for");
  if (settings_.publicUrl.empty() || forwarded.empty() || !HttpAddress{request.address, 0}.isLoopback()) {
    return request.address;
  }
  const std::size_t begin = forwarded.find_last_of(", ");
  return forwarded.substr(begin == std::string::npos ? 0 : begin + 1);
}

void WebDesk::handle(HttpRequest request, HttpServer::Reply reply) {
  const Wording& wording = wordingFor(request);
  Router::Match match = router_.find(request.method, request.path);
  const auto finish = [this, reply, begun = std::chrono::steady_clock::now(),
                       what = match.route == nullptr ? std::string("-")
                                                     : match.route->method + " " + match.route->path](
                          HttpResponse response, const char* page = nullptr) {
    addSecurityHeaders(response);
    if (settings_.accessLog) {
      const auto took = std::chrono::steady_clock::now() - begun;
      settings_.accessLog(
          (page == nullptr ? what : page) + (" " + std::to_string(response.status) + " ") +
          std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(took).count()) + " ms");
    }
    reply(std::move(response));
  };
  if (request.method == "GET") {
    if (auto page = pages_.answer(request)) {
      return finish(std::move(*page), "GET a page");
    }
  }
  if (match.route == nullptr) {
    return finish(refused(match.otherMethod ? 405 : 404, wording));
  }
  const Route& route = *match.route;
  auto work = [this, request = std::move(request), match = std::move(match),
               finish](SessionContext& context) {
    try {
      finish(answer(request, *match.route, match.parts, context));
    } catch (...) {
      finish(answerOf(std::current_exception(), wordingFor(request)));
    }
  };
  if (!(route.heavy ? heavy_ : workers_).take(std::move(work))) {
    HttpResponse busy = refused(503, wording);
    busy.headers.emplace_back("Retry-After", "2");
    finish(std::move(busy));
  }
}

HttpResponse WebDesk::answer(const HttpRequest& request, const Route& route,
                             const std::vector<std::string>& parts, SessionContext& context) {
  const Wording& wording = wordingFor(request);
  const bool change = isChange(request.method);
  const bool json = request.header("content-type").rfind("application/json", 0) == 0;
  if (change && (!json || !fromOwnPage(request))) {
    return refusal(
        403,
        simpleRefusal(Text::tr("this was not ordered by a page of Torsio"), Text::tr("Load the page again")),
        wording);
  }
  const SteadyTime now = std::chrono::steady_clock::now();
  if (sessions_.idleIsOld(now)) {
    // The page locks itself then; this covers pages that are asleep, closed, or not ours.
    sessions_.setIdle(
        std::chrono::seconds(centreIdleLimits(context.connectionWithoutRight()).lock_us / kSecond_us) +
        kIdleSlack);
  }
  const std::shared_ptr<WebSession> session =
      route.access == RouteAccess::kOpen ? nullptr : sessions_.find(request.cookie(kCookie), now);
  if (route.access == RouteAccess::kSignedIn && session == nullptr) {
    return refused(401, wording);
  }
  if (session != nullptr && passwordStamp(context, session->userId) != session->stamp) {
    sessions_.closeAll(session->userId);  // the password was changed or the account disabled
    return refused(401, wording);
  }
  std::unique_lock<std::mutex> busy;
  if (session != nullptr) {
    if (change && request.header("x-torsio-token") != session->token) {
      return refused(401, wording);
    }
    busy = std::unique_lock(session->busy);
    context.setActor(session->actor);
    if (route.heavy) {
      busy.unlock();
    }
  }
  const JsonBody body = change ? JsonBody::parse(request.body) : JsonBody(nlohmann::json::object());
  Call call{request, *this, context, session.get(), parts, body, wording, now};
  const auto keepActor = [&] {
    if (session != nullptr && !route.heavy) {
      session->actor = context.actor();  // a signature may have consumed the password
    }
  };
  try {
    HttpResponse response = route.answer(call);
    keepActor();
    return response;
  } catch (...) {
    keepActor();
    throw;
  }
}

}  // namespace torsio::web
