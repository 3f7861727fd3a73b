// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assessment/people/audit_entry.h"

namespace torsio {

class Connection;

/// Makes a new key that signs heads of the audit trail (Ed25519) in a file of its own that nobody else can
/// read. Returns its public part, 64 hexadecimal digits, by which signatures are checked. Throws Error
/// (kFileUnwritable) when the file exists.
[[nodiscard]] std::string makeAnchorKey(const std::filesystem::path& file);
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
/// Adds a line to a witness file; makes the file. Throws Error (kFileUnwritable).
void appendToWitness(const std::filesystem::path& witness, const std::string& head);

/// Compares the audit trail with heads that were kept elsewhere: finds entries that were cut off, a chain
/// that was rewritten, an older file in the record's place, a head that nobody signed with `publicKey`
/// (empty: the key that the first signed head names). Throws Error (kBadData) for a line that is no head,
/// DbError.
[[nodiscard]] std::vector<AuditFinding> compareWithHeads(const std::string& locator,
                                                         const std::vector<std::string>& heads,
                                                         const std::string& publicKey);
/// Heads of a witness file, one a line. Throws Error: kFileMissing; kBadData when it is empty.
[[nodiscard]] std::vector<std::string> headsOf(const std::filesystem::path& witness);

}  // namespace torsio
