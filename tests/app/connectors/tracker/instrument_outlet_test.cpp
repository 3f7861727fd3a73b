// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/instrument_outlet.h"

#include <arpa/inet.h>
#include <chrono>
#include <netinet/in.h>
#include <sys/socket.h>
#include <thread>
#include <unistd.h>

#include <QTcpServer>
#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "tests/support/fake_tracker.h"

namespace torsio {
namespace {

using testing::FakeTracker;

std::uint16_t freePort() {
  QTcpServer free;
  free.listen(QHostAddress::LocalHost, 0);
  return free.serverPort();
}

bool comes(const InstrumentOutlet& outlet, std::int64_t watchers) {
  for (int tries = 0; tries < 2'000 && outlet.view().watchers != watchers; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return outlet.view().watchers == watchers;
}

/// Connects with a small receive buffer and never reads.
int sleeper(std::uint16_t port) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  const int little = 4'096;
  ::setsockopt(socket, SOL_SOCKET, SO_RCVBUF, &little, sizeof little);
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_port = htons(port);
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  for (int tries = 0; tries < 400; ++tries) {
    if (::connect(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0) {
      break;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  return socket;
}

TEST(InstrumentOutlet, SendsTheInstrumentAndItsEventsToViewers) {
  const std::uint16_t port = freePort();
  InstrumentOutlet outlet("127.0.0.1", port);
  FakeTracker slicer;
  ASSERT_TRUE(slicer.call(port));
  ASSERT_TRUE(comes(outlet, 1));

  LiveState state;
  state.tool.position_m = {0.010, -0.020, 0.030};  // left 10, front 20, head 30 mm
  state.phase = ExercisePhase::kTwisting;
  state.response.angle_rad = radians(91.84);
  outlet.show(state);
  const FakeTracker::Message pose = slicer.receive();
  const FakeTracker::Message grips = slicer.receive();
  state.phase = ExercisePhase::kReleased;
  state.response.angle_rad = 0.0;
  outlet.show(state);
  static_cast<void>(slicer.receive());
  const FakeTracker::Message letsGo = slicer.receive();

  EXPECT_EQ(pose.kind, "TRANSFORM");
  EXPECT_EQ(pose.device, "TorsioInstrument");
  EXPECT_EQ(pose.content, "-10.0 20.0 30.0");  // right, front, head
  EXPECT_EQ(grips.kind, "STRING");
  EXPECT_EQ(grips.device, "TorsioEvent");
  EXPECT_EQ(grips.content, "grips");
  EXPECT_EQ(letsGo.content, "lets go at 91.8 deg");
  slicer.hangUp();
  EXPECT_TRUE(comes(outlet, 0));
}

TEST(InstrumentOutlet, SkipsPosesForViewersThatDoNotRead) {
  const std::uint16_t port = freePort();
  InstrumentOutlet outlet("127.0.0.1", port);
  const int asleep = sleeper(port);
  ASSERT_TRUE(comes(outlet, 1));

  LiveState state;
  for (int i = 0; i < 100'000 && outlet.view().left == 0; ++i) {
    outlet.show(state);
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }

  EXPECT_GT(outlet.view().left, 0);
  FakeTracker awake;
  ASSERT_TRUE(awake.call(port));
  ASSERT_TRUE(comes(outlet, 2));
  outlet.show(state);
  EXPECT_EQ(awake.receive().kind, "TRANSFORM");
  ::close(asleep);
}

TEST(InstrumentOutlet, ReportsWhyNobodyCanConnect) {
  const std::uint16_t port = freePort();
  const InstrumentOutlet first("127.0.0.1", port);
  FakeTracker slicer;
  ASSERT_TRUE(slicer.call(port));
  const InstrumentOutlet second("127.0.0.1", port);
  const InstrumentOutlet nowhere("not here", port);
  for (int tries = 0; tries < 2'000 && (second.view().trouble.empty() || nowhere.view().trouble.empty());
       ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_FALSE(second.view().trouble.empty());
  EXPECT_FALSE(nowhere.view().trouble.empty());
}

}  // namespace
}  // namespace torsio
