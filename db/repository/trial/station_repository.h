// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/study/station_state.h"
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
  [[nodiscard]] std::optional<StationState> find(const std::string& station) const;
  /// All, by name.
  [[nodiscard]] std::vector<StationState> board() const;
  /// Who owns a trial that runs: the station that last showed it with a sign of life after
  /// `aliveSinceUtc_us`, unless the trial has ended. Empty: nobody, so that its own station may close it.
  [[nodiscard]] std::optional<StationState> ownerOf(const std::string& trialId,
                                                    std::int64_t aliveSinceUtc_us) const;

 private:
  Connection& connection_;
};

}  // namespace torsio
