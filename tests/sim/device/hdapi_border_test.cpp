// SPDX-License-Identifier: GPL-3.0-or-later
// Cases B1 to B2 and K1 to K3 of the haptics plan: buttons, pose and roll at the border.
// Cases C1 to C5 of the haptics plan: the stylus in the inkwell.
#include <cmath>

#include "sim/core/angle.h"
#include "sim/core/random.h"
#include "tests/sim/device/hdapi_bench.h"

namespace torsio {
namespace {

// The quantisation of a DeviceSample, at most half a step on each of three axes.
constexpr double kQuantum_m = 1e-7;
constexpr double kQuantum_rad = 1e-7;

class HdapiGives : public testing::HdapiBench {
 protected:
  HdapiGives() { options.stylusTip_m = 0.0; }

  FakePose pose = testing::kDockedPose;
  /// One tick with the stylus rolled to this gimbal angle, in the Touch's convention.
  ToolState rollTo(double gimbalRoll_rad) {
    pose.gimbal_rad[2] = gimbalRoll_rad;
    fake.set_pose(&pose);
    fake.run(1);
    return toolState(loop.sample);
  }
};

TEST_F(HdapiGives, B1_DeliversPressAndReleaseWithinOneFrameOfAViewInOrderWithTheirTimes) {
  start();
  fake.run(10);
  fake.set_buttons(1);
  fake.run(6);
  fake.set_buttons(0);
  fake.run(10);  // 16 ms: one frame of a view

  const std::vector<DeviceEvent> edges = events(DeviceEvent::Kind::kButtons);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].value, static_cast<std::uint32_t>(kButtonGrip));
  EXPECT_EQ(edges[1].value, 0U);
  EXPECT_EQ(edges[0].time_us, 10'000);
  EXPECT_EQ(edges[1].time_us, 16'000);
}

TEST_F(HdapiGives, B2_KnowsTheTwoButtonsAndDropsTheOtherBits) {
  start();
  fake.set_buttons(0b1111);
  fake.run(1);

  EXPECT_EQ(loop.sample.buttons, static_cast<std::uint32_t>(kButtonGrip | kButtonSecond));
}

TEST_F(HdapiGives, B2_CountsABouncingContactOnceAndNeverDelaysThePress) {
  start();
  fake.run(1);
  for (const int level : {1, 0, 1, 0, 1, 1}) {
    fake.set_buttons(level);
    fake.run(1);
    EXPECT_EQ(loop.sample.buttons, static_cast<std::uint32_t>(kButtonGrip));
  }
  fake.run(20);
  fake.set_buttons(0);
  fake.run(1);
  EXPECT_EQ(loop.sample.buttons, 0U);

  EXPECT_EQ(events(DeviceEvent::Kind::kButtons).size(), 2U);
}

TEST_F(HdapiGives, B2_ReleasesAButtonThatWasLetGoWhileItsBounceWasIgnored) {
  start();
  fake.set_buttons(2);
  fake.run(1);
  fake.set_buttons(0);
  fake.run(4);
  EXPECT_EQ(loop.sample.buttons, static_cast<std::uint32_t>(kButtonSecond));
  fake.run(1);

  EXPECT_EQ(loop.sample.buttons, 0U);
}

TEST_F(HdapiGives, B2_ClosesTheJawWithTheFirstButton) {
  start();
  fake.run(1);
  fake.set_buttons(1);
  fake.run(50);
  const double half = toolState(loop.sample).grip;
  fake.run(60);
  const double closed = toolState(loop.sample).grip;
  fake.set_buttons(0);
  fake.run(110);

  EXPECT_NEAR(half, 0.5, 1e-4);
  EXPECT_NEAR(closed, 1.0, 1e-4);
  EXPECT_NEAR(toolState(loop.sample).grip, 0.0, 1e-4);
}

TEST_F(HdapiGives, K1_GivesTheRecordedInkwellPoseInMetresOfTheWorld) {
  start();
  fake.run(1);

  // Recorded on a Touch: (0, -65.5107, -88.1142) mm in the device frame. The world's y is minus the device's
  // z.
  const ToolState tool = toolState(loop.sample);
  EXPECT_NEAR(tool.pose.position_m.x, 0.0, kQuantum_m);
  EXPECT_NEAR(tool.pose.position_m.y, 0.0881142, 2.0 * kQuantum_m);  // recorded to 1e-7 m, too
  EXPECT_NEAR(tool.pose.position_m.z, -0.0655107, 2.0 * kQuantum_m);
  EXPECT_TRUE(device->snapshot().docked);
  // Ry(0) Rx(0.370813) Ry(0.000108409) Rx(-0.797273) turns the stylus's -z about x by -0.426460 in all: up
  // and away from the user, z is untouched by the roll.
  const Vec3 ahead = rotate(tool.pose.orientation, {0.0, 0.0, -1.0});
  EXPECT_NEAR(ahead.z, -std::sin(0.426460), 1e-5);
  EXPECT_NEAR(ahead.y, std::cos(0.426460), 1e-5);
  EXPECT_EQ(tool.roll_rad, 0.0);  // docked: the reference
  EXPECT_LT(device->snapshot().geometryError_m, 1e-9);
}

TEST_F(HdapiGives, K1_ComputesTheRecordedPositionFromTheRecordedAngles) {
  const std::array<double, 16> transform =
      touchTransform_mm({0.0, 0.26889, -0.370813}, {0.000108409, 0.797273, -1.94046});

  EXPECT_NEAR(transform[12], 0.0, 1e-4);
  EXPECT_NEAR(transform[13], -65.5107, 1e-4);
  EXPECT_NEAR(transform[14], -88.1142, 1e-4);
}

TEST_F(HdapiGives, K1_AgreesWithTheFakesOwnGeometryEverywhere) {
  start();
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const auto between = [&random](double low, double high) { return low + (high - low) * random.uniform(); };
    const std::array<double, 3> joints{between(-0.9, 0.9), between(0.0, 1.7), between(-0.7, 1.2)};
    const std::array<double, 3> gimbal{between(-2.5, 2.5), between(-1.4, 0.9), between(-2.6, 2.6)};
    pose = {{joints[0], joints[1], joints[2]}, {gimbal[0], gimbal[1], gimbal[2]}, 0, {}};
    fake.set_pose(&pose);
    fake.run(1);

    HdapiFrame frame{.transform_mm = touchTransform_mm(joints, gimbal)};
    DevicePlacement placement;
    const std::optional<Pose> expected = worldPose(frame, placement);
    ASSERT_TRUE(expected);
    const ToolState tool = toolState(loop.sample);
    ASSERT_LT(norm(tool.pose.position_m - expected->position_m), 2.0 * kQuantum_m);
    const Quat turn = conjugate(expected->orientation) * tool.pose.orientation;
    ASSERT_NEAR(std::abs(turn.w), 1.0, 1e-8);
  }
}

TEST_F(HdapiGives, K1_PutsTheTipAheadOfTheGimbalAndTheWorkspaceWhereTheOrganIs) {
  options.stylusTip_m = kStylusTip_m;
  options.workspaceCentre_m = {0.1, 0.2, 0.3};
  pose = {{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  fake.set_pose(&pose);
  start();
  fake.run(1);

  // All angles zero: the stylus points along the device's -z, the world's +y.
  EXPECT_NEAR(norm(toolState(loop.sample).pose.position_m - Vec3{0.1, 0.2 + 0.039, 0.3}), 0.0,
              2.0 * kQuantum_m);
}

TEST_F(HdapiGives, K2_FollowsTheRollToBothStopsAndReportsThem) {
  start();
  rollTo(0.0);
  int stops = 0;
  for (int degree = -1; degree >= -150; --degree) {
    // Docked with the roll at 0: a clockwise gimbal angle turns left-handed about the stylus's z axis.
    ASSERT_NEAR(rollTo(radians(degree)).roll_rad, radians(-degree), kQuantum_rad);
    stops += device->snapshot().rollAtStop ? 1 : 0;
  }
  EXPECT_EQ(stops, 2);  // 149 and 150 degrees
  for (int degree = -150; degree <= 150; ++degree) {
    ASSERT_NEAR(rollTo(radians(degree)).roll_rad, radians(-degree), kQuantum_rad);
  }

  EXPECT_TRUE(device->snapshot().rollAtStop);
  EXPECT_EQ(events(DeviceEvent::Kind::kRollStop).size(), 2U);
}

TEST_F(HdapiGives, K2_CountsNoFalseTurnUnderNoise) {
  start();
  rollTo(0.0);
  Random random(7);
  for (int i = 0; i < 3'000; ++i) {
    const double true_rad = radians(149.0) * std::sin(0.004 * i);
    const double seen_rad = true_rad + radians(0.5) * random.normal();
    ASSERT_NEAR(rollTo(seen_rad).roll_rad, -true_rad, radians(3.0)) << i;  // six standard deviations
  }
}

TEST_F(HdapiGives, K3_GivesTheSameTwistOnAnOmniAsOnATouchAfterTheDockedReference) {
  const auto twist = [this](const char* model, const std::array<double, 3>& scale,
                            const std::array<double, 3>& offset_rad) {
    fake.reset();
    fake.set_model(model);
    fake.set_gimbal(scale.data(), offset_rad.data());
    start();
    pose = testing::kDockedPose;
    std::vector<ToolState> states{rollTo(-1.94046)};
    EXPECT_TRUE(device->snapshot().rollReferenced);
    pose.joints_rad[1] = 0.5;
    for (int i = 0; i <= 250; ++i) {
      states.push_back(rollTo(-1.94046 + 0.017 * i));
    }
    device.reset();
    return states;
  };

  const std::vector<ToolState> touch = twist("Touch", {1, 1, 1}, {0, 0, 0});
  // An Omni whose potentiometers lie elsewhere than those of the one that was published.
  const std::vector<ToolState> omni =
      twist("PHANTOM Omni", {1, -1, 1}, {3.665 + 0.2, -3.805 - 0.1, 3.089 + 0.3});

  ASSERT_EQ(touch.size(), omni.size());
  for (std::size_t i = 0; i < touch.size(); ++i) {
    ASSERT_NEAR(touch[i].roll_rad, omni[i].roll_rad, 2.0 * kQuantum_rad) << i;
    ASSERT_EQ(touch[i].pose.orientation, omni[i].pose.orientation);
  }
  EXPECT_NEAR(touch.back().roll_rad, -0.017 * 250, 2.0 * kQuantum_rad);
}

class HdapiCalibrates : public testing::HdapiBench {
 protected:
  static FakePose away() {
    FakePose pose = testing::kDockedPose;
    pose.joints_rad[1] = 0.8;
    return pose;
  }
};

TEST_F(HdapiCalibrates, C1_IsReadyAtOnceWhenTheDeviceIsCalibrated) {
  open();
  device->start({&testing::FakeLoop::tick, &loop});
  fake.run(2);

  EXPECT_EQ(device->snapshot().state, DeviceState::kReady);
  EXPECT_EQ(device->snapshot().calibration, CalibrationState::kCalibrated);
  EXPECT_EQ(loop.sample.status, static_cast<std::uint32_t>(kDeviceOk));
  EXPECT_EQ(fake.calls("hdUpdateCalibration"), 0);
}

TEST_F(HdapiCalibrates, C2_AsksForTheInkwellCalibratesOnceAndKeepsTheForceOffUntilThen) {
  fake.set_calibration(hd::kCalibrationNeedsManualInput);
  const FakePose pose = away();
  fake.set_pose(&pose);
  loop.wanted_N = {1.0, 0.0, 0.0};
  start();
  fake.run(2'500);

  EXPECT_EQ(device->snapshot().state, DeviceState::kNeedsCalibration);
  EXPECT_EQ(device->snapshot().calibration, CalibrationState::kDockStylus);
  EXPECT_TRUE(loop.sample.status & kDeviceUncalibrated);
  EXPECT_EQ(fake.calls("hdUpdateCalibration"), 0);
  EXPECT_EQ(fake.force_enabled(), 0);
  EXPECT_EQ(rendered_N(), Vec3{});

  fake.dock(1);
  for (int i = 0; i < 2'100 && device->snapshot().calibration != CalibrationState::kCalibrated; ++i) {
    EXPECT_EQ(fake.force_enabled(), 0);
    fake.run(1);
  }

  EXPECT_EQ(device->snapshot().calibration, CalibrationState::kCalibrated);
  EXPECT_EQ(fake.calls("hdUpdateCalibration"), 1);
  fake.run(200);
  EXPECT_EQ(fake.force_enabled(), 1);
  EXPECT_EQ(fake.rule_breaks(), 0);
  const std::vector<DeviceEvent> steps = events(DeviceEvent::Kind::kCalibration);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(steps[0].value, static_cast<std::uint32_t>(CalibrationState::kDockStylus));
  EXPECT_EQ(steps[1].value, static_cast<std::uint32_t>(CalibrationState::kUpdating));
  EXPECT_EQ(steps[2].value, static_cast<std::uint32_t>(CalibrationState::kCalibrated));
}

TEST_F(HdapiCalibrates, C3_StopsTryingAfterRefusedUpdatesAndTriesAgainOnTheUsersWish) {
  fake.set_calibration(hd::kCalibrationNeedsUpdate);
  fake.fault("hdUpdateCalibration", 0, kCalibrationTries, hd::kDeviceFault, 0);
  start();
  fake.run(20'000);

  EXPECT_EQ(fake.calls("hdUpdateCalibration"), kCalibrationTries);
  EXPECT_EQ(device->snapshot().calibration, CalibrationState::kFailed);
  EXPECT_EQ(device->snapshot().state, DeviceState::kNeedsCalibration);  // not lost: a fault here is a refusal
  EXPECT_TRUE(loop.sample.status & kDeviceUncalibrated);

  device->retryCalibration();
  fake.run(1'100);

  EXPECT_EQ(fake.calls("hdUpdateCalibration"), kCalibrationTries + 1);
  EXPECT_EQ(device->snapshot().calibration, CalibrationState::kCalibrated);
}

TEST_F(HdapiCalibrates, C4_CutsTheForceWhenThePositionJumpsAndEngagesByRamp) {
  FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  fake.set_pose(&pose);
  loop.wanted_N = {1.0, 0.0, 0.0};
  engage();
  ASSERT_NEAR(rendered_N().x, 1.0, 1e-9);

  pose.position_mm[0] = 50.0;
  fake.set_pose(&pose);
  fake.run(1);

  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_TRUE(loop.sample.status & kDeviceUncalibrated);
  EXPECT_EQ(device->snapshot().jumps, 1);
  double before_N = 0.0;
  for (int i = 0; i < 1'500; ++i) {
    fake.run(1);
    const double now_N = rendered_N().x;
    ASSERT_GE(now_N, before_N);
    ASSERT_LE(now_N - before_N, kSlewLimit_N_per_s * 1e-3 + 1e-12);
    before_N = now_N;
  }
  EXPECT_NEAR(before_N, 1.0, 1e-9);
}

TEST_F(HdapiCalibrates, C5_SwitchesTheForceOffWhenCalibrationIsLostInMidSession) {
  loop.wanted_N = {1.0, 0.0, 0.0};
  FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  fake.set_pose(&pose);
  engage();
  ASSERT_NEAR(rendered_N().x, 1.0, 1e-9);

  fake.set_calibration(hd::kCalibrationNeedsManualInput);
  fake.run(1'001);

  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_EQ(fake.force_enabled(), 0);
  EXPECT_EQ(device->snapshot().state, DeviceState::kNeedsCalibration);
  // The loop's samples say so: nothing of this time can be scored.
  EXPECT_TRUE(loop.sample.status & kDeviceUncalibrated);
}

TEST_F(HdapiCalibrates, C2_TakesThePresentPositionOfADeviceThatKnowsNoInkwellBeforeTheServoStarts) {
  const double encoderReset = hd::kCalibrationEncoderReset;
  fake.set_number(hd::kCalibrationStyle, &encoderReset, 1);
  fake.set_calibration(hd::kCalibrationNeedsUpdate);

  open();

  EXPECT_EQ(fake.calls("hdUpdateCalibration"), 1);
  EXPECT_EQ(fake.running(), 0);
}

}  // namespace
}  // namespace torsio
