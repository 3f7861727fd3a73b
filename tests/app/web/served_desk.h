// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <barrier>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/assets.h"
#include "app/web/http_server.h"
#include "app/web/web_desk.h"
#include "assessment/domain/people/account.h"
#include "db/repository/people/access_repository.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/web_client.h"

namespace torsio {

/// Password of everybody at a served desk.
inline constexpr const char* kWebPassword = "correct horse battery";
/// What somebody chooses who was invited.
inline constexpr const char* kChosenPassword = "seven kites above the bay";

inline void setWebPasswords(ReviewCentre& centre) {
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  for (const UserAccount& user : access.users()) {
    access.setPassword(user.id, access.sealPassword(user.login, kWebPassword), false);
  }
}

/// A centre with short recordings, and its desk on a local port.
struct ServedDesk {
  explicit ServedDesk(const ReviewCentre::Setup& setup = {.trial_s = 0.5}) : centre(setup) {
    setWebPasswords(centre);
    desk = std::make_unique<web::WebDesk>(web::DeskSettings{.locator = centre.locator(),
                                                            .assets = assetsFolder(),
                                                            .workers = 2,
                                                            .passwordCost = PasswordCost::kTest,
                                                            .accessLog =
                                                                [this](const std::string& line) {
                                                                  const std::lock_guard lock(logging);
                                                                  log += line + "\n";
                                                                },
                                                            .log =
                                                                [this](const std::string& line) {
                                                                  const std::lock_guard lock(logging);
                                                                  causes += line + "\n";
                                                                }});
    server = std::make_unique<web::HttpServer>(
        web::HttpAddress{"127.0.0.1", 0}, web::TlsMaterial{}, web::HttpLimits{},
        [this](web::HttpRequest request, web::HttpServer::Reply reply) {
          desk->handle(std::move(request), std::move(reply));
        });
  }
  ServedDesk(const ServedDesk&) = delete;
  ServedDesk& operator=(const ServedDesk&) = delete;
  ~ServedDesk() { desk->endWaiting(); }
  [[nodiscard]] WebClient client() const { return WebClient(server->port()); }
  [[nodiscard]] WebClient signedIn(const std::string& login) const {
    WebClient client(server->port());
    EXPECT_TRUE(client.signIn(login, kWebPassword)) << login;
    return client;
  }
  [[nodiscard]] WebClient physician(int index) const { return signedIn("physician" + std::to_string(index)); }

  [[nodiscard]] std::string loggedCauses() {
    const std::lock_guard lock(logging);
    return causes;
  }

  std::mutex logging;
  std::string log;     ///< access log
  std::string causes;  ///< lines about the record and failures
  ReviewCentre centre;
  std::unique_ptr<web::WebDesk> desk;
  std::unique_ptr<web::HttpServer> server;
};

inline std::string firstCase(WebClient& client) {
  return client.get("/api/queue").json().at("next").get<std::string>();
}

inline nlohmann::json sheetBody(std::int64_t revision, int time, int accuracy, int overall) {
  return {{"revision", revision},
          {"rows",
           {{{"code", "time"}, {"score_steps", time}, {"not_assessable", ""}},
            {{"code", "accuracy"}, {"score_steps", accuracy}, {"not_assessable", ""}}}},
          {"overall_steps", overall},
          {"comment", ""}};
}

/// Watches the whole recording of a case, half a second long.
inline void watchWhole(WebClient& client, const std::string& path) {
  (void)client.get(path);
  EXPECT_EQ(client
                .send("POST", path + "/viewing",
                      {{"played", {{{"from_us", 0}, {"to_us", 500'000}, {"speed", 1.0}}}}})
                .status,
            200)
      << path;
}

/// Sends the same from every page of a rater at the same moment. `paths`: of the case, in the session of
/// each.
inline std::vector<DeskAnswer> sentAtOnce(std::vector<WebClient>& pages,
                                          const std::vector<std::string>& paths, const std::string& act,
                                          const nlohmann::json& body) {
  std::vector<DeskAnswer> answers(pages.size());
  std::barrier together(static_cast<std::ptrdiff_t>(pages.size()));
  std::vector<std::thread> pressing;
  for (std::size_t i = 0; i < pages.size(); ++i) {
    pressing.emplace_back([&, i] {
      together.arrive_and_wait();
      answers[i] = pages[i].send("POST", paths[i] + act, body);
    });
  }
  for (std::thread& one : pressing) {
    one.join();
  }
  return answers;
}

/// Submits a case from two pages at once: one sheet is sealed, and the other page is told so.
inline void submitTwiceAtOnce(std::vector<WebClient>& pages, const std::vector<std::string>& paths) {
  const std::vector<DeskAnswer> answers =
      sentAtOnce(pages, paths, "/submit", {{"sheet", sheetBody(0, 70, 80, 75)}});
  const std::string said = answers.front().body + answers.back().body;
  EXPECT_EQ(std::min(answers.front().status, answers.back().status), 200) << said;
  EXPECT_EQ(std::max(answers.front().status, answers.back().status), 400) << said;
  EXPECT_NE(said.find("this sheet is sealed already"), std::string::npos) << said;
}

/// Changes the sealed sheet from both pages at once: one is taken, the other is told to look again.
inline void amendTwiceAtOnce(std::vector<WebClient>& pages, const std::vector<std::string>& paths) {
  const std::vector<DeskAnswer> answers =
      sentAtOnce(pages, paths, "/amend", {{"sheet", sheetBody(1, 60, 80, 75)}, {"reason", "mistyped"}});
  const std::string said = answers.front().body + answers.back().body;
  EXPECT_EQ(std::min(answers.front().status, answers.back().status), 200) << said;
  EXPECT_EQ(std::max(answers.front().status, answers.back().status), 409) << said;
  EXPECT_NE(said.find("this sheet was changed at another station meanwhile"), std::string::npos) << said;
  EXPECT_EQ(pages.front().get(paths.front()).json().at("versions").size(), 2U);
}

/// Path of a route with `handle` in place of each `*`.
inline std::string pathOf(const web::Route& route, const std::string& handle) {
  std::string path = route.path;
  for (std::size_t at = path.find('*'); at != std::string::npos; at = path.find('*')) {
    path.replace(at, 1, handle);
  }
  return path;
}

}  // namespace torsio
