// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/core/text.h"

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

/// The head of a record when somebody left it.
struct LeftHead {
  std::string line{};               ///< as anchoredHead() makes it
  std::filesystem::path witness{};  ///< file of this station that it was added to; empty: none
  Text trouble{};  ///< why it was not signed or not added though it should have been; "": nothing
};
/// Signs the head of the record with the key of this station and adds it to its witness file, as far as they
/// are set. Throws Error, DbError.
LeftHead witnessHead(Connection& connection, std::int64_t now_us);
/// The same, but a key or a witness file that cannot be used is told in the answer, and the head is not
/// signed then. Throws DbError.
[[nodiscard]] LeftHead headOnLeaving(Connection& connection, std::int64_t now_us);

}  // namespace torsio
