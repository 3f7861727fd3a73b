// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
#include <nlohmann/json.hpp>

#include "sim/core/deadline.h"
#include "sim/core/vec3.h"
#include "tests/support/eventually.h"

namespace torsio::testing {

/// The service of one Inverse3 with a handle, behind Qt's WebSocket server: it says once what is connected
/// and then answers every command with the state. Its values may be set from any thread.
class InverseService {
 public:
  std::atomic<double> x_m{0.0};
  std::atomic<double> y_m{-0.14};
  std::atomic<double> z_m{0.2};
  std::atomic<double> roll_rad{0.0};  ///< of the handle, about the way it points
  std::atomic<bool> buttonA{false};
  std::atomic<bool> connected{true};  ///< the device, to its service
  std::atomic<bool> silent{false};    ///< answers nothing more
  std::atomic<bool> garbles{false};   ///< answers what is no JSON
  std::atomic<bool> hangs{false};     ///< neither reads nor answers, the connection stays

  InverseService() {
    context_.moveToThread(&thread_);
    thread_.start();
    QMetaObject::invokeMethod(
        &context_, [this] { listen(); }, Qt::BlockingQueuedConnection);
    setenv("TORSIO_INVERSE_SERVICE", ("127.0.0.1:" + std::to_string(port_)).c_str(), 1);
  }
  ~InverseService() {
    hangs = false;
    end();
    thread_.quit();
    thread_.wait();
    unsetenv("TORSIO_INVERSE_SERVICE");
  }
  InverseService(const InverseService&) = delete;
  InverseService& operator=(const InverseService&) = delete;

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

  /// When the last force came.
  [[nodiscard]] std::chrono::steady_clock::time_point told() {
    const std::scoped_lock guard(mutex_);
    return told_;
  }
  /// How many clients are connected now.
  [[nodiscard]] int clients() const { return clients_.load(); }

 private:
  void listen() {
    // A service that answers late gets no force: under test it goes before other work where that is
    // permitted.
    (void)requestRealTime();
    server_ = std::make_unique<QWebSocketServer>(QStringLiteral("Inverse service"),
                                                 QWebSocketServer::NonSecureMode);
    server_->listen(QHostAddress::LocalHost, 0);
    port_ = server_->serverPort();
    QObject::connect(server_.get(), &QWebSocketServer::newConnection, &context_, [this] {
      QWebSocket* const client = server_->nextPendingConnection();
      client->setParent(server_.get());
      ++clients_;
      QObject::connect(client, &QWebSocket::disconnected, &context_, [this] { --clients_; });
      QObject::connect(client, &QWebSocket::textMessageReceived, &context_,
                       [this, client](const QString& text) {
                         take(text.toStdString());
                         QTimer::singleShot(1, client, [this, client] { say(*client); });
                       });
      say(*client);
    });
  }
  void say(QWebSocket& client) {
    while (hangs) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    if (silent) {
      return;
    }
    if (garbles) {
      client.sendTextMessage(QStringLiteral("{\"inverse3\":[{\"device_id\":\"04BA\",\"state\":{\"cursor"));
      return;
    }
    nlohmann::json state;
    state["inverse3"] = nlohmann::json::array();
    if (connected) {
      state["inverse3"].push_back(
          {{"device_id", "04BA"},
           {"config", {{"device_info", {{"firmware_version", "7.1"}}}}},
           {"state", {{"cursor_position", {{"x", x_m.load()}, {"y", y_m.load()}, {"z", z_m.load()}}}}}});
    }
    const double half_rad = 0.5 * roll_rad;
    state["wireless_verse_grip"] = nlohmann::json::array(
        {{{"device_id", "61576"},
          {"state",
           {{"orientation", {{"w", std::cos(half_rad)}, {"x", 0.0}, {"y", std::sin(half_rad)}, {"z", 0.0}}},
            {"buttons", {{"a", buttonA.load()}, {"b", false}, {"c", false}}}}}}});
    client.sendTextMessage(QString::fromStdString(state.dump()));
  }
  void take(const std::string& text) {
    const nlohmann::json values =
        nlohmann::json::parse(text)["inverse3"][0]["commands"]["set_cursor_force"]["values"];
    const std::scoped_lock guard(mutex_);
    told_ = std::chrono::steady_clock::now();
    forces_N_.push_back({values["x"].get<double>(), values["y"].get<double>(), values["z"].get<double>()});
  }

  QThread thread_;
  QObject context_;
  std::unique_ptr<QWebSocketServer> server_;
  quint16 port_ = 0;
  std::mutex mutex_;
  std::vector<Vec3> forces_N_;
  std::chrono::steady_clock::time_point told_{};
  std::atomic<int> clients_{0};
};

/// Whether it comes about within a minute.
template <typename Condition>
bool inTime(const Condition& condition) {
  return eventually(condition, std::chrono::seconds(60));
}

}  // namespace torsio::testing
