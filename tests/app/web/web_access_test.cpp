// SPDX-License-Identifier: GPL-3.0-or-later
// Access by browser: invitation links, duration and end of sessions.
#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/moved_record.h"
#include "app/web/web_sessions.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/clock.h"
#include "tests/app/web/served_desk.h"

namespace torsio::web {
namespace {

using nlohmann::json;

class WebAccess : public ::testing::Test {
 protected:
  WebAccess() { SettingRepository(served.centre.connection()).set(kTwoPeople.name, "no", 0); }
  UserId userOf(const std::string& login) {
    for (const UserAccount& user : AccessRepository(served.centre.connection()).users()) {
      if (user.login == login) {
        return user.id;
      }
    }
    return {};
  }
  std::string linkFor(const std::string& login) {
    // Uses the server's clock: the centre's is frozen.
    SessionContext session({served.centre.locator(), "station", served.centre.administrator()->actor()});
    const std::vector<UserId> ids{userOf(login)};
    return invite(session, ids).at(0).secret;
  }
  DeskAnswer join(WebClient& client, const std::string& token,
                  const std::string& password = kChosenPassword) {
    return client.send("POST", "/api/join", {{"token", token}, {"newPassword", password}});
  }
  WebClient office() { return served.signedIn("office"); }
  std::int64_t audited(const std::string& action) {
    std::int64_t count = 0;
    for (const AuditEntry& entry : AuditRepository(served.centre.connection()).entries()) {
      count += entry.action == action ? 1 : 0;
    }
    return count;
  }

