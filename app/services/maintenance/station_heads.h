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

/// What somebody at this station should know about its heads.
struct StationHeads {
  StationAnchor anchor{};
  std::string publicKey{};       ///< empty: no key, or none that can be used
  Text trouble{};                ///< why key or witness cannot be used; "": they can, as far as they are set
  std::int64_t kept = 0;         ///< lines of the witness file
  bool witnessOnDisk = false;    ///< of the record: whoever takes the disk has both
  bool keyBesideRecord = false;  ///< in its folder
};

/// Needs the right to see the audit trail.
[[nodiscard]] StationHeads stationHeads(SessionContext& session);
/// The head now as one line, signed where this station has a key. Writes nothing. Needs the right to see the
/// audit trail. Throws Error, DbError.
[[nodiscard]] std::string headNow(SessionContext& session);
/// Adds the head now to the witness file of this station. Needs the right to see the audit trail. Throws
/// Error (kUsage: no witness file is set), DbError.
void keepHeadNow(SessionContext& session);

/// From now on this station keeps heads in `file`, a first one at once; empty: nowhere. Needs the right to
/// change settings; audited. Throws Error.
void chooseWitness(SessionContext& session, const std::filesystem::path& file);
/// Makes the key with which this station signs from now on. One that it has already is replaced: the witness
/// file gets the line in which both vouch for each other, and the older file stays. Needs the right to change
/// settings; audited with the public part. Throws Error.
void makeStationKey(SessionContext& session, const std::filesystem::path& file);
/// Signs with a key that is there already; empty: signs no more. Needs the right to change settings; audited.
/// Throws Error.
void chooseStationKey(SessionContext& session, const std::filesystem::path& file);

/// Compares the record with lines that were kept elsewhere, as compareWithHeads(); `publicKey` empty: with
/// this station's key, where it has one. Needs the right to see the audit trail; audited.
[[nodiscard]] std::vector<AuditFinding> verifyHeads(SessionContext& session,
                                                    const std::vector<std::string>& lines,
                                                    const std::string& publicKey);

}  // namespace torsio
