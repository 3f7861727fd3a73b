// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/moved_record.h"
#include "app/services/access/qr_code.h"
#include "app/services/access/second_factor.h"
#include "app/services/access/two_people.h"
#include "app/services/people/waiting_requests.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestLogin = 200;
constexpr std::size_t kLongestPassword = 1024;
constexpr std::size_t kLongestInvitation = 100;
constexpr std::size_t kLongestCode = 100;

HttpResponse wait(Call& call, std::chrono::seconds time) {
  HttpResponse response = refusal(call, 429, ErrorCode::kPermission, Text::tr("too many tries"),
                                  Text::tr("Wait a little, then try again"), {{"wait_s", time.count()}});
  response.headers.emplace_back("Retry-After", std::to_string(time.count()));
  return response;
}

std::string cookieOf(const std::string& value) {
  return std::string(kCookie) + "=" + value + "; Path=/; Secure; HttpOnly; SameSite=Strict";
}

/// A page and the right that it needs; its routes check again in the services.
struct PageRight {
  const char* page;
  Operation operation;
};
constexpr PageRight kPageRights[] = {{"queue", Operation::kMarkSubmit},
                                     {"evaluation", Operation::kEvaluationSubmit},
                                     {"own", Operation::kTrialViewOwn},
                                     {"board", Operation::kStudySetup},
                                     {"people", Operation::kUserManage}};

/// Returns who it is, which pages there are, and for administrators how many requests wait for a second
/// person: all of them in words, and the invitations, which are confirmed in the browser.
json userJson(Call& call, const Actor& actor) {
  SessionContext& context = call.context;
  json pages = json::array();
  for (const PageRight& right : kPageRights) {
    if (context.may(right.operation)) {
      pages.push_back(right.page);
    }
  }
  json user{{"login", actor.login}, {"roles", actor.roles}, {"pages", std::move(pages)}};
  user["record_notice"] = said(call, moveNotice(context.connectionWithoutRight()));
  if (context.may(Operation::kUserManage)) {
    context.beginCall();
    const std::vector<OpenRequest> open = openRequests(context);
    user["invitations_wait"] = std::count_if(open.begin(), open.end(), [](const OpenRequest& one) {
      return one.mayConfirm && one.request.act == DutyAct::kInvite;
    });
    user["requests_wait"] = said(call, toConfirmWords(waitingRequests(context).toConfirm));
  }
  return user;
}

/// Where a password is tried: in a browser from which its owner has signed in before, or at an address.
std::string placeOf(const Call& call, const std::string& login) {
  return call.desk.knownBrowsers().knows(call.request.cookie(kKnownCookie), login)
             ? "known browser"
             : "address " + call.desk.clientOf(call.request);
}

/// Returns what the page shows for an authenticator app.
json offerJson(Call& call, const std::string& login) {
  const SecondFactorOffer offer = offerSecondFactor(call.context, login);
  return {{"login", login}, {"secret", offer.secret}, {"uri", offer.uri}, {"qr", qrRows(offer.uri)}};
}

/// `more`: told beside an opened session.
HttpResponse welcome(Call& call, const SignInAnswer& answer, const json& more = json::object()) {
  switch (answer.outcome) {
    case SignIn::kOk:
      break;
    case SignIn::kMustChange:
      return jsonAnswer({{"outcome", "must_change"}});
    case SignIn::kCodeNeeded:
      return jsonAnswer({{"outcome", "code_needed"}});
    case SignIn::kMustEnrol:
      return jsonAnswer({{"outcome", "must_enrol"}, {"offer", offerJson(call, answer.actor.login)}});
    case SignIn::kCodeWrong:
      call.desk.wrongTries().add(call.desk.clientOf(call.request), call.now);
      return refusal(call, 401, ErrorCode::kPermission, Text::tr("the code is not right, or was used before"),
                     Text::tr("Wait for the next one, or use a recovery code"));
    case SignIn::kWait: {
      const std::int64_t left_us = answer.waitUntilUtc_us - call.context.now_us();
      return wait(call, std::chrono::seconds(left_us / kSecond_us + 1));
    }
    default:
      call.desk.wrongTries().add(call.desk.clientOf(call.request), call.now);
      return refusal(call, 401, ErrorCode::kPermission, Text::tr("name or password is wrong"),
                     Text::tr("Type both again, or ask an administrator for a new start password"));
  }
  const json user = userJson(call, answer.actor);
  if (user.at("pages").empty()) {
    signOut(call.context);
    if (!more.empty()) {
      return jsonAnswer(more);  // shown once, also to somebody who has no page here
    }
    return refusal(call, 403, ErrorCode::kPermission, Text::tr("there is no page for you in the browser"),
                   Text::tr("Use Torsio's window at a station"));
  }
  const std::string cookie =
      call.desk.sessions().open(answer.actor, browserName(call.request.header("user-agent")),
                                passwordStamp(call.context, answer.actor.userId), call.now);
  const auto session = call.desk.sessions().find(cookie, call.now);
  json told{{"outcome", "ok"}, {"token", session->token}, {"user", user}};
  told.update(more);
  HttpResponse response = jsonAnswer(told);
  response.headers.emplace_back("Set-Cookie", cookieOf(cookie));
  response.headers.emplace_back(
      "Set-Cookie",
      std::string(kKnownCookie) + "=" +
          call.desk.knownBrowsers().cookieAfter(call.request.cookie(kKnownCookie), answer.actor.login) +
          "; Path=/; Secure; HttpOnly; SameSite=Strict; Max-Age=15552000");
  return response;
}

