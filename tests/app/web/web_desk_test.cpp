// SPDX-License-Identifier: GPL-3.0-or-later
// The review desk as seen by a browser: access, cases, drafts, and blinding of every byte.
#include "app/web/web_desk.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <regex>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "app/services/access/signing.h"
#include "app/services/review/case_sheet.h"
#include "app/web/http_server.h"
#include "db/repository/people/access_repository.h"
#include "sim/core/random.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/served_desk.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

using nlohmann::json;

using Served = ServedDesk;

constexpr const char* kPassword = kWebPassword;

TEST(WebDesk, OnlyDeclaredRoutesAreOpen) {
  const Served served;
  WebClient client = served.client();

  for (const Route& route : served.desk->router().routes()) {
    const std::string path = pathOf(route, "x");
    const DeskAnswer answer =
        route.method == "GET" ? client.get(path) : client.send(route.method, path, json::object());
    if (route.access == RouteAccess::kSignedIn) {
      EXPECT_EQ(answer.status, 401) << route.method << " " << path;
    }
    EXPECT_EQ(client.send("DELETE", path, json::object()).status, 405) << path;
  }
  for (const char* nowhere :
       {"/api", "/api/", "/api/people", "/../web/index.html", "/web_desk.cpp", "/api/cases/a/b/c/d"}) {
    EXPECT_EQ(client.get(nowhere).status, 404) << nowhere;
  }
}

TEST(WebDesk, AdmitsAPhysician) {
  const Served served;
  WebClient client = served.client();

  EXPECT_EQ(client.send("POST", "/api/sign-in", {{"login", "physician0"}, {"password", "wrong"}}).status,
            401);
  EXPECT_EQ(client.send("POST", "/api/sign-in", {{"login", "nobody"}, {"password", kPassword}}).status, 401);
  const DeskAnswer welcome =
      client.send("POST", "/api/sign-in", {{"login", "physician0"}, {"password", kPassword}});
  ASSERT_EQ(welcome.status, 200) << welcome.body;
  const std::string cookie = welcome.headers.at("set-cookie");
  for (const char* flag : {"__Host-torsio=", "Secure", "HttpOnly", "SameSite=Strict", "Path=/"}) {
    EXPECT_NE(cookie.find(flag), std::string::npos) << flag;
  }
  EXPECT_EQ(client.get("/api/me").json().at("user").at("login"), "physician0");
  client.token = welcome.json().at("token").get<std::string>();
  EXPECT_EQ(client.send("POST", "/api/sign-out", json::object()).status, 200);
  EXPECT_EQ(client.get("/api/me").status, 401);
}

TEST(WebDesk, SlowsDownGuessing) {
  const Served served;
  WebClient client = served.client();
  const auto waited = [&](const std::string& login) {
    int waits = 0;
    for (int i = 0; i < 14; ++i) {
      waits += client.send("POST", "/api/sign-in", {{"login", login}, {"password", "x"}}).status == 429;
    }
    return waits;
  };

  EXPECT_GE(waited("physician0"), 4);
  EXPECT_GE(waited("nobody"), 4) << "a name that does not exist waits like one that does";
  int waits = 0;
  for (int i = 0; i < 14; ++i) {
    waits += client.send("POST", "/api/join", {{"token", "x"}, {"newPassword", "seven kites above the bay"}})
                 .status == 429;
  }
  EXPECT_GE(waits, 4);
}

TEST(WebDesk, FiftyWhoSignInAtOnceFromOneAddressAllComeIn) {
  const Served served;
  std::vector<int> answers(50);
  std::vector<std::thread> people;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    people.emplace_back([&, i] {
      const std::string login = i % 3 == 2 ? "office" : "physician" + std::to_string(i % 3);
      answers[i] =
          served.client().send("POST", "/api/sign-in", {{"login", login}, {"password", kPassword}}).status;
    });
  }
  for (std::thread& one : people) {
    one.join();
  }
  EXPECT_EQ(std::count(answers.begin(), answers.end(), 200), 50);
}

