// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/tracker/tracker_link.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <span>
#include <utility>

#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>

#include "app/connectors/tracker/own_address.h"
#include "app/connectors/tracker/tracker_clock.h"
#include "sim/core/clock.h"
#include "sim/core/device_sample.h"
#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

constexpr int kLook_ms = 50;  // interval at which the thread checks whether to stop
constexpr int kConnect_ms = 3'000;
constexpr std::chrono::milliseconds kAgain{1'000};
constexpr std::chrono::milliseconds kTrackerFarewell{500};
constexpr std::int64_t kAskForTracking_us = 1'000'000;
constexpr std::int64_t kSilent_us = 2'000'000;
constexpr std::int64_t kLetGo_us = 30'000'000;
constexpr std::int64_t kRateOver_us = 1'000'000;
constexpr std::size_t kMaxInstruments = 20;
constexpr qint64 kReadAtOnce = 64 * 1024;

Text socketTrouble(QAbstractSocket::SocketError error, const QString& said) {
  switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
      return Text::tr("no answer from this address and port");
    case QAbstractSocket::HostNotFoundError:
      return Text::tr("there is no computer of this name");
    case QAbstractSocket::SocketTimeoutError:
      return Text::tr("there was no answer in time");
    case QAbstractSocket::RemoteHostClosedError:
      return Text::tr("the tracker ended the connection");
    default:
      return said.toStdString();
  }
}

}  // namespace

struct TrackerLink::State {
  /// Rate of poses over about the last second.
  class PoseRate {
   public:
    void see(std::int64_t now_us) {
      if (count_++ == 0) {
        since_us_ = now_us;
      }
    }
    /// Returns empty until the rate is known.
    std::optional<double> after(std::int64_t now_us) {
      if (count_ == 0 || now_us - since_us_ < kRateOver_us) {
        return std::nullopt;
      }
      const double rate = static_cast<double>(count_) * 1e6 / static_cast<double>(now_us - since_us_);
      count_ = 0;
      return rate;
    }

   private:
    std::int64_t count_ = 0;
    std::int64_t since_us_ = 0;
  };

  const TrackerPlace place;

  mutable std::mutex mutex;  // guards the members below; held briefly
  std::condition_variable changed;
  bool stop = false;
  bool ended = false;
  TrackerView view;
  Text complaint;  // from the tracker's STATUS
  std::shared_ptr<SpscRing<Sample>> ring;
  std::int64_t recordedFrom_us = 0;
  std::optional<std::int64_t> firstPlace;
  std::int64_t lateRecorded = 0;

  // Used by the thread only.
  MonotonicClock clock{};
  TrackerClock times{};
  PoseRate rate{};
  std::int64_t places = 0;  // place of the next pose if none is missing
  std::int64_t connected_us = 0;
  std::int64_t heard_us = 0;
  std::int64_t posed_us = 0;
  std::int64_t changed_us = 0;  // when the pose last changed
  bool askedForTracking = false;

  explicit State(const TrackerPlace& where) : place(where) {}

  [[nodiscard]] bool stops() const {
    const std::lock_guard lock(mutex);
    return stop;
  }
  void pause(std::chrono::milliseconds time) {
    std::unique_lock lock(mutex);
    changed.wait_for(lock, time, [this] { return stop; });
  }
  void seek(Text why) {
    const std::lock_guard lock(mutex);
    view.stage = TrackerStage::kSeeking;
    view.rate_per_s = 0.0;
    if (!why.empty()) {
      view.trouble = std::move(why);
    }
  }

  void take(const IgtlNews& news, std::int64_t arrived_us);
  void takePose(const TrackedPose& pose, std::int64_t arrived_us);
  bool isFrozen(const Pose& pose, std::int64_t arrived_us);
  void keep(const Pose& pose, const TrackerClock::Moment& moment);
  void look(std::int64_t now_us);
  void talk(QTcpSocket& socket);
  void call();
  void answer();
};

