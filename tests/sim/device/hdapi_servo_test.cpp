// SPDX-License-Identifier: GPL-3.0-or-later
// Cases S1 to S5 and E1 to E8 of the haptics plan: the servo loop and everything that can go wrong in it.
#include <numeric>

#include "sim/core/error.h"
#include "tests/sim/device/hdapi_bench.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr double kServoRounding_N = 1e-9;

class HdapiServes : public testing::HdapiBench {
 protected:
  /// Runs until the full force is back; fails when it ever steps up by more than the slew limit.
  void expectRampedReturn() {
    double before_N = rendered_N().x;
    for (int i = 0; i < 4'000 && before_N < 1.0 - kServoRounding_N; ++i) {
      fake.run(1);
      ASSERT_LE(rendered_N().x - before_N, kSlewLimit_N_per_s * 1e-3 + kServoRounding_N);
      before_N = rendered_N().x;
    }
    EXPECT_NEAR(before_N, 1.0, kServoRounding_N);
  }
};

TEST_F(HdapiServes, S1_TearsDownInOrderWhenTheSchedulerDoesNotStart) {
  open();
  fake.fault("hdStartScheduler", 0, 1, hd::kTimerError, 0);
  const int begin = fake.log_count();

  const Error error = testing::refusal([&] { device->start({&testing::FakeLoop::tick, &loop}); });
  EXPECT_EQ(error.code(), ErrorCode::kDevice);
  EXPECT_NE(std::string(error.what()).find("servo timer"), std::string::npos) << error.what();

  EXPECT_EQ(fake.callbacks(), 0);
  EXPECT_EQ(fake.errors_pending(), 0);
  ASSERT_EQ(logged("hdStopScheduler", begin).size(), 1U);
  ASSERT_EQ(logged("hdUnschedule", begin).size(), 1U);
  ASSERT_EQ(logged("hdDisableDevice", begin).size(), 1U);
  EXPECT_LT(logged("hdStopScheduler", begin)[0], logged("hdUnschedule", begin)[0]);
  EXPECT_LT(logged("hdUnschedule", begin)[0], logged("hdDisableDevice", begin)[0]);
}

TEST_F(HdapiServes, S2_GoesOnAtTheLibrarysOwnRateWhenARateIsRefused) {
  for (const hd::ErrorCode refusal : {hd::kInvalidValue, hd::kInvalidOperation, hd::kTimerError}) {
    fake.reset();
    loop.ticks = 0;
    fake.fault("hdSetSchedulerRate", 0, 1, refusal, 0);

    start();
    fake.run(5);

    EXPECT_EQ(loop.ticks, 5);
    EXPECT_EQ(device->identity().notes,
              std::vector<Text>{Text::verbatim("The library keeps its own servo rate")});
    device.reset();
  }
}

TEST_F(HdapiServes, S3_ReportsAFullSchedulerOnceAndDoesNotAskAgain) {
  for (const hd::ErrorCode refusal : {hd::kSchedulerFull, hd::kInvalidPriority}) {
    fake.reset();
    open();
    fake.fault("hdScheduleAsynchronous", 0, -1, refusal, 0);

    EXPECT_THROW(device->start({&testing::FakeLoop::tick, &loop}), Error);

    EXPECT_EQ(fake.calls("hdScheduleAsynchronous"), 1);
    EXPECT_EQ(fake.calls("hdStartScheduler"), 0);
    device.reset();
  }
}

