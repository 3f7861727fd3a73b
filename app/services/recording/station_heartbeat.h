// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/devices/device_readiness.h"
#include "assessment/domain/ids.h"

namespace torsio {

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
  bool changed_ = true;
  bool answered_ = true;
};

}  // namespace torsio
