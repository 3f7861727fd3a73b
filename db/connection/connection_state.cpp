// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/connection_state.h"

#include <algorithm>
#include <list>
#include <sqlite3.h>
#include <utility>

#include <QCoreApplication>
#include <QSqlDatabase>
#include <QSqlError>
#include <QSqlQuery>
#include <QStringList>
#include <QVariant>

#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "sim/core/contracts.h"
#include "sim/core/file_io.h"

namespace torsio {

namespace {

/// Formats one libpq parameter; Qt turns the semicolons between them into blanks.
QString optionOf(const std::string& name, const std::string& value) {
  std::string quoted;
  for (const char c : value) {
    quoted += c == '\'' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return QString::fromStdString(name + "='" + quoted + "'");
}

/// Appends the address's parameters to our defaults: of duplicates, the last one counts. Our defaults would
/// override a service file, so they are left out if a service is named.
QString serverOptions(const Locator& locator, int busyTimeout_ms) {
  QStringList options{optionOf("fallback_application_name", "torsio")};
  if (locator.parameter("service").empty()) {
    // A server that vanished without notice (a cable, a power cut) is detected about when a lock wait would
    // time out.
    options += {optionOf("connect_timeout", std::to_string(std::max(2, busyTimeout_ms / 1000))),
                optionOf("tcp_user_timeout", std::to_string(busyTimeout_ms + 1000)),
                optionOf("keepalives_idle", "10"), optionOf("keepalives_interval", "3"),
                optionOf("keepalives_count", "3")};
  }
  for (const ServerParameter& parameter : locator.parameters) {
    options += optionOf(parameter.name, parameter.value);
  }
  return options.join(QLatin1Char(';'));
}

constexpr std::size_t kMaxKept = 64;
constexpr int kMaxRowsKept = 32;  // a query holds the rows of its last run

/// Keeps SQLite from counting its memory: one lock for all threads' allocations, and half the time of a busy
/// desk. Does nothing once the library is in use.
void countNoMemory() {
  static const int result = sqlite3_config(SQLITE_CONFIG_MEMSTATUS, 0);
  (void)result;
}

/// Unique while the connection exists.
std::string connectionName(const void* state) {
  return "torsio-" + std::to_string(reinterpret_cast<std::uintptr_t>(state));
}

}  // namespace

struct ConnectionState::Kept {
  struct One {
    std::string sql;
    QSqlQuery query;
  };
  std::list<One> all;  // most recently used first
  [[nodiscard]] auto find(std::string_view sql) {
    return std::find_if(all.begin(), all.end(), [sql](const One& one) { return one.sql == sql; });
  }
};

ConnectionState::ConnectionState(const Locator& locator, OpenMode mode, int busyTimeout_ms)
    : engine(locator.engine),
      location(locator.shown()),
      readOnly(mode == OpenMode::kReadOnly),
      name_(connectionName(this)),
      thread_(std::this_thread::get_id()),
      kept_(std::make_unique<Kept>()) {
  TORSIO_EXPECTS(QCoreApplication::instance() != nullptr);
  const QString driver = engine == Engine::kSqlite ? QStringLiteral("QSQLITE") : QStringLiteral("QPSQL");
  if (!QSqlDatabase::isDriverAvailable(driver)) {
    throw DbError(DbFault::kOther, "", Text::tr("Qt has no driver %1", driver.toStdString()), location,
                  Text::tr("Install the package %1",
                           engine == Engine::kSqlite ? "libqt6sql6-sqlite" : "libqt6sql6-psql"));
  }
  database_ =
      std::make_unique<QSqlDatabase>(QSqlDatabase::addDatabase(driver, QString::fromStdString(name_)));
  try {
    if (engine == Engine::kSqlite) {
      openSqlite(locator, mode, busyTimeout_ms);
    } else {
      openPostgresql(locator, mode, busyTimeout_ms);
    }
  } catch (...) {
    close();
    throw;
  }
}

ConnectionState::~ConnectionState() {
  if (depth > 0) {
    leave();
  }
  close();
}

void ConnectionState::close() noexcept {
  forgetKept();
  database_->close();
  database_.reset();
  QSqlDatabase::removeDatabase(QString::fromStdString(name_));
}

void ConnectionState::openSqlite(const Locator& locator, OpenMode mode, int busyTimeout_ms) {
  const bool inMemory = locator.file == ":memory:";
  if (!inMemory) {
    requireUsableFile(locator.file, mode);
  }
  countNoMemory();
  database_->setDatabaseName(QString::fromStdString(locator.file));
  QString options = QStringLiteral("QSQLITE_BUSY_TIMEOUT=%1").arg(busyTimeout_ms);
  if (readOnly) {
    options += QStringLiteral(";QSQLITE_OPEN_READONLY");
  }
  database_->setConnectOptions(options);
  if (!database_->open()) {
    throw Error(mode == OpenMode::kReadOnly ? ErrorCode::kFileUnreadable : ErrorCode::kFileUnwritable,
                Text::tr("database cannot be opened"), location,
                Text::tr("Check that you may read and write in its folder"));
  }
  try {
    // The first read shows whether the file is a database at all.
    run("SELECT count(*) FROM sqlite_master");
    run("PRAGMA foreign_keys = ON");
    run("PRAGMA recursive_triggers = ON");  // otherwise REPLACE would bypass the delete triggers
    run("PRAGMA trusted_schema = OFF");
    if (!readOnly) {
      run("PRAGMA journal_mode = WAL");
      run("PRAGMA synchronous = FULL");
      run("PRAGMA secure_delete = ON");  // erased data are overwritten, not just unlinked
      run("BEGIN IMMEDIATE");            // detects a read-only file system before the first record
      run("ROLLBACK");
    }
  } catch (const DbError& error) {
    if (error.fault() == DbFault::kBusy) {
      return;  // somebody is writing, so the file is writable
    }
    if (error.fault() == DbFault::kReadOnly && readOnly && hasJournal(locator.file)) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("a program that was ended left a change half done"),
                  location, Text::tr("Open it with Torsio once, which takes the change back"));
    }
    if (error.fault() == DbFault::kReadOnly) {
      refuseReadOnly(Text::tr("database file is read-only"), locator.file);
    }
    if (error.fault() == DbFault::kCorrupt) {
      if (looksLikeDatabase(locator.file)) {
        throw Error(ErrorCode::kVerifyFailed, Text::tr("database is damaged"), location,
                    Text::tr("Restore the latest backup"));
      }
      throw Error(ErrorCode::kFileUnreadable, Text::tr("is not a database"), location,
                  Text::tr("Choose another file; if there was a record here, restore the latest backup"));
    }
    throw;
  }
}

