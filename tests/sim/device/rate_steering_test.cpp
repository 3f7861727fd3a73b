// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/rate_steering.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace torsio {
namespace {

constexpr double kStep_s = 0.001;
constexpr Vec3 kStart_m{0.1, 0.2, 0.3};

/// Steers for so many milliseconds with one input.
void steer(RateSteering& steering, const SteeringInput& input, int steps) {
  for (int i = 0; i < steps; ++i) {
    steering.step(input, kStep_s);
  }
}

TEST(SteeringCurve, IsNothingNearRestFineInTheMiddleAndFullAtTheEnd) {
  // By hand: (0.56 - 0.12) / (1 - 0.12) = 0.5, squared 0.25.
  EXPECT_DOUBLE_EQ(steeringCurve(0.12, 0.12), 0.0);
  EXPECT_NEAR(steeringCurve(0.56, 0.12), 0.25, 1e-12);
  EXPECT_NEAR(steeringCurve(-0.56, 0.12), -0.25, 1e-12);
  EXPECT_DOUBLE_EQ(steeringCurve(1.0, 0.12), 1.0);
  EXPECT_DOUBLE_EQ(steeringCurve(-1.01, 0.12), -1.0);
  EXPECT_DOUBLE_EQ(steeringCurve(std::numeric_limits<double>::quiet_NaN(), 0.12), 0.0);
}

TEST(RateSteering, BeginsWhereItIsPutAndPointsAwayFromTheUser) {
  const RateSteering steering(kStart_m, {});

  const DeviceReading reading = steering.reading(7);

  EXPECT_EQ(reading.time_us, 7);
  EXPECT_EQ(reading.pose.position_m, kStart_m);
  const Vec3 stylus = rotate(reading.pose.orientation, {0.0, 0.0, -1.0});
  EXPECT_NEAR(norm(stylus - Vec3{0.0, 1.0, 0.0}), 0.0, 1e-12);
  EXPECT_EQ(reading.grip, 0.0);
  EXPECT_EQ(reading.status, kDeviceOk);
}

TEST(RateSteering, AFullDeflectionMovesByItsSpeedLessTheSmoothing) {
  // Smoothed by share = 1 / 31 a millisecond: the sum of 1 - (30/31)^n over 1000 steps is 1000 - 30.
  constexpr double kWay_m = kSteeringSpeed_m_per_s * (1.0 - 0.03);
  const struct {
    Vec3 push;
    Vec3 way;
  } cases[] = {{{1.0, 0.0, 0.0}, {kWay_m, 0.0, 0.0}},
               {{0.0, 1.0, 0.0}, {0.0, 0.0, kWay_m}},
               {{0.0, 0.0, 1.0}, {0.0, -kWay_m, 0.0}}};

  for (const auto& one : cases) {
    RateSteering steering(kStart_m, kStart_m);
    steer(steering, {.move = one.push}, 1000);

    EXPECT_NEAR(norm(steering.reading(0).pose.position_m - kStart_m - one.way), 0.0, 1e-9);
  }
}

TEST(RateSteering, TheTurnIsUnwrappedAndTurnsTheJaw) {
  RateSteering steering(kStart_m, kStart_m);

  steer(steering, {.roll = 1.0}, 4000);

  // 4 s less the 0.03 s of the smoothing, 90 degrees a second: beyond half a turn.
  const DeviceReading reading = steering.reading(0);
  EXPECT_NEAR(reading.roll_rad, (4.0 - 0.03) * kSteeringRoll_rad_per_s, 1e-9);
  EXPECT_GT(reading.roll_rad, 3.2);
  EXPECT_NEAR(norm(rotate(reading.pose.orientation, {0.0, 0.0, -1.0}) - Vec3{0.0, 1.0, 0.0}), 0.0, 1e-12);
}

TEST(RateSteering, StaysInItsCubeAndTiltsNoFurtherThanPeopleCanRead) {
  RateSteering steering(kStart_m, kStart_m);

  steer(steering, {.move = {1.0, 0.0, 0.0}, .pitch = 1.0}, 5000);

  const DeviceReading reading = steering.reading(0);
  EXPECT_DOUBLE_EQ(reading.pose.position_m.x, kStart_m.x + kSteeringReach_m);
  const Vec3 stylus = rotate(reading.pose.orientation, {0.0, 0.0, -1.0});
  EXPECT_NEAR(stylus.z, std::sin(kSteeringTiltMost_rad), 1e-9);
}

TEST(RateSteering, GripIsGradedAndTheButtonSaysWhenItIsHalfClosed) {
  RateSteering steering(kStart_m, kStart_m);

  steer(steering, {.grip = 0.4, .buttons = kButtonSecond}, 1000);
  const DeviceReading open = steering.reading(0);
  steer(steering, {.grip = 0.8}, 1000);
  const DeviceReading closed = steering.reading(0);

  EXPECT_NEAR(open.grip, 0.4, 1e-9);
  EXPECT_EQ(open.buttons, static_cast<std::uint32_t>(kButtonSecond));
  EXPECT_NEAR(closed.grip, 0.8, 1e-9);
  EXPECT_EQ(closed.buttons, static_cast<std::uint32_t>(kButtonGrip));
}

TEST(RateSteering, AThreadThatWasHeldUpDoesNotThrowTheTip) {
  RateSteering late(kStart_m, kStart_m);
  RateSteering inTime(kStart_m, kStart_m);

  late.step({.move = {1.0, 0.0, 0.0}}, 5.0);
  inTime.step({.move = {1.0, 0.0, 0.0}}, kSteeringStepMost_s);

  EXPECT_EQ(late.reading(0).pose.position_m, inTime.reading(0).pose.position_m);
}

TEST(RateSteering, AnInputThatIsNotFiniteMovesNothingAndIsMarked) {
  RateSteering steering(kStart_m, kStart_m);

  steering.step({.move = {std::numeric_limits<double>::infinity(), 0.0, 0.0}}, kStep_s);
  const DeviceReading bad = steering.reading(0);
  steering.step({}, kStep_s);

  EXPECT_EQ(bad.status, kDeviceInvalid);
  EXPECT_EQ(bad.pose.position_m, kStart_m);
  EXPECT_EQ(steering.reading(0).status, kDeviceOk);
}

}  // namespace
}  // namespace torsio
