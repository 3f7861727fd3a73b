// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/steered_device.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/allocation_count.h"
#include "tests/support/eventually.h"
#include "tests/support/lock_count.h"

namespace torsio {
namespace {

/// What a test decides about a device from another thread.
struct Plug {
  std::atomic<bool> plugged{true};
  std::atomic<bool> hangs{false};
  std::atomic<bool> hanging{false};  ///< a poll does not come back
  std::atomic<std::uint32_t> buttons{0};
};

class PluggedSource final : public SteeringSource {
 public:
  explicit PluggedSource(std::shared_ptr<Plug> plug) : plug_(std::move(plug)) {}
  [[nodiscard]] std::optional<SteeringInput> poll() override {
    while (plug_->hangs.load()) {
      plug_->hanging = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (!plug_->plugged.load()) {
      return std::nullopt;
    }
    return SteeringInput{.move = {1.0, 0.0, 0.0}, .buttons = plug_->buttons.load()};
  }

 private:
  std::shared_ptr<Plug> plug_;
};

class Steered : public ::testing::Test {
 protected:
  std::shared_ptr<Plug> plug_ = std::make_shared<Plug>();
  SteeredDevice device_{std::make_unique<PluggedSource>(plug_), identity(), request()};

  static DeviceIdentity identity() {
    DeviceIdentity identity;
    identity.model = "Puck";
    return identity;
  }
  static DeviceRequest request() {
    DeviceRequest request;
    request.start.position_m = {0.1, 0.0, 0.2};
    request.workspaceCentre_m = {0.0, 0.0, 0.2};
    return request;
  }
  void serveUntilRead() {
    device_.serve();
    ASSERT_TRUE(testing::eventually([this] { return device_.read(0).status == kDeviceOk; }));
  }
};

TEST_F(Steered, RendersNoForceAndTwistsByRoll) {
  EXPECT_EQ(device_.capabilities().model, "Puck");
  EXPECT_FALSE(device_.capabilities().rendersForce);
  EXPECT_EQ(device_.capabilities().drive, TwistDrive::kRoll);
  EXPECT_DOUBLE_EQ(device_.capabilities().workspaceMax_m.x, kSteeringReach_m);
}

TEST_F(Steered, IsStaleUntilItsThreadHasSpokenAndReadyAfterwards) {
  const DeviceSample before = device_.read(0);

  serveUntilRead();

  EXPECT_EQ(before.status, static_cast<std::uint32_t>(kDeviceStale));
  EXPECT_TRUE(testing::eventually([this] { return device_.snapshot().state == DeviceState::kReady; }));
  EXPECT_EQ(device_.snapshot().calibration, CalibrationState::kCalibrated);
  EXPECT_TRUE(testing::eventually([this] { return toolState(device_.read(0)).pose.position_m.x > 0.101; }));
}

TEST_F(Steered, ReportsALostDeviceInReadingSnapshotAndEvent) {
  serveUntilRead();

  plug_->plugged = false;

  EXPECT_TRUE(testing::eventually([this] { return (device_.read(0).status & kDeviceLost) != 0; }));
  EXPECT_TRUE(testing::eventually([this] { return device_.snapshot().state == DeviceState::kLost; }));
  DeviceEvent event;
  ASSERT_TRUE(testing::eventually([&] { return device_.nextEvent(event); }));
  EXPECT_EQ(event.kind, DeviceEvent::Kind::kLost);
  EXPECT_FALSE(device_.lossText(device_.snapshot().lostBecause).empty());
}

TEST_F(Steered, AThreadThatHangsMakesTheReadingStaleThenLost) {
  serveUntilRead();

  plug_->hangs = true;
  ASSERT_TRUE(testing::eventually([this] { return plug_->hanging.load(); }));  // the poll before it has ended
  const DeviceSample last = device_.read(1'000'000);
  const DeviceSample stale = device_.read(1'000'000 + kSteeringStale_us + 1);
  const DeviceSample lost = device_.read(1'000'000 + kSteeringLost_us + 1);
  plug_->hangs = false;

  EXPECT_EQ(stale.position, last.position);
  EXPECT_EQ(stale.status, static_cast<std::uint32_t>(kDeviceStale));
  EXPECT_EQ(lost.status, static_cast<std::uint32_t>(kDeviceStale | kDeviceLost));
}

TEST_F(Steered, ButtonsAreEventsThatNoLaterOneOverwrites) {
  serveUntilRead();

  plug_->buttons = kButtonSecond;
  ASSERT_TRUE(testing::eventually([this] { return device_.read(0).buttons == kButtonSecond; }));
  plug_->buttons = 0;
  ASSERT_TRUE(testing::eventually([this] { return device_.read(0).buttons == 0; }));

  DeviceEvent pressed;
  DeviceEvent released;
  ASSERT_TRUE(device_.nextEvent(pressed));
  ASSERT_TRUE(device_.nextEvent(released));
  EXPECT_EQ(pressed.value, static_cast<std::uint32_t>(kButtonSecond));
  EXPECT_EQ(released.value, 0U);
  EXPECT_LT(pressed.time_us, released.time_us);
}

TEST_F(Steered, ReadingTakesNoMemoryAndNoLock) {
  serveUntilRead();
  const std::int64_t taken = testing::allocationCount();
  const std::int64_t locked = testing::lockCount();

  for (int i = 0; i < 1000; ++i) {
    static_cast<void>(device_.read(i * 1000));
    device_.write({});
  }

  EXPECT_EQ(testing::allocationCount() - taken, 0);
  EXPECT_EQ(testing::lockCount() - locked, 0);
}

TEST_F(Steered, CanBeClosedTwice) {
  serveUntilRead();

  EXPECT_TRUE(device_.close());
  EXPECT_TRUE(device_.close());
  EXPECT_EQ(device_.snapshot().state, DeviceState::kClosed);
}

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
