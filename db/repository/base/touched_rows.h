// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "db/connection/change_watch.h"
#include "db/connection/connection.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"

namespace torsio {

/// A statement that changes rows of one table; made by row_ledger.cpp.
class LedgerPlan : public ChangeWatch::Plan {
 public:
  /// `rule`: null for an entry of the audit trail.
  LedgerPlan(ChangedStatement statement, const SealRule* rule);

  [[nodiscard]] std::string returning() const override { return keyColumns; }

  ChangedStatement change;
  const SealRule* sealRule;  ///< null: an entry of the audit trail
  std::vector<int> keys;     ///< indices of the key's placeholders
  std::string keyColumns;    ///< empty: the statement gives the key
};

/// Values that one statement gave for a row.
struct GivenValues {
  std::shared_ptr<const LedgerPlan> plan;
  std::vector<Value> bound;
};

/// A row touched by the transaction.
struct TouchedRow {
  const SealRule* rule = nullptr;
  std::vector<Value> key;
  std::vector<GivenValues> given{};  ///< in order of execution
  bool whole = false;                ///< inserted: columns not given are null
  bool gone = false;
  std::string before{};  ///< RowSeal::before
};

/// Seals the rows touched by a transaction, inside it and before its commit. Throws Error (kVerifyFailed) if
/// a stored row differs from the values given.
[[nodiscard]] std::vector<RowSeal> sealsOf(Connection& connection, std::span<const TouchedRow> touched);

}  // namespace torsio
