// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/centres/sound_record.h"

#include <vector>

#include "db/repository/system/audit_verification.h"
#include "sim/core/error.h"

namespace torsio {

void requireSound(Connection& connection, const Text& what) {
  const std::vector<AuditFinding> findings = verifyAuditTrail(connection);
  if (!findings.empty()) {
    const AuditFinding& first = findings.front();
    throw Error(ErrorCode::kVerifyFailed,
                Text::tr("%1: %2 {finding|findings}, the first one: %3", what, findings.size(),
                         first.objectKind + " " + first.objectId + " " + first.what),
                connection.location(), Text::tr("Run torsio audit verify on it; nothing was changed"));
  }
}

}  // namespace torsio
