// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/steering/steered_device.h"

#include <atomic>
#include <chrono>
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

}  // namespace
}  // namespace torsio
