// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// Observes what the prepared statements of one connection change, and may veto before the commit. A watched
/// statement outside a transaction gets one of its own. Statements run verbatim are not observed. All calls
/// come in the connection's thread.
class ChangeWatch {
 public:
  /// What the watch knows about one statement.
  class Plan {
   public:
    Plan() = default;
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    virtual ~Plan() = default;
    /// Columns that the statement must return for each changed row ("id"); empty: none.
    [[nodiscard]] virtual std::string returning() const = 0;
  };
  using Rows = std::vector<std::vector<Value>>;

  ChangeWatch() = default;
  ChangeWatch(const ChangeWatch&) = delete;
  ChangeWatch& operator=(const ChangeWatch&) = delete;
  virtual ~ChangeWatch() = default;

  /// Called once per statement; null: it changes nothing watched.
  [[nodiscard]] virtual std::shared_ptr<const Plan> planOf(std::string_view sql) = 0;
  /// Called before the statement runs with the values in `bound`, inside a transaction.
  virtual void changing(Connection& connection, const Plan& plan, std::span<const Value> bound) = 0;
  /// Called after the statement ran with the values in `bound`. `returned`: the columns of returning().
  /// `rows`: number of changed rows.
  virtual void changed(const std::shared_ptr<const Plan>& plan, std::span<const Value> bound,
                       const Rows& returned, std::int64_t rows) = 0;
  /// Called when a database function changed or removed the row with this key (in the order of the key's
  /// columns).
  virtual void changedElsewhere(std::string_view table, std::vector<Value> key, bool removed) = 0;
  /// Called before the outermost transaction is committed; throwing rolls it back.
  virtual void beforeCommit(Connection& connection) = 0;
  /// Called when the transaction has ended, committed or not.
  virtual void forget() noexcept = 0;
};

}  // namespace torsio
