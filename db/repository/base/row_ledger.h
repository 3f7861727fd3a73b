// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "db/connection/connection.h"

namespace torsio {

/// From now on every change of a sealed row (kSealRules) on this connection is followed by its seal in the
/// audit trail, in the same transaction. What was added or set is compared with what the statement gave, so
/// that nothing between the program and the table can alter it: Error (kVerifyFailed), and nothing is kept.
void sealChanges(Connection& connection);

/// No seals while it lives: for a copy that brings the seals of its rows along.
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

/// Seals every row that has no seal yet, in one entry with this reason: after a step of the schema. Returns
/// how many. One transaction, or part of the one that is open. Throws DbError.
std::int64_t sealUnsealed(Connection& connection, const std::string& reason, std::int64_t utc_us);

}  // namespace torsio
