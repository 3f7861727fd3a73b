// SPDX-License-Identifier: GPL-3.0-or-later
// A tick takes no memory and no lock in any phase of an exercise, with every link joined.
#include <mutex>
#include <set>

#include <gtest/gtest.h>

#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/hollow_bar.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"

namespace torsio {
namespace {

TEST(TickCost, TakesNoMemoryAndNoLockThroughAWholeExercise) {
  const Scene scene = barScene();
  ScriptedHand hand({.seed = 3, .task = handTask(scene), .profile = handProfile(3), .duration_s = 10.0});
  SpscRing<Sample> ring(20'000);
  SpscRing<ServoCommand> wishes(4);
  SpscRing<ExerciseMoment> events(64);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand,
                  .scene = &scene,
                  .recording = &ring,
                  .live = &live,
                  .commands = &wishes,
                  .events = &events},
                 {});
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kSetTarget, 1.0}));
  std::set<ExercisePhase> phases;

  std::int64_t taken = 0;
  std::int64_t locked = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t allocations = testing::allocationCount();
    const std::int64_t locks = testing::lockCount();
    loop.tick(1000LL * i);
    taken += testing::allocationCount() - allocations;
    locked += testing::lockCount() - locks;
    phases.insert(loop.lastSample().phase);
  }

  EXPECT_EQ(taken, 0);
  EXPECT_EQ(locked, 0);
  EXPECT_EQ(phases.size(), 4U);
}

TEST(TickCost, TakesNoMemoryAndNoLockWhileAnOrganIsUndone) {
  const Scene scene = hollowScene(twistedTube());
  ScriptedHandOptions options{
      .seed = 3, .task = handTask(scene), .profile = {.initialSkill = 0.9, .finalSkill = 0.9}};
  options.duration_s = undone_s(*scene.hollow, ScriptedHand(options));
  ScriptedHand hand(options);
  SpscRing<Sample> ring(100'000);
  SpscRing<ServoCommand> wishes(4);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand, .scene = &scene, .recording = &ring, .live = &live, .commands = &wishes},
                 {});
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kVent, 1.0}));
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kCheckFlow, 3.0}));
  std::set<ExercisePhase> phases;

  const std::int64_t allocations = testing::allocationCount();
  const std::int64_t locks = testing::lockCount();
  for (int i = 0; i < static_cast<int>(options.duration_s * 1000.0); ++i) {
    loop.tick(1000LL * i);
    phases.insert(loop.lastSample().phase);
  }
  const std::int64_t ofTheSet = static_cast<std::int64_t>(phases.size());

  EXPECT_EQ(testing::allocationCount() - allocations, ofTheSet);  // a node for each phase
  EXPECT_EQ(testing::lockCount() - locks, 0);
  EXPECT_EQ(phases.size(), 4U);
}

TEST(TickCost, DetectsALock) {
  if (!testing::lockCountWorks()) {
    GTEST_SKIP() << "locks are not counted here";
  }
  std::mutex mutex;
  const std::int64_t before = testing::lockCount();
  { const std::lock_guard<std::mutex> guard(mutex); }
  EXPECT_EQ(testing::lockCount() - before, 1);
}

TEST(TickCost, ReportsEveryEventWithItsTime) {
  const Scene scene = barScene();
  ScriptedHand hand({.seed = 3, .task = handTask(scene), .profile = handProfile(3), .duration_s = 10.0});
  SpscRing<ExerciseMoment> events(64);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand, .scene = &scene, .live = &live, .events = &events}, {});
  for (int i = 0; i < 10'000; ++i) {
    loop.tick(1000LL * i);
  }

  std::uint32_t seen = kEventNone;
  std::int64_t touched_us = -1;
  std::int64_t gripped_us = -1;
  std::int64_t released_us = -1;
  std::int64_t last_us = 0;
  ExerciseMoment moment;
  while (events.pop(moment)) {
    EXPECT_GE(moment.time_us, last_us);
    EXPECT_EQ(moment.time_us, 1000 * moment.tick);
    last_us = moment.time_us;
    seen |= moment.events;
    if ((moment.events & kEventTouched) != 0) {
      touched_us = moment.time_us;
    }
    if ((moment.events & kEventGripped) != 0) {
      gripped_us = moment.time_us;
    }
    if ((moment.events & kEventReleased) != 0) {
      released_us = moment.time_us;
    }
  }

  EXPECT_EQ(seen & (kEventTouched | kEventGripped | kEventReleased),
            kEventTouched | kEventGripped | kEventReleased);
  EXPECT_LT(gripped_us, released_us);
  const ExerciseTimes& times = live.latest().times;
  EXPECT_EQ(times.touched_us, touched_us);
  EXPECT_EQ(times.gripped_us, gripped_us);
  EXPECT_EQ(times.released_us, released_us);
  EXPECT_EQ(times.slipped_us, -1);
  EXPECT_EQ(times, loop.times());
}

}  // namespace
}  // namespace torsio
