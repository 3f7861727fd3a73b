// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "app/services/maintenance/station_anchor.h"
#include "assessment/domain/people/audit_entry.h"
#include "sim/core/text.h"

namespace torsio {

class SessionContext;

/// Status of this station's heads.
struct StationHeads {
  StationAnchor anchor{};
  std::string publicKey{};       ///< empty: no usable key
  Text trouble{};                ///< why key or witness cannot be used; "": no problem
  std::int64_t kept = 0;         ///< lines of the witness file
  bool witnessOnDisk = false;    ///< on the record's disk: a stolen disk would contain both
  bool keyBesideRecord = false;  ///< in the record's folder
};

/// Requires the right to see the audit trail.
[[nodiscard]] StationHeads stationHeads(SessionContext& session);
/// Returns the current head as one line, signed if this station has a key. Writes nothing. Requires the right
/// to see the audit trail. Throws Error, DbError.
[[nodiscard]] std::string headNow(SessionContext& session);
/// Appends the current head to this station's witness file. Requires the right to see the audit trail. Throws
/// Error (kUsage: no witness file is set), DbError.
void keepHeadNow(SessionContext& session);

/// Sets the file in which this station stores heads and writes the first one; empty: none. Requires the right
/// to change settings; audited. Throws Error.
void chooseWitness(SessionContext& session, const std::filesystem::path& file);
/// Creates a new signing key for this station. If there is one already, the witness file gets the line signed
/// by both, and the old key file stays. Requires the right to change settings; audited with the public key.
/// Throws Error.
void makeStationKey(SessionContext& session, const std::filesystem::path& file);
/// Sets an existing signing key; empty: no signing. Requires the right to change settings; audited. Throws
/// Error.
void chooseStationKey(SessionContext& session, const std::filesystem::path& file);

/// Compares the record with lines stored elsewhere like compareWithHeads(); an empty `publicKey` means this
/// station's key, if any. Requires the right to see the audit trail; audited.
[[nodiscard]] std::vector<AuditFinding> verifyHeads(SessionContext& session,
                                                    const std::vector<std::string>& lines,
                                                    const std::string& publicKey);

}  // namespace torsio
