// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/services/maintenance/anchor.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"

namespace torsio {

/// Compares the trail of a record that nobody has open with lines stored elsewhere.
[[nodiscard]] inline std::vector<AuditFinding> compareWithHeads(const std::string& locator,
                                                                const std::vector<std::string>& lines,
                                                                const std::string& publicKey) {
  Connection connection = openRecord(locator, OpenMode::kReadOnly);
  return compareWithHeads(connection, lines, publicKey);
}

}  // namespace torsio
