// SPDX-License-Identifier: GPL-3.0-or-later
// The driver against a service that speaks the documented messages, in this process and in the device
// process.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/deadline.h"
#include "sim/core/error.h"
#include "sim/device/inverse3/inverse3_device.h"
#include "sim/device/process/device_process.h"
#include "tests/sim/device/inverse_service.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"

namespace torsio {
namespace {

using Json = nlohmann::json;
using testing::inTime;
using testing::InverseService;

constexpr Vec3 kOrgan_m{0.1, 0.2, 0.3};
constexpr Vec3 kPush_N{0.4, -0.3, 0.2};

/// The parameter: whether the driver runs in the device process.
class Inverse3 : public ::testing::TestWithParam<bool> {
 protected:
  std::unique_ptr<InverseService> service_ = std::make_unique<InverseService>();
  std::unique_ptr<HapticDevice> device_;

  static void SetUpTestSuite() {
    setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1);
    (void)requestRealTime();  // a force that is renewed late ends
  }
  static DeviceDriver driver() { return hosted(inverse3Driver()); }
  static DeviceRequest request() {
    DeviceRequest request;
    request.workspaceCentre_m = kOrgan_m;
    request.inThisProcess = !GetParam();
    return request;
  }
  void open() {
    device_ = driver().open(request());
    device_->serve();
    ASSERT_TRUE(inTime([this] { return device_->read(0).status == kDeviceOk; }));
  }
  [[nodiscard]] ToolState tool() { return toolState(device_->read(0)); }
  /// Renews the force until the service was told it, as a servo does.
  bool pushUntilFelt(const Vec3& force_N) {
    return inTime([&] {
      device_->write({force_N, 0});
      return norm(service_->lastForce_N() - force_N) < 1e-9;
    });
  }
};

TEST(Inverse3Messages, ReadsADocumentedState) {
  const auto message = inverse3Message(
      R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0.01,"y":-0.1,"z":0.2}}},{"device_id":"B"}],)"
      R"("wireless_verse_grip":[{"device_id":"G","state":{"orientation":{"w":1,"x":0,"y":0,"z":0},)"
      R"("buttons":{"a":true,"b":false,"c":true}}}]})",
      "");

  ASSERT_TRUE(message);
  EXPECT_EQ(message->deviceId, "A");
  EXPECT_EQ(message->cursor_m, (Vec3{0.01, -0.1, 0.2}));
  EXPECT_EQ(message->orientation, Quat{});
  EXPECT_EQ(message->buttons, static_cast<std::uint32_t>(kButtonGrip | kButtonBookmark));
}

TEST(Inverse3Messages, WhatIsMissingOrWrongIsEmptyAndNeverThrows) {
  EXPECT_FALSE(inverse3Message("", ""));
  EXPECT_FALSE(inverse3Message("[1, 2]", ""));
  EXPECT_EQ(inverse3Message(R"({"inverse3":7})", "")->deviceId, "");
  EXPECT_EQ(inverse3Message(R"({"inverse3":[{"device_id":"A"}]})", "B")->deviceId, "");
  for (const char* const x : {"null", "\"0.1\"", "1e300", "2.0"}) {
    const std::string json =
        std::string(R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":)") + x +
        R"(,"y":0,"z":0}}}]})";
    EXPECT_FALSE(inverse3Message(json, "")->cursor_m) << x;
  }
}

TEST(Inverse3Messages, AForceIsWrittenAsTheServiceTakesIt) {
  const Json command = Json::parse(inverse3Force("A", {1.0, -2.0, 3.0}));

  EXPECT_EQ(command["inverse3"][0]["device_id"], "A");
  const Json& values = command["inverse3"][0]["commands"]["set_cursor_force"]["values"];
  EXPECT_EQ(values["x"], 1.0);
  EXPECT_EQ(values["y"], -2.0);
  EXPECT_EQ(values["z"], 3.0);
}

TEST_P(Inverse3, IsFoundByItsIdAndSaysThatNobodyHasConfirmedIt) {
  const DriverFinding found = driver().look(request());
  open();

  EXPECT_TRUE(found.available);
  EXPECT_NE(found.sentence.str().find("04BA"), std::string::npos);
  EXPECT_TRUE(device_->capabilities().rendersForce);
  EXPECT_DOUBLE_EQ(device_->capabilities().maxForce_N, 3.3);
  EXPECT_EQ(device_->identity().serial, "04BA");
  EXPECT_NE(device_->identity().notes.at(0).str().find("not confirmed on hardware"), std::string::npos);
}

