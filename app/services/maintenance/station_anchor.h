// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/services/maintenance/stamped_heads.h"
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

/// A signature of this station's key.
struct StationSignature {
  std::string publicKey{};
  std::string signature{};
};
/// Signs a text with this station's key; empty without a key. Throws Error if the key cannot be used.
[[nodiscard]] std::optional<StationSignature> signedByStation(const std::string& text);

/// The head of a record at sign-off.
struct LeftHead {
  std::string line{};               ///< from anchoredHead()
  std::filesystem::path witness{};  ///< file of this station that it was appended to; empty: none
  Text trouble{};  ///< why it was not signed or not appended despite the settings; "": no problem
  Text noStamp{};  ///< why it has no time stamp although the centre names an authority; "": no problem
};
/// Signs the record's head with this station's key and appends it to its witness file, and then a time stamp
/// of it, waiting at most `patience`: as far as they are configured. Throws Error, DbError.
LeftHead witnessHead(Connection& connection, std::int64_t now_us,
                     std::chrono::milliseconds patience = kStampPatience);
/// Like witnessHead(), but waits less, for somebody wants to leave, and reports an unusable key or witness
/// file in the result, and then does not sign the head. Throws DbError.
[[nodiscard]] LeftHead headOnLeaving(Connection& connection, std::int64_t now_us);

class SessionContext;

/// Status of this station's heads.
struct StationHeads {
  StationAnchor anchor{};
  std::string publicKey{};       ///< empty: no usable key
  Text trouble{};                ///< why key or witness cannot be used; "": no problem
  std::int64_t kept = 0;         ///< lines of the witness file
  bool witnessOnDisk = false;    ///< on the record's disk: a stolen disk would contain both
  bool keyBesideRecord = false;  ///< in the record's folder
  std::string authority{};       ///< address that heads are stamped by; empty: none
};

/// Requires the right to see the audit trail.
[[nodiscard]] StationHeads stationHeads(SessionContext& session);
/// Returns the current head as one line, signed if this station has a key. Writes nothing. Requires the right
/// to see the audit trail. Throws Error, DbError.
[[nodiscard]] std::string headNow(SessionContext& session);
/// Appends the current head to this station's witness file, with a time stamp if the centre names an
/// authority. Requires the right to see the audit trail. Returns why it has no stamp; "": no problem. Throws
/// Error (kUsage: no witness file is set), DbError.
Text keepHeadNow(SessionContext& session);

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

/// Compares the record with lines stored elsewhere like judgeHeads(); an empty `publicKey` means this
/// station's key, if any. Requires the right to see the audit trail; audited.
[[nodiscard]] HeadsVerdict verifyHeads(SessionContext& session, const std::vector<std::string>& lines,
                                       const std::string& publicKey);

}  // namespace torsio
