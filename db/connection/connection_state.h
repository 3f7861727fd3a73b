// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>

#include "db/connection/connection.h"

class QSqlDatabase;
class QSqlError;
class QSqlQuery;

namespace torsio {

/// The QtSql side of a Connection. Private to db/connection.
class ConnectionState {
 public:
  ConnectionState(const Locator& locator, OpenMode mode, int busyTimeout_ms);
  ConnectionState(const ConnectionState&) = delete;
  ConnectionState& operator=(const ConnectionState&) = delete;
  ~ConnectionState();

  /// A query of this database; our own bug when called from another thread than the opening one.
  [[nodiscard]] QSqlQuery query() const;
  /// A prepared query that keep() was given for the same text, or null: preparing and forgetting one on a
  /// server are two more ways to it and back.
  [[nodiscard]] std::unique_ptr<QSqlQuery> takeKept(std::string_view sql);
  /// Keeps a prepared query that ran without fault, if it is worth it; the oldest of many are given up.
  void keep(std::string sql, QSqlQuery&& query);
  /// After a change of tables.
  void forgetKept() noexcept;
  /// Runs one statement just as it is, and forgets its rows.
  void run(std::string_view sql);
  /// Throws the DbError for `error`, and remembers that the open transaction is lost.
  [[noreturn]] void fail(std::string_view sql, const QSqlError& error);

  void begin(Transaction::Purpose purpose);
  void commit();
  /// Rolls back at once; what still belongs to the transaction is refused until it is left.
  void abandon() noexcept;
  /// The outermost Transaction ends without having been kept.
  void leave() noexcept;

  Engine engine;
  std::string location;
  bool readOnly = false;
  int depth = 0;  ///< open transactions, the inner ones joined
  std::function<void(std::string_view)> observer;
  std::shared_ptr<ChangeWatch> watch;
  bool broken = false;  ///< the open transaction was rolled back already

 private:
  void openSqlite(const Locator& locator, OpenMode mode, int busyTimeout_ms);
  void openPostgresql(const Locator& locator, OpenMode mode, int busyTimeout_ms);
  void close() noexcept;

  std::string name_;
  std::unique_ptr<QSqlDatabase> database_;
  std::thread::id thread_;
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

/// "INSERT INTO trial_chunk" out of a whole statement: enough to know which, without values.
[[nodiscard]] std::string operationOf(std::string_view sql);

/// The fault behind a driver's error, from the native code (never from QSqlError::type, which differs).
[[nodiscard]] DbFault faultOf(Engine engine, const QSqlError& error);

}  // namespace torsio
