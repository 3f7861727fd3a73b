// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include "sim/core/error.h"
#include "sim/device/inverse3/web_socket.h"

namespace torsio {

namespace {

using Time = std::chrono::steady_clock;

constexpr unsigned kFinal = 0x80;
constexpr unsigned kMasked = 0x80;
constexpr unsigned kContinued = 0x0;
constexpr unsigned kText = 0x1;
constexpr unsigned kClose = 0x8;
constexpr unsigned kPing = 0x9;
constexpr unsigned kPong = 0xA;

[[noreturn]] void refuseConnection(const std::string& host, int port) {
  throw Error(ErrorCode::kDevice, Text::tr("no service answers at %1", host + ":" + std::to_string(port)),
              Text::verbatim("WebSocket"),
              Text::tr("Install the device's service and start it (docs/devices.md)"));
}

int remaining_ms(Time::time_point until) {
  const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Time::now()).count();
  return left > 0 ? static_cast<int>(left) : 0;
}

}  // namespace

struct WebSocket::Wire {
  int file = -1;
  std::string came;     // bytes that are not taken yet
  std::string message;  // of one that comes in parts
  std::uint32_t mask = 0x9e3779b9U;

  ~Wire() { close(); }
  void close() noexcept {
    if (file >= 0) {
      ::close(file);
    }
    file = -1;
  }
  bool connectTo(const std::string& host, int port, Time::time_point until) {
    addrinfo hints{};
    hints.ai_family = AF_UNSPEC;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
      return false;
    }
    for (const addrinfo* place = found; place != nullptr && file < 0; place = place->ai_next) {
      file = ::socket(place->ai_family, place->ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
      const bool begun =
          file >= 0 && (::connect(file, place->ai_addr, place->ai_addrlen) == 0 || errno == EINPROGRESS);
      pollfd ready{file, POLLOUT, 0};
      int problem = 0;
      socklen_t size = sizeof(problem);
      if (!begun || ::poll(&ready, 1, remaining_ms(until)) <= 0 ||
          getsockopt(file, SOL_SOCKET, SO_ERROR, &problem, &size) != 0 || problem != 0) {
        close();
      }
    }
    freeaddrinfo(found);
    const int now = 1;  // a force must not wait for more to send
    return file >= 0 && setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &now, sizeof(now)) == 0;
  }
  /// Takes what has come, waiting at most until then. False: nothing, or closed.
  bool fill(Time::time_point until) {
    if (file < 0) {
      return false;
    }
    pollfd ready{file, POLLIN, 0};
    if (::poll(&ready, 1, remaining_ms(until)) <= 0) {
      return false;
    }
    std::array<char, 16'384> part;
    const ssize_t got = ::recv(file, part.data(), part.size(), 0);
    if (got <= 0) {
      if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
        close();
      }
      return false;
    }
    came.append(part.data(), static_cast<std::size_t>(got));
    return true;
  }
  void put(const std::string& bytes) {
    // A full system buffer means that the service stopped reading long ago.
    if (file >= 0 &&
        ::send(file, bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size())) {
      close();
    }
  }
  void putFrame(unsigned code, const std::string& content) {
    std::string frame(1, static_cast<char>(kFinal | code));
    if (content.size() < 126) {
      frame += static_cast<char>(kMasked | content.size());
    } else {
      frame += static_cast<char>(kMasked | 126U);
      frame += static_cast<char>(content.size() >> 8U & 0xffU);
      frame += static_cast<char>(content.size() & 0xffU);
    }
    mask = mask * 1664525U + 1013904223U;
    std::array<char, 4> key;
    std::memcpy(key.data(), &mask, key.size());
    frame.append(key.data(), key.size());
    for (std::size_t i = 0; i < content.size(); ++i) {
      frame += static_cast<char>(content[i] ^ key[i % 4]);
    }
    put(frame);
  }
  /// Takes one frame off what has come; false when it is not complete. A frame that breaks the rules closes.
  bool takeFrame(unsigned& code, bool& final, std::string& content) {
    if (came.size() < 2) {
      return false;
    }
    const auto byte = [this](std::size_t i) {
      return static_cast<unsigned>(static_cast<unsigned char>(came[i]));
    };
    const unsigned shortSize = byte(1) & 0x7fU;
    const std::size_t extra = shortSize == 127 ? 8 : (shortSize == 126 ? 2 : 0);
    if (came.size() < 2 + extra) {
      return false;
    }
    std::uint64_t size = extra == 0 ? shortSize : 0;
    for (std::size_t i = 0; i < extra; ++i) {
      size = size << 8U | byte(2 + i);
    }
    if ((byte(1) & kMasked) != 0 || size > kLongest) {  // a server does not mask
      close();
      return false;
    }
    const std::size_t begin = 2 + extra;
    if (came.size() < begin + size) {
      return false;
    }
    final = (byte(0) & kFinal) != 0;
    code = byte(0) & 0x0fU;
    content = came.substr(begin, size);
    came.erase(0, begin + size);
    return true;
  }
  /// Takes the next whole text message off what has come, and answers pings.
  bool takeText(std::string& text) {
    unsigned code = 0;
    bool final = false;
    std::string content;
    while (takeFrame(code, final, content)) {
      if (code == kPing) {
        putFrame(kPong, content);
      } else if (code == kClose) {
        close();
      } else if (code == kText || code == kContinued) {
        message = code == kText ? content : message + content;
        if (message.size() > kLongest) {
          close();
        } else if (final) {
          text = std::move(message);
          message.clear();
          return true;
        }
      }
    }
    return false;
  }
};

WebSocket::WebSocket(const std::string& host, int port, std::int64_t patience_us)
    : wire_(std::make_unique<Wire>()) {
  const Time::time_point until = Time::now() + std::chrono::microseconds(patience_us);
  if (!wire_->connectTo(host, port, until)) {
    refuseConnection(host, port);
  }
  // The key proves only that the other side knows the protocol; ours is the example of the standard.
  wire_->put("GET / HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port) +
             "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
             "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n");
  std::size_t end = std::string::npos;
  while ((end = wire_->came.find("\r\n\r\n")) == std::string::npos) {
    if (wire_->came.size() > kLongest || (!wire_->fill(until) && (closed() || remaining_ms(until) == 0))) {
      refuseConnection(host, port);
    }
  }
  const std::string answer = wire_->came.substr(0, end);
  // What the standard's example must be answered with (RFC 6455, 1.3).
  if (answer.rfind("HTTP/1.1 101", 0) != 0 ||
      answer.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo=") == std::string::npos) {
    refuseConnection(host, port);
  }
  wire_->came.erase(0, end + 4);
}

WebSocket::~WebSocket() {
  wire_->putFrame(kClose, {});
}

bool WebSocket::closed() const noexcept {
  return wire_->file < 0;
}

bool WebSocket::receive(std::string& text, std::int64_t wait_us) {
  const Time::time_point until = Time::now() + std::chrono::microseconds(wait_us);
  while (!wire_->takeText(text)) {
    if (!wire_->fill(until) && (closed() || remaining_ms(until) == 0)) {
      return false;
    }
  }
  return true;
}

void WebSocket::send(const std::string& text) {
  wire_->putFrame(kText, text);
}

}  // namespace torsio
