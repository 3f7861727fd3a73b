// SPDX-License-Identifier: GPL-3.0-or-later
// What is felt of a model that runs beside the servo.
#include "sim/servo/async_tissue.h"

#include <limits>

#include <gtest/gtest.h>

#include "sim/core/beside_link.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr std::int64_t kTick_us = 1000;
constexpr BesideAnswer kAnswer{BesideState::kSound, 0.5, 0.2, 0.4};

TEST(AsyncTissue, ContinuesTheTorqueAlongItsSlopeAndNoFurtherThanItReaches) {
  AsyncTissue tissue;
  tissue.grip();
  tissue.hear(kAnswer, kTick_us);

  EXPECT_DOUBLE_EQ(tissue.torque_Nm(0.5), 0.2);
  EXPECT_DOUBLE_EQ(tissue.torque_Nm(0.6), 0.2 + 0.4 * (0.6 - 0.5));
  EXPECT_DOUBLE_EQ(tissue.torque_Nm(3.0), 0.2 + 0.4 * kBesideReach_rad);
  EXPECT_DOUBLE_EQ(tissue.torque_Nm(-3.0), 0.2 - 0.4 * kBesideReach_rad);
}

TEST(AsyncTissue, PushesAgainstTheTurnWithTheTorqueOverTheArm) {
  AsyncTissue tissue;
  tissue.grip();
  tissue.hear(kAnswer, kTick_us);
  const AxisFrame axis{.centre_m = {}, .tangent = {0, 0, 1}, .e1 = {1, 0, 0}, .e2 = {0, 1, 0}};

  // An arm of 50 mm, further than sqrt(0.4 / 500) = 28 mm: 0.2 N m / 0.05 m = 4 N against +y.
  const Vec3 force_N = tissue.force_N(0.5, axis, {0.05, 0.0, 0.0}, 500.0);

  EXPECT_NEAR(force_N.y, -4.0, 1e-12);
  EXPECT_NEAR(force_N.x, 0.0, 1e-12);
}

TEST(AsyncTissue, SaysNothingBeforeTheFirstAnswerAndOfAnotherGrip) {
  AsyncTissue tissue;
  tissue.grip();
  EXPECT_EQ(tissue.torque_Nm(1.0), 0.0);
  tissue.hear(kAnswer, kTick_us);

  tissue.grip();

  EXPECT_EQ(tissue.torque_Nm(0.5), 0.0);
  EXPECT_FALSE(tissue.doubtful());
}

TEST(AsyncTissue, IsDoubtedWhenItIsSilentTooLongAndTrustedWithTheNextAnswer) {
  AsyncTissue tissue;
  tissue.grip();
  tissue.hear(kAnswer, kTick_us);
  for (std::int64_t us = 0; us < kBesideLate_us; us += kTick_us) {
    tissue.hear({}, kTick_us);
  }
  EXPECT_FALSE(tissue.doubtful());

  tissue.hear({}, kTick_us);

  EXPECT_TRUE(tissue.doubtful());
  EXPECT_EQ(tissue.torque_Nm(0.5), 0.0);
  tissue.hear(kAnswer, kTick_us);
  EXPECT_FALSE(tissue.doubtful());
  EXPECT_DOUBLE_EQ(tissue.torque_Nm(0.5), 0.2);
}

TEST(AsyncTissue, IsDoubtedWhenItIsBroken) {
  AsyncTissue tissue;
  tissue.grip();

  tissue.hear({.state = BesideState::kBroken}, kTick_us);

  EXPECT_TRUE(tissue.doubtful());
  EXPECT_EQ(tissue.torque_Nm(0.5), 0.0);
}

/// A loop whose organ a model beside it answers; the test says what that model delivers.
class LoopBesideAModel : public ::testing::Test {
 protected:
  LoopBesideAModel()
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
        loop_({.device = &hand_, .scene = &scene_, .beside = &link_}, {}) {}

  void tick() {
    loop_.tick(time_us_);
    time_us_ += kTick_us;
  }
  void tickUntilHeld() {
    while (loop_.lastSample().phase != ExercisePhase::kTwisting) {
      ASSERT_LT(time_us_, 20'000'000);
      tick();
    }
  }
  void deliver(double torque_Nm) {
    const BesideQuestion& asked = link_.questions.latest();
    link_.deliveries.publish({++number_, asked.grip, {BesideState::kSound, asked.angle_rad, torque_Nm, 0.1}});
  }
  /// Runs the time of a doubt; a sound model would have spoken.
  void tickWithout(std::int64_t span_us) {
    for (std::int64_t us = 0; us < span_us; us += kTick_us) {
      tick();
    }
  }

  Scene scene_;
  BesideLink link_;
  ScriptedHand hand_;
  ServoLoop loop_;
  std::int64_t time_us_ = 0;
  std::int64_t number_ = 0;
};

TEST_F(LoopBesideAModel, RecordsWhatArrivedWithTheTickThatItArrivedIn) {
  tickUntilHeld();
  tick();
  deliver(0.05);

  tick();

  EXPECT_EQ(loop_.lastSample().beside.state, BesideState::kSound);
  EXPECT_EQ(loop_.lastSample().beside.torque_Nm, 0.05);
  EXPECT_NE(loop_.lastSample().response.torque_Nm, 0.0);
  tick();
  EXPECT_EQ(loop_.lastSample().beside.state, BesideState::kNothing);
}

TEST_F(LoopBesideAModel, LetsTheForceOfTheGripFallToZeroWhenTheModelHangs) {
  tickUntilHeld();
  deliver(0.05);
  tick();
  ASSERT_NE(loop_.lastSample().response.torque_Nm, 0.0);
  EXPECT_EQ(loop_.lastSample().limits & kForceModelLate, 0U);

  tickWithout(kBesideLate_us + 2 * kTick_us);

  ASSERT_EQ(loop_.lastSample().phase, ExercisePhase::kTwisting);
  EXPECT_NE(loop_.lastSample().limits & kForceModelLate, 0U);
  EXPECT_EQ(loop_.lastSample().response.torque_Nm, 0.0);
  EXPECT_EQ(norm(loop_.lastSample().response.force_N), 0.0);
}

TEST_F(LoopBesideAModel, LetsTheForceOfTheGripFallToZeroWhenTheModelSaysNoNumber) {
  tickUntilHeld();
  deliver(0.05);
  tick();

  deliver(std::numeric_limits<double>::quiet_NaN());
  tick();

  EXPECT_EQ(loop_.lastSample().beside, (BesideAnswer{.state = BesideState::kBroken}));
  EXPECT_NE(loop_.lastSample().limits & kForceModelLate, 0U);
  EXPECT_EQ(norm(loop_.lastSample().response.force_N), 0.0);
}

TEST_F(LoopBesideAModel, PassesOverWhatBelongsToAnotherGrip) {
  tickUntilHeld();
  link_.deliveries.publish({++number_, 7, {BesideState::kSound, 0.0, 1.0, 1.0}});

  tick();

  EXPECT_EQ(loop_.lastSample().beside.state, BesideState::kNothing);
  EXPECT_EQ(loop_.lastSample().response.torque_Nm, 0.0);
}

}  // namespace
}  // namespace torsio
