// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "app/services/access/session_context.h"
#include "app/services/devices/device_readiness.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// How patient a StationWriter is. Tests use shorter times.
struct LinePatience {
  std::chrono::milliseconds again{3'000};      ///< between two tries while the database is away
  std::chrono::milliseconds heartbeat{1'000};  ///< between two looks whether a heartbeat is due
  std::chrono::milliseconds silence{3'000};    ///< an answer that takes longer is none
  std::chrono::milliseconds farewell{2'000};   ///< for what is still to be written when the line ends
};

/// The line of one station to its database, on a thread and a connection of its own, so that nobody who looks
/// at a window waits for a server: heartbeats (StationHeartbeat), and small writes that need no answer.
/// Writes keep their order and are tried again while the database is away. A server that neither answers nor
/// refuses holds up this thread and nothing else.
class StationWriter {
 public:
  /// Opens the database; throws Error, DbError. Called in the line's thread.
  using Open = std::function<std::unique_ptr<SessionContext>()>;
  using Write = std::function<void(SessionContext&)>;

  explicit StationWriter(const SessionKey& key, const LinePatience& patience = {});
  StationWriter(Open open, const LinePatience& patience);
  /// Waits `farewell` at most.
  ~StationWriter();
  StationWriter(const StationWriter&) = delete;
  StationWriter& operator=(const StationWriter&) = delete;

  /// Who sits at the station from now on: shown on the board, and the actor of the writes that follow.
  void signIn(const Actor& actor);
  /// Which trial runs; empty: none.
  void show(const TrialId& trialId);
  /// Which device this station has. One that was not checked takes the place of none, or of another one, but
  /// never of a check of the same.
  void showDevice(const StationDevice& device);
  /// Does it soon, as the present actor. What the database refuses for good is given up and counted.
  void write(Write write);

  /// False while the database is away: the last try failed, or the present one has lasted too long.
  [[nodiscard]] bool answers() const;
  [[nodiscard]] std::size_t waiting() const;
  [[nodiscard]] std::size_t refused() const;
  /// Waits until everything was written and shown. False when it took longer than `limit`.
  [[nodiscard]] bool settled(std::chrono::milliseconds limit) const;
  /// The station is closed in good order: it leaves the board, and the line ends. Waits `farewell` at most.
  void leave();

 private:
  struct State;
  static void run(const std::shared_ptr<State>& state);
  void end(bool leaveBoard);

  std::shared_ptr<State> state_;
  std::thread thread_;
};

}  // namespace torsio
