// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "app/services/access/session_context.h"
#include "app/services/devices/device_readiness.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// Time-outs of a StationWriter. Tests use shorter ones.
struct LinePatience {
  std::chrono::milliseconds again{3'000};      ///< between attempts while the database is unreachable
  std::chrono::milliseconds heartbeat{1'000};  ///< between checks whether a heartbeat is due
  std::chrono::milliseconds silence{3'000};    ///< an attempt that takes longer counts as failed
  std::chrono::milliseconds farewell{2'000};   ///< for pending writes at the end
};

/// Writes a station's heartbeats (StationHeartbeat) and small changes that need no result to the database, on
/// its own thread and connection, so that the window never waits for a server. Writes keep their order and
/// are retried while the database is unreachable. A server that hangs blocks only this thread.
class StationWriter {
 public:
  /// Opens the database; throws Error, DbError. Called in the writer's thread.
  using Open = std::function<std::unique_ptr<SessionContext>()>;
  using Write = std::function<void(SessionContext&)>;

  explicit StationWriter(const SessionKey& key, const LinePatience& patience = {});
  StationWriter(Open open, const LinePatience& patience);
  /// Waits at most `farewell`.
  ~StationWriter();
  StationWriter(const StationWriter&) = delete;
  StationWriter& operator=(const StationWriter&) = delete;

  /// Sets the user at the station: shown on the board, and the actor of later writes.
  void signIn(const Actor& actor);
  /// Sets the running trial; empty: none.
  void show(const TrialId& trialId);
  /// Sets this station's device. An unchecked one replaces none or a different one, but never a checked one
  /// of the same name.
  void showDevice(const StationDevice& device);
  /// Queues a write as the current actor. Writes that the database rejects permanently are dropped and
  /// counted.
  void write(Write write);

  /// Returns false while the database is unreachable: the last attempt failed, or the current one takes too
  /// long.
  [[nodiscard]] bool answers() const;
  /// Returns whether the station has a twin (StationHeartbeat::hasTwin()).
  [[nodiscard]] bool hasTwin() const;
  /// Returns what people at the station must know of the record (moveNotice()); empty: nothing.
  [[nodiscard]] Text notice() const;
  [[nodiscard]] std::size_t waiting() const;
  [[nodiscard]] std::size_t refused() const;
  /// Waits until all writes and heartbeats are done. Returns false after `limit`.
  [[nodiscard]] bool settled(std::chrono::milliseconds limit) const;
  /// Closes the station properly: removes it from the board and ends the thread. Waits at most `farewell`.
  void leave();

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);
  void end(bool leaveBoard);

  std::shared_ptr<State> state_;
  std::thread thread_;
};

/// Interval of heartbeats: three fit into kStationSilence_us.
inline constexpr std::int64_t kHeartbeat_us = 10'000'000;

/// Writes the heartbeats of this station (StationRepository): signed-in user, running trial, version, device.
/// Belongs to its session's thread. An unreachable database is no error here: the board then shows the
/// station as silent.
class StationHeartbeat {
 public:
  explicit StationHeartbeat(SessionContext& session) : session_(&session) {}

  /// Sets the running trial; empty: none. Shown with the first heartbeat that finds it in the database.
  void show(const TrialId& trialId);
  /// Sets this station's device and the result of its last check.
  void showDevice(const StationDevice& device);
  /// Call it often: writes after a change or every kHeartbeat_us.
  void send();
  /// Returns whether somebody else has lately written heartbeats as this station (twinWords()): another
  /// window with the same settings, or a copy of the computer.
  [[nodiscard]] bool hasTwin() const;
  /// Returns the moveNotice() of the last heartbeat.
  [[nodiscard]] const Text& notice() const noexcept { return notice_; }
  /// Returns false if the database was unreachable at the last heartbeat.
  [[nodiscard]] bool answered() const noexcept { return answered_; }
  /// Reports that the station closes down.
  void leave();

 private:
  SessionContext* session_;
  TrialId trialId_;
  StationDevice device_;
  std::string shownTrial_;
  std::string shownUser_;
  std::int64_t next_us_ = 0;
  std::optional<std::int64_t> written_us_{};  ///< of the last heartbeat
  std::optional<std::int64_t> twinSeen_us_{};
  Text notice_;
  bool changed_ = true;
  bool answered_ = true;
};

}  // namespace torsio
