// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// Condition for the demonstration rows of a table: those with the flag, and those that belong to such a row
/// (the seconds of a simulated trial).
struct DemonstrationRows {
  std::string table;
  std::string condition;  ///< over the table's columns; "FALSE": there are none
  std::int64_t rows = 0;
};

/// Returns the conditions of all tables, parents first.
[[nodiscard]] std::vector<DemonstrationRows> demonstrationRows(Connection& connection);

/// True if the record is a demonstration: there are rows with a demonstration flag, and it is set in all of
/// them.
[[nodiscard]] bool holdsOnlySimulated(Connection& connection);

/// Removes all demonstration data through the erasure gate, in one transaction, with an audit entry for every
/// removed sealed mark and trial and one for the whole. Real rows are unchanged; a station that shows a
/// simulated trial shows none. Returns the removed rows by table, children first, without empty tables.
/// Throws Error (kBadData) naming the table if a real row refers to a simulated one, and (kPermission) on a
/// station of a prepared server; nothing is removed then.
std::vector<DemonstrationRows> removeDemonstration(Connection& connection, const std::string& requestedBy,
                                                   const std::string& station, const std::string& reason,
                                                   std::int64_t utc_us);

}  // namespace torsio
