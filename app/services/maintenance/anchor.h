// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"

namespace torsio {

class Connection;

/// Makes a new key that signs heads of the audit trail (Ed25519) in a file of its own that nobody else can
/// read. Returns its public part, 64 hexadecimal digits, by which signatures are checked. Throws Error
/// (kFileUnwritable) when the file exists.
[[nodiscard]] std::string makeAnchorKey(const std::filesystem::path& file);
/// Makes a new key in place of the one in `old`, whose heads it vouches for up to now. Returns its public
/// part and the line that says so, signed by both: "torsio-key 1 OLD NEW LENGTH TIME SIGNATURE SIGNATURE",
/// which is kept in the key's file, and added to `witness` unless that is empty. A call that was cut off is
/// brought to its end by the same call. Throws Error as makeAnchorKey(), publicAnchorKey() and
/// appendToWitness(), DbError.
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
/// Public part of the key in `file`. Throws Error: kFileMissing, kBadData, kPermission when other accounts
/// can read it.
[[nodiscard]] std::string publicAnchorKey(const std::filesystem::path& file);

/// The head of the audit trail as one line to be kept elsewhere: "torsio-head 1 LENGTH HASH TIME PUBLIC
/// SIGNATURE", time in microseconds since 1970 UTC; "-" for the last two when `key` is empty. Throws Error,
/// DbError.
[[nodiscard]] std::string anchoredHead(const std::string& locator, const std::filesystem::path& key,
                                       std::int64_t now_us);
[[nodiscard]] std::string anchoredHead(Connection& connection, const std::filesystem::path& key,
                                       std::int64_t now_us);
/// What such a line says.
struct AnchoredHead {
  std::int64_t length = 0;  ///< entries of the trail
  std::string hash{};       ///< of the newest one; "-": there is none
  std::int64_t utc_us = 0;
  std::string publicKey = "-";  ///< "-": nobody signed it
  std::string signature = "-";
  [[nodiscard]] bool isSigned() const { return signature != "-"; }
};
/// Throws Error (kBadData) for a line that is no head.
[[nodiscard]] AnchoredHead readHead(const std::string& line);
/// Adds a line to a witness file, whole or not at all; makes the file. One that was cut off at its end goes.
/// Throws Error (kFileUnwritable).
void appendToWitness(const std::filesystem::path& witness, const std::string& head);

/// Compares the audit trail with lines that were kept elsewhere: finds entries that were cut off, a chain
/// that was rewritten, an older file in the record's place, a head that was signed neither with `publicKey`
/// (empty: the key that the first signed head names) nor, in its time, with a key that it replaced or that
/// replaced it. A head without a signature counts where a later one with a signature fits. Throws Error
/// (kBadData) for a line that is no head, DbError.
[[nodiscard]] std::vector<AuditFinding> compareWithHeads(Connection& connection,
                                                         const std::vector<std::string>& lines,
                                                         const std::string& publicKey);
[[nodiscard]] std::vector<AuditFinding> compareWithHeads(const std::string& locator,
                                                         const std::vector<std::string>& lines,
                                                         const std::string& publicKey);
/// Lines of a witness file, but for one that was cut off at its end. Throws Error: kFileMissing; kBadData
/// when it is empty.
[[nodiscard]] std::vector<std::string> headsOf(const std::filesystem::path& witness);

}  // namespace torsio
