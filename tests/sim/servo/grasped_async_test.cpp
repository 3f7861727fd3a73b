// SPDX-License-Identifier: GPL-3.0-or-later
// What is felt of an asynchronous model.
#include <limits>

#include <gtest/gtest.h>

#include "sim/core/async_model.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/grasped_bar.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr AsyncAnswer kAnswer{AsyncState::kSound, 0.5, 0.2, 0.4};

/// A bar that an asynchronous model answers, gripped.
class GraspedAsyncTest : public ::testing::Test {
 protected:
  GraspedAsyncTest() { grip(); }

  void grip() {
    const Vec3 held_m{kBarRadius_m, 0.0, 0.2};
    const auto axis = tissue.grip(held_m, 0.2, {}, organ);
    ASSERT_TRUE(axis);
    motion.close(*axis, {.pose = {held_m, {}}}, 0.0);
  }
  [[nodiscard]] GripFeel feelAt(double angle_rad, double arm_m = 0.05) {
    organ.twist.graspAngle_rad = angle_rad;
    const AxisFrame& axis = motion.axis();
    return tissue.feel(axis.centre_m + axis.e1 * arm_m, motion, organ);
  }

  GraspedAsync tissue{scene(), kTickPeriod_us};
  JawMotion motion{TwistDrive::kTangential};
  OrganState organ;

 private:
  static const Scene& scene() {
    static const Scene kScene = barScene();
    return kScene;
  }
};

TEST_F(GraspedAsyncTest, ContinuesTheTorqueAlongItsSlopeAndNoFurtherThanItReaches) {
  tissue.takeAnswer(kAnswer);

  EXPECT_DOUBLE_EQ(feelAt(0.5).torque_Nm, 0.2);
  EXPECT_DOUBLE_EQ(feelAt(0.6).torque_Nm, 0.2 + 0.4 * (0.6 - 0.5));
  EXPECT_DOUBLE_EQ(feelAt(3.0).torque_Nm, 0.2 + 0.4 * kAsyncReach_rad);
  EXPECT_DOUBLE_EQ(feelAt(-3.0).torque_Nm, 0.2 - 0.4 * kAsyncReach_rad);
}

TEST_F(GraspedAsyncTest, PushesAgainstTheTurnWithTheTorqueOverTheArm) {
  tissue.takeAnswer(kAnswer);

  // An arm of 50 mm, further than sqrt(0.4 / 500) = 28 mm: 0.2 N m / 0.05 m = 4 N against e2.
  const Vec3 force_N = feelAt(0.5).force_N;

  EXPECT_NEAR(dot(force_N, motion.axis().e2), -4.0, 1e-9);
  EXPECT_NEAR(norm(force_N), 4.0, 1e-9);
}

TEST_F(GraspedAsyncTest, FeelsNothingBeforeTheFirstAnswerToItsGrip) {
  EXPECT_EQ(feelAt(1.0).torque_Nm, 0.0);
  tissue.takeAnswer(kAnswer);

  grip();

  EXPECT_EQ(feelAt(0.5).torque_Nm, 0.0);
  EXPECT_FALSE(feelAt(0.5).late);
}

TEST_F(GraspedAsyncTest, IsLateWhenTheModelIsSilentTooLongAndTrustsItsNextAnswer) {
  tissue.takeAnswer(kAnswer);
  for (std::int64_t us = 0; us < kAsyncLate_us; us += kTickPeriod_us) {
    tissue.takeAnswer({});
  }
  EXPECT_FALSE(feelAt(0.5).late);

  tissue.takeAnswer({});

  EXPECT_TRUE(feelAt(0.5).late);
  EXPECT_EQ(feelAt(0.5).torque_Nm, 0.0);
  tissue.takeAnswer(kAnswer);
  EXPECT_FALSE(feelAt(0.5).late);
  EXPECT_DOUBLE_EQ(feelAt(0.5).torque_Nm, 0.2);
}

