// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/db_error.h"

namespace torsio {

DbError::DbError(DbFault fault, const std::string& operation, const std::string& what,
                 const std::string& where, const std::string& remedy)
    : Error(ErrorCode::kDatabase, operation.empty() ? what : what + " (" + operation + ")", where, remedy),
      fault_(fault),
      operation_(operation) {}

bool DbError::retryable() const noexcept {
  return fault_ == DbFault::kBusy || fault_ == DbFault::kUnreachable || fault_ == DbFault::kConflict;
}

}  // namespace torsio