TEST_P(Inverse3, WithoutServiceOrDeviceItIsNotThere) {
  service_->connected = false;
  const DriverFinding noDevice = driver().look(request());
  service_.reset();
  setenv("TORSIO_INVERSE_SERVICE", "127.0.0.1:1", 1);
  const DriverFinding noService = driver().look(request());

  EXPECT_FALSE(noDevice.available);
  EXPECT_NE(noDevice.sentence.str().find("no such device"), std::string::npos);
  EXPECT_FALSE(noService.available);
  EXPECT_NE(noService.sentence.str().find("127.0.0.1:1"), std::string::npos);
  EXPECT_THROW(static_cast<void>(driver().open(request())), Error);
  unsetenv("TORSIO_INVERSE_SERVICE");
}

TEST_P(Inverse3, ItsCursorMovesTheTipAboutTheOrgan) {
  open();
  EXPECT_NEAR(norm(tool().pose.position_m - kOrgan_m), 0.0, 1e-6);

  service_->x_m = 0.03;
  service_->y_m = -0.10;

  EXPECT_TRUE(inTime([this] {
    return norm(tool().pose.position_m - kOrgan_m - Vec3{0.03, 0.04, 0.0}) < 1e-6;
  }));
}

TEST_P(Inverse3, TheHandleTurnsTheJawUnwrappedAndItsButtonClosesIt) {
  open();
  for (double turn_rad = 0.0; turn_rad < 4.0; turn_rad += 0.5) {
    service_->roll_rad = turn_rad;
    // The stylus points along y, its own z the other way: what the handle turns about y is the opposite about
    // z.
    ASSERT_TRUE(inTime([&] { return std::abs(tool().roll_rad + turn_rad) < 1e-6; })) << turn_rad;
  }
  service_->buttonA = true;

  EXPECT_TRUE(inTime([this] { return tool().grip > 0.999; }));
  EXPECT_NE(tool().buttons & kButtonGrip, 0U);
}

TEST_P(Inverse3, AForceIsRenderedAfterARampAndOnlyWhenItWasAskedFor) {
  open();
  for (int i = 0; i < 100; ++i) {
    device_->write({kPush_N, 0});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_EQ(norm(service_->lastForce_N()), 0.0) << "nobody has asked for force";

  device_->enableForce(true);

  EXPECT_TRUE(pushUntilFelt(kPush_N));
  EXPECT_TRUE(device_->snapshot().forceOn);
  const std::vector<Vec3> sent_N = service_->forces_N();
  double longest_N = 0.0;
  for (std::size_t i = 1; i < sent_N.size(); ++i) {
    longest_N = std::max(longest_N, norm(sent_N[i]) - norm(sent_N[i - 1]));
  }
  // The ramp of half a second moves on by a millisecond a message at most: 1/500 of the force.
  EXPECT_LT(longest_N, norm(kPush_N) / 500.0 + 1e-9);
}

TEST_P(Inverse3, NoMoreThanTheLimitIsSentAndNothingThatIsNoNumber) {
  open();
  device_->enableForce(true);

  EXPECT_TRUE(inTime([this] {
    device_->write({{0.0, 0.0, 100.0}, 0});
    return std::abs(service_->lastForce_N().z - 3.3) < 1e-9;
  }));
  device_->write({{std::nan(""), 0.0, 0.0}, 0});

  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
}

TEST_P(Inverse3, AForceThatIsNotRenewedEnds) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
}

TEST_P(Inverse3, ADroppedForceStaysAwayUntilTheNextWriteAndThenReturnsByTheRamp) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  device_->dropForce();
  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
  device_->write({kPush_N, 0});
  std::this_thread::sleep_for(std::chrono::milliseconds(5));

  EXPECT_LT(norm(service_->lastForce_N()), 0.5 * norm(kPush_N));
  EXPECT_TRUE(pushUntilFelt(kPush_N));
}

TEST_P(Inverse3, TheServoTakesNoMemoryAndNoLockHere) {
  open();
  const std::int64_t taken = testing::allocationCount();
  const std::int64_t locked = testing::lockCount();

  for (int i = 0; i < 1000; ++i) {
    static_cast<void>(device_->read(i * 1000));
    device_->write({kPush_N, 0});
  }
  device_->dropForce();

  EXPECT_EQ(testing::allocationCount() - taken, 0);
  EXPECT_EQ(testing::lockCount() - locked, 0);
}

