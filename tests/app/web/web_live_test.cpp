// SPDX-License-Identifier: GPL-3.0-or-later
// Live scoring in browsers: a call opens the sheet on every rater's page, and the administrator calls.
#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/study/live_call.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/served_desk.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

using nlohmann::json;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

class WebLive : public ::testing::Test {
 protected:
  WebLive() : served({.raters = 3, .trainees = 2, .trial_s = 0.5, .live = true, .called = false}) {
    office = served.signedIn("office");
    cohort =
        "/api/cohorts/" + office.get("/api/cohorts").json().at("cohorts")[0].at("cohort").get<std::string>();
  }
  DeskAnswer call(const std::string& code) {
    return office.send("POST", cohort + "/calls",
                       {{"code", code}, {"occasion", "post"}, {"room", "Skills lab"}});
  }
  std::string pathOfCall(const char* act) {
    return cohort + "/calls/" +
           office.get(cohort + "/calls").json().at("calls")[0].at("call").get<std::string>() + "/" + act;
  }
  static std::string stampOf(WebClient& rater) { return rater.get("/api/live").json().at("stamp"); }

  ServedDesk served;
  WebClient office{0};
  std::string cohort;
};

TEST_F(WebLive, ACallReachesEveryWaitingPageWithinTwoSeconds) {
  std::vector<WebClient> raters;
  for (int i = 0; i < 3; ++i) {
    raters.push_back(served.physician(i));
  }
  std::vector<std::thread> waiting;
  std::vector<json> heard(raters.size());
  std::vector<Clock::time_point> when(raters.size());
  for (std::size_t i = 0; i < raters.size(); ++i) {
    waiting.emplace_back([&, i, stamp = stampOf(raters[i])] {
      heard[i] = raters[i].get("/api/live/" + stamp).json();
      when[i] = Clock::now();
    });
  }
  std::this_thread::sleep_for(300ms);
  EXPECT_EQ(served.client().get("/readyz").status, 200) << "waiting pages take no thread";

  const Clock::time_point called = Clock::now();
  const DeskAnswer answer = call("tr-4100 ");
  ASSERT_EQ(answer.status, 200) << answer.body;
  for (std::thread& one : waiting) {
    one.join();
  }

  for (std::size_t i = 0; i < raters.size(); ++i) {
    EXPECT_LT(when[i] - called, 2s);
    ASSERT_EQ(heard[i].at("lines").size(), 1U) << heard[i];
    EXPECT_TRUE(heard[i].at("lines")[0].at("open"));
    EXPECT_TRUE(heard[i].at("calls_go_on"));
    const json follow =
        raters[i].send("POST", "/api/live/follow", {{"shown", ""}, {"busy", 0}, {"followed", ""}}).json();
    EXPECT_EQ(follow.at("called").at("case"), heard[i].at("lines")[0].at("case"));
    EXPECT_EQ(follow.at("called").at("room"), "Skills lab");
    EXPECT_TRUE(follow.at("opens"));
    EXPECT_EQ(raters[i].get("/api/cases/" + follow.at("called").at("case").get<std::string>()).status, 200);
  }
}

TEST_F(WebLive, ACallMadeAtAStationReachesThePageToo) {
  WebClient rater = served.physician(0);
  std::thread calling([&] {
    std::this_thread::sleep_for(200ms);
    ReviewCentre station(served.centre.folder());
    const auto session = station.administrator();
    session->beginCall();
    const CohortId cohortId = station.cohortId();
    (void)callTrainee(*session,
                      {cohortId, enrolmentWithCode(*session, cohortId, "TR-4100"), "post", "Skills lab"});
  });
  const Clock::time_point begun = Clock::now();
  const json heard = rater.get("/api/live/" + stampOf(rater)).json();
  const auto took = Clock::now() - begun;
  calling.join();

  EXPECT_LT(took, 3s);
  EXPECT_EQ(heard.at("lines").size(), 1U);
}

TEST_F(WebLive, APageThatDoesNotKnowTheNewestIsAnsweredAtOnce) {
  WebClient rater = served.physician(0);
  const std::string stamp = stampOf(rater);
  ASSERT_EQ(call("TR-4100").status, 200);

  const Clock::time_point begun = Clock::now();
  EXPECT_EQ(rater.get("/api/live/" + stamp).json().at("lines").size(), 1U);
  EXPECT_LT(Clock::now() - begun, 1s);
}

