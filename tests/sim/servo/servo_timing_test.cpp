// SPDX-License-Identifier: GPL-3.0-or-later
// The histogram of a thread's times, and the logic of its watchdog on a manual clock; its thread is tested
// with real threads (servo_thread_test.cpp).
#include <gtest/gtest.h>

#include "sim/servo/servo_thread.h"
#include "sim/servo/timing_histogram.h"

namespace torsio {
namespace {

TEST(TimingHistogram, SaysNothingBeforeTheFirstValue) {
  const TimingHistogram histogram;

  EXPECT_EQ(histogram.summary().count, 0);
  EXPECT_EQ(histogram.summary().median_us, 0.0);
  EXPECT_EQ(histogram.summary().max_us, 0.0);
}

TEST(TimingHistogram, BoundsEachQuantileFromAboveByAQuarter) {
  TimingHistogram histogram;
  for (int i = 1; i <= 10'000; ++i) {
    histogram.add_ns(i * 1000);  // 1 us .. 10 ms, evenly
  }

  const TimingSummary summary = histogram.summary();

  EXPECT_EQ(summary.count, 10'000);
  EXPECT_EQ(summary.max_us, 10'000.0);
  EXPECT_GE(summary.median_us, 5'000.0);
  EXPECT_LE(summary.median_us, 5'000.0 * 1.25);
  EXPECT_GE(summary.p99_us, 9'900.0);
  EXPECT_LE(summary.p99_us, 10'000.0);
  EXPECT_GE(summary.p999_us, summary.p99_us);
}

TEST(TimingHistogram, KeepsRareOutliersInItsMaximum) {
  TimingHistogram histogram;
  for (int i = 0; i < 9'999; ++i) {
    histogram.add_ns(20'000);
  }
  histogram.add_ns(24'500'000);

  EXPECT_LE(histogram.summary().p999_us, 25.0);
  EXPECT_EQ(histogram.summary().max_us, 24'500.0);
}

TEST(TimingHistogram, TakesValuesBelowAndAboveItsRange) {
  TimingHistogram histogram;
  histogram.add_ns(-5);
  histogram.add_ns(0);
  histogram.add_ns(3'600'000'000'000);

  EXPECT_EQ(histogram.summary().count, 3);
  EXPECT_EQ(histogram.summary().max_us, 3.6e9);
  EXPECT_LE(histogram.summary().median_us, 0.256);
}

constexpr std::int64_t kMillisecond_ns = 1'000'000;

TEST(ServoWatchdog, LetsGoOnceForEachStall) {
  int dropped = 0;
  ServoWatchdog dog([&dropped] { ++dropped; });
  dog.beat(0);

  for (int ms = 0; ms < 25; ++ms) {
    dog.check(ms * kMillisecond_ns);
  }
  EXPECT_EQ(dropped, 0);
  for (int ms = 25; ms < 200; ++ms) {
    dog.check(ms * kMillisecond_ns);
  }
  EXPECT_EQ(dropped, 1);
  dog.beat(200 * kMillisecond_ns);
  dog.check(224 * kMillisecond_ns);
  EXPECT_EQ(dropped, 1);
  dog.check(225 * kMillisecond_ns);

  EXPECT_EQ(dropped, 2);
  EXPECT_EQ(dog.stalls(), 2);
}

TEST(ServoWatchdog, WatchesNothingBeforeTheFirstTickAndNeverBitesALivelyOne) {
  int dropped = 0;
  ServoWatchdog dog([&dropped] { ++dropped; });
  for (int ms = 0; ms < 100; ++ms) {
    dog.check(ms * kMillisecond_ns);
  }
  for (int ms = 100; ms < 10'000; ++ms) {
    dog.beat(ms * kMillisecond_ns);
    dog.check(ms * kMillisecond_ns + 999'999);
  }
  EXPECT_EQ(dropped, 0);
}

}  // namespace
}  // namespace torsio