TEST_P(Inverse3, ClosingSendsZeroLast) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  EXPECT_TRUE(device_->close());

  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
  EXPECT_EQ(device_->snapshot().state, DeviceState::kClosed);
  EXPECT_FALSE(device_->snapshot().forceOn);
}

TEST_P(Inverse3, AServiceThatEndsOrFallsSilentIsALostDevice) {
  for (const bool ends : {true, false}) {
    open();
    device_->enableForce(true);

    if (ends) {
      service_->end();
    } else {
      service_->silent = true;
    }

    EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceLost) != 0; })) << ends;
    EXPECT_TRUE(inTime([this] { return device_->snapshot().state == DeviceState::kLost; })) << ends;
    EXPECT_FALSE(device_->snapshot().forceOn);
    device_.reset();
    service_.reset();
    service_ = std::make_unique<InverseService>();
  }
}

TEST_P(Inverse3, ADeviceThatIsUnpluggedFromItsServiceIsInvalidThenLost) {
  open();

  service_->connected = false;

  EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceInvalid) != 0; }));
  EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
}

TEST_P(Inverse3, AServiceThatAnswersRubbishGetsZeroAndIsALostDevice) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  service_->garbles = true;

  EXPECT_TRUE(inTime([this] {
    device_->write({kPush_N, 0});
    return norm(service_->lastForce_N()) == 0.0;
  }));
  EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
  EXPECT_TRUE(inTime([this] { return device_->snapshot().state == DeviceState::kLost; }));
}

TEST_P(Inverse3, AHangingServiceBlocksNothing) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  service_->hangs = true;

  EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
  const auto begun = std::chrono::steady_clock::now();
  device_->close();
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(3));
  service_->hangs = false;
  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }))
      << "what it finds when it goes on";
}

INSTANTIATE_TEST_SUITE_P(InThisProcess, Inverse3, ::testing::Values(false));
INSTANTIATE_TEST_SUITE_P(InTheDeviceProcess, Inverse3, ::testing::Values(true));

/// The newest process that this one has started.
pid_t newestChild() {
  pid_t newest = 0;
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::ifstream children(task.path() / "children");
    for (pid_t child = 0; children >> child;) {
      newest = std::max(newest, child);
    }
  }
  return newest;
}

TEST(Inverse3Process, WhenTheDeviceProcessEndsOrStopsASecondOneSendsTheServiceZero) {
  setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1);
  (void)requestRealTime();
  for (const int signal : {SIGKILL, SIGSTOP, SIGQUIT, SIGSEGV}) {
    InverseService service;
    const std::unique_ptr<HapticDevice> device = hosted(inverse3Driver()).open({});
    device->serve();
    device->enableForce(true);
    const auto push = [&] { device->write({kPush_N, 0}); };
    ASSERT_TRUE(inTime([&] {
      push();
      return norm(service.lastForce_N() - kPush_N) < 1e-9;
    }));

    kill(newestChild(), signal);

    EXPECT_TRUE(inTime([&] {
      push();
      return norm(service.lastForce_N()) == 0.0;
    })) << signal;
    EXPECT_TRUE(inTime([&] { return device->snapshot().state == DeviceState::kLost; })) << signal;
    EXPECT_NE(device->lossText(device->snapshot().lostBecause).str().find("switched its force off"),
              std::string::npos)
        << device->lossText(device->snapshot().lostBecause).str();
    EXPECT_TRUE(inTime([&] { return service.clients() == 0; })) << signal;
    EXPECT_EQ(norm(service.lastForce_N()), 0.0) << signal;
  }
}

TEST(Inverse3Process, WhenTheProgramIsKilledTheServiceIsSentZeroAndTheDeviceProcessEnds) {
  setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1);
  (void)requestRealTime();
  InverseService service;
  const pid_t program = fork();
  if (program == 0) {
    const std::unique_ptr<HapticDevice> device = hosted(inverse3Driver()).open({});
    device->serve();
    device->enableForce(true);
    for (;;) {
      device->write({kPush_N, 0});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  ASSERT_GT(program, 0);
  EXPECT_TRUE(inTime([&] { return norm(service.lastForce_N() - kPush_N) < 1e-9; }));

  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);

  EXPECT_TRUE(inTime([&] { return norm(service.lastForce_N()) == 0.0; }));
  EXPECT_TRUE(inTime([&] { return service.clients() == 0; }));
}

}  // namespace
}  // namespace torsio