TEST_F(WebLive, WaitingPagesAreAnsweredWhenTheServerStops) {
  WebClient rater = served.physician(0);
  DeskAnswer answer;
  std::thread waiting([&, stamp = stampOf(rater)] { answer = rater.get("/api/live/" + stamp); });
  std::this_thread::sleep_for(200ms);

  served.desk->endWaiting();
  waiting.join();

  EXPECT_EQ(answer.status, 204);
}

TEST_F(WebLive, TheAdministratorCallsRemindsAndEnds) {
  EXPECT_EQ(call("TR-9999").status, 400);
  const json called = call("TR-4100").json().at("calls");
  ASSERT_EQ(called.size(), 1U);
  EXPECT_EQ(called[0].at("asked"), 3);
  EXPECT_EQ(called[0].at("submitted"), 0);
  EXPECT_EQ(call("TR-4101").status, 400) << "the room is taken";

  WebClient rater = served.physician(0);
  const std::string sheet =
      "/api/cases/" + rater.get("/api/live").json().at("lines")[0].at("case").get<std::string>();
  ASSERT_EQ(rater.send("PUT", sheet + "/sheet", sheetBody(0, 70, 80, 75)).status, 200);
  const DeskAnswer sealed = rater.send("POST", sheet + "/submit", {{"sheet", sheetBody(1, 70, 80, 75)}});
  ASSERT_EQ(sealed.status, 200) << sealed.body;
  EXPECT_EQ(office.send("POST", pathOfCall("cancel"), {{"reason", "wrong person"}}).status, 400)
      << "a sheet is in already";

  const json ended = office.send("POST", pathOfCall("end"), json::object()).json().at("calls");
  ASSERT_EQ(ended.size(), 1U) << "two sheets are late";
  EXPECT_FALSE(ended[0].at("open"));
  EXPECT_EQ(ended[0].at("missing"), 2);
  const json reminder = office.send("POST", pathOfCall("remind"), json::object()).json();
  const std::string codes =
      ended[0].at("missing_text").get<std::string>().substr(std::string("missing: ").size());
  EXPECT_NE(codes.find(", "), std::string::npos) << codes;
  EXPECT_TRUE(reminder.at("text").get<std::string>().ends_with(codes)) << reminder;
}

TEST_F(WebLive, ASealedSheetSubmittedAgainOrAtOnceIsSaidToBeSealed) {
  ASSERT_EQ(call("TR-4100").status, 200);
  std::vector<WebClient> pages{served.physician(0), served.physician(0)};
  std::vector<std::string> paths;
  for (WebClient& page : pages) {
    paths.push_back("/api/cases/" +
                    page.get("/api/live").json().at("lines")[0].at("case").get<std::string>());
  }

  submitTwiceAtOnce(pages, paths);

  const DeskAnswer again = pages[0].send("POST", paths[0] + "/submit", {{"sheet", sheetBody(0, 70, 80, 75)}});
  EXPECT_EQ(again.status, 400) << again.body;
  EXPECT_NE(again.body.find("this sheet is sealed already"), std::string::npos) << again.body;
  EXPECT_EQ(office.get(cohort + "/calls").json().at("calls")[0].at("submitted"), 1);
}

TEST_F(WebLive, AWithdrawnCallClosesTheSheetAndKeepsTheDraft) {
  ASSERT_EQ(call("TR-4100").status, 200);
  WebClient rater = served.physician(0);
  const std::string sheet =
      "/api/cases/" + rater.get("/api/live").json().at("lines")[0].at("case").get<std::string>();
  ASSERT_EQ(rater.send("PUT", sheet + "/sheet", sheetBody(0, 70, 80, 75)).status, 200);

  EXPECT_EQ(office.send("POST", pathOfCall("cancel"), {{"reason", ""}}).status, 400);
  ASSERT_EQ(office.send("POST", pathOfCall("cancel"), {{"reason", "wrong person"}}).status, 200);
  EXPECT_TRUE(rater.get("/api/live").json().at("lines").empty());
  EXPECT_EQ(rater.get(sheet).status, 400);

  ASSERT_EQ(call("TR-4100").status, 200);
  EXPECT_EQ(rater.get(sheet).json().at("sheet").at("overall_steps"), 75);
}

}  // namespace
}  // namespace torsio::web
