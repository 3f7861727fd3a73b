// SPDX-License-Identifier: GPL-3.0-or-later
// A scheduler that calls a function, as a vendor's does, on a clock that the test turns.
#include "sim/servo/servo_callback.h"

#include <vector>

#include <gtest/gtest.h>

#include "sim/device/virtual/idle_device.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

std::int64_t manualNow_ns = 0;
std::int64_t manualClock() noexcept {
  return manualNow_ns;
}

/// What the vendor's scheduler does with a function and a pointer.
struct Scheduler {
  bool (*function)(void*) = nullptr;
  void* data = nullptr;
  int calls = 0;
  bool call(std::int64_t now_ns) {
    manualNow_ns = now_ns;
    ++calls;
    return function(data);
  }
};

class ServoCallbackTest : public ::testing::Test {
 protected:
  ServoCallbackTest() { manualNow_ns = 5'000'000'000; }

  std::vector<std::int64_t> times_us() {
    std::vector<std::int64_t> times;
    Sample sample;
    while (ring.pop(sample)) times.push_back(sample.device.time_us);
    return times;
  }

  Scene scene = barScene(testing::prism(testing::circleOutline(kBarRadius_m, 24), kBarLength_m, 12));
  IdleDevice device{Pose{{0.2, 0.0, 0.2}, {}}};
  SpscRing<Sample> ring{4'096};
  ServoLoop loop{{.device = &device, .scene = &scene, .recording = &ring}, {}};
  ServoCallback callback{loop, &manualClock};
  Scheduler scheduler{&ServoCallback::invoke, &callback};
};

TEST_F(ServoCallbackTest, TicksOnceACallFromTimeZeroOn) {
  for (int i = 0; i < 100; ++i)
    EXPECT_TRUE(scheduler.call(5'000'000'000 + i * 1'000'000LL + (i * 37) % 1000));

  const std::vector<std::int64_t> times = times_us();
  ASSERT_EQ(times.size(), 100U);
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times.back(), 99'000);
  EXPECT_EQ(loop.lateTicks(), 0);
  EXPECT_EQ(callback.duration().summary().count, 100);
}

TEST_F(ServoCallbackTest, LeavesOutCallsOfAFasterScheduler) {
  for (int i = 0; i < 400; ++i) (void)scheduler.call(5'000'000'000 + i * 250'000LL);

  const auto ticks = static_cast<double>(times_us().size());
  EXPECT_NEAR(ticks, 100.0, 1.0);
  EXPECT_NEAR(static_cast<double>(callback.early()), 300.0, 1.0);
}

TEST_F(ServoCallbackTest, CountsLateCallsAndNeverCatchesUp) {
  for (int i = 0; i < 10; ++i) (void)scheduler.call(5'000'000'000 + i * 1'000'000LL);
  // The scheduler sleeps for 20 ms and then calls 50 times within 5 ms.
  for (int i = 0; i < 50; ++i) (void)scheduler.call(5'029'000'000 + i * 100'000LL);

  const std::vector<std::int64_t> times = times_us();
  EXPECT_EQ(loop.lateTicks(), 19);
  // After the gap one tick at once, then one a period: 29.0, 29.5 or later ... 33.9 ms.
  ASSERT_GE(times.size(), 14U);
  EXPECT_LE(times.size(), 16U);
  for (std::size_t i = 11; i < times.size(); ++i) EXPECT_GE(times[i] - times[i - 1], 500);
}

TEST_F(ServoCallbackTest, TellsTheSchedulerWhenItIsDone) {
  EXPECT_TRUE(scheduler.call(5'000'000'000));
  callback.stop();
  EXPECT_FALSE(scheduler.call(5'001'000'000));
  EXPECT_EQ(loop.ticks(), 1);
}

}  // namespace
}  // namespace torsio
