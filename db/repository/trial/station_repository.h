// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"

namespace torsio {

/// Heartbeats of all stations: what they record, for the board and for taking over a station.
class StationRepository {
 public:
  explicit StationRepository(Connection& connection) : connection_(connection) {}

  /// Adds or replaces the row of a station. Throws DbError (kForeignKey) if the trial does not exist.
  void heartbeat(const StationState& state);
  /// Returns the time of a station's last heartbeat; empty: it has left, or none was heard.
  [[nodiscard]] std::optional<std::int64_t> lastHeartbeatUtc_us(const std::string& station) const;
  /// Records that the station was shut down properly.
  void leave(const std::string& station);
  /// All stations, by name.
  [[nodiscard]] std::vector<StationState> board() const;

 private:
  Connection& connection_;
};

}  // namespace torsio
