// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "sim/core/vec3.h"

namespace torsio::testing {

/// The peer of OpenIGTLink, made of the library's own classes: a tracker that waits for Torsio, or connects
/// to it. One thread; waits at most twenty seconds.
class FakeTracker {
 public:
  /// Listens on a free local port.
  FakeTracker();
  ~FakeTracker();
  FakeTracker(const FakeTracker&) = delete;
  FakeTracker& operator=(const FakeTracker&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// Waits for Torsio to connect. False: it did not.
  [[nodiscard]] bool wait();
  /// Connects to Torsio, retrying until it answers. False: it did not.
  [[nodiscard]] bool call(std::uint16_t port);
  void hangUp();

  /// Sends a TRANSFORM without rotation; `sent_us` 0: without a time stamp. False: disconnected.
  bool sendTransform(const std::string& device, const Vec3& place_mm, std::int64_t sent_us);
  /// Sends a TRANSFORM whose matrix starts with this number.
  bool sendTransformWith(const std::string& device, float first, std::int64_t sent_us);
  /// Sends a TDATA message with one instrument.
  bool sendTracking(const std::string& instrument, const Vec3& place_mm, std::int64_t sent_us);
  bool sendStatus(int code, const std::string& words);
  bool sendBytes(const std::string& bytes);
  /// Waits for a message; returns its kind, device and, for a STRING, its text or, for a TRANSFORM, its
  /// position in mm ("-1.0 2.5 10.0"). Empty kind: none.
  struct Message {
    std::string kind{};
    std::string device{};
    std::string content{};
  };
  [[nodiscard]] Message receive();

 private:
  struct Sockets;
  std::unique_ptr<Sockets> sockets_;
};

}  // namespace torsio::testing
