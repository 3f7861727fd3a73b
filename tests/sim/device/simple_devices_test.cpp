// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/virtual_drivers.h"

namespace torsio {
namespace {

// Steps of the quantisation, at most one half each, on three axes.
constexpr double kQuantum_m = 1e-7;

TEST(IdleDevice, StaysWhereItWasPutAndIgnoresForces) {
  const Pose pose{{0.1, -0.2, 0.3}, axisAngle({0, 1, 0}, 0.5)};
  IdleDevice device(pose);

  const DeviceSample first = device.read(0);
  device.write({{3.0, 0.0, 0.0}, 0});
  const DeviceSample later = device.read(1'000'000);

  EXPECT_EQ(later.time_us, 1'000'000);
  EXPECT_EQ(first.position, later.position);
  EXPECT_EQ(first.orientation, later.orientation);
  EXPECT_NEAR(norm(toolState(later).pose.position_m - pose.position_m), 0.0, kQuantum_m);
  EXPECT_FALSE(device.capabilities().rendersForce);
}

TEST(ReplayDevice, GivesEachRecordedSampleOnceAndThenSaysThatItEnded) {
  std::vector<DeviceSample> recorded(3);
  for (std::int32_t i = 0; i < 3; ++i) {
    recorded[static_cast<std::size_t>(i)].time_us = 1000 * i;
    recorded[static_cast<std::size_t>(i)].position = {i, 2 * i, 3 * i};
  }
  ReplayDevice device(recorded, {});

  for (const DeviceSample& sample : recorded) {
    EXPECT_EQ(device.read(0), sample);
  }
  const DeviceSample after = device.read(9'000);

  EXPECT_EQ(after.status, static_cast<std::uint32_t>(kDeviceEnded));
  EXPECT_EQ(after.position, recorded.back().position);
  EXPECT_EQ(after.time_us, 9'000);
}

TEST(ReplayDevice, EndsAtOnceWithoutSamples) {
  ReplayDevice device({}, {});

  EXPECT_EQ(device.read(0).status, static_cast<std::uint32_t>(kDeviceEnded));
}

class PointerDeviceTest : public ::testing::Test {
 protected:
  /// The state after so many milliseconds of reading.
  ToolState settle(int ticks = 500) {
    DeviceSample sample;
    for (int i = 0; i < ticks; ++i) {
      sample = device.read(time_us += 1000);
    }
    return toolState(sample);
  }
  static PointerInput at(const Vec3& onPlane_m) {
    PointerInput input;
    input.present = true;
    input.onPlane_m = onPlane_m;
    return input;
  }

  PointerDevice device{Pose{{0.0, 0.0, 0.1}, {}}};
  std::int64_t time_us = 0;
};

TEST_F(PointerDeviceTest, WaitsAtItsStartUntilThePointerAppears) {
  const ToolState state = settle();

  EXPECT_NEAR(norm(state.pose.position_m - Vec3{0.0, 0.0, 0.1}), 0.0, kQuantum_m);
  EXPECT_EQ(state.status, static_cast<std::uint32_t>(kDeviceOk));
}

TEST_F(PointerDeviceTest, FollowsThePointerOnThePlaneAndTheWheelIntoThePicture) {
  PointerInput input = at({0.02, 0.03, 0.1});
  input.depth_m = 0.01;
  input.view = axisAngle({1.0, 0.0, 0.0}, radians(90.0));  // the camera looks along +y
  device.publish(input);

  const ToolState state = settle();

  EXPECT_NEAR(norm(state.pose.position_m - Vec3{0.02, 0.04, 0.1}), 0.0, 2.0 * kQuantum_m);
  const Vec3 ahead = rotate(state.pose.orientation, {0.0, 0.0, -1.0});
  EXPECT_NEAR(norm(ahead - Vec3{0.0, 1.0, 0.0}), 0.0, 1e-8);
}

TEST_F(PointerDeviceTest, TurnsTheStylusByKeysInThreeAngles) {
  PointerInput input = at({});
  input.roll_rad = radians(400.0);
  device.publish(input);
  const ToolState rolled = settle();
  input.roll_rad = 0.0;
  input.yaw_rad = radians(90.0);
  device.publish(input);
  const ToolState yawed = settle();
  input.yaw_rad = 0.0;
  input.pitch_rad = radians(90.0);
  device.publish(input);
  const ToolState pitched = settle();

  EXPECT_NEAR(rolled.roll_rad, radians(400.0), 1e-6);  // unwrapped
  EXPECT_NEAR(norm(rotate(rolled.pose.orientation, {1, 0, 0}) -
                   Vec3{std::cos(radians(40.0)), std::sin(radians(40.0)), 0.0}),
              0.0, 1e-6);
  EXPECT_NEAR(norm(rotate(yawed.pose.orientation, {0, 0, -1}) - Vec3{-1, 0, 0}), 0.0, 1e-6);
  EXPECT_NEAR(norm(rotate(pitched.pose.orientation, {0, 0, -1}) - Vec3{0, 1, 0}), 0.0, 1e-6);
}

TEST_F(PointerDeviceTest, ClosesAndOpensTheJawWithTheButton) {
  PointerInput input = at({});
  input.grip = 1.0;
  input.buttons = kButtonBookmark;
  device.publish(input);
  const ToolState closed = settle();
  input.present = false;
  device.publish(input);
  const ToolState gone = settle();

  EXPECT_NEAR(closed.grip, kPointerClosure, 1e-4);
  EXPECT_EQ(closed.buttons, static_cast<std::uint32_t>(kButtonBookmark));
  EXPECT_NEAR(gone.grip, 0.0, 1e-4);  // a pointer that left the view lets go
}

TEST_F(PointerDeviceTest, SmoothsSixtyUpdatesASecondIntoAThousandSmallSteps) {
  Vec3 before_m = settle(1).pose.position_m;
  double largest_m = 0.0;
  for (int frame = 1; frame <= 60; ++frame) {
    device.publish(at({0.003 * frame, 0.0, 0.1}));  // 3 mm a frame, 0.18 m/s
    for (int i = 0; i < 16; ++i) {
      const Vec3 tip_m = settle(1).pose.position_m;
      largest_m = std::max(largest_m, norm(tip_m - before_m));
      before_m = tip_m;
    }
  }

  // Two equal low-passes answer a step of 3 mm with at most 3 mm / (e * 15 ms) on top of the mean speed.
  EXPECT_LT(largest_m, 0.00035);
}

TEST_F(PointerDeviceTest, NeverMovesFasterThanItsSpeedLimit) {
  (void)settle(1);
  device.publish(at({0.5, 0.0, 0.1}));
  Vec3 before_m{0.0, 0.0, 0.1};
  for (int i = 0; i < 600; ++i) {
    const Vec3 tip_m = settle(1).pose.position_m;
    ASSERT_LE(norm(tip_m - before_m), kPointerSpeedLimit_m_per_s * 1e-3 + 2.0 * kQuantum_m);
    before_m = tip_m;
  }
  EXPECT_NEAR(before_m.x, 0.5, 1e-6);
}

TEST_F(PointerDeviceTest, DoesNotTurnWhatTheJawHoldsWhenTheCameraGoesRound) {
  PointerInput input = at({});
  input.grip = 1.0;
  device.publish(input);
  const ToolState before = settle();
  input.view = axisAngle({0.0, 1.0, 0.0}, 1.0);
  device.publish(input);
  const ToolState after = settle();

  EXPECT_EQ(before.pose.orientation, after.pose.orientation);
}

TEST_F(PointerDeviceTest, RepeatsItsPoseAndSaysSoForInputThatIsNotFinite) {
  device.publish(at({0.02, 0.0, 0.1}));
  const ToolState good = settle();
  for (int broken = 0; broken < 3; ++broken) {
    PointerInput input = at({0.5, 0.0, 0.1});
    (broken == 0   ? input.onPlane_m.x
     : broken == 1 ? input.view.w
                   : input.roll_rad) = std::numeric_limits<double>::quiet_NaN();
    device.publish(input);
    const ToolState state = settle(10);

    EXPECT_EQ(state.status, static_cast<std::uint32_t>(kDeviceInvalid));
    EXPECT_NEAR(norm(state.pose.position_m - good.pose.position_m), 0.0, 2.0 * kQuantum_m);
  }
}

}  // namespace
}  // namespace torsio
