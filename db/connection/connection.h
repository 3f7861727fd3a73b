// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/connection/value.h"

namespace torsio {

class ChangeWatch;
class ConnectionState;  // QtSql lives behind it (connection_state.h)
class Statement;

/// An open database. Confined to the thread that opened it, except for closing; any other use breaks the
/// contract. A QCoreApplication must exist before the first one is opened (QtSql loads its drivers through
/// it).
///
/// SQLite runs with write-ahead log, synchronous FULL, foreign keys and a busy timeout, so that whatever a
/// statement reported as done survives a power cut, and several processes may share a file.
class Connection {
 public:
  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) noexcept;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  /// Prepares a statement with `?` placeholders. Throws DbError.
  [[nodiscard]] Statement prepare(std::string_view sql);
  /// Runs a statement that returns no rows. Returns the number of changed rows. Throws DbError.
  std::int64_t execute(std::string_view sql, std::initializer_list<Value> values = {});
  /// Runs a statement without placeholders, unprepared: schema changes. Throws DbError.
  void executeVerbatim(std::string_view sql);
  /// Runs a statement without placeholders that returns rows and cannot be prepared (FETCH). Throws DbError.
  [[nodiscard]] Statement selectVerbatim(std::string_view sql);

  /// Calls `observer` with the text of every statement prepared from now on, for diagnosis (kShowStatements)
  /// and query plans.
  void observeStatements(std::function<void(std::string_view)> observer);

  /// Reports changes by statements prepared from now on to `watch`; null: to nobody. Returns the previous
  /// watch. Not allowed in a transaction with changes.
  std::shared_ptr<ChangeWatch> watchChanges(std::shared_ptr<ChangeWatch> watch);
  /// Reports to the watch a row that a database function changed or removed in this transaction; `key`: in
  /// the order of the key's columns.
  void reportChange(std::string_view table, std::vector<Value> key, bool removed);

  [[nodiscard]] Engine engine() const noexcept;
  /// Returns the address for messages, without a password.
  [[nodiscard]] const std::string& location() const noexcept;
  [[nodiscard]] bool readOnly() const noexcept;
  /// True while a Transaction is open.
  [[nodiscard]] bool inTransaction() const noexcept;

 private:
  friend class Statement;
  friend class Transaction;
  friend Connection openDatabase(const std::string& locator, OpenMode mode, int busyTimeout_ms);
  explicit Connection(std::shared_ptr<ConnectionState> state);
  std::shared_ptr<ConnectionState> state_;
};

inline constexpr int kBusyTimeout_ms = 5000;

/// Environment variable; if set, every prepared statement is printed to standard error, without its values.
inline constexpr const char* kShowStatements = "TORSIO_SHOW_STATEMENTS";

/// Opens a database without checking its schema (openRecord in db/migrations does both). `busyTimeout_ms`:
/// how long to wait for a lock and, on PostgreSQL, roughly for a server that does not answer. Throws Error
/// (kFileMissing; kFileUnreadable: not a database; kFileUnwritable: read-only file or folder) or DbError.
[[nodiscard]] Connection openDatabase(const std::string& locator, OpenMode mode,
                                      int busyTimeout_ms = kBusyTimeout_ms);

/// A prepared statement: execute it, then step through its rows. Keeps its database open.
class Statement {
 public:
  Statement(Statement&&) noexcept;
  Statement& operator=(Statement&&) noexcept;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  /// Sets the placeholder at `position` (from 0) for the next execute(). Doubles must be finite.
  Statement& bind(int position, const Value& value);
  /// Runs with the bound values. May be called again with others. Throws DbError.
  void execute();
  /// Binds all placeholders in order and runs. Throws DbError.
  void execute(std::initializer_list<Value> values);
  void execute(std::span<const Value> values);
  /// Moves to the next row; false after the last, which resets the statement. Throws DbError.
  [[nodiscard]] bool step();
  /// Rows changed by the last execute() of an INSERT, UPDATE or DELETE.
  [[nodiscard]] std::int64_t affectedRows() const;

  /// Columns of the current row, from 0. Null reads as 0, false or empty; use isNull() or the maybe form to
  /// tell.
  [[nodiscard]] bool isNull(int column) const;
  [[nodiscard]] std::int64_t int64(int column) const;
  [[nodiscard]] double real(int column) const;
  [[nodiscard]] bool boolean(int column) const;
  [[nodiscard]] std::string text(int column) const;
  [[nodiscard]] Blob blob(int column) const;
  [[nodiscard]] std::optional<std::int64_t> maybeInt64(int column) const;
  [[nodiscard]] std::optional<double> maybeReal(int column) const;
  [[nodiscard]] std::optional<std::string> maybeText(int column) const;
  [[nodiscard]] int columnCount() const;
  [[nodiscard]] std::string columnName(int column) const;
  /// Returns the value with its stored type; SQLite returns booleans as integers.
  [[nodiscard]] Value value(int column) const;

 private:
  friend class Connection;
  class Query;
  explicit Statement(std::unique_ptr<Query> query);
  void run();
  std::unique_ptr<Query> query_;
};

/// Groups statements: all or nothing. Rolls back unless commit() was reached; the destructor never throws. A
/// nested Transaction joins the outer one: its commit alone persists nothing, and if it is abandoned, the
/// outer one can no longer be committed.
class Transaction {
 public:
  enum class Purpose {
    kChange,
    kReadOnly,  ///< a consistent snapshot that blocks nobody
  };
  /// On SQLite kChange takes the write lock at once (BEGIN IMMEDIATE), so that it waits here, not halfway.
  explicit Transaction(Connection& connection, Purpose purpose = Purpose::kChange);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  /// Throws DbError after rolling everything back.
  void commit();

 private:
  std::shared_ptr<ConnectionState> state_;
  bool open_ = true;
};

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
