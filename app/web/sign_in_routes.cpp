// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "app/access/access_service.h"
#include "app/access/settings_service.h"
#include "app/web/router.h"
#include "app/web/web_desk.h"
#include "app/web/web_texts.h"
#include "sim/base/time_units.h"

namespace torsio::web {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestLogin = 200;
constexpr std::size_t kLongestPassword = 1024;
constexpr std::chrono::seconds kBusy{2};

HttpResponse wait(Call& call, std::chrono::seconds time) {
  HttpResponse response = refusal(429,
                                  Error(ErrorCode::kPermission, Text::tr("too many tries"), "",
                                        Text::tr("Wait a little, then try again")),
                                  call.wording, {{"wait_s", time.count()}});
  response.headers.emplace_back("Retry-After", std::to_string(time.count()));
  return response;
}

std::string cookieOf(const std::string& value) {
  return std::string(kCookie) + "=" + value + "; Path=/; Secure; HttpOnly; SameSite=Strict";
}

json userJson(const Actor& actor) {
  return {{"login", actor.login}, {"roles", actor.roles}};
}

/// Hashes under the desk's lock. Empty: too many wait.
template <typename Try>
std::optional<SignInAnswer> hashed(Call& call, const Try& tryIt) {
  if (!call.desk.enterHashing()) {
    return std::nullopt;
  }
  struct Leave {
    WebDesk& desk;
    ~Leave() { desk.leaveHashing(); }
  } leave{call.desk};
  return tryIt();
}

HttpResponse welcome(Call& call, const std::optional<SignInAnswer>& answer) {
  if (!answer) {
    return wait(call, kBusy);
  }
  switch (answer->outcome) {
    case SignIn::kOk:
      break;
    case SignIn::kMustChange:
      return jsonAnswer({{"outcome", "must_change"}});
    case SignIn::kWait: {
      const std::int64_t left_us = answer->waitUntilUtc_us - call.context.now_us();
      return wait(call, std::chrono::seconds(left_us / kSecond_us + 1));
    }
    default:
      return refusal(401,
                     Error(ErrorCode::kPermission, Text::tr("name or password is wrong"), "",
                           Text::tr("Type both again, or ask an administrator for a new start password")),
                     call.wording);
  }
  if (!call.context.may(Operation::kMarkSubmit)) {
    signOut(call.context);
    return refusal(403,
                   Error(ErrorCode::kPermission, Text::tr("the browser is for physicians who score"), "",
                         Text::tr("Use Torsio's window at a station")),
                   call.wording);
  }
  const std::string cookie = call.desk.sessions().open(answer->actor, call.now);
  const auto session = call.desk.sessions().find(cookie, call.now);
  HttpResponse response =
      jsonAnswer({{"outcome", "ok"}, {"token", session->token}, {"user", userJson(answer->actor)}});
  response.headers.emplace_back("Set-Cookie", cookieOf(cookie));
  return response;
}

HttpResponse answerSignIn(Call& call) {
  const auto left = call.desk.signInTries().tried(call.request.address, call.now);
  if (left.count() > 0) {
    return wait(call, left);
  }
  const std::string login = call.body.text("login", kLongestLogin);
  const std::string password = call.body.text("password", kLongestPassword);
  return welcome(call, hashed(call, [&] { return signIn(call.context, login, password); }));
}

HttpResponse answerPassword(Call& call) {
  const auto left = call.desk.signInTries().tried(call.request.address, call.now);
  if (left.count() > 0) {
    return wait(call, left);
  }
  const std::string login = call.body.text("login", kLongestLogin);
  const std::string oldPassword = call.body.text("oldPassword", kLongestPassword);
  const std::string newPassword = call.body.text("newPassword", kLongestPassword);
  const auto changed =
      hashed(call, [&] { return changeOwnPassword(call.context, login, oldPassword, newPassword); });
  if (changed && changed->outcome == SignIn::kOk) {
    call.desk.sessions().closeAll(changed->actor.userId);
  }
  return welcome(call, changed);
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
                     {"user", userJson(call.session->actor)},
                     {"idle_s", idle.lock_us / kSecond_us}});
}

HttpResponse answerTexts(Call& call) {
  json texts = json::object();
  for (const Text& text : webTexts()) {
    texts[text.pattern()] = call.wording(text).toStdString();
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

std::vector<Route> signInRoutes() {
  return {{"GET", "/api/texts", RouteAccess::kOpen, answerTexts},
          {"POST", "/api/sign-in", RouteAccess::kOpen, answerSignIn},
          {"POST", "/api/password", RouteAccess::kOpen, answerPassword},
          {"POST", "/api/sign-out", RouteAccess::kSignedIn, answerSignOut},
          {"GET", "/api/me", RouteAccess::kSignedIn, answerMe}};
}

}  // namespace torsio::web
