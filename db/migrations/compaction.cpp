// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/compaction.h"

#include "db/connection/connection.h"
#include "db/connection/db_error.h"

namespace torsio {

namespace {

/// Runs housekeeping that other users may postpone.
void runWhenFree(Connection& connection, const char* sql) {
  if (connection.engine() != Engine::kSqlite || connection.inTransaction()) {
    return;
  }
  try {
    connection.executeVerbatim(sql);
  } catch (const DbError& error) {
    if (!error.retryable() && error.fault() != DbFault::kFull) {
      throw;
    }
  }
}

}  // namespace

void truncateLog(Connection& connection) {
  runWhenFree(connection, "PRAGMA wal_checkpoint(TRUNCATE)");
}

void compactDatabase(Connection& connection) {
  runWhenFree(connection, "VACUUM");
  truncateLog(connection);
}

}  // namespace torsio
