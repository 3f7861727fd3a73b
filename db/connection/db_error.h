// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/core/error.h"

namespace torsio {

/// What kind of refusal a database gave, the same for both engines.
enum class DbFault {
  kOther,
  kBusy,          ///< another connection holds the lock; nothing was changed
  kUnique,        ///< such a row exists already
  kForeignKey,    ///< refers to a row that does not exist, or is still referred to
  kCheck,         ///< a value outside the rule of its column
  kNotNull,       ///< a value is missing
  kAppendOnly,    ///< the row is sealed: it may be added to, never changed
  kReadOnly,      ///< the connection or the file may not be written
  kFull,          ///< no space left
  kCorrupt,       ///< the file is damaged
  kUnreachable,   ///< the server does not answer, or the connection was lost
  kConflict,      ///< two transactions crossed (serialisation, deadlock)
  kBrokenBefore,  ///< an earlier statement of this transaction failed: nothing of it can be kept
};

/// A database refused an operation. Carries the operation ("INSERT INTO trial_chunk") without any values, so
/// that no name or mark reaches a log. Its code is kDatabase, and kVerifyFailed for a damaged file.
class DbError : public Error {
 public:
  DbError(DbFault fault, const std::string& operation, const Text& what, const Text& where,
          const Text& remedy);

  [[nodiscard]] DbFault fault() const noexcept { return fault_; }
  [[nodiscard]] const std::string& operation() const noexcept { return operation_; }
  /// Whether the same operation, repeated from the start of its transaction, may succeed.
  [[nodiscard]] bool retryable() const noexcept;

 private:
  DbFault fault_;
  std::string operation_;
};

}  // namespace torsio
