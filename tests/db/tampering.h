// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// Switches every guard of a record off: triggers, references, checks.
void disarm(Connection& connection);

/// What verification says, one sentence a finding: of the rows, the trail and the schema.
[[nodiscard]] std::vector<std::string> allFindings(Connection& connection);

/// Appends an entry and a well-formed seal of every row that no longer fits its own, as somebody would who
/// knows how Torsio does it.
void forgeSeals(Connection& connection, AuditAction action, AuditObject object, const std::string& objectId);

/// Makes every seal fit the rows as they are now and the whole chain fit itself.
void rewriteTrail(Connection& connection);

}  // namespace torsio
