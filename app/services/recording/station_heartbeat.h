// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/devices/device_readiness.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// Between two heartbeats: three fit into kStationSilence_us.
inline constexpr std::int64_t kHeartbeat_us = 10'000'000;

/// The heartbeats of this station (StationRepository): who is signed in, which trial runs, which version,
/// which device.
/// Belongs to the thread of its session. A database that is away is no error here: the board then shows
/// that the station is silent.
class StationHeartbeat {
 public:
  explicit StationHeartbeat(SessionContext& session) : session_(&session) {}

  /// What runs from now on; empty: nothing. Shown with the next heartbeat that finds it in the database.
  void show(const TrialId& trialId);
  /// Which device this station has, and what its last check found.
  void showDevice(const StationDevice& device);
  /// Call it often: it writes when something changed or kHeartbeat_us have passed.
  void send();
  /// False when the database was away at the last heartbeat.
  [[nodiscard]] bool answered() const noexcept { return answered_; }
  /// The station is closed down in good order.
  void leave();

 private:
  SessionContext* session_;
  TrialId trialId_;
  StationDevice device_;
  std::string shownTrial_;
  std::string shownUser_;
  std::int64_t next_us_ = 0;
  bool changed_ = true;
  bool answered_ = true;
};

}  // namespace torsio
