// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/access/session_context.h"
#include "assessment/people/audit_entry.h"

namespace torsio {

/// Newest first. kAuditView.
[[nodiscard]] std::vector<AuditEntry> auditEntries(SessionContext& session, const AuditFilter& filter = {});
/// How many there are since `fromUtc_us`. kAuditView.
[[nodiscard]] std::int64_t auditEntryCount(SessionContext& session, std::int64_t fromUtc_us);
/// Sign-in names by the ids that stand in the entries. kAuditView.
[[nodiscard]] std::map<std::string, std::string> auditActors(SessionContext& session);
/// Walks the whole chain and compares every sealed mark and trial with its row. That somebody looked, and
/// what was found, is audited. Takes seconds with many trials. kAuditView.
[[nodiscard]] std::vector<AuditFinding> verifyAudit(SessionContext& session);

}  // namespace torsio
