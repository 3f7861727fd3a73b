// SPDX-License-Identifier: GPL-3.0-or-later
// The driver against a service behind Qt's own WebSocket server, which speaks the documented messages: it
// says once what is connected and then answers every command with the state.
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <QThread>
#include <QTimer>
#include <QWebSocket>
#include <QWebSocketServer>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/device/inverse3/inverse3_device.h"
#include "sim/device/inverse3/inverse3_driver.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"

namespace torsio {
namespace {

using Json = nlohmann::json;

/// The service of one Inverse3 with a handle. Its values may be set from any thread.
class Service {
 public:
  std::atomic<double> x_m{0.0};
  std::atomic<double> y_m{-0.14};
  std::atomic<double> z_m{0.2};
  std::atomic<double> roll_rad{0.0};  ///< of the handle, about the way it points
  std::atomic<bool> buttonA{false};
  std::atomic<bool> connected{true};  ///< the device, to its service
  std::atomic<bool> silent{false};    ///< answers nothing more

  Service() {
    context_.moveToThread(&thread_);
    thread_.start();
    QMetaObject::invokeMethod(
        &context_, [this] { listen(); }, Qt::BlockingQueuedConnection);
    setenv("TORSIO_INVERSE_SERVICE", ("127.0.0.1:" + std::to_string(port_)).c_str(), 1);
  }
  ~Service() {
    end();
    thread_.quit();
    thread_.wait();
    unsetenv("TORSIO_INVERSE_SERVICE");
  }
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;

  /// Ends as a service that is stopped.
  void end() {
    QMetaObject::invokeMethod(
        &context_, [this] { server_.reset(); }, Qt::BlockingQueuedConnection);
  }
  [[nodiscard]] std::vector<Vec3> forces_N() {
    const std::scoped_lock guard(mutex_);
    return forces_N_;
  }
  [[nodiscard]] Vec3 lastForce_N() {
    const std::scoped_lock guard(mutex_);
    return forces_N_.empty() ? Vec3{} : forces_N_.back();
  }

 private:
  void listen() {
    server_ = std::make_unique<QWebSocketServer>(QStringLiteral("Inverse service"),
                                                 QWebSocketServer::NonSecureMode);
    server_->listen(QHostAddress::LocalHost, 0);
    port_ = server_->serverPort();
    QObject::connect(server_.get(), &QWebSocketServer::newConnection, &context_, [this] {
      QWebSocket* const client = server_->nextPendingConnection();
      client->setParent(server_.get());
      QObject::connect(client, &QWebSocket::textMessageReceived, &context_,
                       [this, client](const QString& text) {
                         take(text.toStdString());
                         QTimer::singleShot(1, client, [this, client] { say(*client); });
                       });
      say(*client);
    });
  }
  void say(QWebSocket& client) {
    if (silent) {
      return;
    }
    Json state;
    state["inverse3"] = Json::array();
    if (connected) {
      state["inverse3"].push_back(
          {{"device_id", "04BA"},
           {"config", {{"device_info", {{"firmware_version", "7.1"}}}}},
           {"state", {{"cursor_position", {{"x", x_m.load()}, {"y", y_m.load()}, {"z", z_m.load()}}}}}});
    }
    const double half_rad = 0.5 * roll_rad;
    state["wireless_verse_grip"] = Json::array(
        {{{"device_id", "61576"},
          {"state",
           {{"orientation", {{"w", std::cos(half_rad)}, {"x", 0.0}, {"y", std::sin(half_rad)}, {"z", 0.0}}},
            {"buttons", {{"a", buttonA.load()}, {"b", false}, {"c", false}}}}}}});
    client.sendTextMessage(QString::fromStdString(state.dump()));
  }
  void take(const std::string& text) {
    const Json values = Json::parse(text)["inverse3"][0]["commands"]["set_cursor_force"]["values"];
    const std::scoped_lock guard(mutex_);
    forces_N_.push_back({values["x"].get<double>(), values["y"].get<double>(), values["z"].get<double>()});
  }

  QThread thread_;
  QObject context_;
  std::unique_ptr<QWebSocketServer> server_;
  quint16 port_ = 0;
  std::mutex mutex_;
  std::vector<Vec3> forces_N_;
};

template <typename Condition>
bool inTime(const Condition& condition) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < until) {
    if (condition()) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return false;
}

constexpr Vec3 kOrgan_m{0.1, 0.2, 0.3};
constexpr Vec3 kPush_N{0.4, -0.3, 0.2};

class Inverse3 : public ::testing::Test {
 protected:
  std::unique_ptr<Service> service_ = std::make_unique<Service>();
  std::unique_ptr<HapticDevice> device_;

