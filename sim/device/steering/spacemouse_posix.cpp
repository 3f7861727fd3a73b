// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <utility>

// The library's guard, so that it comes without X11, whose macros are everybody's.
#define SPNAV_CONFIG_H_  // NOLINT(readability-identifier-naming)
#include <spnav.h>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "sim/device/steering/spacemouse.h"
#include "sim/device/steering/steered_device.h"
#include "sim/device/virtual/pointer_device.h"

namespace torsio {

namespace {

/// What a puck reports when it is pushed as far as it goes, at the daemon's usual sensitivity.
constexpr double kPuckMost = 350.0;
constexpr double kPuckDead = 0.05;  // the daemon has taken most of the rest out already
constexpr int kMaxEventsAtOnce = 64;
constexpr const char* kDefaultSocket = "/var/run/spnav.sock";

/// Whether somebody listens there: spnav_open loses memory each time it fails.
bool daemonListens() {
  const char* const named = std::getenv("SPNAV_SOCKET");
  for (const std::string& path : {std::string(named != nullptr ? named : ""), std::string(kDefaultSocket)}) {
    sockaddr_un address{};
    if (path.empty() || path.size() >= sizeof(address.sun_path)) {
      continue;
    }
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, path.c_str(), path.size());
    const int file = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const bool there =
        file >= 0 && ::connect(file, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0;
    ::close(file);
    if (there) {
      return true;
    }
  }
  return false;
}

/// The library's one connection, as long as somebody uses it.
class Connection {
 public:
  Connection() {
    const std::scoped_lock guard(access());
    open_ = !taken() && daemonListens() && spnav_open() == 0;
    taken() = taken() || open_;
    if (!open_) {
      return;
    }
    std::array<char, 256> name{};
    if (spnav_protocol() < 1) {
      device_ = "SpaceMouse";  // an old daemon does not tell
    } else if (spnav_dev_name(name.data(), static_cast<int>(name.size())) > 0) {
      device_ = plainLine(name.data());
    }
  }
  ~Connection() {
    const std::scoped_lock guard(access());
    if (open_) {
      spnav_close();
      taken() = false;
    }
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Whether this process has a connection, this one or another.
  [[nodiscard]] static bool anotherOne() {
    const std::scoped_lock guard(access());
    return taken();
  }
  [[nodiscard]] bool open() const noexcept { return open_; }
  /// Name of the puck; empty: the daemon has none.
  [[nodiscard]] const std::string& device() const noexcept { return device_; }

 private:
  static std::mutex& access() {
    static std::mutex mutex;
    return mutex;
  }
  static bool& taken() {
    static bool open = false;
    return open;
  }

  bool open_ = false;
  std::string device_;
};

Text noDaemon() {
  return Text::tr("the daemon spacenavd does not answer");
}
Text startDaemon() {
  return Text::tr("Install spacenavd, start it and plug the device in (docs/devices.md)");
}

class SpaceMouseSource final : public SteeringSource {
 public:
  /// Throws Error{kDevice}.
  SpaceMouseSource() {
    if (!connection_.open()) {
      throw Error(ErrorCode::kDevice, noDaemon(), Text::verbatim("SpaceMouse"), startDaemon());
    }
    if (connection_.device().empty()) {
      throw Error(ErrorCode::kDevice, Text::tr("spacenavd runs, but has no device"),
                  Text::verbatim("SpaceMouse"), startDaemon());
    }
    if (spnav_protocol() >= 1) {
      spnav_evmask(SPNAV_EVMASK_INPUT | SPNAV_EVMASK_DEV);
    }
  }

  [[nodiscard]] std::optional<SteeringInput> poll() override {
    if (ended()) {
      return std::nullopt;
    }
    spnav_event event;
    for (int i = 0; i < kMaxEventsAtOnce && spnav_poll_event(&event) != 0; ++i) {
      if (event.type == SPNAV_EVENT_DEV && event.dev.op == SPNAV_DEV_RM) {
        return std::nullopt;
      }
      take(event);
    }
    return input_;
  }

  [[nodiscard]] DeviceIdentity identity() const {
    DeviceIdentity identity;
    identity.model = connection_.device();
    identity.libraryVersion = "libspnav";
    identity.driverVersion = "spacenavd, protocol " + std::to_string(spnav_protocol());
    identity.openedAs = identity.model;
    identity.inputDof = 6;
    return identity;
  }

 private:
  /// Tells whether the daemon has gone: its end of the socket is closed.
  [[nodiscard]] static bool ended() {
    char byte = 0;
    const ssize_t got = ::recv(spnav_fd(), &byte, 1, MSG_PEEK | MSG_DONTWAIT);
    return got == 0 || (got < 0 && errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR);
  }
  /// The library's frame has x to the right, y up and z away from the user, and turns against it about z.
  void take(const spnav_event& event) {
    const auto push = [](int value) { return steeringCurve(value / kPuckMost, kPuckDead); };
    if (event.type == SPNAV_EVENT_MOTION) {
      input_.move = {push(event.motion.x), push(event.motion.y), -push(event.motion.z)};
      input_.pitch = push(event.motion.rx);
      input_.yaw = push(event.motion.ry);
      input_.roll = -push(event.motion.rz);
    } else if (event.type == SPNAV_EVENT_BUTTON && event.button.bnum == 0) {
      input_.grip = event.button.press != 0 ? kPointerClosure : 0.0;
    } else if (event.type == SPNAV_EVENT_BUTTON && event.button.bnum == 1) {
      input_.buttons = event.button.press != 0 ? static_cast<std::uint32_t>(kButtonSecond) : 0U;
    }
  }

  Connection connection_;
  SteeringInput input_;
};

DriverFinding lookForSpaceMouse(const DeviceRequest&) {
  if (Connection::anotherOne()) {
    return {true, Text::tr("in use by this program"), "", {}};
  }
  const Connection connection;
  if (!connection.open()) {
    return {false, noDaemon(), startDaemon(), {}};
  }
  if (connection.device().empty()) {
    return {false, Text::tr("spacenavd runs, but has no device"), startDaemon(), {}};
  }
  return {true,
          Text::tr("found: %1; this kind of device was not confirmed on hardware yet", connection.device()),
          "",
          {}};
}

std::unique_ptr<HapticDevice> openSpaceMouse(const DeviceRequest& request) {
  auto source = std::make_unique<SpaceMouseSource>();
  DeviceIdentity identity = source->identity();
  return std::make_unique<SteeredDevice>(std::move(source), std::move(identity), request);
}

}  // namespace

DeviceDriver spaceMouseDriver() {
  DeviceDriver driver;
  driver.id = "spacemouse";
  driver.name = "SpaceMouse";
  driver.needs = Text::tr("the daemon spacenavd; not confirmed on hardware");
  driver.look = lookForSpaceMouse;
  driver.open = openSpaceMouse;
  return driver;
}

}  // namespace torsio
