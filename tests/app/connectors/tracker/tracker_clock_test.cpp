// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/tracker_clock.h"

#include <gtest/gtest.h>

namespace torsio {
namespace {

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
