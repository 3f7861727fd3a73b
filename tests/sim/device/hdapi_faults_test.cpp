// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that a hostile library showed: what the motors render, and what the driver says, in each of them.
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "sim/core/error.h"
#include "tests/sim/device/hdapi_bench.h"

namespace torsio {
namespace {

class HdapiFaults : public testing::HdapiBench {
 protected:
  void engageAtOneNewton() {
    const FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
    fake.set_pose(&pose);
    loop.wanted_N = {1.0, 0.0, 0.0};
    engage();
    ASSERT_NEAR(rendered_N().x, 1.0, 1e-9);
  }
};

TEST_F(HdapiFaults, ARefusedFrameSwitchesTheOutputOffInTheSameTick) {
  engageAtOneNewton();

  fake.fault("hdBeginFrame", 0, -1, hd::kFrameError, 0);
  fake.run(1);

  EXPECT_EQ(rendered_N(), Vec3{});
  fake.run(101);
  EXPECT_EQ(device->snapshot().state, DeviceState::kLost);
  EXPECT_EQ(events(DeviceEvent::Kind::kLost).size(), 1U);
}

TEST_F(HdapiFaults, AFrameWhoseEndIsRefusedSwitchesTheOutputOffAndKeepsItOff) {
  engageAtOneNewton();

  fake.fault("hdEndFrame", 0, -1, hd::kFrameError, 0);
  for (int tick = 0; tick < 50; ++tick) {
    fake.run(1);
    EXPECT_EQ(rendered_N(), Vec3{}) << tick;
    EXPECT_EQ(fake.force_enabled(), 0) << tick;
  }
  EXPECT_NE(device->snapshot().state, DeviceState::kLost);
  fake.run(60);

  EXPECT_EQ(device->snapshot().state, DeviceState::kLost);
  EXPECT_EQ(events(DeviceEvent::Kind::kLost).size(), 1U);
}

TEST_F(HdapiFaults, AFatalErrorAtTheEndOfAFrameSendsZeroAndSwitchesOffInTheSameTick) {
  engageAtOneNewton();
  const int begin = fake.log_count();

  fake.fault("hdEndFrame", 0, 1, hd::kCommError, -28);
  fake.run(1);

  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_EQ(fake.force_enabled(), 0);
  std::array<double, 3> last{1, 1, 1};
  fake.commanded(last.data());
  EXPECT_EQ(last, (std::array<double, 3>{}));
  EXPECT_TRUE(loop.sample.status & kDeviceLost);
  EXPECT_LT(logged("hdEndFrame", begin).back(), logged("hdDisable", begin).back());
  EXPECT_EQ(fake.rule_breaks(), 0);
}

TEST_F(HdapiFaults, ADeadServoIsReleasedFromOutside) {
  engageAtOneNewton();
  fake.die();
  const int begin = fake.log_count();

  EXPECT_TRUE(device->close());

  std::array<double, 3> last{1, 1, 1};
  fake.commanded(last.data());
  EXPECT_EQ(last, (std::array<double, 3>{}));
  EXPECT_EQ(fake.force_enabled(), 0);
  ASSERT_FALSE(logged("hdDisable", begin).empty());
  EXPECT_LT(logged("hdEndFrame", begin).at(0), logged("hdDisable", begin).back());
  EXPECT_LT(logged("hdDisable", begin).back(), logged("hdStopScheduler", begin).at(0));
  EXPECT_LT(logged("hdStopScheduler", begin).at(0), logged("hdDisableDevice", begin).at(0));
}

TEST_F(HdapiFaults, ReportsASilentServo) {
  start();
  EXPECT_NE(device->snapshot().state, DeviceState::kSilent);

  std::this_thread::sleep_for(std::chrono::microseconds(kServoSilent_us + 50'000));

  EXPECT_EQ(device->snapshot().state, DeviceState::kSilent);
}

TEST_F(HdapiFaults, AFrozenPositionEndsTheForceAndIsCountedAsNoCalibration) {
  engageAtOneNewton();

  // The gimbal's first joint turns by 5 mrad a tick, 0.1 rad within 21 ticks; the position does not move.
  for (int i = 1; i <= 25; ++i) {
    const FakePose pose{{0, 0, 0}, {0.005 * i, 0, 0}, 1, {0, 0, 0}};
    fake.set_pose(&pose);
    fake.run(1);
  }

  EXPECT_TRUE(device->snapshot().frozen);
  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_TRUE(loop.sample.status & kDeviceStale);
  EXPECT_EQ(events(DeviceEvent::Kind::kFrozen).size(), 1U);
}

TEST_F(HdapiFaults, ATouchThatReportsFortyNewtonIsHeldToItsDataSheet) {
  const double forty_N = 40.0;
  fake.set_number(hd::kNominalMaxForce, &forty_N, 1);
  for (const auto& [model, limit_N] : {std::pair{"Touch", 3.3}, std::pair{"PHANTOM Omni", 3.3},
                                       std::pair{"Touch X", 7.9}, std::pair{"?", 3.3}}) {
    fake.set_model(model);
    open();

    EXPECT_EQ(device->capabilities().maxForce_N, limit_N) << model;
    device.reset();
  }
}

TEST_F(HdapiFaults, ATextThatIsNotUtf8AndPositionsBeyondTheEarthAreHarmless) {
  fake.set_model("Touch\xff\xfe");
  open();
  EXPECT_EQ(device->capabilities().model, "Touch??");
  loop.governor = ForceGovernor(limits());
  device->start({&testing::FakeLoop::tick, &loop});

  const FakePose far{{0, 0, 0}, {0, 0, 0}, 1, {1e300, 0, 0}};
  fake.set_pose(&far);
  fake.run(3);
  const FakePose turned{{1e300, 0, 0}, {0, 0, 1e300}, 1, {0, 0, 0}};
  fake.set_pose(&turned);
  fake.run(3);

  EXPECT_EQ(device->snapshot().validPoses, 0);
  EXPECT_EQ(device->snapshot().invalidPoses, 6);
  EXPECT_TRUE(std::isfinite(device->snapshot().geometryError_m));
}

TEST_F(HdapiFaults, ASecondOpenDuringAStuckTeardownIsRefusedInWords) {
  options.patience_us = 20'000;
  start();
  fake.run(10);
  fake.unplug();
  fake.run(1);
  EXPECT_FALSE(device->close());

  try {
    const HdapiDevice second(library.api, options);
    FAIL() << "opened";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kDevice);
    EXPECT_NE(std::string(error.what()).find("still being released"), std::string::npos);
  }
  fake.replug();
  while (!device->close()) {
  }
}

TEST_F(HdapiFaults, ACallbackAfterUnscheduleFindsNobody) {
  start();
  fake.run(10);
  fake.keep_task();
  EXPECT_TRUE(device->close());
  const std::int64_t ticks = loop.ticks;
  device.reset();

  fake.call_kept();

  EXPECT_EQ(loop.ticks, ticks);
}

TEST_F(HdapiFaults, FramesWithForceAreCountedAsTakenOrRefused) {
  engageAtOneNewton();
  const DeviceSnapshot before = device->snapshot();

  fake.run(10);
  fake.fault("hdSetDoublev", 0, 5, hd::kForceError, 0);
  fake.run(1);

  EXPECT_EQ(device->snapshot().forcesSent - before.forcesSent, 10);
  EXPECT_EQ(device->snapshot().forcesRefused - before.forcesRefused, 1);
}

class BrokenLibraries : public ::testing::Test {
 protected:
  std::filesystem::path copy(const char* name) {
    const std::filesystem::path path = std::filesystem::path(::testing::TempDir()) / name;
    std::filesystem::remove(path);
    std::filesystem::copy_file(TORSIO_FAKEHD, path);
    return path;
  }
};

TEST_F(BrokenLibraries, ATruncatedOneIsThereButRefused) {
  const std::filesystem::path path = copy("libHD_truncated.so");
  std::filesystem::resize_file(path, 3'000);  // what comes last may be for debuggers only

  const HdapiLibrary library = loadHdapi(path.string());

  EXPECT_EQ(library.status, HdapiLoadStatus::kDependencyMissing);
  EXPECT_NE(library.sentence.str().find("truncated"), std::string::npos) << library.sentence;
}

TEST_F(BrokenLibraries, OneForAnotherProcessorIsNamedAsSuch) {
  const std::filesystem::path path = copy("libHD_other.so");
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(18);             // e_machine, ELF specification
  file.write("\xb7\x00", 2);  // EM_AARCH64 = 183
  file.close();

  const HdapiLibrary library = loadHdapi(path.string());

  EXPECT_EQ(library.status, HdapiLoadStatus::kDependencyMissing);
  EXPECT_NE(library.sentence.str().find("another kind of processor"), std::string::npos) << library.sentence;
}

}  // namespace
}  // namespace torsio
