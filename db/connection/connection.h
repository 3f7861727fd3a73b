// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

enum class OpenMode {
  kCreate,     ///< SQLite: made if missing. PostgreSQL: the database must exist
  kReadWrite,  ///< must exist
  kReadOnly,   ///< must exist; nothing can be changed
};

/// One open database. Belongs to the thread that opened it: using it from another is a broken contract;
/// closing it there is allowed. A QCoreApplication must exist before the first one is opened (QtSql loads its
/// drivers through it); the library makes none.
///
/// SQLite runs with write-ahead log, synchronous FULL, foreign keys on and a busy timeout, so that what a
/// statement reported as done survives a power cut, and two processes may share one file.
class Connection {
 public:
  Connection(Connection&&) noexcept;
  Connection& operator=(Connection&&) noexcept;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection();

  /// Compiles one statement with `?` placeholders. Throws DbError.
  [[nodiscard]] Statement prepare(std::string_view sql);
  /// Runs one statement that returns no rows. Returns the number of rows it changed. Throws DbError.
  std::int64_t execute(std::string_view sql, std::initializer_list<Value> values = {});
  /// Runs one statement without placeholders just as it is: schema changes. Throws DbError.
  void executeVerbatim(std::string_view sql);
  /// Executes one statement without placeholders that returns rows and cannot be prepared (FETCH). Throws
  /// DbError.
  [[nodiscard]] Statement selectVerbatim(std::string_view sql);

  /// Has `observer` hear the text of every statement that is prepared from now on: diagnosis
  /// (kShowStatements), query plans.
  void observeStatements(std::function<void(std::string_view)> observer);

  /// Has `watch` hear what statements that are prepared from now on change; null: nobody. Returns the watch
  /// before. Not inside a transaction that changed something.
  std::shared_ptr<ChangeWatch> watchChanges(std::shared_ptr<ChangeWatch> watch);
  /// Tells the watch of a row that a function of the database changed or removed in this transaction; `key`:
  /// in the order of the key's columns.
  void tellChanged(std::string_view table, std::vector<Value> key, bool removed);

  [[nodiscard]] Engine engine() const noexcept;
  /// For messages; never contains a password.
  [[nodiscard]] const std::string& location() const noexcept;
  [[nodiscard]] bool readOnly() const noexcept;
  /// Whether a Transaction is open.
  [[nodiscard]] bool inTransaction() const noexcept;

 private:
  friend class Statement;
  friend class Transaction;
  friend Connection openDatabase(const std::string& locator, OpenMode mode, int busyTimeout_ms);
  explicit Connection(std::shared_ptr<ConnectionState> state);
  std::shared_ptr<ConnectionState> state_;
};

inline constexpr int kBusyTimeout_ms = 5000;

/// Environment variable: when set, each statement that is prepared goes to standard error, never with its
/// values.
inline constexpr const char* kShowStatements = "TORSIO_SHOW_STATEMENTS";

/// Opens a database without looking at its schema (openRecord in db/migrations does both). `busyTimeout_ms`:
/// how long to wait for a lock, and on PostgreSQL also about how long for a server that does not answer.
/// Throws Error (kFileMissing, kFileUnreadable: not a database, kFileUnwritable: read-only file or folder) or
/// DbError.
[[nodiscard]] Connection openDatabase(const std::string& locator, OpenMode mode,
                                      int busyTimeout_ms = kBusyTimeout_ms);

/// A prepared statement: execute, then step through its rows. Keeps its database open while it lives.
class Statement {
 public:
  Statement(Statement&&) noexcept;
  Statement& operator=(Statement&&) noexcept;
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement();

  /// Sets the placeholder at `position` (from 0) for the next execute(). Doubles must be finite.
  Statement& bind(int position, const Value& value);
  /// Runs with what was bound. May be called again with other values. Throws DbError.
  void execute();
  /// Binds all placeholders in order and runs. Throws DbError.
  void execute(std::initializer_list<Value> values);
  void execute(std::span<const Value> values);
  /// Moves to the next row; false after the last, and then the statement is reset. Throws DbError.
  [[nodiscard]] bool step();
  /// Rows changed by the last execute() of an INSERT, UPDATE or DELETE.
  [[nodiscard]] std::int64_t affectedRows() const;

  /// Columns of the current row, from 0. A null reads as 0, false or empty; ask isNull() or the maybe form.
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
  /// The value with its own type; booleans of SQLite come back as integers.
  [[nodiscard]] Value value(int column) const;

 private:
  friend class Connection;
  class Query;
  explicit Statement(std::unique_ptr<Query> query);
  void run();
  std::unique_ptr<Query> query_;
};

/// Several statements as one: all or nothing. Rolls back unless commit() was reached; the destructor never
/// throws. A Transaction inside a Transaction joins the outer one: it keeps nothing by itself, and if it is
/// given up, the outer one cannot be committed any more.
class Transaction {
 public:
  enum class Purpose {
    kChange,
    kLook,  ///< nothing is written: all that is read is of one moment, and nobody waits for it
  };
  /// SQLite takes the write lock at once (BEGIN IMMEDIATE), so that it waits here and never in the middle.
  explicit Transaction(Connection& connection, Purpose purpose = Purpose::kChange);
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  ~Transaction();

  /// Throws DbError; then everything was rolled back.
  void commit();

 private:
  std::shared_ptr<ConnectionState> state_;
  bool open_ = true;
};

}  // namespace torsio