TEST(WebDesk, AThousandWrongPasswordsKeepNobodyOut) {
  const Served served;
  std::vector<std::thread> guessing;
  for (int thread = 0; thread < 8; ++thread) {
    guessing.emplace_back([&, thread] {
      WebClient client = served.client();
      for (int i = 0; i < 125; ++i) {
        const std::string login = "nobody" + std::to_string(125 * thread + i);
        EXPECT_NE(client.send("POST", "/api/sign-in", {{"login", login}, {"password", "x"}}).status, 200);
      }
    });
  }
  const auto took = [&] {
    const auto begun = std::chrono::steady_clock::now();
    WebClient client = served.client();
    EXPECT_TRUE(client.signIn("physician0", kPassword));
    return std::chrono::steady_clock::now() - begun;
  };
  EXPECT_LT(took(), std::chrono::seconds(2)) << "meanwhile";
  for (std::thread& one : guessing) {
    one.join();
  }
  EXPECT_LT(took(), std::chrono::seconds(2)) << "afterwards";
}

TEST(WebDesk, ARightPasswordDoesNotWaitForWrongOnesUnderOtherNames) {
  constexpr int kGuesses = 12;
  const Served served;
  WebDesk desk(
      {.locator = served.centre.locator(), .assets = assetsFolder(), .workers = 2});  // the real cost
  const HttpServer server({"127.0.0.1", 0}, {}, {}, [&desk](HttpRequest request, HttpServer::Reply reply) {
    desk.handle(std::move(request), std::move(reply));
  });
  std::atomic<int> answered{0};
  std::vector<std::thread> guessing;
  for (int i = 0; i < kGuesses; ++i) {
    guessing.emplace_back([&, i] {
      WebClient client(server.port());
      const std::string login = "nobody" + std::to_string(i);
      EXPECT_EQ(client.send("POST", "/api/sign-in", {{"login", login}, {"password", "x"}}).status, 401);
      ++answered;
    });
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(300));  // all of them wait now
  const int before = answered;
  const auto begun = std::chrono::steady_clock::now();
  WebClient right(server.port());
  EXPECT_TRUE(right.signIn("physician0", kPassword));
  const auto took = std::chrono::steady_clock::now() - begun;
  EXPECT_LE(answered - before, 2) << "the one that was being checked, and the oldest";
  EXPECT_LT(took, std::chrono::seconds(2));
  RecordProperty("took_ms",
                 static_cast<int>(std::chrono::duration_cast<std::chrono::milliseconds>(took).count()));
  for (std::thread& one : guessing) {
    one.join();
  }
}

/// Clients that keep guessing from one address, each under a new name and without a pause.
class Guessers {
 public:
  Guessers(int count, std::uint16_t port) {
    for (int i = 0; i < count; ++i) {
      threads_.emplace_back([this, i, port] {
        WebClient client(port);
        for (int n = 0; !over_; ++n) {
          const std::string login = "nobody" + std::to_string(i) + "." + std::to_string(n);
          (void)client.send("POST", "/api/sign-in", {{"login", login}, {"password", "x"}});
          ++answered_;
        }
      });
    }
  }
  [[nodiscard]] int answered() const noexcept { return answered_; }
  void end(WebDesk& desk) {
    over_ = true;
    desk.endWaiting();
    for (std::thread& one : threads_) {
      one.join();
    }
  }

 private:
  std::atomic<bool> over_{false};
  std::atomic<int> answered_{0};
  std::vector<std::thread> threads_;
};

