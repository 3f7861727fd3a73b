// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/recording/station_writer.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <tuple>
#include <utility>

#include "app/services/access/moved_record.h"
#include "app/services/base/build_info.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

using Steady = std::chrono::steady_clock;

bool isAway(const std::exception& problem) {
  const auto* database = dynamic_cast<const DbError*>(&problem);
  return database != nullptr && database->retryable();
}

/// The thread's own session and heartbeat.
struct Desk {
  std::unique_ptr<SessionContext> session;
  std::optional<StationHeartbeat> heartbeat;
};

}  // namespace

struct StationWriter::State {
  struct Waiting {
    Actor actor;
    Write write;
  };

  Open open;
  LinePatience patience;
  mutable std::mutex mutex;
  mutable std::condition_variable changed;
  std::deque<Waiting> writes;
  Actor actor;
  TrialId trialId;
  StationDevice device;
  std::optional<Steady::time_point> since;  // start of the current attempt
  std::size_t refused = 0;
  bool twin = false;
  Text notice;
  bool fresh = true;  // work to do at once
  bool failed = false;
  bool stop = false;
  bool leaveBoard = false;
  bool ended = false;

  /// Runs one round. Throws what the database throws.
  void serve(Desk& desk) {
    if (!desk.session) {
      desk.session = open();
      desk.heartbeat.emplace(*desk.session);
    }
    while (std::optional<Waiting> next = front()) {
      desk.session->setActor(next->actor);
      perform(*desk.session, *next);
    }
    const auto [who, trial, tool, leaves] = shown();
    desk.session->setActor(who);
    desk.heartbeat->show(trial);
    desk.heartbeat->showDevice(tool);
    if (leaves) {
      desk.heartbeat->leave();
    } else {
      desk.heartbeat->send();
    }
    {
      const std::lock_guard lock(mutex);
      twin = desk.heartbeat->hasTwin();
      notice = desk.heartbeat->notice();
    }
    if (!desk.heartbeat->answered()) {
      throw DbError(DbFault::kUnreachable, "", Text::tr("the database does not answer"),
                    desk.session->station(), "");
    }
  }

  void perform(SessionContext& session, const Waiting& waiting) {
    bool given = false;
    try {
      waiting.write(session);
    } catch (const std::exception& problem) {
      if (isAway(problem)) {
        throw;
      }
      given = true;
    }
    const std::lock_guard lock(mutex);
    writes.pop_front();
    if (given) {
      ++refused;
    }
  }

  [[nodiscard]] std::optional<Waiting> front() const {
    const std::lock_guard lock(mutex);
    return writes.empty() ? std::nullopt : std::optional(writes.front());
  }

  [[nodiscard]] std::tuple<Actor, std::string, StationDevice, bool> shown() const {
    const std::lock_guard lock(mutex);
    return {actor, trialId, device, leaveBoard};
  }
};

StationWriter::StationWriter(const SessionKey& key, const LinePatience& patience)
    : StationWriter([key] { return std::make_unique<SessionContext>(key); }, patience) {
  signIn(key.actor);
}

StationWriter::StationWriter(Open open, const LinePatience& patience) : state_(std::make_shared<State>()) {
  state_->open = std::move(open);
  state_->patience = patience;
  thread_ = std::thread([state = state_] { run(state); });
}

StationWriter::~StationWriter() {
  end(false);
}

void StationWriter::run(const std::shared_ptr<State>& state) {
  Desk desk;
  for (;;) {
    bool last = false;
    {
      std::unique_lock lock(state->mutex);
      const auto pause = state->failed ? state->patience.again : state->patience.heartbeat;
      state->changed.wait_for(lock, pause, [&] { return state->stop || (state->fresh && !state->failed); });
      last = state->stop;
      state->fresh = false;
      state->since = Steady::now();
    }
    bool failed = false;
    try {
      state->serve(desk);
    } catch (const std::exception&) {
      failed = true;
      desk = {};  // a lost connection cannot be reused
    }
    const std::lock_guard lock(state->mutex);
    state->since.reset();
    state->failed = failed;
    state->ended = last;
    state->changed.notify_all();
    if (last) {
      return;
    }
  }
}

void StationWriter::signIn(const Actor& actor) {
  const std::lock_guard lock(state_->mutex);
  if (state_->actor.userId == actor.userId && state_->actor.practiceOnly == actor.practiceOnly) {
    return;
  }
  state_->actor = actor;
  state_->fresh = true;
  state_->changed.notify_all();
}

void StationWriter::show(const TrialId& trialId) {
  const std::lock_guard lock(state_->mutex);
  if (state_->trialId == trialId) {
    return;
  }
  state_->trialId = trialId;
  state_->fresh = true;
  state_->changed.notify_all();
}

