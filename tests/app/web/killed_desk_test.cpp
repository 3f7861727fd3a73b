// SPDX-License-Identifier: GPL-3.0-or-later
// Kills the desk's process while a sheet is edited and restarts it, with the system clock set back: whatever
// was acknowledged is there, nothing is duplicated. TORSIO_KILL_INSTANTS: number of kills.
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <thread>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/random.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/served_desk.h"
#include "tests/app/web/serving_program.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

using nlohmann::json;

using namespace std::chrono_literals;

WebClient physicianAt(std::uint16_t port) {
  WebClient client(port);
  client.headers = {{"Sec-Fetch-Site", "same-origin"}};
  EXPECT_TRUE(client.signIn("physician0", kWebPassword));
  return client;
}

json sheetOf(WebClient& client) {
  return client.get("/api/cases/" + firstCase(client)).json().at("sheet");
}

/// Marks of the sheet by row, with the overall mark.
std::map<std::string, int> marksOf(const json& sheet) {
  std::map<std::string, int> marks{{"overall", sheet.at("overall_steps")}};
  for (const json& row : sheet.at("rows")) {
    marks[row.at("code")] = row.at("score_steps");
  }
  return marks;
}

/// Marks that identify the save by its number.
json savedAs(std::int64_t revision, int step) {
  return sheetBody(revision, step % 100, (step + 1) % 100, (step + 2) % 100);
}

TEST(KilledDesk, LosesNoAcknowledgedMarkAndDuplicatesNone) {
  ReviewCentre centre({.trial_s = 0.5});
  setWebPasswords(centre);
  Random random(20'26);
  std::int64_t revision = 0;
  int step = 0;
  int kept = 0;  // number of the save with this revision

  for (long round = 0; round < instantsOf("TORSIO_KILL_INSTANTS", 5); ++round) {
    ServingProgram served(centre, {});
    const std::uint16_t port = served.port();
    ASSERT_NE(port, 0);
    WebClient client = physicianAt(port);
    const std::string path = "/api/cases/" + firstCase(client) + "/sheet";
    const auto later = std::chrono::microseconds(static_cast<long>(2e5 * random.uniform()));
    std::thread killer([&served, later] {
      std::this_thread::sleep_for(later);
      served.die();
    });
    DeskAnswer answer;
    do {
      ++step;
      answer = client.send("PUT", path, savedAs(revision, step));
      EXPECT_TRUE(answer.status == 200 || answer.status == 0) << answer.status << answer.body;
      if (answer.status == 200) {
        ++revision;
        kept = step;
      }
    } while (answer.status == 200);
    killer.join();

    ServingProgram again(centre, {});
    const std::uint16_t newPort = again.port();
    ASSERT_NE(newPort, 0) << "what the killed one left behind is in the way";
    WebClient back = physicianAt(newPort);
    const json sheet = sheetOf(back);
    const std::int64_t found = sheet.at("revision");
    ASSERT_TRUE(found == revision || found == revision + 1) << "answered " << revision << ", found " << sheet;
    kept = found == revision ? kept : step;  // the interrupted save is complete, and stored once
    revision = found;
    if (revision > 0) {
      EXPECT_EQ(marksOf(sheet), marksOf(savedAs(0, kept)));
    }
  }
}

TEST(KilledDesk, FindsAndSealsADraftWithTheClockSetBack) {
  ReviewCentre centre({.trial_s = 0.5});
  setWebPasswords(centre);
  std::int64_t revision = 0;
  {
    ServingProgram served(centre, {});
    WebClient client = physicianAt(served.port());
    const DeskAnswer saved =
        client.send("PUT", "/api/cases/" + firstCase(client) + "/sheet", sheetBody(0, 70, 80, 75));
    ASSERT_EQ(saved.status, 200) << saved.body;
    revision = saved.json().at("revision");
  }
  ServingProgram served(centre, {"LD_PRELOAD=" TORSIO_FAULT_POINTS, "TORSIO_FAULT_CLOCK_S=-90000"});
  const std::uint16_t port = served.port();
  ASSERT_NE(port, 0);
  WebClient client = physicianAt(port);
  const std::string path = "/api/cases/" + firstCase(client);
  const json opened = client.get(path).json();

  EXPECT_EQ(opened.at("sheet").at("overall_steps"), 75);
  EXPECT_EQ(client.send("PUT", path + "/sheet", sheetBody(revision - 1, 1, 1, 1)).status, 409)
      << "what is older is older, whatever the clock says";
  const DeskAnswer saved = client.send("PUT", path + "/sheet", sheetBody(revision, 72, 80, 75));
  ASSERT_EQ(saved.status, 200) << saved.body;
  ASSERT_EQ(client
                .send("POST", path + "/viewing",
                      {{"played", {{{"from_us", 0}, {"to_us", opened.at("length_us")}, {"speed", 1.0}}}}})
                .status,
            200);
  const DeskAnswer sealed =
      client.send("POST", path + "/submit", {{"sheet", sheetBody(revision + 1, 72, 80, 75)}});
  ASSERT_EQ(sealed.status, 200) << sealed.body;
  EXPECT_EQ(client.get(path).json().at("state"), "submitted");
}

}  // namespace
}  // namespace torsio::web
