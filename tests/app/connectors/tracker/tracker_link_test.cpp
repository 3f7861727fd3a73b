// SPDX-License-Identifier: GPL-3.0-or-later
// Simulated trackers based on the library's own classes, valid and misbehaving ones.
#include "app/connectors/tracker/tracker_link.h"

#include <chrono>
#include <cmath>
#include <functional>
#include <thread>

#include <QTcpServer>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/connectors/tracker/tracked_recording.h"
#include "app/connectors/tracker/tracker_clock.h"
#include "assessment/attempt/foreign_measures.h"
#include "sim/core/clock.h"
#include "sim/core/foreign_recording.h"
#include "sim/record/sample_codec.h"
#include "sim/record/trial.h"
#include "tests/support/fake_tracker.h"

namespace torsio {
namespace {

using testing::FakeTracker;

constexpr const char* kStylus = "StylusToReference";
constexpr std::chrono::milliseconds kStep{10};

bool becomes(const std::function<bool()>& done) {
  for (int tries = 0; tries < 2'000 && !done(); ++tries) {
    std::this_thread::sleep_for(kStep);
  }
  return done();
}

TrackerPlace placeOf(const FakeTracker& tracker) {
  return {.port = tracker.port()};
}

/// A tracker of 100 Hz with regular timing: the instrument moves on a circle of 20 mm, twice per second.
class Circle {
 public:
  explicit Circle(FakeTracker& tracker) : tracker_(tracker) {}

  /// Returns the number of the next pose due after now.
  [[nodiscard]] int next() const { return static_cast<int>((clock_.now_us() - began_us_) / kEvery_us) + 2; }
  void send(int from, int count) {
    for (int i = from; i < from + count; ++i) {
      const std::int64_t wait_us = began_us_ + i * kEvery_us - clock_.now_us();
      std::this_thread::sleep_for(std::chrono::microseconds(wait_us));
      const double angle = 4.0 * M_PI * i / 100.0;
      ASSERT_TRUE(tracker_.sendTransform(kStylus, {20.0 * std::cos(angle), 20.0 * std::sin(angle), 5.0},
                                         sent_us_ + i * kEvery_us));
    }
  }

 private:
  static constexpr std::int64_t kEvery_us = 10'000;
  FakeTracker& tracker_;
  MonotonicClock clock_;
  std::int64_t began_us_ = clock_.now_us();
  std::int64_t sent_us_ = utcNow_us() + 3'600'000'000;  // its clock is an hour ahead
};

TEST(TrackerLink, ConnectsToATrackerAndReportsThePoseOfTheInstrument) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());

  ASSERT_TRUE(tracker.sendStatus(13, "warming up"));
  ASSERT_TRUE(becomes([&] { return link.view().trouble.str() == "the tracker says: warming up"; }));
  ASSERT_TRUE(tracker.sendStatus(1, ""));
  ASSERT_TRUE(tracker.sendTransform(kStylus, {1.0, 2.0, 3.0}, 0));
  ASSERT_TRUE(tracker.sendTransform("ProbeToReference", {9.0, 9.0, 9.0}, 0));

  ASSERT_TRUE(becomes([&] { return link.view().instruments.size() == 2; }));
  const TrackerView view = link.view();
  EXPECT_EQ(view.stage, TrackerStage::kTracking);
  EXPECT_EQ(view.instrument, kStylus);  // the first one received
  EXPECT_NEAR(view.pose.position_m.y, 0.002, 1e-9);
  EXPECT_EQ(view.counts.received, 1);
  EXPECT_TRUE(view.trouble.empty());
}

TEST(TrackerLink, RequestsTrackingDataIfNothingArrives) {
  FakeTracker tracker;
  const TrackerLink link({.port = tracker.port(), .instrument = "Channel 0"});
  ASSERT_TRUE(tracker.wait());

  EXPECT_EQ(tracker.receive().kind, "STT_TDATA");
  ASSERT_TRUE(tracker.sendTracking("Channel 0", {4.0, 0.0, 0.0}, 0));
  EXPECT_TRUE(becomes([&] { return link.view().stage == TrackerStage::kTracking; }));
}

