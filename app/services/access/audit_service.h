// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/people/audit_entry.h"

namespace torsio {

/// Returns entries, latest first. kAuditView.
[[nodiscard]] std::vector<AuditEntry> auditEntries(SessionContext& session, const AuditFilter& filter = {});
/// Counts the entries from `fromUtc_us` to `toUtc_us`, inclusive. kAuditView.
[[nodiscard]] std::int64_t auditEntryCount(SessionContext& session, std::int64_t fromUtc_us,
                                           std::int64_t toUtc_us = INT64_MAX);
/// Returns sign-in names by the ids in the entries. kAuditView.
[[nodiscard]] std::map<std::string, std::string> auditActors(SessionContext& session);
/// Returns codes by the ids of the subjects of the entries from `fromSequence` on: "T-30", "R-03: 7F".
/// kAuditView.
[[nodiscard]] std::map<std::string, std::string> auditSubjectCodes(SessionContext& session,
                                                                   std::int64_t fromSequence);
/// Verifies the whole chain and compares every sealed mark and trial with its row. The check and its result
/// are audited. Takes seconds with many trials. kAuditView.
[[nodiscard]] std::vector<AuditFinding> verifyAudit(SessionContext& session);

/// Returns the text that is signed for a head of the trail: "torsio-head 1 LENGTH HASH TIME"; "-" for an
/// empty `hash`.
[[nodiscard]] std::string headWords(std::int64_t length, const std::string& hash, std::int64_t utc_us);
/// Returns the current head, unsigned, as one cell of an exported table. Throws DbError.
[[nodiscard]] std::string plainHead(Connection& connection, std::int64_t now_us);

}  // namespace torsio
