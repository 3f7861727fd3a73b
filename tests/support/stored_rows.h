// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/repository/trial/station_repository.h"

namespace torsio {

/// Returns the codes of every role of the record, in their order. Throws DbError.
[[nodiscard]] inline std::vector<std::string> storedRoles(Connection& connection) {
  return selectAll(connection, "SELECT code FROM role ORDER BY code", {}, readText);
}

/// Returns the codes of every operation of the record, in their order. Throws DbError.
[[nodiscard]] inline std::vector<std::string> storedOperations(Connection& connection) {
  return selectAll(connection, "SELECT code FROM operation ORDER BY code", {}, readText);
}

/// Returns every pair of role and operation that the record allows. Throws DbError.
[[nodiscard]] inline std::set<std::pair<std::string, std::string>> storedPermissions(Connection& connection) {
  const auto all =
      selectAll(connection, "SELECT role_code, operation_code FROM role_operation", {}, [](RowReader& row) {
        return std::pair<std::string, std::string>{row.text(), row.text()};
      });
  return {all.begin(), all.end()};
}

/// Returns a station's state on the board; empty: not there. Throws DbError.
[[nodiscard]] inline std::optional<StationState> stationOnBoard(Connection& connection,
                                                                const std::string& station) {
  for (const StationState& state : StationRepository(connection).board()) {
    if (state.station == station) {
      return state;
    }
  }
  return std::nullopt;
}

}  // namespace torsio