  static DeviceRequest request() {
    DeviceRequest request;
    request.workspaceCentre_m = kOrgan_m;
    return request;
  }
  void open() {
    device_ = inverse3Driver().open(request());
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

TEST_F(Inverse3, IsFoundByItsIdAndSaysThatNobodyHasConfirmedIt) {
  const DriverFinding found = inverse3Driver().look(request());
  open();

  EXPECT_TRUE(found.available);
  EXPECT_NE(found.sentence.str().find("04BA"), std::string::npos);
  EXPECT_TRUE(device_->capabilities().rendersForce);
  EXPECT_DOUBLE_EQ(device_->capabilities().maxForce_N, 3.3);
  EXPECT_EQ(device_->identity().serial, "04BA");
  EXPECT_NE(device_->identity().notes.at(0).str().find("not confirmed on hardware"), std::string::npos);
}

TEST_F(Inverse3, WithoutServiceOrDeviceItIsNotThere) {
  service_->connected = false;
  const DriverFinding noDevice = inverse3Driver().look(request());
  service_.reset();
  setenv("TORSIO_INVERSE_SERVICE", "127.0.0.1:1", 1);
  const DriverFinding noService = inverse3Driver().look(request());

  EXPECT_FALSE(noDevice.available);
  EXPECT_NE(noDevice.sentence.str().find("no such device"), std::string::npos);
  EXPECT_FALSE(noService.available);
  EXPECT_NE(noService.sentence.str().find("127.0.0.1:1"), std::string::npos);
  EXPECT_THROW(static_cast<void>(inverse3Driver().open(request())), Error);
  unsetenv("TORSIO_INVERSE_SERVICE");
}

TEST_F(Inverse3, ItsCursorMovesTheTipAboutTheOrgan) {
  open();
  EXPECT_NEAR(norm(tool().pose.position_m - kOrgan_m), 0.0, 1e-6);

  service_->x_m = 0.03;
  service_->y_m = -0.10;

  EXPECT_TRUE(inTime([this] {
    return norm(tool().pose.position_m - kOrgan_m - Vec3{0.03, 0.04, 0.0}) < 1e-6;
  }));
}

TEST_F(Inverse3, TheHandleTurnsTheJawUnwrappedAndItsButtonClosesIt) {
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

TEST_F(Inverse3, AForceIsRenderedAfterARampAndOnlyWhenItWasAskedFor) {
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

TEST_F(Inverse3, NoMoreThanTheLimitIsSentAndNothingThatIsNoNumber) {
  open();
  device_->enableForce(true);

  EXPECT_TRUE(inTime([this] {
    device_->write({{0.0, 0.0, 100.0}, 0});
    return std::abs(service_->lastForce_N().z - 3.3) < 1e-9;
  }));
  device_->write({{std::nan(""), 0.0, 0.0}, 0});

  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
}

TEST_F(Inverse3, AForceThatIsNotRenewedEnds) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
}

TEST_F(Inverse3, ADroppedForceStaysAwayUntilTheNextWriteAndThenReturnsByTheRamp) {
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

TEST_F(Inverse3, TheServoTakesNoMemoryAndNoLockHere) {
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

TEST_F(Inverse3, ClosingSendsZeroLast) {
  open();
  device_->enableForce(true);
  ASSERT_TRUE(pushUntilFelt(kPush_N));

  EXPECT_TRUE(device_->close());

  EXPECT_TRUE(inTime([this] { return norm(service_->lastForce_N()) == 0.0; }));
  EXPECT_EQ(device_->snapshot().state, DeviceState::kClosed);
  EXPECT_FALSE(device_->snapshot().forceOn);
}

TEST_F(Inverse3, AServiceThatEndsOrFallsSilentIsALostDevice) {
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
    service_ = std::make_unique<Service>();
  }
}

TEST_F(Inverse3, ADeviceThatIsUnpluggedFromItsServiceIsInvalidThenLost) {
  open();

  service_->connected = false;

  EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceInvalid) != 0; }));
  EXPECT_TRUE(inTime([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
}

}  // namespace
}  // namespace torsio
