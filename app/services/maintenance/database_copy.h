// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "db/repository/system/record_copy.h"

namespace torsio {

/// Copies a record to another database: SQLite to PostgreSQL or back. Reads the source as of one moment
/// without changing it; the target must be a new file or an empty database, and receives everything in one
/// transaction or stays as it was. Compares counts and hashes of every table and verifies the target's audit
/// trail before committing. Audited in the source before copying (so in the copy too) and after a failure.
/// kDatabaseRestore. Throws Error: kUsage if both are the same, kBadData if the target is not empty,
/// kVerifyFailed if the copy differs.
[[nodiscard]] CopyReport copyDatabase(SessionContext& session, const std::string& to,
                                      const ProgressCallback& progress = {});

}  // namespace torsio
