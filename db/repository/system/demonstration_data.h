// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// Which rows of a table are demonstration data: those with the flag, and those that belong to such a row
/// (the seconds of a simulated trial).
struct DemonstrationRows {
  std::string table;
  std::string condition;  ///< over the table's columns; "FALSE": the table never holds any
  std::int64_t rows = 0;
};

/// For every table, parents first.
[[nodiscard]] std::vector<DemonstrationRows> demonstrationRows(Connection& connection);

/// Whether every row that carries the flag of a demonstration has it set: nobody and nothing here is real. A
/// record without any such row is no demonstration.
[[nodiscard]] bool holdsOnlySimulated(Connection& connection);

/// Removes all demonstration data through the erasure gate, in one transaction, with an entry in the audit
/// trail for every sealed mark and trial that goes and one for the whole. Real rows stay as they are; a
/// station that shows a simulated trial shows none. Returns what was removed, children first, without tables
/// that had nothing. Throws Error (kBadData) naming the table when a real row uses a simulated one, and
/// (kPermission) as a station of a prepared server; nothing is removed then.
std::vector<DemonstrationRows> removeDemonstration(Connection& connection, const std::string& requestedBy,
                                                   const std::string& station, const std::string& reason,
                                                   std::int64_t utc_us);

}  // namespace torsio
