// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"

namespace torsio {

class Connection;

/// Creates a key for signing heads of the audit trail (Ed25519) in a file readable only by its owner. Returns
/// the public key, 64 hexadecimal digits. Throws Error (kFileUnwritable) if the file exists.
[[nodiscard]] std::string makeAnchorKey(const std::filesystem::path& file);
/// Creates a new key to replace the one in `old`, confirming the old key's heads so far. Returns the public
/// key and the line of the replacement, signed by both: "torsio-key 1 OLD NEW LENGTH TIME SIGNATURE
/// SIGNATURE", stored in the key file and appended to `witness` unless that is empty. An interrupted call can
/// be completed by repeating it. Throws Error like makeAnchorKey(), publicAnchorKey() and appendToWitness(),
/// DbError.
struct ReplacedKey {
  std::string publicKey{};
  std::string line{};
};
ReplacedKey replaceAnchorKey(const std::string& locator, const std::filesystem::path& old,
                             const std::filesystem::path& file, const std::filesystem::path& witness,
                             std::int64_t now_us);
ReplacedKey replaceAnchorKey(Connection& connection, const std::filesystem::path& old,
                             const std::filesystem::path& file, const std::filesystem::path& witness,
                             std::int64_t now_us);
/// Returns the public key of the key in `file`. Throws Error: kFileMissing, kBadData, kPermission if other
/// accounts can read it.
[[nodiscard]] std::string publicAnchorKey(const std::filesystem::path& file);

/// Returns the head of the audit trail as a line to store elsewhere: "torsio-head 1 LENGTH HASH TIME PUBLIC
/// SIGNATURE", time in microseconds since 1970 UTC; "-" for the last two if `key` is empty. Throws Error,
/// DbError.
[[nodiscard]] std::string anchoredHead(const std::string& locator, const std::filesystem::path& key,
                                       std::int64_t now_us);
[[nodiscard]] std::string anchoredHead(Connection& connection, const std::filesystem::path& key,
                                       std::int64_t now_us);
/// A parsed head.
struct AnchoredHead {
  std::int64_t length = 0;  ///< number of entries
  std::string hash{};       ///< of the latest entry; "-": no entries
  std::int64_t utc_us = 0;
  std::string publicKey = "-";  ///< "-": unsigned
  std::string signature = "-";
  [[nodiscard]] bool isSigned() const { return signature != "-"; }
};
/// Throws Error (kBadData) if the line is not a head.
[[nodiscard]] AnchoredHead readHead(const std::string& line);
inline constexpr const char* kHeadWord = "torsio-head";  ///< first word of such a line
/// Appends a line to a witness file, creating it if missing; all or nothing. Removes an incomplete last line.
/// Throws Error (kFileUnwritable), also for a file that holds anything but such lines and for a link.
void appendToWitness(const std::filesystem::path& witness, const std::string& head);

/// Compares the audit trail with lines stored elsewhere. Detects a truncated trail, a rewritten chain, an
/// older file in the record's place, and a head signed neither with `publicKey` (empty: the key of the first
/// signed head) nor with a key valid at its time that replaced it or was replaced by it. An unsigned head
/// counts if a later signed one matches. Throws Error (kBadData) for an invalid line, DbError.
[[nodiscard]] std::vector<AuditFinding> compareWithHeads(Connection& connection,
                                                         const std::vector<std::string>& lines,
                                                         const std::string& publicKey);
/// Returns the lines of a witness file without an incomplete last one. Throws Error: kFileMissing; kBadData
/// if it is empty.
[[nodiscard]] std::vector<std::string> headsOf(const std::filesystem::path& witness);

}  // namespace torsio
