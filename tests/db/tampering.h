// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"

namespace torsio {

/// Disables every guard of a record: triggers, references, checks.
void disarm(Connection& connection);

/// Verifies rows, trail and schema; returns one sentence per finding.
[[nodiscard]] std::vector<std::string> allFindings(Connection& connection);

/// Appends an entry with a well-formed seal of every row whose seal no longer matches, as an expert attacker
/// would.
void forgeSeals(Connection& connection, AuditAction action, AuditObject object, const std::string& objectId);

/// Rewrites all seals to match the present rows, and the chain to be consistent.
void rewriteTrail(Connection& connection);

}  // namespace torsio
