// SPDX-License-Identifier: GPL-3.0-or-later
// The logic on a manual clock; its thread is tested with real threads (servo_thread_test.cpp).
#include <gtest/gtest.h>

#include "sim/servo/servo_thread.h"

namespace torsio {
namespace {

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
