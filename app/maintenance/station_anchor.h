// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace torsio {

class Connection;

/// Where this station keeps heads of the audit trail, and the key that signs them. Of the station and its
/// account, not of the record: somebody with the record in hand must not be able to change it.
struct StationAnchor {
  std::filesystem::path witness{};  ///< file outside the record's disk; empty: none is kept
  std::filesystem::path key{};      ///< empty: heads are not signed
};

[[nodiscard]] StationAnchor stationAnchor();
/// Throws Error (kFileUnwritable, kFileMissing, kBadData) when the witness is a database or the key none.
void setStationAnchor(const StationAnchor& anchor);

/// True once at a station without a key, so that it is told once.
[[nodiscard]] bool remindOfKey();

/// Adds the head of the record to the witness file of this station; does nothing where none is set. Throws
/// Error, DbError.
void witnessHead(Connection& connection, std::int64_t now_us);

}  // namespace torsio