TEST_F(HdapiServes, S4_CountsASingleLateTickAndKeepsTheForce) {
  engageAtOneNewton();

  fake.advance_us(2'000);
  fake.run(1);  // 3 ms after the one before

  EXPECT_EQ(device->snapshot().timing.late, 1);
  EXPECT_EQ(device->snapshot().timing.gaps, 0);
  EXPECT_NEAR(rendered_N().x, 1.0, kServoRounding_N);
}

TEST_F(HdapiServes, S4_CutsTheForceAfterAGapAndEngagesByRamp) {
  for (const std::int64_t gap_us : {20'000, 1'000'000}) {
    fake.reset();
    engageAtOneNewton();

    fake.advance_us(gap_us);
    fake.run(1);

    EXPECT_EQ(rendered_N(), Vec3{});
    EXPECT_EQ(device->snapshot().timing.gaps, 1);
    expectRampedReturn();
    device.reset();
  }
}

TEST_F(HdapiServes, S4_SwitchesTheForceOffWhileTheServoIsSlowAndOnAgainWhenItIsNot) {
  engageAtOneNewton();

  fake.set_tick_us(2'500);  // 400 Hz
  fake.run(450);

  EXPECT_EQ(device->snapshot().state, DeviceState::kDegraded);
  EXPECT_NEAR(device->snapshot().timing.rate_Hz, 400.0, 1.0);
  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_EQ(fake.force_enabled(), 0);
  EXPECT_TRUE(loop.sample.status & kDeviceStale);

  fake.set_tick_us(1'000);
  fake.run(1'100);
  EXPECT_EQ(device->snapshot().state, DeviceState::kRunning);
  expectRampedReturn();
}

TEST_F(HdapiServes, S5_CountsTicksOverTheBudgetInTheHistogram) {
  loop.workEach_us = 50;
  start();
  fake.run(100);
  loop.workEach_us = 700;
  fake.run(1);
  loop.workEach_us = 50;
  fake.run(100);

  const TickStatistics timing = device->snapshot().timing;
  EXPECT_EQ(timing.overruns, 1);
  EXPECT_EQ(timing.slowest_us, 700);
  EXPECT_EQ(timing.durations[timingClass(50)], 200);
  EXPECT_EQ(timing.durations[timingClass(700)], 1);
  EXPECT_EQ(std::accumulate(timing.durations.begin(), timing.durations.end(), std::int64_t{0}), timing.ticks);
  EXPECT_EQ(std::accumulate(timing.intervals.begin(), timing.intervals.end(), std::int64_t{0}),
            timing.ticks - 1);
}

TEST_F(HdapiServes, E1_EndsTheServoAtACommunicationErrorAndCallsNothingMoreButTheTeardown) {
  engageAtOneNewton();

  fake.fault("hdBeginFrame", 0, 1, hd::kCommError, -28);
  fake.run(1);
  const int afterLoss = fake.log_count();
  fake.run(50);

  EXPECT_EQ(device->snapshot().state, DeviceState::kLost);
  EXPECT_EQ(device->snapshot().lostBecause, hd::kCommError);
  EXPECT_TRUE(loop.sample.status & kDeviceLost);  // the loop was told
  EXPECT_EQ(loop.sent.force_N, Vec3{});
  EXPECT_EQ(fake.callbacks(), 0);
  EXPECT_EQ(fake.log_count(), afterLoss);
  EXPECT_EQ(rendered_N(), Vec3{});

  EXPECT_TRUE(device->close());
  const std::vector<int> stop = logged("hdStopScheduler", afterLoss);
  const std::vector<int> unschedule = logged("hdUnschedule", afterLoss);
  const std::vector<int> disable = logged("hdDisableDevice", afterLoss);
  ASSERT_TRUE(stop.size() == 1 && unschedule.size() == 1 && disable.size() == 1);
  EXPECT_TRUE(stop[0] < unschedule[0] && unschedule[0] < disable[0]);
  EXPECT_EQ(fake.off_thread(), 0);
}

TEST_F(HdapiServes, E1_TellsTheLoopOfALossThatShowsOnlyWhenTheFrameEnds) {
  engageAtOneNewton();

  fake.fault("hdEndFrame", 0, 1, hd::kCommError, -28);
  fake.run(1);

  EXPECT_TRUE(loop.sample.status & kDeviceLost);
  EXPECT_EQ(loop.sent.force_N, Vec3{});
  EXPECT_EQ(device->snapshot().state, DeviceState::kLost);
}

TEST_F(HdapiServes, E2_NeverBlocksTheCallerWhenAnUnpluggedDeviceBlocksTheLibrary) {
  options.patience_us = 20'000;
  engageAtOneNewton();

  fake.unplug();
  fake.run(1);
  const DeviceSample frozen = loop.sample;
  device->beginClose();  // returns although hdStopScheduler does not
  const bool released = device->close();

  EXPECT_FALSE(released);
  EXPECT_TRUE(frozen.status & kDeviceLost);
  EXPECT_TRUE(frozen.status & kDeviceStale);
  EXPECT_EQ(loop.sent.force_N, Vec3{});
  EXPECT_EQ(device->snapshot().state, DeviceState::kClosed);
  fake.replug();
  while (!device->close()) {
  }
}

TEST_F(HdapiServes, E2_MarksMailboxReadingsStaleAndThenLostWhenNothingNewComes) {
  open();
  device->serve();
  EXPECT_TRUE(device->read(0).status & kDeviceStale);  // no frame yet
  fake.run(3);
  const DeviceSample fresh = device->read(1'000);
  const DeviceSample young = device->read(6'000);
  const DeviceSample stale = device->read(6'001);
  const DeviceSample lost = device->read(1'000 + kReadingLost_us + 1);
  fake.run(1);
  const DeviceSample back = device->read(400'000);

  EXPECT_EQ(fresh.status, static_cast<std::uint32_t>(kDeviceOk));
  EXPECT_EQ(young.status, static_cast<std::uint32_t>(kDeviceOk));
  EXPECT_EQ(stale.status, static_cast<std::uint32_t>(kDeviceStale));
  EXPECT_EQ(lost.status, static_cast<std::uint32_t>(kDeviceStale | kDeviceLost));
  EXPECT_EQ(back.status, static_cast<std::uint32_t>(kDeviceOk));
  EXPECT_EQ(back.time_us, 400'000);
}

TEST_F(HdapiServes, E2_SendsNoMailboxForceThatIsNotRenewed) {
  const FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  fake.set_pose(&pose);
  serveHalfNewton();

  fake.run(kForceExpires_us / 1'000);
  EXPECT_NEAR(rendered_N().x, 0.5, kServoRounding_N);
  fake.run(2);

  EXPECT_EQ(rendered_N(), Vec3{});
}

TEST_F(HdapiServes, E3_StaysLostAfterReplugUntilTheUserOpensItAgain) {
  engageAtOneNewton();
  fake.unplug();
  fake.run(5);
  fake.replug();
  fake.run(100);
  ASSERT_EQ(device->snapshot().state, DeviceState::kLost);
  EXPECT_EQ(fake.calls("hdInitDevice"), 1);

  device.reset();
  fake.set_calibration(hd::kCalibrationNeedsManualInput);  // lost by unplugging
  start();
  fake.run(1'500);
  EXPECT_EQ(device->snapshot().state, DeviceState::kNeedsCalibration);
  EXPECT_EQ(rendered_N(), Vec3{});
  fake.dock(1);
  fake.run(2'200);
  EXPECT_EQ(device->snapshot().state, DeviceState::kRunning);
  EXPECT_EQ(rendered_N(), Vec3{});  // the inkwell lies outside the workspace
  const FakePose out{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  fake.set_pose(&out);
  expectRampedReturn();
}

TEST_F(HdapiServes, E4_FoldsBackWithHysteresisAndSurvivesThreeAndSixTemperatures) {
  for (const int motors : {3, 6}) {
    fake.reset();
    start();
    const auto statusAt = [&](double warmest) {
      std::vector<double> temperatures(static_cast<std::size_t>(motors), 0.1);
      temperatures.back() = warmest;
      fake.set_temperature(temperatures.data(), motors);
      fake.run(2);
      return loop.sample.status;
    };

    EXPECT_EQ(statusAt(0.6), static_cast<std::uint32_t>(kDeviceOk));
    EXPECT_EQ(statusAt(0.75), static_cast<std::uint32_t>(kDeviceWarm));
    EXPECT_EQ(statusAt(0.6), static_cast<std::uint32_t>(kDeviceWarm));
    EXPECT_EQ(statusAt(0.45), static_cast<std::uint32_t>(kDeviceOk));
    EXPECT_EQ(statusAt(0.6), static_cast<std::uint32_t>(kDeviceOk));
    device.reset();
  }
}

TEST_F(HdapiServes, E4_FoldsTheForceBackToTheContinuousOneAndLetsItReturnSlowly) {
  const FakePose pose{{0, 0, 0}, {0, 0, 0}, 1, {0, 0, 0}};
  fake.set_pose(&pose);
  loop.wanted_N = {1.0, 0.0, 0.0};
  engage();
  const std::vector<double> warm(3, 0.75);
  const std::vector<double> cool(3, 0.45);

  fake.set_temperature(warm.data(), 3);
  fake.run(1'500);
  const double folded_N = rendered_N().x;
  fake.set_temperature(cool.data(), 3);
  fake.run(1'500);

  EXPECT_NEAR(folded_N, 0.88, kServoRounding_N);
  EXPECT_NEAR(rendered_N().x, 1.0, kServoRounding_N);
}

TEST_F(HdapiServes, E4_SwitchesTheForceOffWhenTheLibrarySaysThatTheMotorsAreWarm) {
  engageAtOneNewton();
  const std::vector<double> warm(3, 0.6);
  fake.set_temperature(warm.data(), 3);
  fake.push_error(hd::kWarmMotors, 0);
  fake.run(1);

  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_EQ(device->snapshot().state, DeviceState::kDegraded);
  fake.run(3'000);
  EXPECT_EQ(rendered_N(), Vec3{});  // not below the lower threshold yet

  const std::vector<double> cool(3, 0.45);
  fake.set_temperature(cool.data(), 3);
  fake.run(1);
  expectRampedReturn();
}

TEST_F(HdapiServes, E5_EngagesAnewAfterTheDevicesProtectionTripped) {
  for (const hd::ErrorCode trip :
       {hd::kExceededMaxForce, hd::kExceededMaxForceImpulse, hd::kExceededMaxVelocity}) {
    fake.reset();
    engageAtOneNewton();

    fake.push_error(trip, 0);
    fake.run(1);

    EXPECT_EQ(rendered_N(), Vec3{});
    EXPECT_TRUE(loop.sample.status & kDeviceInvalid);
    EXPECT_EQ(device->snapshot().forceTrips, 1);
    expectRampedReturn();
    device.reset();
  }
}

TEST_F(HdapiServes, E5_StaysInhibitedAfterRepeatedTrips) {
  engageAtOneNewton();
  for (int trip = 0; trip <= kFaultsForgiven; ++trip) {
    fake.push_error(hd::kExceededMaxForce, 0);
    fake.run(2'500);
  }

  EXPECT_EQ(loop.governor.state(), GovernorState::kInhibited);
  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_EQ(device->snapshot().forceTrips, 1 + kFaultsForgiven);
}

TEST_F(HdapiServes, E6_LosesTheDeviceAtADeviceFault) {
  engageAtOneNewton();

  fake.push_error(hd::kDeviceFault, 0);
  fake.run(1);

  EXPECT_EQ(device->snapshot().state, DeviceState::kLost);
  EXPECT_EQ(device->snapshot().lostBecause, hd::kDeviceFault);
  EXPECT_EQ(fake.callbacks(), 0);
}

TEST_F(HdapiServes, E7_TakesAllErrorsOfATickInTheirOrderAndObeysTheWorst) {
  engageAtOneNewton();
  (void)events(DeviceEvent::Kind::kError);

  fake.push_error(hd::kExceededMaxForce, 1);
  fake.push_error(hd::kCommError, 2);
  fake.push_error(hd::kInvalidEnum, 3);
  fake.run(1);

  const std::vector<DeviceEvent> errors = events(DeviceEvent::Kind::kError);
  ASSERT_EQ(errors.size(), 3U);
  EXPECT_EQ(errors[0].code, hd::kExceededMaxForce);
  EXPECT_EQ(errors[1].code, hd::kCommError);
  EXPECT_EQ(errors[2].code, hd::kInvalidEnum);
  EXPECT_EQ(errors[1].detail, 2);
  EXPECT_EQ(device->snapshot().state, DeviceState::kLost);
  EXPECT_EQ(fake.errors_pending(), 0);
}

TEST_F(HdapiServes, E7_IsNotHeldUpByAnEndlessStreamOfErrors) {
  start();
  fake.fault("hdGetError", 0, 200, hd::kInvalidEnum, 0);  // every look at the stack finds a new one

  fake.run(40);

  EXPECT_EQ(loop.ticks, 40);
  EXPECT_NE(device->snapshot().state, DeviceState::kLost);
}

TEST_F(HdapiServes, E8_EndsNoFrameThatCouldNotBeginAndSendsNothingInTheNextTick) {
  engageAtOneNewton();
  const int ends = fake.calls("hdEndFrame");

  fake.fault("hdBeginFrame", 0, 1, hd::kFrameError, 0);
  fake.run(1);

  EXPECT_EQ(fake.calls("hdEndFrame"), ends);
  EXPECT_EQ(fake.rule_breaks(), 0);
  EXPECT_TRUE(loop.sample.status & kDeviceStale);
  fake.run(1);
  EXPECT_EQ(rendered_N(), Vec3{});
  EXPECT_EQ(fake.calls("hdEndFrame"), ends + 1);
  expectRampedReturn();
}

}  // namespace
}  // namespace torsio
