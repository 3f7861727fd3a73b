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

/// A statement that changes rows of one table, as row_ledger.cpp makes it.
class LedgerPlan : public ChangeWatch::Plan {
 public:
  /// `rule`: null for an entry of the audit trail.
  LedgerPlan(ChangedStatement statement, const SealRule* rule);

  [[nodiscard]] std::string returning() const override { return keyColumns; }

  ChangedStatement change;
  const SealRule* sealRule;  ///< null: an entry of the audit trail
  std::vector<int> keys;     ///< placeholders of the key
  std::string keyColumns;    ///< empty: the statement gives the key
};

/// What one statement gave for a row.
struct GivenValues {
  std::shared_ptr<const LedgerPlan> plan;
  std::vector<Value> bound;
};

/// One row that the transaction touched.
struct TouchedRow {
  const SealRule* rule = nullptr;
  std::vector<Value> key;
  std::vector<GivenValues> given{};  ///< in their order
  bool whole = false;                ///< added: what was not given is null
  bool gone = false;
  std::string before{};  ///< RowSeal::before
};

/// Seals of the rows that one transaction touched, inside it, before its commit. Throws Error (kVerifyFailed)
/// when a row that is stored is not what was given for it.
[[nodiscard]] std::vector<RowSeal> sealsOf(Connection& connection, std::span<const TouchedRow> touched);

}  // namespace torsio
