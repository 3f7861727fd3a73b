// SPDX-License-Identifier: GPL-3.0-or-later
// Real time and a real thread: labelled soak. No upper bound on jitter is asserted, the machine decides it.
#include "sim/servo/servo_thread.h"

#include <atomic>
#include <chrono>
#include <cstdio>
#include <thread>

#include <gtest/gtest.h>

#include "sim/device/virtual/scripted_hand.h"
#include "sim/device/virtual/virtual_drivers.h"
#include "sim/record/recorder.h"
#include "sim/record/trial.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/sim/servo/recorded_trial.h"

namespace torsio {
namespace {

TEST(ServoThread, TicksAThousandTimesASecondAndLosesNoSample) {
  const Scene scene = barScene();
  IdleDevice device(Pose{{0.041, 0.0, 0.2}, {}});
  SpscRing<Sample> ring(kRecordingRing);
  LatestValue<LiveState> live;
  MemoryTrialSink sink;
  TrialHeader header;
  header.organHash = scene.organHash;
  header.parameterHash = scene.parameterHash;
  ServoLoop loop({.device = &device, .scene = &scene, .recording = &ring, .live = &live}, {});
  Recorder recorder(ring, sink, header);
  ServoThread thread(loop, 1000);
  recorder.start();

  thread.start();
  std::this_thread::sleep_for(std::chrono::milliseconds(1'500));
  thread.stop();
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, loop.lateTicks());

  // Every deadline of 1.5 s was either served or counted as skipped.
  EXPECT_GE(loop.ticks() + thread.skipped(), 1'500);
  EXPECT_GT(loop.ticks(), 500);
  EXPECT_EQ(result.summary.samples, loop.ticks());
  EXPECT_EQ(result.summary.refusedSamples, 0);
  EXPECT_EQ(thread.wakeUp().count, loop.ticks());
  EXPECT_EQ(thread.duration().count, loop.ticks());
  EXPECT_LT(thread.wakeUp().median_us, 500.0);
  EXPECT_LE(thread.skipped(), loop.lateTicks() + 1);
  EXPECT_EQ(live.latest().tick, loop.ticks() - 1);
  EXPECT_TRUE(replayTrial(scene, sink.trial()).identical());
}

TEST(ServoThread, StopsTwiceAndStartsAgain) {
  const Scene scene = barScene();
  IdleDevice device(Pose{{0.2, 0.0, 0.2}, {}});
  ServoLoop loop({.device = &device, .scene = &scene}, {});
  ServoThread thread(loop, 1000);
  for (int round = 0; round < 2; ++round) {
    const std::int64_t before = loop.ticks();
    thread.start();
    while (thread.duration().count == before) {
      std::this_thread::yield();
    }
    thread.stop();
    thread.stop();
    EXPECT_GT(loop.ticks(), before);
  }
}

/// A device that does something before every reading.
class BusyDevice : public HapticDevice {
 public:
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t) noexcept override {
    before(++reads_);
    return {};
  }
  void write(const ForceCommand&) noexcept override {}

 private:
  virtual void before(int read) noexcept = 0;

  DeviceCapabilities capabilities_;
  int reads_ = 0;
};

/// Takes far longer than a tick now and then.
class SlowDevice final : public BusyDevice {
  void before(int read) noexcept override {
    if (read % 20 == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }
};

TEST(ServoThread, SkipsMissedDeadlinesInsteadOfCatchingUpInABurst) {
  const Scene scene = barScene();
  SlowDevice device;
  SpscRing<Sample> ring(4'096);
  ServoLoop loop({.device = &device, .scene = &scene, .recording = &ring}, {});
  ServoThread thread(loop, 1000);

  thread.start();
  while (thread.duration().count < 200) {
    std::this_thread::yield();
  }
  thread.stop();

  // Ten milliseconds of sleep pass nine or more deadlines, ten times in two hundred ticks.
  EXPECT_GE(thread.skipped(), 9 * 9);
  EXPECT_GE(loop.lateTicks(), 9 * 9);
  // After each sleep at most one tick comes at once (the deadline that was just missed).
  Sample before;
  Sample sample;
  int bursts = 0;
  int ticks = 0;
  ASSERT_TRUE(ring.pop(before));
  std::int64_t lastGap_us = 0;
  while (ring.pop(sample)) {
    const std::int64_t gap_us = sample.device.time_us - before.device.time_us;
    bursts += gap_us < 100 && lastGap_us < 100 ? 1 : 0;
    lastGap_us = gap_us;
    before = sample;
    ++ticks;
  }
  EXPECT_LT(bursts, 5) << "of " << ticks;
}

/// Hangs in one read until it is told to let go of the hand.
class HangingDevice final : public BusyDevice {
 public:
  void dropForce() noexcept override { dropped.store(true); }
  std::atomic<bool> dropped{false};

 private:
  void before(int read) noexcept override {
    while (read == 50 && !dropped.load()) {
      std::this_thread::yield();
    }
  }
};

TEST(ServoThread, LetsGoOfTheHandWhenATickHangs) {
  const Scene scene = barScene();
  HangingDevice device;
  ServoLoop loop({.device = &device, .scene = &scene}, {});
  ServoThread thread(loop, 1000);

  thread.start();
  while (thread.duration().count < 60) {
    std::this_thread::yield();  // for ever without a watchdog
  }
  thread.stop();

  EXPECT_TRUE(device.dropped.load());
  EXPECT_GE(thread.stalls(), 1);
  // The first tick after the gap sends no force, whatever the tissue wants.
  EXPECT_GE(loop.lateTicks(), 20);
}

void print(const char* what, const TimingHistogram& histogram) {
  const TimingSummary all = histogram.summary();
  std::printf("%s: median %.0f, 99 %% %.0f, 99.9 %% %.0f, longest %.0f us\n", what, all.median_us, all.p99_us,
              all.p999_us, all.max_us);
  histogram.forEach([](double from_us, double to_us, std::int64_t count) {
    std::printf("  %10.1f .. %10.1f us %8lld\n", from_us, to_us, static_cast<long long>(count));
  });
}

TEST(ServoThread, LosesNoSampleInAMinuteOfRealTime) {
  const Scene scene = barScene();
  ScriptedHand hand({.seed = 3, .task = handTask(scene), .profile = handProfile(3), .duration_s = 60.0});
  SpscRing<Sample> ring(kRecordingRing);
  LatestValue<LiveState> live;
  MemoryTrialSink sink;
  const TrialHeader header = headerOf(scene, hand);
  ServoLoop loop({.device = &hand, .scene = &scene, .recording = &ring, .live = &live}, {});
  Recorder recorder(ring, sink, header);
  ServoThread thread(loop, 1000);
  recorder.start();

  thread.start();
  std::this_thread::sleep_for(std::chrono::seconds(60));
  thread.stop();
  const RecordingResult result = recorder.finish(TrialOutcome::kCompleted, loop.lateTicks());

  EXPECT_GE(loop.ticks() + thread.skipped(), 60'000);
  EXPECT_EQ(result.summary.samples, loop.ticks());
  EXPECT_EQ(result.summary.refusedSamples, 0);
  EXPECT_TRUE(replayTrial(scene, sink.trial()).identical());
  std::printf("real-time scheduling %s, memory %s, %lld ticks, %lld deadlines skipped\n",
              thread.realTime() ? "granted" : "refused", thread.memoryLocked() ? "locked" : "not locked",
              static_cast<long long>(loop.ticks()), static_cast<long long>(thread.skipped()));
  print("deadline to tick", thread.wakeUpHistogram());
  print("duration of a tick", thread.durationHistogram());
}

}  // namespace
}  // namespace torsio