void ConnectionState::openPostgresql(const Locator& locator, OpenMode mode, int busyTimeout_ms) {
  // Parts left out come from the service or the library's defaults.
  if (!locator.host.empty()) {
    database_->setHostName(QString::fromStdString(locator.host));
  }
  if (locator.port > 0) {
    database_->setPort(locator.port);
  }
  database_->setDatabaseName(QString::fromStdString(locator.database));
  database_->setUserName(QString::fromStdString(locator.user));
  database_->setPassword(QString::fromStdString(locator.password));
  database_->setConnectOptions(serverOptions(locator, busyTimeout_ms));
  if (!database_->open()) {
    const std::string detail =
        database_->lastError().databaseText().section(QLatin1Char('\n'), 0, 0).trimmed().toStdString();
    throw DbError(DbFault::kUnreachable, "", Text::tr("database server cannot be reached: %1", detail),
                  location, Text::tr("Check that it runs, and that address, user and password are right"));
  }
  run("SET lock_timeout = " + std::to_string(busyTimeout_ms));
  run("SET TIME ZONE 'UTC'");
  run("SET client_min_messages = error");  // its library would print warnings beside our own log
  run("SET synchronous_commit = on");
  if (!locator.schema.empty()) {
    run("SET search_path TO \"" + locator.schema + "\"");
  }
  if (mode == OpenMode::kReadOnly) {
    run("SET default_transaction_read_only = on");
  }
}

QSqlQuery ConnectionState::query() const {
  TORSIO_EXPECTS(std::this_thread::get_id() == thread_);
  TORSIO_EXPECTS(!broken);  // after a failure the transaction must be left, not continued
  QSqlQuery query(*database_);
  // Not for PostgreSQL, where it means single-row mode, which allows no second query meanwhile.
  if (engine == Engine::kSqlite) {
    query.setForwardOnly(true);
  }
  return query;
}

std::unique_ptr<QSqlQuery> ConnectionState::takeKept(std::string_view sql) {
  const auto found = kept_->find(sql);
  if (found == kept_->all.end()) {
    return nullptr;
  }
  TORSIO_EXPECTS(std::this_thread::get_id() == thread_);
  TORSIO_EXPECTS(!broken);
  auto query = std::make_unique<QSqlQuery>(std::move(found->query));
  kept_->all.erase(found);
  return query;
}

void ConnectionState::keep(std::string sql, QSqlQuery&& query) {
  // SQLite prepares in-process. "SELECT *" would change its columns when a table gets a new one.
  if (engine == Engine::kSqlite || query.size() > kMaxRowsKept || sql.find("SELECT *") != std::string::npos ||
      kept_->find(sql) != kept_->all.end()) {
    return;
  }
  query.finish();
  kept_->all.push_front({std::move(sql), std::move(query)});
  if (kept_->all.size() > kMaxKept) {
    kept_->all.pop_back();
  }
}

void ConnectionState::forgetKept() noexcept {
  kept_->all.clear();
}

void ConnectionState::run(std::string_view sql) {
  QSqlQuery statement = query();
  if (!statement.exec(QString::fromUtf8(sql.data(), static_cast<qsizetype>(sql.size())))) {
    fail(sql, statement.lastError());
  }
}

void ConnectionState::begin(Transaction::Purpose purpose) {
  broken = false;
  const bool snapshot = purpose == Transaction::Purpose::kReadOnly;
  if (engine == Engine::kSqlite) {
    run(readOnly || snapshot ? "BEGIN" : "BEGIN IMMEDIATE");
    return;
  }
  if (!database_->transaction()) {
    fail("BEGIN", database_->lastError());
  }
  if (snapshot) {
    run("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ");
  }
}

void ConnectionState::commit() {
  if (engine == Engine::kSqlite) {
    run("COMMIT");
  } else if (!database_->commit()) {
    // Also if the server turned COMMIT into ROLLBACK: a plain COMMIT statement would report success.
    fail("COMMIT", database_->lastError());
  }
}

void ConnectionState::abandon() noexcept {
  if (broken) {
    return;
  }
  broken = true;
  try {
    if (engine == Engine::kSqlite) {
      QSqlQuery(*database_).exec(QStringLiteral("ROLLBACK"));
    } else {
      database_->rollback();
    }
  } catch (...) {  // Qt reports errors by value; only memory can run out here, and then the engine rolls back
  }
}

void ConnectionState::leave() noexcept {
  abandon();
  depth = 0;
  broken = false;
  if (watch) {
    watch->forget();
  }
}

}  // namespace torsio
