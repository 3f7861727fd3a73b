// SPDX-License-Identifier: GPL-3.0-or-later
// Forty minutes of the forearm on a manual clock: labelled soak, about a minute and a half of processor time.
#include <array>
#include <cstdint>
#include <cstdio>

#include <gtest/gtest.h>

#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/content_hash.h"
#include "sim/record/recorder.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/recorded_trial.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr std::int64_t kMinutes = 40;
constexpr std::int64_t kTicks = kMinutes * 60 * 1000;
// A trial replays from its first tick; so many seconds of it are tried.
constexpr std::size_t kReplayed_s = 120;
// What the recorder's description allows it to keep: 25 MB an hour.
constexpr std::size_t kMaxBytes = 25'000'000 * kMinutes / 60;

/// What came, and the first part of it.
class CountingSink final : public TrialSink {
 public:
  void begin(const TrialHeader& header) override { part_.header = header; }
  void append(const TrialChunk& chunk) override {
    inOrder_ = inOrder_ && chunk.index == chunks_ && chunk.firstTick == samples_;
    ++chunks_;
    samples_ += chunk.samples;
    bytes_ += chunk.bytes.size();
    if (part_.chunks.size() == kReplayed_s) {
      return;
    }
    part_.chunks.push_back(chunk);
    part_.summary.samples = samples_;
  }
  void finish(const TrialSummary&) override { part_.summary.contentHash = contentHash(part_); }

  [[nodiscard]] bool inOrder() const { return inOrder_; }
  [[nodiscard]] std::int64_t chunks() const { return chunks_; }
  [[nodiscard]] std::int64_t samples() const { return samples_; }
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  [[nodiscard]] const Trial& part() const { return part_; }

 private:
  bool inOrder_ = true;
  std::int64_t chunks_ = 0;
  std::int64_t samples_ = 0;
  std::size_t bytes_ = 0;
  Trial part_;
};

TEST(ServoLoop, LosesNoSampleInFortyMinutesOnAManualClock) {
  const Scene scene = testing::shippedScene("forearm");
  ScriptedHand hand({.seed = 5,
                     .task = handTask(scene),
                     .profile = handProfile(5),
                     .duration_s = 60.0 * static_cast<double>(kMinutes)});
  SpscRing<Sample> ring(kRecordingRing);
  SpscRing<ExerciseMoment> events(64);
  LatestValue<LiveState> live;
  CountingSink sink;
  const TrialHeader header = headerOf(scene, hand);
  ServoLoop loop({.device = &hand, .scene = &scene, .recording = &ring, .live = &live, .events = &events},
                 {});
  Recorder recorder(ring, sink, header);
  std::array<std::int64_t, 4> ticksIn{};
  std::int64_t grips = 0;
  std::int64_t slips = 0;

  for (std::int64_t i = 0; i < kTicks; ++i) {
    loop.tick(1000 * i);
    ++ticksIn[static_cast<std::size_t>(loop.lastSample().phase)];
    if (i % 1000 != 999) {
      continue;
    }
    recorder.pump();
    ASSERT_EQ(recorder.samples(), i + 1);  // nothing waits in the ring
    for (ExerciseMoment moment; events.pop(moment);) {
      grips += (moment.events & kEventGripped) != 0 ? 1 : 0;
      slips += (moment.events & kEventSlipped) != 0 ? 1 : 0;
    }
  }
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, loop.lateTicks());

  EXPECT_EQ(result.summary.samples, kTicks);
  EXPECT_EQ(result.summary.refusedSamples, 0);
  EXPECT_EQ(result.summary.lateTicks, 0);
  EXPECT_EQ(events.refused(), 0U);
  EXPECT_TRUE(sink.inOrder());
  EXPECT_EQ(sink.chunks(), kTicks / 1000);
  EXPECT_EQ(sink.samples(), kTicks);
  EXPECT_LE(sink.bytes(), kMaxBytes);
  EXPECT_GT(grips, kMinutes);
  const ReplayReport replay = replayTrial(scene, sink.part());
  EXPECT_EQ(replay.samples, static_cast<std::int64_t>(1000 * kReplayed_s));
  EXPECT_TRUE(replay.identical());
  std::printf(
      "%lld ticks: %lld tracking, %lld contact, %lld twisting, %lld released; %lld grips, %lld slips; "
      "%.1f MB\n",
      static_cast<long long>(loop.ticks()), static_cast<long long>(ticksIn[0]),
      static_cast<long long>(ticksIn[1]), static_cast<long long>(ticksIn[2]),
      static_cast<long long>(ticksIn[3]), static_cast<long long>(grips), static_cast<long long>(slips),
      1e-6 * static_cast<double>(sink.bytes()));
}

}  // namespace
}  // namespace torsio