TEST_F(GraspedAsyncTest, IsLateWhenTheModelIsBroken) {
  tissue.takeAnswer({.state = AsyncState::kBroken});

  EXPECT_TRUE(feelAt(0.5).late);
  EXPECT_EQ(feelAt(0.5).torque_Nm, 0.0);
}

/// A loop whose organ a model beside it answers; the test says what that model delivers.
class LoopWithAsyncModel : public ::testing::Test {
 protected:
  LoopWithAsyncModel()
      : scene_([] {
          Scene scene = barScene();
          scene.tissue = TissueModel::kFiniteElements;
          return scene;
        }()),
        hand_([this] {
          ScriptedHandOptions options;
          options.task = handTask(scene_);
          return options;
        }()),
        loop_({.device = &hand_, .scene = &scene_, .async = &link_}, {}) {}

  void tick() {
    loop_.tick(time_us_);
    time_us_ += kTickPeriod_us;
  }
  void tickUntilHeld() {
    while (loop_.lastSample().phase != ExercisePhase::kTwisting) {
      ASSERT_LT(time_us_, 20'000'000);
      tick();
    }
  }
  void deliver(double torque_Nm) {
    const AsyncQuestion& asked = link_.questions.latest();
    link_.deliveries.publish({++number_, asked.grip, {AsyncState::kSound, asked.angle_rad, torque_Nm, 0.1}});
  }
  /// Runs the time of a doubt; a sound model would have spoken.
  void tickWithout(std::int64_t span_us) {
    for (std::int64_t us = 0; us < span_us; us += kTickPeriod_us) {
      tick();
    }
  }

  Scene scene_;
  AsyncLink link_;
  ScriptedHand hand_;
  ServoLoop loop_;
  std::int64_t time_us_ = 0;
  std::int64_t number_ = 0;
};

TEST_F(LoopWithAsyncModel, RecordsAnAnswerWithTheTickOfItsArrival) {
  tickUntilHeld();
  tick();
  deliver(0.05);

  tick();

  EXPECT_EQ(loop_.lastSample().async.state, AsyncState::kSound);
  EXPECT_EQ(loop_.lastSample().async.torque_Nm, 0.05);
  EXPECT_NE(loop_.lastSample().response.torque_Nm, 0.0);
  tick();
  EXPECT_EQ(loop_.lastSample().async.state, AsyncState::kNothing);
}

TEST_F(LoopWithAsyncModel, DropsTheGripForceWhenTheModelHangs) {
  tickUntilHeld();
  deliver(0.05);
  tick();
  ASSERT_NE(loop_.lastSample().response.torque_Nm, 0.0);
  EXPECT_EQ(loop_.lastSample().limits & kForceModelLate, 0U);

  tickWithout(kAsyncLate_us + 2 * kTickPeriod_us);

  ASSERT_EQ(loop_.lastSample().phase, ExercisePhase::kTwisting);
  EXPECT_NE(loop_.lastSample().limits & kForceModelLate, 0U);
  EXPECT_EQ(loop_.lastSample().response.torque_Nm, 0.0);
  EXPECT_EQ(norm(loop_.lastSample().response.force_N), 0.0);
}

TEST_F(LoopWithAsyncModel, DropsTheGripForceWhenTheModelAnswersNaN) {
  tickUntilHeld();
  deliver(0.05);
  tick();

  deliver(std::numeric_limits<double>::quiet_NaN());
  tick();

  EXPECT_EQ(loop_.lastSample().async, (AsyncAnswer{.state = AsyncState::kBroken}));
  EXPECT_NE(loop_.lastSample().limits & kForceModelLate, 0U);
  EXPECT_EQ(norm(loop_.lastSample().response.force_N), 0.0);
}

TEST_F(LoopWithAsyncModel, IgnoresAnswersToAnotherGrip) {
  tickUntilHeld();
  link_.deliveries.publish({++number_, 7, {AsyncState::kSound, 0.0, 1.0, 1.0}});

  tick();

  EXPECT_EQ(loop_.lastSample().async.state, AsyncState::kNothing);
  EXPECT_EQ(loop_.lastSample().response.torque_Nm, 0.0);
}

}  // namespace
}  // namespace torsio