TEST(TrackerLink, ReconnectsWhenTheTrackerDisconnectsOrSendsGarbage) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());
  tracker.hangUp();
  ASSERT_TRUE(becomes([&] { return link.view().trouble.str() == "the tracker ended the connection"; }));

  ASSERT_TRUE(tracker.wait());
  ASSERT_TRUE(tracker.sendBytes(std::string(200, '\xff')));
  ASSERT_TRUE(becomes([&] { return link.view().trouble.str() == "the data received are not OpenIGTLink"; }));
  EXPECT_EQ(link.view().stage, TrackerStage::kSeeking);

  ASSERT_TRUE(tracker.wait());
  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 0));
  EXPECT_TRUE(becomes([&] { return link.view().stage == TrackerStage::kTracking; }));
}

TEST(TrackerLink, CountsUnusablePoses) {
  FakeTracker tracker;
  const TrackerLink link(placeOf(tracker));
  ASSERT_TRUE(tracker.wait());

  ASSERT_TRUE(tracker.sendTransformWith(kStylus, std::nanf(""), 0));
  ASSERT_TRUE(tracker.sendTransformWith(kStylus, 0.3F, 0));
  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 5'000'000));
  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 5'000'000));  // a repeated time

  ASSERT_TRUE(becomes([&] { return link.view().counts.refused == 3; }));
  EXPECT_EQ(link.view().counts.received, 1);
}

TEST(TrackerLink, WaitsForATrackerThatConnects) {
  QTcpServer free;
  ASSERT_TRUE(free.listen(QHostAddress::LocalHost, 0));
  const std::uint16_t port = free.serverPort();
  free.close();
  const TrackerLink link({.port = port, .listens = true});
  FakeTracker tracker;
  ASSERT_TRUE(tracker.call(port));

  ASSERT_TRUE(tracker.sendTransform(kStylus, {}, 0));

  EXPECT_TRUE(becomes([&] { return link.view().stage == TrackerStage::kTracking; }));
  const TrackerLink second({.port = port, .listens = true});
  EXPECT_TRUE(becomes([&] { return !second.view().trouble.empty(); }));
  const TrackerLink elsewhere({.address = "no address", .port = port, .listens = true});
  EXPECT_TRUE(becomes([&] { return !elsewhere.view().trouble.empty(); }));
}

TEST(TrackerLink, NeverBlocksTheCaller) {
  FakeTracker hangs;  // its system accepts the connection, but nobody answers
  const MonotonicClock clock;
  const std::int64_t before_us = clock.now_us();
  for (int i = 0; i < 5; ++i) {
    const TrackerLink toWhoHangs(placeOf(hangs));
    const TrackerLink toNobody({.address = "192.0.2.1"});  // TEST-NET-1: nobody answers
    static_cast<void>(toNobody.view());
    static_cast<void>(toWhoHangs.view());
  }
  EXPECT_LT(clock.now_us() - before_us, 30'000'000);  // ten destructors of half a second, and a busy machine
}

