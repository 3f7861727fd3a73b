// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <arpa/inet.h>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <netinet/in.h>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>
#include <utility>

namespace torsio::testing {

/// A server on this computer that says whatever bytes a test wants, to one guest after another.
class RawServer {
 public:
  class Guest {
   public:
    Guest(int socket, const std::atomic<bool>& stop, std::atomic<std::int64_t>& sent)
        : socket_(socket), stop_(stop), sent_(sent) {}
    /// Returns false once the guest has left or the server ends.
    bool say(const std::string& bytes) {
      for (std::size_t done = 0; done < bytes.size() && !stop_;) {
        pollfd line{socket_, POLLOUT, 0};
        if (::poll(&line, 1, kLook_ms) <= 0) {
          continue;
        }
        const ssize_t count =
            ::send(socket_, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count <= 0) {
          return false;
        }
        done += static_cast<std::size_t>(count);
        sent_ += count;
      }
      return !stop_;
    }
    /// Says a byte at a time.
    bool trickle(const std::string& bytes, std::chrono::milliseconds apart) {
      for (const char byte : bytes) {
        std::this_thread::sleep_for(apart);
        if (!say(std::string(1, byte))) {
          return false;
        }
      }
      return true;
    }
    /// Returns what the guest says up to `end`, included; less once the guest has left or the server ends.
    std::string hear(const std::string& end) {
      while (heard_.find(end) == std::string::npos && hearMore()) {
      }
      const std::size_t at = heard_.find(end);
      return taken(at == std::string::npos ? heard_.size() : at + end.size());
    }
    /// Returns the next `count` bytes; less once the guest has left or the server ends.
    std::string hear(std::size_t count) {
      while (heard_.size() < count && hearMore()) {
      }
      return taken(std::min(count, heard_.size()));
    }

   private:
    /// Returns false once the guest has left or the server ends.
    bool hearMore() {
      while (!stop_) {
        pollfd line{socket_, POLLIN, 0};
        if (::poll(&line, 1, kLook_ms) <= 0) {
          continue;
        }
        char part[4096];
        const ssize_t count = ::recv(socket_, part, sizeof(part), 0);
        if (count <= 0) {
          return false;
        }
        heard_.append(part, static_cast<std::size_t>(count));
        return true;
      }
      return false;
    }
    std::string taken(std::size_t size) {
      std::string words = heard_.substr(0, size);
      heard_.erase(0, size);
      return words;
    }

    int socket_;
    const std::atomic<bool>& stop_;
    std::atomic<std::int64_t>& sent_;
    std::string heard_{};
  };

  /// `talk` is called for each guest, who is shown out when it returns.
  explicit RawServer(std::function<void(Guest&)> talk) : talk_(std::move(talk)) {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(place);
    if (::bind(listener_, reinterpret_cast<sockaddr*>(&place), size) != 0 || ::listen(listener_, 8) != 0 ||
        ::getsockname(listener_, reinterpret_cast<sockaddr*>(&place), &size) != 0) {
      throw std::runtime_error("no port for the server");
    }
    port_ = ntohs(place.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  ~RawServer() {
    stop_ = true;
    thread_.join();
    ::close(listener_);
  }
  RawServer(const RawServer&) = delete;
  RawServer& operator=(const RawServer&) = delete;

  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::int64_t sent_bytes() const { return sent_; }
  [[nodiscard]] int guests() const { return guests_; }

 private:
  static constexpr int kLook_ms = 20;

  void serve() {
    while (!stop_) {
      pollfd door{listener_, POLLIN, 0};
      if (::poll(&door, 1, kLook_ms) > 0) {
        const int socket = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
        ++guests_;
        Guest guest(socket, stop_, sent_);
        talk_(guest);
        ::shutdown(socket, SHUT_WR);
        ::close(socket);
      }
    }
  }

  std::function<void(Guest&)> talk_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> sent_{0};
  std::atomic<int> guests_{0};
  std::thread thread_;
};

}  // namespace torsio::testing
