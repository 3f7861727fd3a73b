// SPDX-License-Identifier: GPL-3.0-or-later
// Faults that a hostile library showed: what the motors render, and what the driver says, in each of them.
// Cases T1 to T3 of the haptics plan: who calls what from which thread, and at what cost.
#include <atomic>
#include <filesystem>
#include <fstream>
#include <thread>

#include "sim/core/error.h"
#include "sim/core/latest_value.h"
#include "tests/sim/device/hdapi_bench.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

class HdapiFaults : public testing::HdapiBench {};

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
  EXPECT_EQ(device->capabilities().model, "Touch\xef\xbf\xbd\xef\xbf\xbd");
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

  const Error error = testing::refusal([&] { const HdapiDevice second(library.api, options); });
  EXPECT_EQ(error.code(), ErrorCode::kDevice);
  EXPECT_NE(std::string(error.what()).find("still being released"), std::string::npos);
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

class HdapiThreads : public testing::HdapiBench {};

TEST_F(HdapiThreads, T1_MakesNoDeviceCallOffTheServoThreadInAFullSession) {
  fake.set_calibration(hd::kCalibrationNeedsUpdate);
  start();
  fake.run(1'200);
  loop.wanted_N = {0.5, 0.0, 0.0};
  fake.run(800);
  device->enableForce(false);
  (void)device->snapshot();
  device->retryCalibration();
  fake.run(800);
  device->enableForce(true);
  fake.run(100);
  EXPECT_TRUE(device->close());

  EXPECT_EQ(fake.off_thread(), 0);
  EXPECT_EQ(fake.rule_breaks(), 0);
  EXPECT_GT(fake.log_count(), 10'000);
}

TEST_F(HdapiThreads, T1_HoldsWithAServoThreadOfOurOwnOverMailboxes) {
  open();
  device->enableForce(true);
  device->serve();
  std::atomic<bool> stop{false};
  std::atomic<std::int64_t> reads{0};
  std::thread own([&] {
    for (std::int64_t time_us = 0; !stop; time_us += 10) {
      const DeviceSample sample = device->read(time_us);
      device->write({{sample.status == kDeviceOk ? 0.5 : 0.0, 0.0, 0.0}, 0});
      ++reads;
    }
  });
  fake.run(2'000);
  while (reads < 100) {
    std::this_thread::yield();
  }
  stop = true;
  own.join();
  EXPECT_TRUE(device->close());

  EXPECT_EQ(fake.off_thread(), 0);
  EXPECT_EQ(fake.rule_breaks(), 0);
}

TEST(HdapiMailbox, T2_HandsOverAMillionReadingsWithoutTearingOne) {
  constexpr std::int64_t kExchanges = 1'000'000;
  LatestValue<MailedReading> mailbox;
  std::thread writer([&mailbox] {
    MailedReading reading;
    for (std::int64_t i = 1; i <= kExchanges; ++i) {
      reading.number = static_cast<std::uint64_t>(i);
      reading.sample.time_us = i;
      reading.sample.roll = static_cast<std::int32_t>(i);
      reading.sample.position = {static_cast<std::int32_t>(i), static_cast<std::int32_t>(i),
                                 static_cast<std::int32_t>(i)};
      mailbox.publish(reading);
    }
  });

  std::uint64_t last = 0;
  std::int64_t torn = 0;
  std::int64_t backwards = 0;
  while (last < static_cast<std::uint64_t>(kExchanges)) {
    const MailedReading reading = mailbox.latest();
    const auto i = static_cast<std::int64_t>(reading.number);
    const auto short32 = static_cast<std::int32_t>(i);
    if (reading.sample.time_us != i || reading.sample.roll != short32 ||
        reading.sample.position[2] != short32) {
      ++torn;
    }
    if (reading.number < last) {
      ++backwards;
    }
    last = reading.number;
  }
  writer.join();

  EXPECT_EQ(torn, 0);
  EXPECT_EQ(backwards, 0);
}

/// What one callback cost; filled by the fake's hook around it, in the servo thread.
struct Cost {
  std::int64_t allocationsBefore = 0;
  std::int64_t allocations = 0;
  std::int64_t locksBefore = 0;
  std::int64_t locked = 0;
  std::int64_t callbacks = 0;

  static void hook(void* context, int before) {
    auto& cost = *static_cast<Cost*>(context);
    if (before != 0) {
      cost.allocationsBefore = testing::allocationCount();
      cost.locksBefore = testing::lockCount();
      return;
    }
    cost.allocations += testing::allocationCount() - cost.allocationsBefore;
    cost.locked += testing::lockCount() - cost.locksBefore;
    ++cost.callbacks;
  }
};

TEST_F(HdapiThreads, T3_AllocatesAndLocksNothingInTheCallback) {
  Cost cost;
  open();
  device->enableForce(true);
  loop.wanted_N = {0.5, 0.0, 0.0};
  fake.set_hook(&Cost::hook, &cost);
  device->start({&testing::FakeLoop::tick, &loop});

  fake.run(1'500);
  fake.push_error(hd::kExceededMaxForce, 0);
  fake.set_buttons(3);
  fake.run(10);
  fake.set_calibration(hd::kCalibrationNeedsUpdate);
  fake.run(2'500);
  fake.unplug();
  fake.run(1);
  fake.replug();

  EXPECT_EQ(cost.callbacks, 1'500 + 10 + 2'500 + 1);
  EXPECT_EQ(cost.allocations, 0);
  EXPECT_EQ(cost.locked, 0);
  EXPECT_EQ(testing::lockCount() > 0, testing::lockCountWorks()) << "the count does not count";
}

}  // namespace
}  // namespace torsio