HttpResponse answerSignIn(Call& call) {
  const std::string login = call.body.text("login", kLongestLogin);
  const std::string password = call.body.text("password", kLongestPassword);
  const std::string code = call.body.textOrNone("code", kLongestCode);
  return welcome(call, signIn(call.context, login, password, placeOf(call, login), code));
}

HttpResponse answerPassword(Call& call) {
  const PasswordChange change{.login = call.body.text("login", kLongestLogin),
                              .oldPassword = call.body.text("oldPassword", kLongestPassword),
                              .newPassword = call.body.text("newPassword", kLongestPassword),
                              .code = call.body.textOrNone("code", kLongestCode)};
  const SignInAnswer changed = changeOwnPassword(call.context, change, placeOf(call, change.login));
  if (changed.outcome == SignIn::kOk) {
    call.desk.sessions().closeAll(changed.actor.userId);
  }
  return welcome(call, changed);
}

/// Switches the second factor on, at the sign-in that asks for it or on request, and signs in.
HttpResponse answerSwitchOn(Call& call) {
  const std::string login = call.body.text("login", kLongestLogin);
  const SecondFactorStart start =
      switchOnSecondFactor(call.context, {.login = login,
                                          .password = call.body.text("password", kLongestPassword),
                                          .secret = call.body.text("secret", kLongestCode),
                                          .code = call.body.text("code", kLongestCode),
                                          .place = placeOf(call, login)});
  call.desk.sessions().closeAll(start.answer.actor.userId);
  return welcome(call, start.answer, {{"recovery_codes", start.recoveryCodes}});
}

/// Returns whether the user's second factor is on; if not, what to set it up with.
HttpResponse answerSecondFactor(Call& call) {
  const OwnSecondFactor own = ownSecondFactor(call.context);
  return jsonAnswer({{"on", own.on},
                     {"asked", own.asked},
                     {"recovery_codes_left", own.recoveryCodes},
                     {"offer", own.on ? json(nullptr) : offerJson(call, call.session->actor.login)}});
}

HttpResponse answerSwitchOff(Call& call) {
  switchOffSecondFactor(call.context, call.body.text("password", kLongestPassword),
                        call.body.text("code", kLongestCode));
  return answerSecondFactor(call);
}

/// Redeems an invitation link with a password; all faults of a link get the same answer.
HttpResponse answerJoin(Call& call) {
  const auto left = call.desk.wrongTries().waitOf(call.desk.clientOf(call.request), call.now);
  if (left.count() > 0) {
    return wait(call, left);
  }
  const std::string token = call.body.text("token", kLongestInvitation);
  const std::string code = call.body.textOrNone("code", kLongestInvitation);
  const std::string newPassword = call.body.text("newPassword", kLongestPassword);
  const SignInAnswer joined = acceptInvitation(call.context, token, code, newPassword);
  if (joined.outcome == SignIn::kWrong) {
    call.desk.wrongTries().add(call.desk.clientOf(call.request), call.now);
    return refusal(call, 401, ErrorCode::kPermission,
                   Text::tr("this invitation is not good, or not any more"),
                   Text::tr("Check the link, or ask an administrator for a new one"));
  }
  if (joined.outcome == SignIn::kOk) {
    call.desk.sessions().closeAll(joined.actor.userId);
  }
  return welcome(call, joined);
}

HttpResponse answerSignOut(Call& call) {
  signOut(call.context);
  call.desk.sessions().close(call.request.cookie(kCookie));
  HttpResponse response = jsonAnswer(json::object());
  response.headers.emplace_back("Set-Cookie", cookieOf("; Max-Age=0"));
  return response;
}

HttpResponse answerMe(Call& call) {
  const IdleLimits idle = centreIdleLimits(call.context.connectionWithoutRight());
  return jsonAnswer({{"token", call.session->token},
                     {"user", userJson(call, call.session->actor)},
                     {"idle_s", idle.lock_us / kSecond_us}});
}

