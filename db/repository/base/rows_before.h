// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "db/connection/connection.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/seal_rules.h"

namespace torsio {

/// A row as it was right before a statement changed it.
struct RowBefore {
  std::vector<Value> key;
  std::string hash;  ///< see RowSeal::before
};

/// Returns the rows of a table with Sealing::kEachChange that an UPDATE, or an INSERT that may replace a row,
/// is about to change; on a server they are locked until the transaction ends. `bound`: values of the
/// statement's placeholders. Empty for other statements. Throws DbError.
[[nodiscard]] std::vector<RowBefore> rowsBefore(Connection& connection, const SealRule& rule,
                                                const ChangedStatement& change, std::span<const Value> bound);

}  // namespace torsio
