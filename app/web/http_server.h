// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace torsio::web {

/// A request within HttpLimits. Header names are lower-case.
struct HttpRequest {
  std::string method{};  ///< "GET"
  std::string path{};    ///< "/api/queue": decoded, with leading slash, without query
  std::map<std::string, std::string> headers{};
  std::string body{};
  std::string address{};  ///< of the peer, from the socket
  bool encrypted = false;

  [[nodiscard]] std::string header(const std::string& name) const;
  [[nodiscard]] std::string cookie(const std::string& name) const;
};

struct HttpResponse {
  int status = 200;
  std::string type = "application/json";  ///< Content-Type
  std::string body{};
  std::vector<std::pair<std::string, std::string>> headers{};
};

/// Address on which a server listens.
struct HttpAddress {
  std::string host = "127.0.0.1";  ///< IPv4 or IPv6 address, numeric
  std::uint16_t port = 8443;       ///< 0: any free port

  /// True if only this machine can connect.
  [[nodiscard]] bool isLoopback() const;
};
/// Reads "127.0.0.1:8443" or "[::1]:8443". Throws Error{kUsage}.
[[nodiscard]] HttpAddress addressOf(const std::string& text);

/// Certificate chain and private key, both PEM; empty: no encryption.
struct TlsMaterial {
  std::string certificate{};
  std::string key{};
};

struct HttpLimits {
  std::size_t headers_bytes = 32 * 1024;
  std::size_t body_bytes = 256 * 1024;
  unsigned connections = 1000;
  unsigned connectionsAnAddress =
      400;                  ///< a house behind one address: 200 pages that wait, and as many requests
  unsigned silent_s = 60;   ///< idle timeout
  unsigned request_s = 90;  ///< deadline for receiving a whole request, from the end of the previous one
  unsigned drain_s = 10;    ///< at the end: for answering what was received
};

/// HTTP/1.1 server; the only user of libmicrohttpd. Two network threads only read requests and write answers.
/// Rejects contradictory requests (two lengths, a length with chunked encoding).
class HttpServer {
 public:
  /// Sends the answer. Call it exactly once, from any thread, even after the server was destroyed.
  using Reply = std::function<void(HttpResponse)>;
  /// Called in a network thread; must return at once and not throw.
  using Handler = std::function<void(HttpRequest, Reply)>;

  /// Starts listening. Throws Error{kUsage}: unusable address; {kBadParameter}: certificate or key.
  HttpServer(const HttpAddress& address, const TlsMaterial& tls, const HttpLimits& limits, Handler handler);
  /// Accepts no more requests, waits for pending replies, then closes all connections; later replies are
  /// dropped.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] std::uint16_t port() const noexcept;

 private:
  struct Daemon;
  std::unique_ptr<Daemon> daemon_;
};

}  // namespace torsio::web
