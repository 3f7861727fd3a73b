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

/// Hears what the prepared statements of one connection change, and has a last word before it is committed.
/// A watched statement outside any transaction gets one of its own. Statements that run verbatim are not
/// heard. Everything happens in the thread of the connection.
class ChangeWatch {
 public:
  /// What the watch knows of one statement.
  class Plan {
   public:
    Plan() = default;
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;
    virtual ~Plan() = default;
    /// Columns that the statement shall return for each row that it changes ("id"); empty: none.
    [[nodiscard]] virtual std::string returning() const = 0;
  };
  using Rows = std::vector<std::vector<Value>>;

  ChangeWatch() = default;
  ChangeWatch(const ChangeWatch&) = delete;
  ChangeWatch& operator=(const ChangeWatch&) = delete;
  virtual ~ChangeWatch() = default;

  /// Asked once a statement; null: it changes nothing that is watched.
  [[nodiscard]] virtual std::shared_ptr<const Plan> planOf(std::string_view sql) = 0;
  /// The statement is about to run with the values in `bound`, in a transaction.
  virtual void changing(Connection& connection, const Plan& plan, std::span<const Value> bound) = 0;
  /// The statement ran with the values in `bound`. `returned`: what returning() asked for. `rows`: how many
  /// were changed.
  virtual void changed(const std::shared_ptr<const Plan>& plan, std::span<const Value> bound,
                       const Rows& returned, std::int64_t rows) = 0;
  /// A function of the database changed or removed the row with this key, in the order of the key's columns.
  virtual void changedElsewhere(std::string_view table, std::vector<Value> key, bool removed) = 0;
  /// The outermost transaction is about to be kept; throwing gives it up.
  virtual void beforeCommit(Connection& connection) = 0;
  /// The transaction is over, kept or not.
  virtual void forget() noexcept = 0;
};

}  // namespace torsio