TEST(WebDesk, GuessesFromTheSameAddressKeepNobodyWaiting) {
  constexpr int kGuessers = 25;
  const Served served;
  WebDesk desk(
      {.locator = served.centre.locator(), .assets = assetsFolder(), .workers = 2});  // the real cost
  const HttpServer server({"127.0.0.1", 0}, {}, {}, [&desk](HttpRequest request, HttpServer::Reply reply) {
    desk.handle(std::move(request), std::move(reply));
  });
  WebClient owner(server.port());
  ASSERT_TRUE(owner.signIn("physician0", kPassword)) << "from now on this browser is known";
  const auto begunAlone = std::chrono::steady_clock::now();
  EXPECT_EQ(owner.send("POST", "/api/sign-in", {{"login", "nobody"}, {"password", "x"}}).status, 401);
  const auto alone = std::chrono::steady_clock::now() - begunAlone;
  Guessers guessers(kGuessers, server.port());
  while (guessers.answered() == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  const auto took = [&](WebClient& browser, const std::string& login) {
    const auto begun = std::chrono::steady_clock::now();
    EXPECT_TRUE(browser.signIn(login, kPassword));
    return std::chrono::steady_clock::now() - begun;
  };
  EXPECT_LT(took(owner, "physician0"), 10 * alone) << "a known browser comes first";
  std::this_thread::sleep_for(std::chrono::seconds(5));  // the first guess of each has been checked
  for (int i = 0; i < 3; ++i) {
    WebClient fresh(server.port());
    EXPECT_LT(took(fresh, "physician1"), 10 * alone) << "so does whoever comes for the first time";
  }
  guessers.end(desk);
}

TEST(LateAnswers, AreGivenWhenTheyAreDueOrAtTheEnd) {
  using std::chrono::milliseconds;
  EXPECT_EQ(LateAnswers::delayFor(2).count(), 0) << "nobody is kept waiting on a quiet day";
  EXPECT_GT(LateAnswers::delayFor(4), LateAnswers::delayFor(3));
  EXPECT_LE(LateAnswers::delayFor(10'000), std::chrono::seconds(45)) << "browsers give up after a minute";
  LateAnswers late;
  std::vector<int> given;
  const SteadyTime now{};
  late.keep(now + milliseconds(20), [&] { given.push_back(2); });
  late.keep(now + milliseconds(10), [&] { given.push_back(1); });
  late.tick(now + milliseconds(9));
  EXPECT_TRUE(given.empty());
  late.tick(now + milliseconds(10));
  EXPECT_EQ(given, std::vector<int>{1});
  late.end();
  late.keep(now + milliseconds(99), [&] { given.push_back(3); });
  EXPECT_EQ(given, (std::vector<int>{1, 2, 3}));
}

/// Wrong passwords from elsewhere, or from the same address, do not keep the owner of an account out.
TEST(WebDesk, NobodyCanLockTheOwnerOfAnAccountOut) {
  const Served served;
  WebClient owner = served.client();
  ASSERT_TRUE(owner.signIn("physician0", kPassword)) << "from now on this browser is known";
  WebClient stranger = served.client();
  int last = 0;
  for (int i = 0; i < 6; ++i) {
    last = stranger.send("POST", "/api/sign-in", {{"login", "physician0"}, {"password", "x"}}).status;
  }
  EXPECT_EQ(last, 429);
  EXPECT_FALSE(stranger.signIn("physician0", kPassword)) << "who has guessed waits, even with the right one";

  EXPECT_TRUE(owner.signIn("physician0", kPassword)) << "at the same address, in a known browser";
  WebClient other = served.client();
  EXPECT_TRUE(other.signIn("physician1", kPassword)) << "of another name";
  other.cookie = "__Host-torsio-known=" + std::string(64, 'a');
  EXPECT_FALSE(other.signIn("physician0", kPassword)) << "a forged mark";
}

/// A page elsewhere whose name points to this machine would be of the same origin as the desk (DNS
/// rebinding).
TEST(WebDesk, AnswersOnlyUnderItsOwnNames) {
  const Served served;
  const WebClient client = served.client();
  const auto statusOf = [&](const std::string& host, const std::string& path) {
    return client.raw("GET " + path + " HTTP/1.1\r\n" + host + "Connection: close\r\n\r\n").status;
  };
  for (const char* own :
       {"localhost", "LOCALHOST.:8443", "127.0.0.1", "127.0.0.1:8443", "192.0.2.7", "[::1]:8443"}) {
    EXPECT_EQ(statusOf("Host: " + std::string(own) + "\r\n", "/"), 200) << own;
    EXPECT_EQ(statusOf("Host: " + std::string(own) + "\r\n", "/api/me"), 401) << own;
  }
  for (const char* other : {"evil.example", "evil.example:8443", "localhost.evil.example",
                            "127.0.0.1.evil.example", "localhost@evil.example", "", "[::1", "127.0.0.1#x"}) {
    EXPECT_EQ(statusOf("Host: " + std::string(other) + "\r\n", "/"), 421) << other;
    EXPECT_EQ(statusOf("Host: " + std::string(other) + "\r\n", "/api/me"), 421) << other;
    EXPECT_EQ(statusOf("Host: " + std::string(other) + "\r\n", "/healthz"), 200) << other;
  }

  web::DeskSettings named{.locator = served.centre.locator(), .assets = assetsFolder(), .workers = 1};
  named.publicUrl = "https://desk.example.org";
  named.hosts = {"Room-3", "*.clinic.example"};
  web::WebDesk desk(named);
  const auto answered = [&](const std::string& host) {
    int status = 0;
    desk.handle({.method = "GET", .path = "/", .headers = {{"host", host}}},
                [&status](const web::HttpResponse& response) { status = response.status; });
    return status;
  };
  for (const char* own : {"desk.example.org", "room-3:8443", "a.clinic.example"}) {
    EXPECT_EQ(answered(own), 200) << own;
  }
  for (const char* other : {"example.org", "clinic.example", "a.b.clinic.example", ".clinic.example"}) {
    EXPECT_EQ(answered(other), 421) << other;
  }
}

TEST(WrongTries, AreManyForAMinute) {
  WrongTries tries(2, std::chrono::minutes(1));
  const SteadyTime now{std::chrono::hours(1)};
  tries.add("a", now);
  EXPECT_EQ(tries.waitOf("a", now).count(), 0);
  tries.add("a", now + std::chrono::seconds(20));
  EXPECT_EQ(tries.waitOf("a", now + std::chrono::seconds(20)).count(), 41);
  EXPECT_EQ(tries.waitOf("b", now).count(), 0);
  EXPECT_EQ(tries.waitOf("a", now + std::chrono::seconds(61)).count(), 0);
}

TEST(WebDesk, AcceptsRequestsOnlyFromItsOwnPage) {
  const Served served;
  WebClient client = served.physician(0);
  const std::string path = "/api/cases/" + firstCase(client) + "/remarks";
  const json remark = {{"time_us", 1000}, {"text", "here"}};

  WebClient other = client;
  other.token = "forged";
  EXPECT_EQ(other.send("POST", path, remark).status, 401);
  other = client;
  other.headers = {{"Sec-Fetch-Site", "cross-site"}};
  EXPECT_EQ(other.send("POST", path, remark).status, 403);
  const std::string text = remark.dump();
  const std::string head =
      "POST " + path + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nCookie: " + client.cookie +
      "\r\nX-Torsio-Token: " + client.token +
      "\r\nOrigin: http://localhost\r\nContent-Length: " + std::to_string(text.size()) + "\r\nContent-Type: ";
  EXPECT_EQ(client.raw(head + "text/plain\r\n\r\n" + text).status, 403);
  EXPECT_EQ(client.raw(head + "application/json\r\n\r\n" + text).status, 200);
  const auto desk = served.centre.trialIds();
  EXPECT_EQ(client.get("/api/cases/" + firstCase(client)).json().at("remarks").size(), 1U);
}

TEST(WebDesk, ACaseIsScoredSavedAndSubmitted) {
  Served served;
  WebClient client = served.physician(0);
  const std::string handle = firstCase(client);
  const std::string path = "/api/cases/" + handle;
  const json opened = client.get(path).json();
  ASSERT_EQ(opened.at("state"), "open");
  EXPECT_EQ(opened.at("rubric").at("rows").size(), 2U);
  EXPECT_FALSE(opened.at("check").at("may_submit"));

  const DeskAnswer saved = client.send("PUT", path + "/sheet", sheetBody(0, 70, 80, 75));
  ASSERT_EQ(saved.status, 200) << saved.body;
  EXPECT_EQ(saved.json().at("revision"), 1);
  const DeskAnswer early = client.send("POST", path + "/submit", {{"sheet", sheetBody(1, 70, 80, 75)}});
  EXPECT_EQ(early.status, 400) << "nothing was watched yet";
  const DeskAnswer seen =
      client.send("POST", path + "/viewing",
                  {{"played", {{{"from_us", 0}, {"to_us", opened.at("length_us")}, {"speed", 1.0}}}}});
  ASSERT_EQ(seen.status, 200) << seen.body;
  EXPECT_GT(seen.json().at("share").get<double>(), 0.8);
  const DeskAnswer sealed = client.send("POST", path + "/submit", {{"sheet", sheetBody(1, 70, 80, 75)}});
  ASSERT_EQ(sealed.status, 200) << sealed.body;

  EXPECT_EQ(client.get(path).json().at("state"), "submitted");
  const DeskAnswer again = client.send("POST", path + "/submit", {{"sheet", sheetBody(1, 70, 80, 75)}});
  EXPECT_EQ(again.status, 400) << again.body;
  EXPECT_NE(again.body.find("this sheet is sealed already"), std::string::npos) << again.body;
  EXPECT_EQ(sealed.json().at("next"), firstCase(client));
  const auto desk = served.centre.physician(0);
  int submitted = 0;
  for (const AssignmentId& id : served.centre.cases(0)) {
    submitted += openSheet(*desk, id).state == SheetState::kSubmitted;
  }
  EXPECT_EQ(submitted, 1) << "the window finds what the browser has sealed";
}

TEST(WebDesk, OfTwoSealsOrTwoChangesAtOnceOneCountsAndTheOtherIsTold) {
  const Served served({.raters = 1, .trainees = 1, .trial_s = 0.5});
  std::vector<WebClient> tabs{served.physician(0), served.physician(0)};
  const std::vector<std::string> paths{"/api/cases/" + firstCase(tabs[0]),
                                       "/api/cases/" + firstCase(tabs[1])};
  watchWhole(tabs[0], paths[0]);
  submitTwiceAtOnce(tabs, paths);
  amendTwiceAtOnce(tabs, paths);
}

TEST(WebDesk, ASealedSheetSubmittedAgainIsSaidToBeSealed) {
  const Served served({.raters = 1, .trainees = 1, .trial_s = 0.5});
  WebClient client = served.physician(0);
  WebClient late = served.physician(0);
  const std::string path = "/api/cases/" + firstCase(client);
  const std::string pathOfLate = "/api/cases/" + firstCase(late);
  watchWhole(client, path);
  const json body = {{"sheet", sheetBody(0, 70, 80, 75)}};
  ASSERT_EQ(client.send("POST", path + "/submit", body).status, 200);

  for (const DeskAnswer& answer :
       {client.send("POST", path + "/submit", body), late.send("POST", pathOfLate + "/submit", body),
        late.send("PUT", pathOfLate + "/sheet", sheetBody(0, 10, 10, 10)),
        late.send("POST", pathOfLate + "/viewing",
                  {{"played", {{{"from_us", 0}, {"to_us", 1'000}, {"speed", 1.0}}}}})}) {
    EXPECT_EQ(answer.status, 400) << answer.body;
    EXPECT_NE(answer.body.find("this sheet is sealed already"), std::string::npos) << answer.body;
    EXPECT_EQ(answer.body.find("has been played"), std::string::npos) << answer.body;
  }
}

TEST(WebDesk, TheWindowAndTwoTabsNeverOverwriteEachOther) {
  Served served;
  WebClient one = served.physician(0);
  WebClient two = served.physician(0);
  const std::string here = "/api/cases/" + firstCase(one) + "/sheet";
  const std::string there = "/api/cases/" + firstCase(two) + "/sheet";
  EXPECT_NE(here, there) << "a handle means nothing in another session";

  EXPECT_EQ(one.send("PUT", here, sheetBody(0, 70, 80, 75)).status, 200);
  const DeskAnswer late = two.send("PUT", there, sheetBody(0, 10, 10, 10));

  ASSERT_EQ(late.status, 409) << late.body;
  EXPECT_EQ(late.json().at("sheet").at("overall_steps"), 75);
  const std::int64_t revision = late.json().at("sheet").at("revision");
  EXPECT_EQ(two.send("PUT", there, sheetBody(revision, 10, 10, 10)).status, 200);
  EXPECT_EQ(one.send("PUT", here, sheetBody(1, 71, 80, 75)).status, 409);
}

TEST(WebDesk, AsksForThePasswordIfTheSignatureRequiresIt) {
  Served served;
  {
    const auto office = served.centre.administrator();
    setCentreSetting<kSignMinutes>(*office, 0);
  }
  WebClient client = served.physician(0);
  const std::string path = "/api/cases/" + firstCase(client);
  (void)client.send("POST", path + "/viewing",
                    {{"played", {{{"from_us", 0}, {"to_us", 500'000}, {"speed", 1.0}}}}});
  json body = {{"sheet", sheetBody(0, 70, 80, 75)}};

  const DeskAnswer asked = client.send("POST", path + "/submit", body);
  ASSERT_EQ(asked.status, 403) << asked.body;
  EXPECT_TRUE(asked.json().at("need_password"));
  EXPECT_EQ(asked.json().at("meaning"), "I scored this case");
  body["password"] = "wrong";
  EXPECT_EQ(client.send("POST", path + "/submit", body).status, 403);
  body["password"] = kPassword;
  const DeskAnswer sealed = client.send("POST", path + "/submit", body);
  EXPECT_EQ(sealed.status, 200) << sealed.body;
}

TEST(WebDesk, NoByteRevealsTheTrainee) {
  Served served({.raters = 2, .trainees = 3, .trial_s = 0.5, .live = true, .dueByTrainee = true});
  WebClient client = served.physician(0);
  std::vector<DeskAnswer> answers{client.get("/api/queue"), client.get("/api/me"), client.get("/api/texts")};
  for (const char* path : {"/api/evaluation", "/api/calibration", "/api/severity", "/api/discrepancies",
                           "/api/sessions", "/api/own", "/api/own/remarks", "/api/own/transcript",
                           "/api/cohorts", "/api/all-sessions", "/api/invitations"}) {
    answers.push_back(client.get(path));
  }
  const json queue = answers.front().json();
  for (const json& line : queue.at("lines")) {
    const std::string path = "/api/cases/" + line.at("case").get<std::string>();
    answers.push_back(client.get(path));
    answers.push_back(client.get(path + "/recording"));
    answers.push_back(client.get(path + "/organ"));
    answers.push_back(client.send("PUT", path + "/sheet", sheetBody(7, 70, 80, 75)));
    answers.push_back(client.send("POST", path + "/submit", {{"sheet", sheetBody(7, 70, 80, 75)}}));
  }

  ASSERT_GT(answers.size(), 10U);
  std::vector<std::string> secrets = served.centre.secrets();
  for (std::size_t i = 0; i < 2; ++i) {
    for (const bool live : {false, true}) {
      for (const AssignmentId& id : served.centre.cases(i, live)) {
        secrets.push_back(id);
      }
    }
  }
  for (const DeskAnswer& answer : answers) {
    std::string all = answer.body;
    for (const auto& [name, value] : answer.headers) {
      all.append("\n").append(name).append(": ").append(value);
    }
    for (const std::string& secret : secrets) {
      EXPECT_EQ(all.find(secret), std::string::npos) << secret << " in " << all.substr(0, 200);
    }
    EXPECT_EQ(answer.headers.count("last-modified"), 0U);
    EXPECT_EQ(answer.headers.count("etag"), 0U);
  }
  const std::lock_guard lock(served.logging);
  EXPECT_NE(served.log.find("GET /api/cases/*/recording 200"), std::string::npos) << served.log;
  secrets.push_back("physician");
  secrets.push_back(queue.at("lines").at(0).at("case"));
  for (const std::string& secret : secrets) {
    EXPECT_EQ(served.log.find(secret), std::string::npos) << secret << " in the log of accesses";
  }
}

TEST(WebDesk, AnotherUsersCaseIsAnsweredLikeAMissingOne) {
  const Served served;
  WebClient one = served.physician(0);
  WebClient two = served.physician(1);
  const std::string foreign = firstCase(one);

  const DeskAnswer theirs = two.get("/api/cases/" + foreign);
  const DeskAnswer none = two.get("/api/cases/nothing");

  EXPECT_EQ(theirs.status, 403);
  EXPECT_EQ(theirs.body, none.body);
}

TEST(WebDesk, ARecordingHasItsTraces) {
  const Served served;
  WebClient client = served.physician(0);
  const DeskAnswer answer = client.get("/api/cases/" + firstCase(client) + "/recording");

  ASSERT_EQ(answer.status, 200);
  ASSERT_EQ(answer.body.substr(0, 4), "TRS1");
  std::uint32_t length = 0;
  std::copy_n(answer.body.data() + 4, sizeof length, reinterpret_cast<char*>(&length));
  const json head = json::parse(answer.body.substr(8, length));
  EXPECT_EQ(head.at("meta").at("rate_hz"), 60);
  EXPECT_EQ(head.at("meta").at("frames"), 30);
  for (const json& array : head.at("arrays")) {
    EXPECT_EQ(array.at("offset").get<int>() % 4, 0);
    const int columns = array.at("name") == "tool" ? 7 : 1;
    EXPECT_EQ(array.at("count"), 30 * columns) << array;
  }
}

TEST(WebDesk, AnswersInTheLanguageOfThePage) {
  const Served served;
  WebClient client = served.client();
  client.headers = {{"X-Torsio-Language", "zh_CN"}};

  EXPECT_EQ(client.get("/api/texts").json().at("language"), "zh_CN");
  const DeskAnswer refused = client.get("/api/queue");
  EXPECT_EQ(refused.status, 401);
  EXPECT_EQ(refused.json().at("error").at("what").get<std::string>().find("signed"), std::string::npos);
  WebClient physician = served.physician(0);
  const std::string path = "/api/cases/" + firstCase(physician);
  const json english = physician.get(path).json();
  physician.headers = client.headers;
  EXPECT_NE(physician.get(path).json().at("rubric"), english.at("rubric"));
}

TEST(WebDesk, NoRequestCausesAnInternalError) {
  const Served served;
  WebClient client = served.physician(0);
  const std::string handle = firstCase(client);
  Random random(5);
  const std::vector<json> odd = {nullptr,
                                 -1,
                                 1e300,
                                 "x",
                                 json::array(),
                                 json::object(),
                                 true,
                                 9223372036854775807,
                                 std::string(5000, 'y'),
                                 json::array({json::object()}),
                                 "\xF0\x9F\x98\x80"};
  const std::vector<std::string> names = {"revision", "rows",     "overall_steps", "comment",
                                          "sheet",    "played",   "text",          "time_us",
                                          "reason",   "password", "code",          "score_steps"};
  for (int i = 0; i < 400; ++i) {
    const auto& routes = served.desk->router().routes();
    const Route& route = routes[random.bounded(routes.size())];
    if (route.method == "GET" || route.path == "/api/sign-out" || route.access == RouteAccess::kOpen) {
      continue;
    }
    json body = sheetBody(0, 70, 80, 75);
    for (std::uint64_t k = 0; k < 1 + random.bounded(3); ++k) {
      body[names[random.bounded(names.size())]] = odd[random.bounded(odd.size())];
    }
    const DeskAnswer answer = client.send(route.method, pathOf(route, handle), body);
    EXPECT_NE(answer.status, 500) << route.path << " "
                                  << body.dump(-1, ' ', false, json::error_handler_t::replace);
    EXPECT_NE(answer.status, 0);
  }
  EXPECT_EQ(client.get("/api/me").status, 200);
}

TEST(WebDesk, TellsAMonitoringSystemCountsAndTimesAndNothingOfPeople) {
  const Served served;
  WebClient client = served.client();
  ASSERT_TRUE(client.signIn("physician1", kWebPassword));
  ASSERT_EQ(client.get("/api/queue").status, 200);
  ASSERT_EQ(client.get("/api/queue").status, 200);
  ASSERT_EQ(client.get("/api/cases/none").status, 403);

  const DeskAnswer answer = client.get("/metrics");

  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.headers.at("content-type"), "application/openmetrics-text; version=1.0.0; charset=utf-8");
  for (const char* line :
       {"torsio_answers_total{route=\"GET /api/queue\",status=\"200\"} 2\n",
        "torsio_answers_total{route=\"GET /api/cases/*\",status=\"403\"} 1\n",
        "torsio_answer_seconds_bucket{route=\"GET /api/queue\",le=\"+Inf\"} 2\n",
        "torsio_answer_seconds_count{route=\"GET /api/queue\"} 2\n", "\ntorsio_record_up 1\n",
        "\ntorsio_sessions 1\n", "\ntorsio_queued_passwords 0\n"}) {
    EXPECT_NE(answer.body.find(line), std::string::npos) << line << answer.body;
  }
  EXPECT_TRUE(answer.body.ends_with("\n# EOF\n"));
  EXPECT_EQ(answer.body.find("physician"), std::string::npos);
  const std::regex line(
      "# (TYPE [a-z_]+ (info|counter|gauge|histogram)|HELP [a-z_]+ .+|EOF)|[a-z_]+(\\{[^}]*\\})? [0-9.e+-]+");
  std::istringstream lines(answer.body);
  for (std::string one; std::getline(lines, one);) {
    EXPECT_TRUE(std::regex_match(one, line)) << one;
  }
}

TEST(WebDesk, TellsItsMetricsToOtherComputersOnlyIfItIsToldTo) {
  const Served served;
  for (const bool open : {false, true}) {
    web::WebDesk desk(
        {.locator = served.centre.locator(), .assets = assetsFolder(), .workers = 1, .openMetrics = open});
    int status = 0;
    desk.handle({.method = "GET", .path = "/metrics", .address = "203.0.113.7"},
                [&status](const web::HttpResponse& response) { status = response.status; });
    EXPECT_EQ(status, open ? 200 : 404);
  }
}

}  // namespace
}  // namespace torsio::web
