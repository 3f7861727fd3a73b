// SPDX-License-Identifier: GPL-3.0-or-later
// torsio tracker with the library's own classes as peer.
#include <filesystem>
#include <future>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/support/fake_tracker.h"

namespace torsio {
namespace {

using testing::FakeTracker;

class TrackerCommand : public ::testing::Test {
 protected:
  ProgramRun run(const std::string& arguments) {
    return runTorsio("tracker " + arguments, folder_, "XDG_CONFIG_HOME=" + (folder_ / "settings").string());
  }

  std::filesystem::path folder_ = emptyFolder("tracker");
};

TEST_F(TrackerCommand, WatchShowsATrackersPoses) {
  FakeTracker tracker;
  auto watched = std::async(std::launch::async, [&] {
    return run("watch --seconds 120 --poses 25 --json --port " + std::to_string(tracker.port()));
  });
  ASSERT_TRUE(tracker.wait());
  for (int i = 0; i < 25; ++i) {
    ASSERT_TRUE(tracker.sendTransform("StylusToReference", {1.0, 2.0, 3.0 + i}, 1'000'000 + i * 10'000));
  }
  const ProgramRun shown = watched.get();

  EXPECT_EQ(shown.code, 0) << shown.err;
  const nlohmann::json said = nlohmann::json::parse(shown.out, nullptr, false);
  EXPECT_EQ(said["instrument"], "StylusToReference");
  EXPECT_EQ(said["received"], 25);
  EXPECT_EQ(said["missing"], 0);
  EXPECT_EQ(said["period_us"], 10'000);
  EXPECT_NEAR(said["position_mm"][2].get<double>(), 27.0, 1e-4);
  EXPECT_EQ(said["orientation_wxyz"][0], 1.0);
}

TEST_F(TrackerCommand, WatchWithoutAPoseIsExitCodeTwelve) {
  FakeTracker tracker;
  auto watched = std::async(
      std::launch::async, [&] { return run("watch --seconds 6 --port " + std::to_string(tracker.port())); });
  ASSERT_TRUE(tracker.wait());
  ASSERT_TRUE(
      tracker.sendBytes("HTTP/1.1 400 Bad Request\r\nConnection: close\r\nServer: another one\r\n\r\n"));
  const ProgramRun shown = watched.get();

  EXPECT_EQ(shown.code, static_cast<int>(ErrorCode::kDevice));
  EXPECT_NE(shown.err.find("not OpenIGTLink"), std::string::npos) << shown.err;
  EXPECT_EQ(run("watch --port 0").code, static_cast<int>(ErrorCode::kUsage));
  EXPECT_EQ(run("watch --seconds -1").code, static_cast<int>(ErrorCode::kBadParameter));
}

TEST_F(TrackerCommand, RemembersTrackerAndServiceUntilCleared) {
  EXPECT_NE(run("choose --port 18955 --instrument Needle").out.find("real arm: 127.0.0.1:18955"),
            std::string::npos);
  const ProgramRun offered = run("offer --port 18956");
  EXPECT_NE(offered.out.find("real arm: 127.0.0.1:18955"), std::string::npos);
  EXPECT_NE(offered.out.find("offered: at 127.0.0.1:18956"), std::string::npos);
  EXPECT_EQ(run("offer --address nowhere").code, static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_NE(run("choose --none").out.find("real arm: none"), std::string::npos);
  EXPECT_NE(run("offer --none").out.find("offered: nowhere"), std::string::npos);
}

TEST_F(TrackerCommand, SendStreamsARecordedRunToItsClient) {
  const std::string record = (folder_ / "r.sqlite").string();
  const ProgramRun recorded = runTorsio("record --duration 1 --json --database " + record, folder_);
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  const std::string trial = nlohmann::json::parse(recorded.out)["trial"];
  std::uint16_t port = 0;
  {
    const FakeTracker free;
    port = free.port();
  }
  auto sent = std::async(std::launch::async, [&] {
    return run("send " + trial + " --json --wait 20 --port " + std::to_string(port) + " --database " +
               record);
  });
  FakeTracker slicer;
  ASSERT_TRUE(slicer.call(port));
  const FakeTracker::Message first = slicer.receive();
  const ProgramRun done = sent.get();

  EXPECT_EQ(first.kind, "TRANSFORM");
  EXPECT_EQ(first.device, "TorsioInstrument");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_GE(nlohmann::json::parse(done.out)["sent"].get<int>(), 20);
  EXPECT_EQ(run("send nothing --database " + record).code, static_cast<int>(ErrorCode::kBadData));
}

}  // namespace
}  // namespace torsio
