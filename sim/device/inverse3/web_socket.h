// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace torsio {

/// The client's end of a WebSocket (RFC 6455): text messages both ways, without extensions, without TLS. One
/// thread at a time.
class WebSocket {
 public:
  /// Longest message that is taken; a longer one ends the connection.
  static constexpr std::size_t kLongest = 1U << 20U;

  /// Connects and shakes hands. Throws Error{kDevice} without an answer within `patience_us`.
  WebSocket(const std::string& host, int port, std::int64_t patience_us);
  /// Says goodbye and closes.
  ~WebSocket();
  WebSocket(const WebSocket&) = delete;
  WebSocket& operator=(const WebSocket&) = delete;

  /// Waits at most `wait_us` for a text message. False: none came, or the connection is closed().
  [[nodiscard]] bool receive(std::string& text, std::int64_t wait_us);
  /// Sends a text message; the connection is closed() when it cannot be handed on at once.
  void send(const std::string& text);
  [[nodiscard]] bool closed() const noexcept;

 private:
  struct Wire;
  std::unique_ptr<Wire> wire_;
};

}  // namespace torsio
