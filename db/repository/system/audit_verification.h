// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"

namespace torsio {

/// Receives the progress of verifyAuditTrail(): recordings read, and their total. May throw to cancel.
using VerifyProgress = std::function<void(std::int64_t done, std::int64_t all)>;

/// Verifies the chain of the audit trail, compares every sealed mark and trial with its row, and looks for
/// rows without an entry. On a server, leaves out tables of which the current user sees only some rows
/// (tablesSeenInPart()); the owner sees all. Trials are decoded and checked chunk by chunk. Empty: no
/// tampering was found. Throws Error (kPermission: requireEveryRow()), DbError.
[[nodiscard]] std::vector<AuditFinding> verifyAuditTrail(Connection& connection,
                                                         const VerifyProgress& progress = {});

}  // namespace torsio
