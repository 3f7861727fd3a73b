// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "app/web/http_message.h"

namespace torsio::web {

/// Where a server listens.
struct HttpAddress {
  std::string host = "127.0.0.1";  ///< IPv4 or IPv6 address, numeric
  std::uint16_t port = 8443;       ///< 0: any that is free

  /// Whether only this machine reaches it.
  [[nodiscard]] bool isLoopback() const;
};
/// Reads "127.0.0.1:8443" or "[::1]:8443". Throws Error{kUsage}.
[[nodiscard]] HttpAddress addressOf(const std::string& text);

/// Certificate chain and key, both PEM; empty: not encrypted.
struct TlsMaterial {
  std::string certificate{};
  std::string key{};
};

struct HttpLimits {
  std::size_t headers_bytes = 32 * 1024;
  std::size_t body_bytes = 256 * 1024;
  unsigned connections = 1000;
  unsigned connectionsAnAddress = 64;
  unsigned silent_s = 60;   ///< without a byte
  unsigned request_s = 90;  ///< for a request to come in whole, counted from the end of the one before
};

/// HTTP/1.1 over libmicrohttpd, the only place that knows that library. Two network threads read requests and
/// write answers; nothing else happens there. What contradicts itself (two lengths, a length beside chunks)
/// is refused here.
class HttpServer {
 public:
  /// Gives the answer; exactly once, from any thread, also after the server was destroyed.
  using Reply = std::function<void(HttpResponse)>;
  /// Called in a network thread; returns at once and throws nothing.
  using Handler = std::function<void(HttpRequest, Reply)>;

  /// Listens at once. Throws Error{kUsage}: the address cannot be used; {kBadParameter}: certificate or key.
  HttpServer(const HttpAddress& address, const TlsMaterial& tls, const HttpLimits& limits, Handler handler);
  /// Ends all connections; replies that come later are dropped.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept;

 private:
  struct Daemon;
  std::unique_ptr<Daemon> daemon_;
};

}  // namespace torsio::web