void TrackerLink::State::keep(const Pose& pose, const TrackerClock::Moment& moment) {
  if (ring == nullptr || moment.time_us < recordedFrom_us) {
    return;
  }
  firstPlace = firstPlace.value_or(moment.place);
  Sample sample;
  sample.tick = moment.place - *firstPlace;
  sample.device = quantize({.time_us = moment.time_us - recordedFrom_us, .pose = pose}, {});
  if (moment.late) {
    sample.device.status |= kDeviceStale;
    ++lateRecorded;
  }
  static_cast<void>(ring->push(sample));  // a full ring counts its losses
}

/// Returns whether the pose has been the same bit for bit for longer than a hand can hold it so.
bool TrackerLink::State::isFrozen(const Pose& pose, std::int64_t arrived_us) {
  if (changed_us == 0 || !(pose == view.pose)) {
    changed_us = arrived_us;
  }
  return arrived_us - changed_us > kFrozenPose_us;
}

void TrackerLink::State::takePose(const TrackedPose& pose, std::int64_t arrived_us) {
  std::vector<std::string>& seen = view.instruments;
  if (std::find(seen.begin(), seen.end(), pose.instrument) == seen.end() && seen.size() < kMaxInstruments) {
    seen.push_back(pose.instrument);
  }
  if (view.instrument.empty()) {
    view.instrument = place.instrument.empty() ? pose.instrument : place.instrument;
  }
  if (pose.instrument != view.instrument) {
    return;
  }
  const std::optional<TrackerClock::Moment> moment = times.take(pose.sent_us, arrived_us);
  if (!moment && pose.lost.empty()) {
    ++view.counts.refused;
    return;
  }
  if (moment) {
    view.counts.missing += moment->place - places;
    places = moment->place + 1;
  }
  if (!pose.lost.empty()) {
    ++view.counts.missing;
    view.trouble = Text::tr("the tracker does not see the instrument: %1", pose.lost);
    return;
  }
  if (isFrozen(pose.pose, arrived_us)) {
    view.trouble = Text::tr("the pose has not changed by a bit: is the instrument out of view?");
  }
  view.counts.late += moment->late ? 1 : 0;
  ++view.counts.received;
  view.stage = TrackerStage::kTracking;
  view.pose = pose.pose;
  view.stamped = times.stamped();
  view.period_us = times.period_us();
  posed_us = arrived_us;
  rate.see(arrived_us);
  keep(pose.pose, *moment);
}

void TrackerLink::State::take(const IgtlNews& news, std::int64_t arrived_us) {
  const std::lock_guard lock(mutex);
  view.counts.refused += news.refused;
  if (news.status) {
    complaint = news.status->empty() ? Text() : Text::tr("the tracker says: %1", *news.status);
  }
  if (news.status || !news.poses.empty()) {
    view.trouble = complaint;  // earlier trouble is cleared once a connection works
  }
  for (const TrackedPose& pose : news.poses) {
    takePose(pose, arrived_us);
  }
}

void TrackerLink::State::look(std::int64_t now_us) {
  const std::lock_guard lock(mutex);
  if (const std::optional<double> measured = rate.after(now_us)) {
    view.rate_per_s = *measured;
  }
  if (view.stage == TrackerStage::kTracking && now_us - posed_us > kSilent_us) {
    view.stage = TrackerStage::kSilent;
    view.rate_per_s = 0.0;
  }
}

