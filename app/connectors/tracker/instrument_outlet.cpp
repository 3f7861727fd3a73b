// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/instrument_outlet.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <QTcpServer>
#include <QTcpSocket>

#include "app/connectors/tracker/igtl_messages.h"
#include "app/connectors/tracker/own_address.h"
#include "app/connectors/tracker/tracker_choice.h"
#include "assessment/results/number_format.h"
#include "sim/core/angle.h"
#include "sim/core/clock.h"

namespace torsio {

namespace {

using Message = std::vector<std::byte>;

constexpr std::chrono::milliseconds kOutletLook{20};
constexpr std::chrono::milliseconds kOutletFarewell{500};
constexpr qint64 kSlow_bytes = 64 * 1024;    // backlog above which poses are dropped
constexpr qint64 kDead_bytes = 1024 * 1024;  // backlog above which a watcher is disconnected
constexpr std::size_t kMaxWatchers = 8;
constexpr std::size_t kMaxWaiting = 256;

/// From world (left, back, head) to the viewers' RAS (right, front, head): half a turn about the last axis.
Pose inRas(const Pose& pose) {
  return {{-pose.position_m.x, -pose.position_m.y, pose.position_m.z},
          Quat{0.0, 0.0, 0.0, 1.0} * pose.orientation};
}

std::string stepName(ExercisePhase phase, double held_rad) {
  switch (phase) {
    case ExercisePhase::kTracking:
      return "free";
    case ExercisePhase::kContact:
      return "touches";
    case ExercisePhase::kTwisting:
      return "grips";
    case ExercisePhase::kReleased:
      return "lets go at " + formatFixed(degrees(held_rad), 1) + " deg";
  }
  return {};
}

}  // namespace

struct InstrumentOutlet::State {
  const std::string address;
  const std::uint16_t port;

  mutable std::mutex mutex;  // guards the members below
  std::condition_variable changed;
  bool stop = false;
  bool ended = false;
  OutletView view;
  std::optional<Message> pose;  // newest, not yet sent
  std::deque<Message> events;

  std::vector<std::unique_ptr<QTcpSocket>> watchers;  // used by the thread only

  State(std::string where, std::uint16_t at) : address(std::move(where)), port(at) {}

  void trouble(Text why) {
    const std::lock_guard lock(mutex);
    view.trouble = std::move(why);
  }
  void offer();
  void welcome(QTcpServer& server);
  void send(const std::optional<Message>& newest, const std::deque<Message>& told);
};

void InstrumentOutlet::State::welcome(QTcpServer& server) {
  while (server.waitForNewConnection(0)) {
    std::unique_ptr<QTcpSocket> socket(server.nextPendingConnection());
    if (socket == nullptr) {
      return;
    }
    if (watchers.size() < kMaxWatchers) {
      socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
      socket->setSocketOption(QAbstractSocket::SendBufferSizeSocketOption, kSlow_bytes);
      watchers.push_back(std::move(socket));
    }
  }
  std::erase_if(watchers, [](const std::unique_ptr<QTcpSocket>& socket) {
    if (socket->waitForReadyRead(0)) {
      socket->readAll();  // watchers have nothing to ask
    }
    return socket->state() != QAbstractSocket::ConnectedState || socket->bytesToWrite() > kDead_bytes;
  });
  const std::lock_guard lock(mutex);
  view.watchers = std::ssize(watchers);
}

void InstrumentOutlet::State::send(const std::optional<Message>& newest, const std::deque<Message>& told) {
  std::int64_t sent = 0;
  std::int64_t left = 0;
  const auto write = [](QTcpSocket& socket, const Message& message) {
    socket.write(reinterpret_cast<const char*>(message.data()), static_cast<qint64>(message.size()));
  };
  for (const std::unique_ptr<QTcpSocket>& socket : watchers) {
    if (newest) {
      const bool slow = socket->bytesToWrite() > kSlow_bytes;
      ++(slow ? left : sent);
      if (!slow) {
        write(*socket, *newest);
      }
    }
    for (const Message& message : told) {
      write(*socket, message);
    }
    socket->flush();
  }
  const std::lock_guard lock(mutex);
  view.sent += sent;
  view.left += left;
}

void InstrumentOutlet::State::offer() {
  QTcpServer server;
  const QHostAddress here = ownAddress(address);
  if (here.isNull() || !server.listen(here, port)) {
    trouble(Text::tr("cannot listen at this address and port: %1", server.errorString().toStdString()));
    std::unique_lock lock(mutex);
    changed.wait_for(lock, std::chrono::seconds(1), [this] { return stop; });
    return;
  }
  trouble({});
  for (;;) {
    std::optional<Message> newest;
    std::deque<Message> told;
    {
      std::unique_lock lock(mutex);
      changed.wait_for(lock, kOutletLook, [this] { return stop || pose || !events.empty(); });
      if (stop) {
        break;
      }
      newest.swap(pose);
      told.swap(events);
    }
    welcome(server);
    send(newest, told);
  }
  watchers.clear();
}

void InstrumentOutlet::run(const std::shared_ptr<State>& state) {
  const auto stops = [&] {
    const std::lock_guard lock(state->mutex);
    return state->stop;
  };
  while (!stops()) {
    state->offer();
  }
  const std::lock_guard lock(state->mutex);
  state->ended = true;
  state->changed.notify_all();
}

InstrumentOutlet::InstrumentOutlet(const std::string& address, std::uint16_t port)
    : state_(std::make_shared<State>(address, port)) {
  thread_ = std::thread([state = state_] { run(state); });
}

InstrumentOutlet::~InstrumentOutlet() {
  bool ended = false;
  {
    std::unique_lock lock(state_->mutex);
    state_->stop = true;
    state_->changed.notify_all();
    ended = state_->changed.wait_for(lock, kOutletFarewell, [this] { return state_->ended; });
  }
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();  // it owns everything that it uses
  }
}

void InstrumentOutlet::show(const LiveState& state) {
  const std::int64_t now_us = utcNow_us();
  Message pose = igtlTransform(kOutletInstrument, inRas(state.tool), now_us);
  std::optional<Message> event;
  if (state.phase == ExercisePhase::kTwisting) {
    held_rad_ = state.response.angle_rad;
  }
  if (state.phase != phase_) {
    phase_ = state.phase;
    event = igtlString(kOutletEvents, stepName(phase_, held_rad_), now_us);
  }
  const std::lock_guard lock(state_->mutex);
  state_->pose = std::move(pose);
  if (event && state_->events.size() < kMaxWaiting) {
    state_->events.push_back(std::move(*event));
  }
  state_->changed.notify_all();
}

bool InstrumentOutlet::isAt(const std::string& address, std::uint16_t port) const {
  return state_->address == address && state_->port == port;
}

OutletView InstrumentOutlet::view() const {
  const std::lock_guard lock(state_->mutex);
  return state_->view;
}

std::shared_ptr<InstrumentOutlet> outletOfThisStation() {
  static std::weak_ptr<InstrumentOutlet> shared;
  const TrackerChoice choice = rememberedTracker();
  if (choice.outletPort == 0) {
    return nullptr;
  }
  std::shared_ptr<InstrumentOutlet> outlet = shared.lock();
  if (outlet == nullptr || !outlet->isAt(choice.outletAddress, choice.outletPort)) {
    outlet = std::make_shared<InstrumentOutlet>(choice.outletAddress, choice.outletPort);
    shared = outlet;
  }
  return outlet;
}

}  // namespace torsio