void StationWriter::showDevice(const StationDevice& device) {
  const std::lock_guard lock(state_->mutex);
  const bool known = state_->device.light && state_->device.haptic == device.haptic;
  if (state_->device == device || (known && !device.light)) {
    return;
  }
  state_->device = device;
  state_->fresh = true;
  state_->changed.notify_all();
}

void StationWriter::write(Write write) {
  const std::lock_guard lock(state_->mutex);
  state_->writes.push_back({state_->actor, std::move(write)});
  state_->fresh = true;
  state_->changed.notify_all();
}

bool StationWriter::answers() const {
  const std::lock_guard lock(state_->mutex);
  if (state_->since && Steady::now() - *state_->since > state_->patience.silence) {
    return false;
  }
  return !state_->failed;
}

bool StationWriter::hasTwin() const {
  const std::lock_guard lock(state_->mutex);
  return state_->twin;
}

Text StationWriter::notice() const {
  const std::lock_guard lock(state_->mutex);
  return state_->notice;
}

std::size_t StationWriter::waiting() const {
  const std::lock_guard lock(state_->mutex);
  return state_->writes.size();
}

std::size_t StationWriter::refused() const {
  const std::lock_guard lock(state_->mutex);
  return state_->refused;
}

bool StationWriter::settled(std::chrono::milliseconds limit) const {
  std::unique_lock lock(state_->mutex);
  return state_->changed.wait_for(lock, limit, [&] {
    return state_->ended || (state_->writes.empty() && !state_->fresh && !state_->since && !state_->failed);
  });
}

void StationWriter::leave() {
  end(true);
}

void StationWriter::end(bool leaveBoard) {
  if (!thread_.joinable()) {
    return;
  }
  bool ended = false;
  {
    std::unique_lock lock(state_->mutex);
    state_->stop = true;
    state_->leaveBoard = leaveBoard;
    state_->changed.notify_all();
    ended = state_->changed.wait_for(lock, state_->patience.farewell, [&] { return state_->ended; });
  }
  // A thread blocked by a dead server is left to finish by itself: it owns everything that it uses.
  if (ended) {
    thread_.join();
  } else {
    thread_.detach();
  }
}

namespace {

// A trial that has just begun is in the database within a second, if that is reachable.
constexpr std::int64_t kAgain_us = 1'000'000;

}  // namespace

void StationHeartbeat::show(const TrialId& trialId) {
  changed_ = changed_ || trialId != trialId_;
  trialId_ = trialId;
}

void StationHeartbeat::showDevice(const StationDevice& device) {
  if (device == device_) {
    return;
  }
  changed_ = true;
  device_ = device;
}

void StationHeartbeat::send() {
  const std::int64_t now_us = session_->now_us();
  changed_ = changed_ || session_->actor().userId != shownUser_;
  if (!changed_ && now_us < next_us_) {
    return;
  }
  changed_ = false;
  shownUser_ = session_->actor().userId;
  next_us_ = now_us + kAgain_us;
  try {
    Connection& connection = session_->connectionWithoutRight();
    const bool there =
        trialId_.empty() || trialId_ == shownTrial_ || TrialRepository(connection).find(trialId_);
    const std::string trial = there ? trialId_ : "";
    StationState state{.station = session_->station(),
                       .trialId = trial,
                       .userId = session_->actor().userId,
                       .softwareVersion = softwareVersion(),
                       .heartbeatUtc_us = now_us};
    storeDevice(device_, state);
    StationRepository stations(connection);
    const std::optional<std::int64_t> before_us = stations.lastHeartbeatUtc_us(state.station);
    if (written_us_ && before_us && before_us != written_us_) {
      twinSeen_us_ = now_us;
    }
    stations.heartbeat(state);
    notice_ = moveNotice(connection);
    written_us_ = now_us;
    shownTrial_ = trial;
    if (there) {
      next_us_ = now_us + kHeartbeat_us;
    }
    answered_ = true;
  } catch (const DbError& error) {
    answered_ = error.fault() != DbFault::kUnreachable;
    shownTrial_.clear();
    next_us_ = now_us + kHeartbeat_us;  // each attempt may take seconds while the server is unreachable
  }
}

bool StationHeartbeat::hasTwin() const {
  return twinSeen_us_ && session_->now_us() - *twinSeen_us_ < 2 * kStationSilence_us;
}

void StationHeartbeat::leave() {
  try {
    StationRepository(session_->connectionWithoutRight()).leave(session_->station());
  } catch (const DbError& error) {
    answered_ = error.fault() != DbFault::kUnreachable;
    shownTrial_.clear();
  }
  changed_ = true;
}

}  // namespace torsio
