// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/core/error.h"

namespace torsio {

/// Kinds of database errors, common to both engines.
enum class DbFault {
  kOther,
  kBusy,          ///< another connection holds the lock; nothing was changed
  kUnique,        ///< such a row already exists
  kForeignKey,    ///< references a missing row, or is still referenced
  kCheck,         ///< a value violates the rule of its column
  kNotNull,       ///< a value is missing
  kAppendOnly,    ///< the row is sealed: it cannot be changed
  kReadOnly,      ///< the connection or file is read-only
  kFull,          ///< no space left
  kCorrupt,       ///< the file is damaged
  kUnreachable,   ///< the server does not answer, or the connection was lost
  kConflict,      ///< transactions collided (serialisation failure, deadlock)
  kBrokenBefore,  ///< an earlier statement of this transaction failed, so it cannot be committed
};

/// A database error. Carries the operation ("INSERT INTO trial_chunk") without values, so that no name or
/// mark reaches a log. Its code is kDatabase, or kVerifyFailed for a damaged file.
class DbError : public Error {
 public:
  DbError(DbFault fault, const std::string& operation, const Text& what, const Text& where,
          const Text& remedy);

  [[nodiscard]] DbFault fault() const noexcept { return fault_; }
  [[nodiscard]] const std::string& operation() const noexcept { return operation_; }
  /// True if repeating the whole transaction may succeed.
  [[nodiscard]] bool retryable() const noexcept;

 private:
  DbFault fault_;
  std::string operation_;
};

}  // namespace torsio
