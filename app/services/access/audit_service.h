// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/audit_entry.h"

namespace torsio {

/// Newest first. kAuditView.
[[nodiscard]] std::vector<AuditEntry> auditEntries(SessionContext& session, const AuditFilter& filter = {});
/// How many there are from `fromUtc_us` to `toUtc_us`, both included. kAuditView.
[[nodiscard]] std::int64_t auditEntryCount(SessionContext& session, std::int64_t fromUtc_us,
                                           std::int64_t toUtc_us = INT64_MAX);
/// Sign-in names by the ids that stand in the entries. kAuditView.
[[nodiscard]] std::map<std::string, std::string> auditActors(SessionContext& session);
/// Codes by the ids of what the entries from `fromSequence` on are about: "T-30", "R-03: 7F". kAuditView.
[[nodiscard]] std::map<std::string, std::string> auditSubjectCodes(SessionContext& session,
                                                                   std::int64_t fromSequence);
/// Walks the whole chain and compares every sealed mark and trial with its row. That somebody looked, and
/// what was found, is audited. Takes seconds with many trials. kAuditView.
[[nodiscard]] std::vector<AuditFinding> verifyAudit(SessionContext& session);

/// What is signed of a head of the trail: "torsio-head 1 LENGTH HASH TIME"; `hash` empty: "-".
[[nodiscard]] std::string headWords(std::int64_t length, const std::string& hash, std::int64_t utc_us);
/// The head now, without a signature, as one cell of a table that leaves the record. Throws DbError.
[[nodiscard]] std::string plainHead(Connection& connection, std::int64_t now_us);

}  // namespace torsio
