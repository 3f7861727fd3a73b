// SPDX-License-Identifier: GPL-3.0-or-later
// The real libspnav against a daemon that speaks the protocol of spacenavd (version 1) on its socket: packets
// of eight 32-bit words, requests tagged 0x7faa in the upper half.
#include "sim/device/steering/spacemouse.h"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <poll.h>
#include <string>
#include <sys/socket.h>
#include <sys/un.h>
#include <thread>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

// The library's guard, so that it comes without X11, whose macros are everybody's.
#define SPNAV_CONFIG_H_  // NOLINT(readability-identifier-naming)
#include <spnav.h>

#include "sim/core/error.h"
#include "sim/device/steering/steered_device.h"
#include "tests/support/eventually.h"

namespace torsio {
namespace {

using Packet = std::array<std::int32_t, 8>;
constexpr std::int32_t kTag = 0x7faa0000;
constexpr std::int32_t kChangeProtocol = 0x5500;
constexpr std::int32_t kDeviceName = 0x2000;
constexpr std::int32_t kMotion = 0;
constexpr std::int32_t kPress = 1;
constexpr std::int32_t kRelease = 2;
constexpr std::int32_t kDeviceChange = 3;
constexpr int kFull = 350;

/// Answers requests and says events, as spacenavd does.
class Daemon {
 public:
  Daemon(std::string path, std::string device) : path_(std::move(path)), device_(std::move(device)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path_.c_str(), sizeof(address.sun_path) - 1);
    ::unlink(path_.c_str());
    listener_ = ::socket(AF_UNIX, SOCK_STREAM, 0);
    if (::bind(listener_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0 ||
        ::listen(listener_, 8) != 0) {
      std::abort();
    }
    thread_ = std::thread([this] { serve(); });
  }
  ~Daemon() { stop(); }
  Daemon(const Daemon&) = delete;
  Daemon& operator=(const Daemon&) = delete;

  /// Ends as a daemon that is killed: all connections break off.
  void stop() {
    if (!thread_.joinable()) {
      return;
    }
    ending_ = true;
    thread_.join();
    for (const int client : clients_) {
      ::close(client);
    }
    clients_.clear();
    ::close(listener_);
    ::unlink(path_.c_str());
  }
  void say(const Packet& event) {
    const std::scoped_lock guard(mutex_);
    for (const int client : clients_) {
      (void)!::send(client, event.data(), sizeof(event), MSG_NOSIGNAL);
    }
  }
  [[nodiscard]] std::size_t clients() {
    const std::scoped_lock guard(mutex_);
    return clients_.size();
  }

 private:
  void serve() {
    while (!ending_) {
      std::vector<pollfd> files{{listener_, POLLIN, 0}};
      for (const int client : clients_) {
        files.push_back({client, POLLIN, 0});
      }
      if (::poll(files.data(), files.size(), 5) <= 0) {
        continue;
      }
      const std::scoped_lock guard(mutex_);
      for (std::size_t i = 1; i < files.size(); ++i) {
        if (files[i].revents != 0 && !answer(files[i].fd)) {
          ::close(files[i].fd);
          std::erase(clients_, files[i].fd);
        }
      }
      if (files[0].revents != 0) {
        clients_.push_back(::accept(listener_, nullptr, nullptr));
      }
    }
  }
  /// False when the client is gone.
  bool answer(int client) {
    Packet packet{};
    const ssize_t got = ::recv(client, packet.data(), sizeof(packet), 0);
    if (got <= 0) {
      return false;
    }
    if (got == sizeof(std::int32_t)) {  // the one short request: which protocol
      const std::int32_t chosen = kTag | kChangeProtocol | 1;
      EXPECT_EQ(packet[0] & ~0xff, kTag | kChangeProtocol);
      (void)!::send(client, &chosen, sizeof(chosen), MSG_NOSIGNAL);
      return true;
    }
    EXPECT_EQ(packet[0] & static_cast<std::int32_t>(0xffff0000), kTag);
    Packet response{packet[0], 0, 0, 0, 0, 0, 0, 0};
    if ((packet[0] & 0xffff) == kDeviceName) {
      std::memcpy(&response[1], device_.data(), device_.size());
      response[7] = device_.empty() ? -1 : static_cast<std::int32_t>(device_.size());
    }
    (void)!::send(client, response.data(), sizeof(response), MSG_NOSIGNAL);
    return true;
  }

