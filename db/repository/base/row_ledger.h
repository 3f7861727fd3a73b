// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "db/connection/connection.h"

namespace torsio {

/// From now on, seals every change of a sealed row (kSealRules) on this connection in the audit trail, in the
/// same transaction. Stored rows are compared with the bound values, so that nothing between program and
/// table can alter them unnoticed: otherwise Error (kVerifyFailed) and rollback.
void sealChanges(Connection& connection);

/// Suspends sealing while it lives: for copying rows together with their seals.
class UnsealedCopy {
 public:
  explicit UnsealedCopy(Connection& connection);
  UnsealedCopy(const UnsealedCopy&) = delete;
  UnsealedCopy& operator=(const UnsealedCopy&) = delete;
  ~UnsealedCopy();

 private:
  Connection& connection_;
  std::shared_ptr<ChangeWatch> watch_;
};

/// Seals every row that has no seal yet in one entry with this reason, after a migration. Returns their
/// number. One transaction, or part of the open one. Throws DbError.
std::int64_t sealUnsealed(Connection& connection, const std::string& reason, std::int64_t utc_us);

}  // namespace torsio