HttpResponse answerTexts(Call& call) {
  json texts = json::object();
  for (const std::string& sentence : call.desk.pages().sentences()) {
    texts[sentence] = call.wording(sentence).toStdString();
  }
  std::string language = "en";
  json languages = json::array();
  for (const auto& [code, wording] : call.desk.languages()) {
    languages.push_back(code);
    if (&wording == &call.wording) {
      language = code;
    }
  }
  return jsonAnswer({{"language", language}, {"languages", languages}, {"texts", texts}});
}

}  // namespace

std::vector<Route> healthRoutes() {
  return {{.method = "GET",
           .path = "/healthz",
           .access = RouteAccess::kAlways,
           .isOfHealth = true,
           .atOnce =
               [](WebDesk&, const HttpRequest&) {
                 return jsonAnswer({{"status", "ok"}});
               }},
          {.method = "GET",
           .path = "/readyz",
           .access = RouteAccess::kOpen,
           .answer =
               [](Call&) {
                 return jsonAnswer({{"status", "ok"}});
               },
           .isOfHealth = true},
          {.method = "GET",
           .path = "/metrics",
           .access = RouteAccess::kAlways,
           .isOfHealth = true,
           .atOnce = [](WebDesk& desk, const HttpRequest& request) { return desk.metrics(request); }}};
}

std::vector<Route> signInRoutes() {
  const auto hashing = [](const char* path, HttpResponse (*answer)(Call&)) {
    return Route{.method = "POST",
                 .path = path,
                 .access = RouteAccess::kOpen,
                 .answer = answer,
                 .hashing = Hashing::kAlways};
  };
  return {{"GET", "/api/texts", RouteAccess::kOpen, answerTexts},
          hashing("/api/sign-in", answerSignIn),
          hashing("/api/password", answerPassword),
          hashing("/api/join", answerJoin),
          hashing("/api/second-factor", answerSwitchOn),
          {"GET", "/api/second-factor", RouteAccess::kSignedIn, answerSecondFactor},
          {.method = "POST",
           .path = "/api/second-factor/off",
           .access = RouteAccess::kSignedIn,
           .answer = answerSwitchOff,
           .hashing = Hashing::kAlways},
          {"POST", "/api/sign-out", RouteAccess::kSignedIn, answerSignOut},
          {"GET", "/api/me", RouteAccess::kSignedIn, answerMe}};
}

namespace {

constexpr std::size_t kLongestId = 100;

json sessionsJson(const Call& call, bool ofAll) {
  json lines = json::array();
  for (const WebSessions::Line& line : call.desk.sessions().list(call.now)) {
    if (!ofAll && line.userId != call.session->userId) {
      continue;
    }
    json one{{"id", line.id},
             {"browser", line.browser},
             {"begun_s", line.age.count()},
             {"idle_s", line.idle.count()},
             {"this", line.id == call.session->id}};
    if (ofAll) {
      one["login"] = line.login;
    }
    lines.push_back(std::move(one));
  }
  return {{"sessions", std::move(lines)}};
}

HttpResponse answerOwnSessions(Call& call) {
  return jsonAnswer(sessionsJson(call, false));
}

HttpResponse answerAll(Call& call) {
  requireSessionsOfOthers(call.context);
  return jsonAnswer(sessionsJson(call, true));
}

/// Returns the session named `id` among those that the caller may end.
WebSessions::Line lineOf(Call& call, bool ofAll) {
  const std::string id = call.body.text("id", kLongestId);
  for (WebSessions::Line& line : call.desk.sessions().list(call.now)) {
    if (line.id == id && (ofAll || line.userId == call.session->userId)) {
      return std::move(line);
    }
  }
  refuseParameter(Text::tr("this session is over"), "", Text::tr("Read the list again"));
}

HttpResponse answerEndOwn(Call& call) {
  call.desk.sessions().end(lineOf(call, false).id);
  return jsonAnswer(sessionsJson(call, false));
}

HttpResponse answerEndAny(Call& call) {
  requireSessionsOfOthers(call.context);
  const WebSessions::Line line = lineOf(call, true);
  noteEndedSessions(call.context, line.userId);
  call.desk.sessions().end(line.id);
  return jsonAnswer(sessionsJson(call, true));
}

}  // namespace

std::vector<Route> sessionRoutes() {
  constexpr auto kIn = RouteAccess::kSignedIn;
  return {{"GET", "/api/sessions", kIn, answerOwnSessions},
          {"POST", "/api/sessions/end", kIn, answerEndOwn},
          {"GET", "/api/all-sessions", kIn, answerAll},
          {"POST", "/api/all-sessions/end", kIn, answerEndAny}};
}

}  // namespace torsio::web