  std::string path_;
  std::string device_;
  int listener_ = -1;
  std::atomic<bool> ending_{false};
  std::mutex mutex_;
  std::vector<int> clients_;
  std::thread thread_;
};

class SpaceMouse : public ::testing::Test {
 protected:
  std::string path_ = "/tmp/torsio_spnav_" + std::to_string(getpid());
  std::unique_ptr<Daemon> daemon_;
  std::unique_ptr<HapticDevice> device_;

  void SetUp() override { setenv("SPNAV_SOCKET", path_.c_str(), 1); }
  void TearDown() override {
    device_.reset();
    daemon_.reset();
    unsetenv("SPNAV_SOCKET");
  }
  static DeviceRequest request() {
    DeviceRequest request;
    request.start.position_m = {0.0, 0.0, 0.2};
    request.workspaceCentre_m = {0.0, 0.0, 0.2};
    return request;
  }
  void open() {
    daemon_ = std::make_unique<Daemon>(path_, "SpaceMouse Compact");
    device_ = spaceMouseDriver().open(request());
    device_->serve();
    ASSERT_TRUE(testing::eventually([this] { return device_->read(0).status == kDeviceOk; }));
  }
  /// The puck, pushed by (x, y, z) and turned by (rx, ry, rz).
  void push(int x, int y, int z, int rx, int ry, int rz) { daemon_->say({kMotion, x, y, z, rx, ry, rz, 16}); }
  [[nodiscard]] ToolState tool() { return toolState(device_->read(0)); }
};

TEST_F(SpaceMouse, WithoutADaemonItIsNotThereAndTheRemedyNamesIt) {
  const DriverFinding found = spaceMouseDriver().look(request());

  EXPECT_FALSE(found.available);
  EXPECT_NE(found.remedy.str().find("spacenavd"), std::string::npos);
  EXPECT_THROW(static_cast<void>(spaceMouseDriver().open(request())), Error);
}

TEST_F(SpaceMouse, ADaemonWithoutADeviceIsNone) {
  daemon_ = std::make_unique<Daemon>(path_, "");

  const DriverFinding found = spaceMouseDriver().look(request());

  EXPECT_FALSE(found.available);
  EXPECT_NE(found.sentence.str().find("has no device"), std::string::npos);
  EXPECT_THROW(static_cast<void>(spaceMouseDriver().open(request())), Error);
}

TEST_F(SpaceMouse, IsFoundByTheNameThatTheDaemonGives) {
  daemon_ = std::make_unique<Daemon>(path_, "SpaceMouse Compact");

  const DriverFinding found = spaceMouseDriver().look(request());

  EXPECT_TRUE(found.available);
  EXPECT_NE(found.sentence.str().find("SpaceMouse Compact"), std::string::npos);
  EXPECT_NE(found.sentence.str().find("not confirmed on hardware"), std::string::npos);
  EXPECT_TRUE(testing::eventually([this] { return daemon_->clients() == 0; }))
      << "looking keeps nothing open";
}

TEST_F(SpaceMouse, SaysWhatItIsAndThatItGivesNoForce) {
  open();

  EXPECT_EQ(device_->capabilities().model, "SpaceMouse Compact");
  EXPECT_FALSE(device_->capabilities().rendersForce);
  EXPECT_EQ(device_->identity().driverVersion, "spacenavd, protocol 1");
  EXPECT_TRUE(spaceMouseDriver().look(request()).available) << "in use by this program";
}

TEST_F(SpaceMouse, IsMovedTheWayThatItsOwnLibraryMovesAnObject) {
  // The library's frame of an object: x to the right, y up, z towards the user (spnav_posrot_moveobj).
  spnav_event_motion motion{};
  motion.x = kFull;
  motion.y = kFull;
  motion.z = kFull;
  spnav_posrot expected;
  spnav_posrot_init(&expected);
  spnav_posrot_moveobj(&expected, &motion);
  open();

  push(kFull, kFull, kFull, 0, 0, 0);

  ASSERT_TRUE(testing::eventually([this] { return tool().pose.position_m.x > 0.01; }));
  const Vec3 way_m = tool().pose.position_m - Vec3{0.0, 0.0, 0.2};
  const Vec3 world{expected.pos[0], -expected.pos[2], expected.pos[1]};  // up is z, the user stands at -y
  EXPECT_NEAR(norm(way_m / norm(way_m) - world / norm(world)), 0.0, 1e-4);
}

TEST_F(SpaceMouse, IsTurnedTheWayThatItsOwnLibraryTurnsAnObject) {
  const struct {
    int rx;
    int ry;
    int rz;
  } cases[] = {{kFull, 0, 0}, {0, kFull, 0}, {0, 0, kFull}};

  for (const auto& turn : cases) {
    spnav_event_motion motion{};
    motion.rx = turn.rx;
    motion.ry = turn.ry;
    motion.rz = turn.rz;
    spnav_posrot expected;
    spnav_posrot_init(&expected);
    spnav_posrot_moveobj(&expected, &motion);
    open();
    const Quat rest = tool().pose.orientation;

    push(0, 0, 0, turn.rx, turn.ry, turn.rz);

    const auto turned = [&] {
      return conjugate(rest) * tool().pose.orientation;  // in the frame of the user
    };
    ASSERT_TRUE(testing::eventually([&] { return std::abs(turned().w) < 0.995; }));
    const Quat got = turned();
    const Vec3 axis = Vec3{got.x, got.y, got.z} * (got.w < 0.0 ? -1.0 : 1.0);
    const Vec3 wanted{expected.rot[0], expected.rot[1], expected.rot[2]};
    EXPECT_NEAR(norm(axis / norm(axis) - wanted / norm(wanted)), 0.0, 1e-3);
    TearDown();
    SetUp();
  }
}

TEST_F(SpaceMouse, StandsStillWhenReleased) {
  open();
  push(kFull, 0, 0, 0, 0, 0);
  ASSERT_TRUE(testing::eventually([this] { return tool().pose.position_m.x > 0.005; }));

  push(0, 0, 0, 0, 0, 0);

  // The smoothing fades by 30/31 a millisecond: after half a second nothing is left that could be read. Full,
  // it would go on by far more in that time.
  EXPECT_TRUE(testing::eventually([this] {
    const double before_m = tool().pose.position_m.x;
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    return std::abs(tool().pose.position_m.x - before_m) < 1e-5;
  }));
}

TEST_F(SpaceMouse, TheFirstButtonHoldsTheJawClosedWithCareAndTheSecondIsTheSecond) {
  open();

  daemon_->say({kPress, 0});
  daemon_->say({kPress, 1});
  EXPECT_TRUE(testing::eventually([this] { return std::abs(tool().grip - 0.6) < 1e-3; }));
  EXPECT_EQ(tool().buttons, static_cast<std::uint32_t>(kButtonGrip | kButtonSecond));
  daemon_->say({kRelease, 0});
  daemon_->say({kRelease, 1});

  EXPECT_TRUE(testing::eventually([this] { return tool().grip < 1e-3 && tool().buttons == 0; }));
}

TEST_F(SpaceMouse, ADaemonThatEndsIsALostDevice) {
  open();

  daemon_->stop();

  EXPECT_TRUE(testing::eventually([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
  EXPECT_TRUE(testing::eventually([this] { return device_->snapshot().state == DeviceState::kLost; }));
}

TEST_F(SpaceMouse, APuckThatIsUnpluggedIsALostDevice) {
  open();

  daemon_->say({kDeviceChange, SPNAV_DEV_RM, 0, SPNAV_DEV_SMCOMP});

  EXPECT_TRUE(testing::eventually([this] { return (device_->read(0).status & kDeviceLost) != 0; }));
}

}  // namespace
}  // namespace torsio
