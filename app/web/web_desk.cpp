// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/web_desk.h"

#include <algorithm>
#include <arpa/inet.h>
#include <array>
#include <exception>
#include <iterator>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/database_away.h"
#include "app/services/access/signing.h"
#include "app/services/base/log.h"
#include "app/services/study/live_call.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio::web {

namespace {

constexpr std::size_t kPictures_bytes = 64UL * 1024UL * 1024UL;
constexpr std::size_t kManyWrongTries = 10;     // a minute
constexpr int kManyWrongRank = 2;               // behind everybody else
constexpr std::chrono::seconds kIdleSlack{60};  // pages in use report every half minute
constexpr std::size_t kWorkersOfAFile = 4;      // writers to a file wait for each other
constexpr std::size_t kWorkersOfAServer = 8;
constexpr std::chrono::seconds kLongestBeat{15};  // without any thread taking work
constexpr std::chrono::milliseconds kLook{500};   // how soon a call made elsewhere is noticed
constexpr std::chrono::seconds kLongestWait{25};  // of a page: proxies close silent connections
constexpr std::size_t kHeavyThreads = 2;          // one makes pictures, the other serves trainees

std::size_t workersFor(const DeskSettings& settings) {
  if (settings.workers > 0) {
    return settings.workers;
  }
  return parseLocator(settings.locator).engine == Engine::kSqlite ? kWorkersOfAFile : kWorkersOfAServer;
}

std::vector<Route> allRoutes() {
  std::vector<Route> routes;
  for (auto* const part : {healthRoutes, signInRoutes, sessionRoutes, caseRoutes, evaluationRoutes,
                           raterRoutes, ownRoutes, boardRoutes, liveRoutes, invitationRoutes}) {
    std::vector<Route> some = part();
    std::move(some.begin(), some.end(), std::back_inserter(routes));
  }
  return routes;
}

/// See docs/server.md.
void addSecurityHeaders(HttpResponse& response, bool strictTransport) {
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
  if (strictTransport) {
    response.headers.emplace_back("Strict-Transport-Security", "max-age=31536000");
  }
}

int statusOf(const Error& error) {
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

/// The answer while the record cannot be reached.
HttpResponse recordAway(const Wording& wording) {
  HttpResponse response = refusal(
      503,
      simpleRefusal(Text::tr("the record cannot be reached just now"),
                    Text::tr("Nothing is lost: this page keeps what you typed and tries again by itself")),
      wording);
  response.headers.emplace_back("Retry-After", "1");
  return response;
}

HttpResponse refusedByRecord(const DbError& error, const Wording& wording) {
  switch (error.fault()) {
    case DbFault::kConflict:
      return refusal(409, error, wording);
    case DbFault::kUnique:
      return refusal(409,
                     simpleRefusal(Text::tr("somebody else saved this at the same moment"),
                                   Text::tr("Load the page again and look before you save")),
                     wording);
    case DbFault::kUnreachable:
      return recordAway(wording);
    case DbFault::kBusy:
      return refused(503, wording);
    default:  // such errors may name rows, so their text goes to the log only
      return refusal(503,
                     simpleRefusal(Text::tr("the record does not take this"),
                                   Text::tr("Tell an administrator: the server's log contains the cause")),
                     wording);
  }
}

/// Returns the host of "Name.example:8443", "[::1]:8443" or "name/path", in lower case, without a final dot.
std::string hostIn(const std::string& text) {
  std::string host = text.substr(0, text.find('/'));
  if (host.starts_with("[")) {
    const std::size_t end = host.find(']');
    host = end == std::string::npos ? std::string() : host.substr(1, end - 1);
  } else {
    host.resize(std::min(host.size(), host.find(':')));
  }
  std::transform(host.begin(), host.end(), host.begin(), [](unsigned char letter) {
    return static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter - 'A' + 'a' : letter);
  });
  if (host.ends_with(".")) {
    host.pop_back();
  }
  return host;
}

bool isNumericAddress(const std::string& host) {
  std::array<unsigned char, 16> bytes{};
  return inet_pton(AF_INET, host.c_str(), bytes.data()) == 1 ||
         inet_pton(AF_INET6, host.c_str(), bytes.data()) == 1;
}

/// `own`: a name, or "*.name" for one label more.
bool isNamedBy(const std::string& own, const std::string& name) {
  if (!own.starts_with("*.")) {
    return own == name;
  }
  const std::size_t dot = name.find('.');
  return dot != std::string::npos && dot > 0 && name.substr(dot) == own.substr(1);
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
  } catch (const DbError& error) {
    return refusedByRecord(error, wording);
  } catch (const Error& error) {
    return refusal(statusOf(error), error, wording);
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
      wrongTries_(kManyWrongTries, std::chrono::minutes(1)),
      pictures_(kPictures_bytes),
      lastBeat_(std::chrono::steady_clock::now().time_since_epoch().count()),
      record_(settings.log),
      workers_(settings.locator, workersFor(settings), settings.passwordCost, record_),
      hashing_(settings.locator, 1, settings.passwordCost, record_, DeskWorkers::Next::kOldestAndNewest),
      heavy_(settings.locator, kHeavyThreads, settings.passwordCost, record_) {
  for (const std::string& language : reportLanguages()) {
    languages_.emplace(language, wordingIn(language));
  }
  lookout_ = std::thread([this] { lookOut(); });
}

WebDesk::~WebDesk() {
  {
    const std::lock_guard lock(lookoutMutex_);
    ending_ = true;
  }
  lookoutEnds_.notify_all();
  lookout_.join();
  late_.end();
}

void WebDesk::prepare(const Actor& actor, const AssignmentId& assignmentId) {
  if (!heavy_.isIdle()) {
    return;  // somebody who opens a case has priority
  }
  (void)heavy_.take([this, actor, assignmentId](SessionContext* context) {
    if (context == nullptr) {
      return;
    }
    context->setActor(actor);
    try {
      (void)pictureOf(*this, *context, assignmentId);
    } catch (...) {
      // The error is reported when the case is opened.
    }
  });
}

bool WebDesk::isAlive() {
  using Clock = std::chrono::steady_clock;
  (void)workers_.take([this](SessionContext*) { lastBeat_ = Clock::now().time_since_epoch().count(); });
  return Clock::now().time_since_epoch() - Clock::duration(lastBeat_) < kLongestBeat;
}

HttpResponse WebDesk::metrics(const HttpRequest& request) {
  if (!settings_.openMetrics && !HttpAddress{clientOf(request), 0}.isLoopback()) {
    return refused(404, wordingFor(request));
  }
  const DeskGauges now{.sessions = sessions_.list(deskNow()).size(),
                       .waitingPages = waiting_.size(),
                       .queued = workers_.waiting() + hashing_.waiting() + heavy_.waiting(),
                       .passwords = hashing_.waiting(),
                       .recordAnswers = !record_.isAway()};
  return {.type = "application/openmetrics-text; version=1.0.0; charset=utf-8", .body = metrics_.text(now)};
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

bool WebDesk::isCalledByItsName(const HttpRequest& request) const {
  const std::string name = hostIn(request.header("host"));
  const std::string proxied = hostIn(
      settings_.publicUrl.substr(std::min(settings_.publicUrl.size(), settings_.publicUrl.find("//") + 2)));
  return isNumericAddress(name) || name == "localhost" || (!name.empty() && name == proxied) ||
         std::any_of(settings_.hosts.begin(), settings_.hosts.end(),
                     [&name](const std::string& own) { return isNamedBy(hostIn(own), name); });
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

namespace {

HttpResponse busyNow(const Wording& wording) {
  HttpResponse busy = refused(503, wording);
  busy.headers.emplace_back("Retry-After", "2");
  return busy;
}

}  // namespace

/// A request that a thread works at.
struct WebDesk::Job {
  HttpRequest request;
  Router::Match match;
  std::function<void(HttpResponse)> finish;
  SteadyTime until;  ///< of a route that waits
};

void WebDesk::handle(HttpRequest request, HttpServer::Reply reply) {
  const Wording& wording = wordingFor(request);
  Router::Match match = router_.find(request.method, request.path);
  const auto finish = [this, reply, begun = std::chrono::steady_clock::now(),
                       what = match.route == nullptr ? std::string("-")
                                                     : match.route->method + " " + match.route->path](
                          HttpResponse response, const char* page = nullptr) {
    addSecurityHeaders(response, settings_.strictTransport);
    const auto took = std::chrono::steady_clock::now() - begun;
    metrics_.answered(page == nullptr ? what : page, response.status, took);
    if (settings_.accessLog) {
      settings_.accessLog(
          (page == nullptr ? what : page) + (" " + std::to_string(response.status) + " ") +
          std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(took).count()) + " ms");
    }
    reply(std::move(response));
  };
  const bool asksForHealth = match.route != nullptr && match.route->isOfHealth;
  if (!asksForHealth && !isCalledByItsName(request)) {
    return finish(refusal(421,
                          simpleRefusal(Text::tr("this desk is not called by that name"),
                                        Text::tr("Use the address that an administrator gave you")),
                          wording));
  }
  if (request.method == "GET") {
    if (auto page = pages_.answer(request)) {
      return finish(std::move(*page), "GET a page");
    }
  }
  if (match.route == nullptr) {
    return finish(refused(match.otherMethod ? 405 : 404, wording));
  }
  const Route& route = *match.route;
  if (route.access == RouteAccess::kAlways) {
    return finish(route.atOnce(*this, request));
  }
  queue(std::make_shared<Job>(Job{.request = std::move(request),
                                  .match = std::move(match),
                                  .finish = finish,
                                  .until = deskNow() + kLongestWait}));
}

void WebDesk::queue(const std::shared_ptr<Job>& job) {
  const Route& route = *job->match.route;
  if (route.hashing == Hashing::kAlways ||
      (route.hashing == Hashing::kIfSent && job->request.body.find("\"password\"") != std::string::npos)) {
    return queueToHash(job);
  }
  DeskWorkers& threads = route.heavy ? heavy_ : workers_;
  if (!threads.take([this, job](SessionContext* context) { work(job, context); })) {
    job->finish(busyNow(wordingFor(job->request)));
  }
}

// Hashing takes a while, and one thread does it. First come those who are signed in and browsers from
// which the name has signed in before, then addresses without many wrong passwords, then the others; of each,
// the newest and the oldest by turns: a right password does not wait for a heap of wrong ones. Which names
// have an account plays no part.
void WebDesk::queueToHash(const std::shared_ptr<Job>& job) {
  const bool open = job->match.route->access == RouteAccess::kOpen && !isKnown(*job);
  const bool many = open && sentManyWrong(*job);
  const auto begin = [this, job, open, many](SessionContext* context) {
    if (open && !many && sentManyWrong(*job)) {
      return queueToHash(job);  // they came to light while it waited
    }
    work(job, context);
  };
  const auto refuse = [this, job] { job->finish(busyNow(wordingFor(job->request))); };
  if (!hashing_.take(begin, many ? kManyWrongRank : open ? 1 : 0, refuse)) {
    refuse();
  }
}

bool WebDesk::sentManyWrong(const Job& job) {
  return wrongTries_.waitOf(clientOf(job.request), deskNow()).count() > 0;
}

bool WebDesk::isKnown(const Job& job) const {
  const auto body = nlohmann::json::parse(job.request.body, nullptr, false);
  const auto login = body.is_object() ? body.find("login") : body.end();
  return login != body.end() && login->is_string() &&
         knownBrowsers_.knows(job.request.cookie(kKnownCookie), login->get<std::string>());
}

void WebDesk::work(const std::shared_ptr<Job>& job, SessionContext* context) {
  const Route& route = *job->match.route;
  if (context == nullptr) {
    return job->finish(recordAway(wordingFor(job->request)));
  }
  try {
    const std::uint64_t seen = waiting_.news();
    HttpResponse response = answer(job->request, route, job->match.parts, *context);
    const bool nothing = route.waits && response.status == kNothingNew;
    const auto now = deskNow();
    if (nothing && now < job->until && waiting_.hold(seen, job->until, [this, job] { queue(job); })) {
      return;
    }
    if (nothing && seen != waiting_.news()) {
      return queue(job);  // news while the record was read
    }
    finish(job, std::move(response));
  } catch (...) {
    job->finish(failure(std::current_exception(), route, wordingFor(job->request)));
  }
}

void WebDesk::finish(const std::shared_ptr<Job>& job, HttpResponse response) {
  constexpr int kWrongPassword = 401;
  const bool guess = job->match.route->hashing == Hashing::kAlways && response.status == kWrongPassword;
  const auto delay = guess ? LateAnswers::delayFor(hashing_.waiting(kManyWrongRank)) : decltype(kLook){};
  if (delay.count() == 0) {
    return job->finish(std::move(response));
  }
  late_.keep(deskNow() + delay, [job, response = std::move(response)] { job->finish(response); });
}

void WebDesk::lookOut() {
  struct Look {
    std::string last;  // written by one work at a time: the next is queued when it has ended
    std::atomic<bool> underway{false};
  };
  const auto look = std::make_shared<Look>();
  std::unique_lock lock(lookoutMutex_);
  while (!lookoutEnds_.wait_for(lock, kLook, [this] { return ending_; })) {
    waiting_.tick(deskNow());
    late_.tick(deskNow());
    if (waiting_.empty() || look->underway.exchange(true)) {
      continue;
    }
    const bool taken = workers_.take([this, look](SessionContext* context) {
      try {
        const std::string stamp = context == nullptr ? look->last : callStamp(*context);
        if (stamp != look->last) {
          look->last = stamp;
          waiting_.tell();
        }
      } catch (...) {
        // pages that ask again report it
      }
      look->underway = false;
    });
    if (!taken) {
      look->underway = false;
    }
  }
}

/// Answers a request that failed, and logs the cause of what is not the sender's fault.
HttpResponse WebDesk::failure(const std::exception_ptr& thrown, const Route& route, const Wording& wording) {
  HttpResponse response = answerOf(thrown, wording);
  if (response.status >= 500 && !saysDatabaseAway(thrown)) {  // of which the next work tells
    record_.logCause(route.method + " " + route.path + ": " + causeForLog(thrown),
                     std::chrono::steady_clock::now());
  }
  return response;
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
  const SteadyTime now = deskNow();
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