  ServedDesk served;
};

TEST_F(WebAccess, AnInvitationOpensTheQueueOnce) {
  const std::string secret = linkFor("physician0");
  WebClient client = served.client();
  EXPECT_EQ(client.get("/join").status, 200) << "the page itself asks for nothing";

  const DeskAnswer weak = join(client, secret, "short");
  EXPECT_EQ(weak.status, 400) << weak.body;
  const DeskAnswer welcome = join(client, secret);
  ASSERT_EQ(welcome.status, 200) << welcome.body;
  EXPECT_EQ(welcome.json().at("user").at("login"), "physician0");
  EXPECT_EQ(client.get("/api/queue").status, 200);

  WebClient other = served.client();
  const DeskAnswer replayed = join(other, secret);
  const DeskAnswer guessed = join(other, "abcde-abcde-abcde-abcde");
  EXPECT_EQ(replayed.status, 401);
  EXPECT_EQ(replayed.body, guessed.body) << "used and never made are answered alike";
  EXPECT_EQ(other.cookie, "");
  EXPECT_TRUE(other.signIn("physician0", kChosenPassword));
  for (const DeskAnswer& answer : {welcome, replayed, guessed}) {
    EXPECT_EQ(answer.body.find(secret), std::string::npos);
  }
}

TEST_F(WebAccess, OneOfManyWhoUseALinkAtOnceIsAdmitted) {
  const std::string secret = linkFor("physician0");
  std::array<int, 4> statuses{};
  std::vector<std::thread> threads;
  threads.reserve(statuses.size());
  for (int& status : statuses) {
    threads.emplace_back([&] {
      WebClient client = served.client();
      status = join(client, secret).status;
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }

  EXPECT_EQ(std::count(statuses.begin(), statuses.end(), 200), 1);
  EXPECT_EQ(audited("invitation.use"), 1);
}

TEST_F(WebAccess, GuessingLinksIsSlowedDown) {
  WebClient client = served.client();
  int waited = 0;
  for (int i = 0; i < 14; ++i) {
    waited += join(client, "guess-" + std::to_string(i)).status == 429;
  }

  EXPECT_GE(waited, 4);
}

/// Number of guesses that had to wait; each pretends to come from another address.
int slowedDown(const WebClient& from) {
  int waited = 0;
  for (int i = 0; i < 14; ++i) {
    WebClient client = from;
    client.headers = {{"X-Forwarded-For", "198.51.100.7, 203.0.113." + std::to_string(i)},
                      {"Sec-Fetch-Site", "same-origin"}};
    waited +=
        client.send("POST", "/api/join", {{"token", "guess"}, {"newPassword", kChosenPassword}}).status == 429
            ? 1
            : 0;
  }
  return waited;
}

TEST_F(WebAccess, ForwardedAddressesAreTrustedOnlyFromALocalProxy) {
  EXPECT_GE(slowedDown(served.client()), 4) << "there is no proxy: whoever says so is counted once";
  WebDesk desk({.locator = served.centre.locator(),
                .assets = assetsFolder(),
                .publicUrl = "https://desk.example.org",
                .workers = 2,
                .passwordCost = PasswordCost::kTest});
  const HttpServer server({"127.0.0.1", 0}, {}, {}, [&desk](HttpRequest request, HttpServer::Reply reply) {
    desk.handle(std::move(request), std::move(reply));
  });

  EXPECT_EQ(slowedDown(WebClient(server.port())), 0) << "fourteen people behind one proxy";
}

TEST_F(WebAccess, UsersWithoutAPageAreRefused) {
  AccessRepository access(served.centre.connection(), PasswordCost::kTest);
  access.addUser({.id = "u-keeper", .login = "keeper", .roles = {"allocator"}}, kWebPassword);
  access.setPassword("u-keeper", access.sealPassword("keeper", kWebPassword), false);
  WebClient client = served.client();

  const DeskAnswer refused =
      client.send("POST", "/api/sign-in", {{"login", "keeper"}, {"password", kWebPassword}});

  EXPECT_EQ(refused.status, 403);
  EXPECT_EQ(refused.headers.count("set-cookie"), 0U);
  EXPECT_EQ(served.physician(0).get("/api/me").json().at("user").at("pages").at(0), "queue");
}

TEST_F(WebAccess, AMovedRecordSaysWhereItWent) {
  const auto notice = [this] {
    return served.physician(0).get("/api/me").json().at("user").at("record_notice").get<std::string>();
  };
  EXPECT_EQ(notice(), "");

  finishMove(served.centre.connection(), "postgresql://server/torsio", 1);

  EXPECT_NE(notice().find("has moved to postgresql://server/torsio"), std::string::npos) << notice();
}

TEST_F(WebAccess, UsersListAndEndTheirOwnSessions) {
  WebClient here = served.physician(0);
  WebClient there = served.client();
  there.headers = {{"User-Agent", "Mozilla/5.0 (Windows NT 10.0; rv:128.0) Gecko/20100101 Firefox/128.0"}};
  ASSERT_TRUE(there.signIn("physician0", kWebPassword));
  WebClient colleague = served.physician(1);

  const json sessions = here.get("/api/sessions").json().at("sessions");
  ASSERT_EQ(sessions.size(), 2U);
  EXPECT_EQ(sessions.at(0).at("browser"), "Firefox, Windows");
  EXPECT_FALSE(sessions.at(0).at("this"));
  const json theirs = colleague.get("/api/sessions").json().at("sessions").at(0).at("id");
  EXPECT_EQ(here.send("POST", "/api/sessions/end", {{"id", theirs}}).status, 400) << "of somebody else";
  EXPECT_EQ(here.send("POST", "/api/sessions/end", {{"id", sessions.at(0).at("id")}}).status, 200);

  EXPECT_EQ(there.get("/api/me").status, 401);
  EXPECT_EQ(here.get("/api/me").status, 200);
  EXPECT_EQ(colleague.get("/api/me").status, 200);
}

TEST_F(WebAccess, AnAdministratorEndsAnySessionWithAnAuditEntry) {
  WebClient physician = served.physician(0);
  WebClient client = office();
  EXPECT_EQ(physician.get("/api/all-sessions").status, 403);
  EXPECT_EQ(physician.send("POST", "/api/all-sessions/end", {{"id", "x"}}).status, 403);
  EXPECT_EQ(client.get("/api/queue").status, 403) << "nobody scores who is no physician";

  json id;
  const json all = client.get("/api/all-sessions").json().at("sessions");
  for (const json& line : all) {
    id = line.at("login") == "physician0" ? line.at("id") : id;
  }
  EXPECT_EQ(client.send("POST", "/api/all-sessions/end", {{"id", id}}).status, 200);

  EXPECT_EQ(physician.get("/api/me").status, 401);
  EXPECT_EQ(audited("user.end_sessions"), 1);
}

TEST_F(WebAccess, APasswordChangeOrADisabledAccountEndsASession) {
  AccessRepository access(served.centre.connection(), PasswordCost::kTest);
  WebClient one = served.physician(0);
  access.setPassword(userOf("physician0"), access.sealPassword("physician0", kChosenPassword), true);
  EXPECT_EQ(one.get("/api/me").status, 401) << "reset at the desk";

  WebClient two = served.physician(1);
  access.setActive(userOf("physician1"), false);
  EXPECT_EQ(two.get("/api/queue").status, 401);
  access.setActive(userOf("physician1"), true);
  EXPECT_EQ(two.get("/api/queue").status, 401) << "what is over stays over";
}

/// Routes that answer each role; all others must be refused to everybody.
const std::map<std::string, std::set<std::string>>& answersOf() {
  static const std::set<std::string> kOfAll = {"GET /healthz",          "GET /readyz", "GET /metrics",
                                               "GET /api/texts",        "GET /api/me", "GET /api/sessions",
                                               "GET /api/second-factor"};
  static const std::map<std::string, std::set<std::string>> kAnswers = {
      {"all", kOfAll},
      {"rater",
       {"GET /api/queue", "GET /api/evaluation", "GET /api/calibration", "GET /api/severity",
        "GET /api/discrepancies", "GET /api/live", "GET /api/live/*"}},
      {"trainee", {"GET /api/evaluation", "GET /api/own", "GET /api/own/remarks", "GET /api/own/transcript"}},
      {"administrator", {"GET /api/all-sessions", "GET /api/cohorts", "GET /api/invitations"}}};
  return kAnswers;
}

/// The six digits of a secret at the server's time.
std::string codeOf(const std::string& secret, std::int64_t stepsAhead = 0) {
  return oneTimeCode(secret, codeStepAt(utcNow_us()) + stepsAhead);
}

TEST_F(WebAccess, ASecondFactorIsSetUpAskedForAndSwitchedOff) {
  WebClient client = office();
  const json state = client.get("/api/second-factor").json();
  EXPECT_EQ(state.at("on"), false);
  const json offer = state.at("offer");
  const std::string secret = offer.at("secret");
  EXPECT_EQ(offer.at("uri").get<std::string>().find("otpauth://totp/Torsio"), 0U);
  EXPECT_EQ(offer.at("qr").size(), offer.at("qr").at(0).get<std::string>().size());
  json wish{{"login", "office"}, {"password", kWebPassword}, {"secret", secret}, {"code", "000000"}};
  EXPECT_EQ(client.send("POST", "/api/second-factor", wish).status, 400);
  wish["code"] = codeOf(secret);
  const DeskAnswer on = client.send("POST", "/api/second-factor", wish);
  ASSERT_EQ(on.status, 200) << on.body;
  const json recovery = on.json().at("recovery_codes");
  ASSERT_EQ(recovery.size(), 10U);
  client.token = on.json().at("token");
  EXPECT_EQ(client.get("/api/second-factor").json().at("recovery_codes_left"), 10);
  EXPECT_EQ(client.get("/api/second-factor").body.find(secret), std::string::npos);

  WebClient other = served.client();
  json entry{{"login", "office"}, {"password", kWebPassword}};
  const DeskAnswer asked = other.send("POST", "/api/sign-in", entry);
  EXPECT_EQ(asked.status, 200);
  EXPECT_EQ(asked.json(), json({{"outcome", "code_needed"}}));
  EXPECT_EQ(other.cookie, "");
  entry["code"] = wish["code"];
  EXPECT_EQ(other.send("POST", "/api/sign-in", entry).status, 401) << "used when it was set up";
  entry["code"] = codeOf(secret, 1);
  EXPECT_EQ(other.send("POST", "/api/sign-in", entry).json().at("outcome"), "ok");

  EXPECT_EQ(
      client.send("POST", "/api/second-factor/off", {{"password", kWebPassword}, {"code", "000000"}}).status,
      403);
  const DeskAnswer off =
      client.send("POST", "/api/second-factor/off", {{"password", kWebPassword}, {"code", recovery.at(0)}});
  EXPECT_EQ(off.status, 200) << off.body;
  EXPECT_EQ(off.json().at("on"), false);
  EXPECT_TRUE(served.client().signIn("office", kWebPassword));
  EXPECT_EQ(served.log.find(secret), std::string::npos);
}

TEST_F(WebAccess, WhereTheCentreAsksForASecondFactorItIsSetUpAtTheSignIn) {
  SettingRepository(served.centre.connection()).set(kSecondFactor.name, "administrators", 0);
  EXPECT_TRUE(served.client().signIn("physician0", kWebPassword));
  WebClient client = served.client();
  const DeskAnswer asked =
      client.send("POST", "/api/sign-in", {{"login", "office"}, {"password", kWebPassword}});
  ASSERT_EQ(asked.json().at("outcome"), "must_enrol") << asked.body;
  EXPECT_EQ(client.cookie, "");
  const json offer = asked.json().at("offer");

  const DeskAnswer on = client.send("POST", "/api/second-factor",
                                    {{"login", offer.at("login")},
                                     {"password", kWebPassword},
                                     {"secret", offer.at("secret")},
                                     {"code", codeOf(offer.at("secret"))}});

  ASSERT_EQ(on.status, 200) << on.body;
  EXPECT_EQ(on.json().at("user").at("login"), "office");
  EXPECT_EQ(client.get("/api/all-sessions").status, 200);
}

TEST_F(WebAccess, EveryRouteAnswersOnlyPermittedRoles) {
  AccessRepository access(served.centre.connection(), PasswordCost::kTest);
  const std::string trainee =
      selectFirst(served.centre.connection(), "SELECT person_id FROM trainee", {}, [](RowReader& row) {
        return row.text();
      }).value();
  access.addUser({.id = "u-trainee", .login = "apprentice", .personId = trainee, .roles = {"trainee"}},
                 kWebPassword);
  access.setPassword("u-trainee", access.sealPassword("apprentice", kWebPassword), false);
  std::set<std::string> met;
  for (const auto& [role, login] : std::map<std::string, std::string>{
           {"rater", "physician0"}, {"trainee", "apprentice"}, {"administrator", "office"}}) {
    std::set<std::string> may = answersOf().at("all");
    may.insert(answersOf().at(role).begin(), answersOf().at(role).end());
    WebClient client = served.client();
    ASSERT_TRUE(client.signIn(login, kWebPassword)) << login;
    for (const Route& route : served.desk->router().routes()) {
      if ((route.access == RouteAccess::kOpen && route.method == "POST") || route.path == "/api/sign-out") {
        continue;  // asks for a secret; ends the session
      }
      const std::string name = route.method + " " + route.path;
      const std::string path = pathOf(route, "x");
      const DeskAnswer answer =
          route.method == "GET" ? client.get(path) : client.send(route.method, path, json::object());
      EXPECT_EQ(answer.status == 200, may.count(name) == 1) << role << ": " << name << " " << answer.status;
      EXPECT_TRUE(answer.status == 200 || answer.status == 400 || answer.status == 403)
          << name << " " << answer.body;
      met.insert(name);
    }
  }
  for (const auto& [role, names] : answersOf()) {
    for (const std::string& name : names) {
      EXPECT_EQ(met.count(name), 1U) << name << " is no route any more";
    }
  }
}

TEST(WebSessions, ExpireAfterSomeTime) {
  WebSessions sessions({.idle = std::chrono::minutes(5), .whole = std::chrono::minutes(12)});
  const SteadyTime begun{};
  const std::string cookie = sessions.open({.userId = "u"}, "", "", begun);

  EXPECT_NE(sessions.find(cookie, begun + std::chrono::minutes(5)), nullptr);
  EXPECT_NE(sessions.find(cookie, begun + std::chrono::minutes(10)), nullptr);
  EXPECT_EQ(sessions.list(begun + std::chrono::minutes(11)).size(), 1U);
  EXPECT_EQ(sessions.find(cookie, begun + std::chrono::minutes(13)), nullptr) << "long enough in all";
  const std::string left = sessions.open({.userId = "u"}, "", "", begun);
  EXPECT_TRUE(sessions.list(begun + std::chrono::minutes(6)).empty());
  EXPECT_EQ(sessions.find(left, begun + std::chrono::minutes(6)), nullptr);
}

TEST(WebSessions, RecogniseBrowsersByName) {
  EXPECT_EQ(browserName("Mozilla/5.0 (X11; Linux x86_64) AppleWebKit/537.36 (KHTML, like Gecko) "
                        "Chrome/120.0 Safari/537.36"),
            "Chrome, Linux");
  EXPECT_EQ(
      browserName("Mozilla/5.0 (Windows NT 10.0) AppleWebKit/537.36 Chrome/120.0 Safari/537.36 Edg/120.0"),
      "Edge, Windows");
  EXPECT_EQ(browserName("<script>curl"), "");
}

}  // namespace
}  // namespace torsio::web
