// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "db/repository/system/record_copy.h"

namespace torsio {

/// Moves a centre to another database: SQLite to PostgreSQL or back. The source is read as it was at one
/// moment and stays as it is; the target must be a new file or an empty database, and gets all, tables and
/// rows, in one transaction, or stays as it was.
/// Counts and hashes of every table are compared, and the audit trail of the target is verified, before the
/// copy is kept. The source gets an audit entry before, which is copied too, and another when it failed.
/// kDatabaseRestore. Throws Error: kUsage when both are the same, kBadData when the target is not empty,
/// kVerifyFailed when the copy differs.
[[nodiscard]] CopyReport copyDatabase(SessionContext& session, const std::string& to,
                                      const ProgressCallback& progress = {});

}  // namespace torsio