TEST(TrackedRecording, IsMeasuredLikeAnyPathOnTheClockOfTheStation) {
  FakeTracker tracker;
  TrackerLink link({.port = tracker.port(), .instrument = kStylus});
  ASSERT_TRUE(tracker.wait());
  Circle circle(tracker);
  circle.send(0, 25);
  ASSERT_TRUE(becomes([&] { return link.view().counts.received == 25; }));  // none is in transit
  ASSERT_TRUE(link.view().period_us.has_value());

  auto sink = std::make_unique<MemoryTrialSink>();
  const MemoryTrialSink& kept = *sink;
  TrackedRecording recording(
      link, link.view(), {.trialId = "tracked", .phaseLabel = "real", .startedUtc_us = 7}, std::move(sink));
  const int first = circle.next();
  circle.send(first, 40);
  circle.send(first + 41, 60);  // one is missing
  ASSERT_TRUE(becomes([&] { return link.view().counts.received == 125; }));
  const RecordingResult result = recording.finish(TrialOutcome::kCompleted);

  const Trial& trial = kept.trial();
  EXPECT_TRUE(isForeign(trial.header.sceneId));
  EXPECT_EQ(trial.header.tickPeriod_us, 10'000);
  EXPECT_EQ(trial.header.startedUtc_us, 7);
  EXPECT_EQ(trial.summary.lateTicks, result.summary.lateTicks);
  EXPECT_EQ(trial.summary.refusedSamples, 0);
  const std::vector<Sample> samples = decodeTrial(trial);
  ASSERT_EQ(samples.size(), 100U);
  const Outcome<TrialMetrics> measured = measureForeign(trial.header, samples);
  ASSERT_TRUE(measured);
  EXPECT_EQ(measured->lostSamples, 1U);
  const double span_s =
      static_cast<double>(samples.back().device.time_us - samples.front().device.time_us) * 1e-6;
  EXPECT_NEAR(*measured->at(Quantity::kTime), span_s, 1e-9);
  EXPECT_NEAR(span_s, 1.0, 0.2);
  const double path_m = 0.020 * 4.0 * M_PI * span_s;
  EXPECT_NEAR(*measured->at(Quantity::kTipPath), path_m, 0.1 * path_m);
  EXPECT_EQ(measured->at(Quantity::kSparc).reason(), "not applicable: foreign recording");
  EXPECT_EQ(measured->at(Quantity::kPeakForce).reason(), "not applicable: foreign recording");
}

constexpr std::int64_t kAhead_us = 3'600'000'000;  // offset of the sender's clock

/// Feeds poses at 50 Hz with a latency of 2 ms.
std::int64_t feed(TrackerClock& clock, std::int64_t from_us, int count) {
  std::int64_t now_us = from_us;
  for (int i = 0; i < count; ++i, now_us += 20'000) {
    EXPECT_TRUE(clock.take(now_us + kAhead_us, now_us + 2'000));
  }
  return now_us;
}

TEST(TrackerClock, ConvertsTimesOfTheSenderToTheClockOfTheStation) {
  TrackerClock clock;
  std::int64_t now_us = feed(clock, 0, 30);
  const auto moment = clock.take(now_us + kAhead_us, now_us + 9'000);  // 7 ms later than the others
  ASSERT_TRUE(moment);
  EXPECT_NEAR(static_cast<double>(moment->time_us), static_cast<double>(now_us + 2'000), 100.0);
  EXPECT_FALSE(moment->late);
  EXPECT_EQ(moment->place, 30);
  EXPECT_EQ(clock.period_us(), 20'000);
  EXPECT_TRUE(clock.stamped());
}

TEST(TrackerClock, CountsLateAndMissingPoses) {
  TrackerClock clock;
  const std::int64_t now_us = feed(clock, 0, 30);
  const auto late = clock.take(now_us + 60'000 + kAhead_us, now_us + 60'000 + 53'000);
  ASSERT_TRUE(late);
  EXPECT_TRUE(late->late);
  EXPECT_EQ(late->place, 33);                                               // 30, 31 and 32 are missing
  EXPECT_FALSE(clock.take(now_us + 60'000 + kAhead_us, now_us + 120'000));  // a repeated pose
}

TEST(TrackerClock, FollowsAClockThatDriftsOrIsSet) {
  TrackerClock clock;
  std::int64_t now_us = feed(clock, 0, 30);
  for (int i = 0; i < 50 * 600; ++i, now_us += 20'000) {  // ten minutes, drifting by 50 us per second
    const std::int64_t sent_us = now_us - now_us / 20'000 + kAhead_us;
    const auto moment = clock.take(sent_us, now_us + 2'000);
    ASSERT_TRUE(moment);
    EXPECT_FALSE(moment->late);
    EXPECT_NEAR(static_cast<double>(moment->time_us), static_cast<double>(now_us + 2'000), 3'000.0);
  }
  const auto back = clock.take(now_us, now_us + 2'000);  // by an hour
  ASSERT_TRUE(back);
  const auto forth = clock.take(now_us + 20'000 + 2 * kAhead_us, now_us + 22'000);
  ASSERT_TRUE(forth);
  EXPECT_EQ(forth->place - back->place, 1);  // none missing
  EXPECT_FALSE(forth->late);
}

TEST(TrackerClock, UsesTheArrivalIfTheSenderGivesNoTime) {
  TrackerClock clock;
  std::int64_t now_us = 1'000;
  for (int i = 0; i < 30; ++i, now_us += 10'000) {
    EXPECT_EQ(clock.take({}, now_us)->time_us, now_us);
  }
  const auto late = clock.take({}, now_us + 80'000);
  EXPECT_TRUE(late->late);
  EXPECT_EQ(late->place, 30);  // missing poses are unknown
  EXPECT_FALSE(clock.stamped());
  EXPECT_EQ(clock.period_us(), 10'000);
  EXPECT_EQ(clock.take({}, now_us + 80'000)->time_us, late->time_us + 1);  // two at the same time: times
                                                                           // still increase
}

}  // namespace
}  // namespace torsio
