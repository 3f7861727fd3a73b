// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/db_error.h"

namespace torsio {

namespace {

ErrorCode codeOf(DbFault fault) {
  switch (fault) {
    case DbFault::kCorrupt:
      return ErrorCode::kVerifyFailed;
    case DbFault::kFull:
      return ErrorCode::kFileUnwritable;
    default:
      return ErrorCode::kDatabase;
  }
}

}  // namespace

DbError::DbError(DbFault fault, const std::string& operation, const Text& what, const Text& where,
                 const Text& remedy)
    // If the server is unreachable, the last statement tells the reader nothing.
    : Error(codeOf(fault),
            operation.empty() || fault == DbFault::kUnreachable ? what : Text::tr("%1 (%2)", what, operation),
            where, remedy),
      fault_(fault),
      operation_(operation) {}

bool DbError::retryable() const noexcept {
  return fault_ == DbFault::kBusy || fault_ == DbFault::kUnreachable || fault_ == DbFault::kConflict;
}

}  // namespace torsio
