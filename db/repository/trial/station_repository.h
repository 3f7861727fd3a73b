// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"

namespace torsio {

/// Signs of life of all stations: who records what where, for the board and for whoever wants to take over.
class StationRepository {
 public:
  explicit StationRepository(Connection& connection) : connection_(connection) {}

  /// Writes or overwrites the row of one station. Throws DbError (kForeignKey) when there is no such trial.
  void heartbeat(const StationState& state);
  /// The station is closed down in good order.
  void leave(const std::string& station);
  /// All, by name.
  [[nodiscard]] std::vector<StationState> board() const;

 private:
  Connection& connection_;
};

}  // namespace torsio
