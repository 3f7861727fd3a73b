// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <netinet/in.h>
#include <string>
#include <sys/socket.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/core/file_io.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/app/support/review_centre.h"

namespace torsio::web {

inline std::uint16_t freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t length = sizeof at;
  const bool bound = bind(socket, reinterpret_cast<const sockaddr*>(&at), length) == 0 &&
                     getsockname(socket, reinterpret_cast<sockaddr*>(&at), &length) == 0;
  close(socket);
  return bound ? ntohs(at.sin_port) : 0;
}

/// The program takes no address with a password; a server's comes from PGPASSFILE.
inline std::string withoutPassword(std::string locator) {
  const std::size_t at = locator.find('@');
  const std::size_t colon = locator.rfind(':', at);
  return at == std::string::npos ? locator : locator.erase(colon, at - colon);
}

/// `torsio serve`, configured for a proxy that does not exist.
class ServingProgram {
 public:
  ServingProgram(const ReviewCentre& centre, const std::vector<std::string>& environment,
                 const std::vector<std::string>& more = {}, bool quiet = true)
      : port_(freePort()), state_(centre.folder() / "desk.json"), errors_(centre.folder() / "desk.log") {
    std::vector<std::string> arguments{"serve",
                                       "--database",
                                       withoutPassword(centre.locator()),
                                       "--listen",
                                       "127.0.0.1:" + std::to_string(port_),
                                       "--public-url",
                                       "https://desk.example.org",
                                       "--state",
                                       state_.string()};
    if (quiet) {
      arguments.emplace_back("--quiet");
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    child_ = startSilent(arguments, TORSIO_PROGRAM, environment, errors_.string());
  }
  ServingProgram(const ServingProgram&) = delete;
  ServingProgram& operator=(const ServingProgram&) = delete;
  ~ServingProgram() { die(); }

  /// 0: it is not serving.
  [[nodiscard]] std::uint16_t port() const {
    for (int tries = 0; tries < 1200; ++tries) {
      if (waitpid(child_, nullptr, WNOHANG) == child_) {
        return 0;
      }
      std::error_code none;
      const nlohmann::json state = std::filesystem::exists(state_, none)
                                       ? nlohmann::json::parse(readFile(state_), nullptr, false)
                                       : nlohmann::json();
      if (state.is_object() && state.value("process", 0) == child_) {
        return port_;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    return 0;
  }
  /// Asks it to stop, and returns its exit code.
  int stopped() {
    kill(child_, SIGTERM);
    return ended();
  }
  /// Waits for its end and returns its exit code.
  int ended() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string errors() const { return readFile(errors_); }
  void die() {
    if (child_ > 0) {
      kill(child_, SIGKILL);
      waitpid(child_, nullptr, 0);
      child_ = -1;
    }
  }

 private:
  std::uint16_t port_;
  std::filesystem::path state_;
  std::filesystem::path errors_;
  pid_t child_ = -1;
};

}  // namespace torsio::web