/// Serves one connection until it ends.
void TrackerLink::State::talk(QTcpSocket& socket) {
  socket.setReadBufferSize(16 * kReadAtOnce);
  socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
  {
    const std::lock_guard lock(mutex);
    view.stage = TrackerStage::kWaiting;
    complaint = {};
  }
  connected_us = heard_us = clock.now_us();
  posed_us = 0;
  askedForTracking = false;
  IgtlReader reader;
  std::array<char, kReadAtOnce> buffer{};
  while (!stops()) {
    const bool ready = socket.bytesAvailable() > 0 || socket.waitForReadyRead(kLook_ms);
    const std::int64_t now_us = clock.now_us();
    look(now_us);
    if (!ready && socket.state() != QAbstractSocket::ConnectedState) {
      seek(socketTrouble(socket.error(), socket.errorString()));
      return;
    }
    if (!ready && now_us - heard_us > kLetGo_us) {
      seek(Text::tr("nothing has come for half a minute"));
      return;
    }
    if (posed_us == 0 && !askedForTracking && now_us - connected_us > kAskForTracking_us) {
      askedForTracking = true;
      const std::vector<std::byte> request = igtlStartTracking();
      socket.write(reinterpret_cast<const char*>(request.data()), static_cast<qint64>(request.size()));
      socket.flush();
    }
    const qint64 count = socket.read(buffer.data(), kReadAtOnce);
    if (count <= 0) {
      continue;
    }
    heard_us = now_us;
    IgtlNews news;
    try {
      reader.take(std::as_bytes(std::span(buffer.data(), static_cast<std::size_t>(count))), news);
    } catch (const Error& rubbish) {
      take(news, now_us);
      seek(rubbish.happenedText());
      return;
    }
    take(news, now_us);
  }
}

void TrackerLink::State::call() {
  QTcpSocket socket;
  socket.connectToHost(QString::fromStdString(place.address), place.port);
  if (!socket.waitForConnected(kConnect_ms)) {
    seek(socketTrouble(socket.error(), socket.errorString()));
    return;
  }
  talk(socket);
  socket.abort();
}

void TrackerLink::State::answer() {
  QTcpServer server;
  const QHostAddress here = ownAddress(place.address);
  if (here.isNull()) {  // Qt would listen at all addresses
    seek(Text::tr("not an address of this computer; use 127.0.0.1, or 0.0.0.0 for all its addresses"));
    return;
  }
  if (!server.listen(here, place.port)) {
    seek(Text::tr("cannot listen at this address and port: %1", server.errorString().toStdString()));
    return;
  }
  while (!stops()) {
    if (!server.waitForNewConnection(kLook_ms)) {
      continue;
    }
    const std::unique_ptr<QTcpSocket> socket(server.nextPendingConnection());
    if (socket != nullptr) {
      talk(*socket);
      socket->abort();
    }
  }
}

void TrackerLink::run(const std::shared_ptr<State>& state) {
  while (!state->stops()) {
    if (state->place.listens) {
      state->answer();
    } else {
      state->call();
    }
    state->pause(kAgain);
  }
  const std::lock_guard lock(state->mutex);
  state->ended = true;
  state->changed.notify_all();
}

TrackerLink::TrackerLink(const TrackerPlace& place) : place_(place), state_(std::make_shared<State>(place)) {
  thread_ = std::thread([state = state_] { run(state); });
}

TrackerLink::~TrackerLink() {
  bool ended = false;
  {
    std::unique_lock lock(state_->mutex);
    state_->stop = true;
    state_->ring.reset();
    state_->changed.notify_all();
    ended = state_->changed.wait_for(lock, kTrackerFarewell, [this] { return state_->ended; });
  }
  // A thread that hangs in a name lookup or a connection attempt is detached: it owns everything that it
  // uses.
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

TrackerView TrackerLink::view() const {
  const std::lock_guard lock(state_->mutex);
  return state_->view;
}

void TrackerLink::record(std::shared_ptr<SpscRing<Sample>> ring) {
  const std::int64_t now_us = MonotonicClock().now_us();
  const std::lock_guard lock(state_->mutex);
  state_->ring = std::move(ring);
  state_->recordedFrom_us = now_us;
  state_->firstPlace.reset();
  state_->lateRecorded = 0;
}

std::int64_t TrackerLink::lateRecorded() const {
  const std::lock_guard lock(state_->mutex);
  return state_->lateRecorded;
}

}  // namespace torsio
