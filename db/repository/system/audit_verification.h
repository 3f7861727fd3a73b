// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"

namespace torsio {

/// Hears how far verifyAuditTrail() is: recordings read, of all. May throw to give up.
using VerifyProgress = std::function<void(std::int64_t done, std::int64_t all)>;

/// Walks the whole chain of the audit trail, then compares every sealed mark and trial with its row, and
/// looks for rows that no entry tells of. Trials are decoded down to their chunk digests. Empty: nothing was
/// tampered with. Throws Error (kPermission: requireEveryRow()), DbError.
[[nodiscard]] std::vector<AuditFinding> verifyAuditTrail(Connection& connection,
                                                         const VerifyProgress& progress = {});

}  // namespace torsio
