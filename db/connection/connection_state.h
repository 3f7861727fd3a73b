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

  /// Returns a new query of this database; must be called in the thread that opened it.
  [[nodiscard]] QSqlQuery query() const;
  /// Returns a prepared query passed to keep() with the same text, or null. Preparing and dropping one on a
  /// server costs two round trips.
  [[nodiscard]] std::unique_ptr<QSqlQuery> takeKept(std::string_view sql);
  /// Caches a prepared query that ran without error, if that pays; evicts the least recently used.
  void keep(std::string sql, QSqlQuery&& query);
  /// Drops the cached queries; called after schema changes.
  void forgetKept() noexcept;
  /// Runs one statement verbatim and discards its rows.
  void run(std::string_view sql);
  /// Throws the DbError for `error` and marks the open transaction as lost.
  [[noreturn]] void fail(std::string_view sql, const QSqlError& error);

  void begin(Transaction::Purpose purpose);
  void commit();
  /// Rolls back at once; further statements of the transaction are refused.
  void abandon() noexcept;
  /// Called when the outermost Transaction ends without commit.
  void leave() noexcept;

  Engine engine;
  std::string location;
  bool readOnly = false;
  int depth = 0;  ///< open transactions, including nested ones
  std::function<void(std::string_view)> observer;
  std::shared_ptr<ChangeWatch> watch;
  bool broken = false;  ///< the open transaction has already been rolled back

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

/// Returns the start of a statement, "INSERT INTO trial_chunk": enough to identify it, without values.
[[nodiscard]] std::string operationOf(std::string_view sql);

/// Maps a driver's native error code to a fault (QSqlError::type differs between drivers).
[[nodiscard]] DbFault faultOf(Engine engine, const QSqlError& error);

}  // namespace torsio
