// SPDX-License-Identifier: GPL-3.0-or-later
// Cases C1 to C5 of the haptics plan: the stylus in the inkwell.
#include "tests/sim/device/hdapi_bench.h"

namespace torsio {
namespace {

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
