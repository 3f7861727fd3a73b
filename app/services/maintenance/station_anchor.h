// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "sim/core/text.h"

namespace torsio {

class Connection;

/// Where this station stores heads of the audit trail, and the key that signs them. Settings of the station's
/// account rather than the record: somebody with access to the record must not be able to change them.
struct StationAnchor {
  std::filesystem::path witness{};  ///< file outside the record's disk; empty: none
  std::filesystem::path key{};      ///< empty: heads are unsigned
};

[[nodiscard]] StationAnchor stationAnchor();
/// Throws Error (kFileUnwritable, kFileMissing, kBadData) if the witness is a database or the key file has no
/// key.
void setStationAnchor(const StationAnchor& anchor);

/// Returns true once at a station without a key, so that the reminder is shown once.
[[nodiscard]] bool remindOfKey();

/// The head of a record at sign-off.
struct LeftHead {
  std::string line{};               ///< from anchoredHead()
  std::filesystem::path witness{};  ///< file of this station that it was appended to; empty: none
  Text trouble{};  ///< why it was not signed or not appended despite the settings; "": no problem
};
/// Signs the record's head with this station's key and appends it to its witness file, as far as they are
/// configured. Throws Error, DbError.
LeftHead witnessHead(Connection& connection, std::int64_t now_us);
/// Like witnessHead(), but reports an unusable key or witness file in the result, and then does not sign the
/// head. Throws DbError.
[[nodiscard]] LeftHead headOnLeaving(Connection& connection, std::int64_t now_us);

}  // namespace torsio
