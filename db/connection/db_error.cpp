// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/connection/db_error.h"

#include <array>
#include <utility>

#include <QSqlError>
#include <QString>

#include "db/connection/connection_state.h"

namespace torsio {

namespace {

// https://www.sqlite.org/rescode.html: extended codes, primary code in the low byte.
DbFault sqliteFault(int code) {
  switch (code) {
    case 2067:  // SQLITE_CONSTRAINT_UNIQUE
    case 1555:  // SQLITE_CONSTRAINT_PRIMARYKEY
      return DbFault::kUnique;
    case 787:  // SQLITE_CONSTRAINT_FOREIGNKEY
      return DbFault::kForeignKey;
    case 275:  // SQLITE_CONSTRAINT_CHECK
      return DbFault::kCheck;
    case 1299:  // SQLITE_CONSTRAINT_NOTNULL
      return DbFault::kNotNull;
    case 1811:  // SQLITE_CONSTRAINT_TRIGGER: only our append-only triggers raise it
      return DbFault::kAppendOnly;
    default:
      break;
  }
  switch (code & 0xFF) {
    case 5:  // SQLITE_BUSY
    case 6:  // SQLITE_LOCKED
      return DbFault::kBusy;
    case 8:  // SQLITE_READONLY
      return DbFault::kReadOnly;
    case 13:  // SQLITE_FULL
      return DbFault::kFull;
    case 11:  // SQLITE_CORRUPT
    case 26:  // SQLITE_NOTADB
      return DbFault::kCorrupt;
    default:
      return DbFault::kOther;
  }
}

// https://www.postgresql.org/docs/15/errcodes-appendix.html
DbFault postgresqlFault(const QString& state) {
  static const std::array<std::pair<const char*, DbFault>, 17> kFaults{{
      {"23505", DbFault::kUnique},
      {"23503", DbFault::kForeignKey},
      {"23001", DbFault::kForeignKey},
      {"23514", DbFault::kCheck},
      {"23502", DbFault::kNotNull},
      {"TR001", DbFault::kAppendOnly},  // raised by refuse_change(), db/migrations/dialect.cpp
      {"25006", DbFault::kReadOnly},
      {"55P03", DbFault::kBusy},
      {"40001", DbFault::kConflict},
      {"40P01", DbFault::kConflict},
      {"53100", DbFault::kFull},
      {"XX001", DbFault::kCorrupt},
      {"57014", DbFault::kBusy},  // statement_timeout exceeded
      {"57P01", DbFault::kUnreachable},
      {"57P02", DbFault::kUnreachable},
      {"57P03", DbFault::kUnreachable},
      {"25P02", DbFault::kBrokenBefore},
  }};
  for (const auto& [code, fault] : kFaults) {
    if (state == QLatin1String(code)) {
      return fault;
    }
  }
  return state.isEmpty() || state.startsWith(QLatin1String("08")) ? DbFault::kUnreachable : DbFault::kOther;
}

/// Detects a format number in the file header that no SQLite version wrote; the engine has no code for it.
bool isOfNoFormat(const QSqlError& error) {
  return error.databaseText().contains(QLatin1String("unsupported file format"));
}

bool isOfTheDisk(const QSqlError& error) {
  constexpr int kIoError = 10;
  constexpr int kCannotOpen = 14;
  const int primary = error.nativeErrorCode().toInt() & 0xFF;
  return primary == kIoError || primary == kCannotOpen;
}

struct Wording {
  Text what;
  Text remedy;
};

Wording wordingOf(DbFault fault) {
  switch (fault) {
    case DbFault::kBusy:
      return {Text::tr("database is busy: another program is writing to it"),
              Text::tr("Try again in a moment")};
    case DbFault::kUnique:
      return {Text::tr("this record exists already"),
              Text::tr("Give it another code, or change the existing one")};
    case DbFault::kForeignKey:
      return {Text::tr("refers to a record that does not exist, or is still in use"),
              Text::tr("Check what it refers to")};
    case DbFault::kCheck:
      return {Text::tr("a value breaks the rule of its column"), Text::tr("Correct the value")};
    case DbFault::kNotNull:
      return {Text::tr("a required value is missing"), Text::tr("Fill it in")};
    case DbFault::kAppendOnly:
      return {Text::tr("this record is sealed and cannot be changed"), Text::tr("Add a new version instead")};
    case DbFault::kReadOnly:
      return {Text::tr("database is open for reading only"),
              Text::tr("Open it for writing, or copy it to a writable folder")};
    case DbFault::kFull:
      return {Text::tr("no space left"), Text::tr("Free some space on the disk")};
    case DbFault::kCorrupt:
      return {Text::tr("database is damaged"), Text::tr("Restore the latest backup")};
    case DbFault::kUnreachable:
      return {Text::tr("database server does not answer"),
              Text::tr("Check that it runs and that the address is right")};
    case DbFault::kConflict:
      return {Text::tr("another station changed the same records at the same time"), Text::tr("Try again")};
    case DbFault::kBrokenBefore:
      return {Text::tr("an earlier step of this change failed: nothing was kept"),
              Text::tr("Repeat the whole change")};
    case DbFault::kOther:
      break;
  }
  return {Text::tr("database refused the operation"), Text()};
}

}  // namespace

std::string operationOf(std::string_view sql) {
  constexpr std::size_t kWords = 3;
  std::string words;
  std::size_t count = 0;
  for (const char c : sql) {
    const bool gap = c == ' ' || c == '\n' || c == '\t';
    if (c == '(' || c == ';' || c == '\'' || words.size() >= 60) {
      break;
    }
    if (gap && (words.empty() || words.back() == ' ')) {
      continue;
    }
    if (gap && ++count == kWords) {
      break;
    }
    words.push_back(gap ? ' ' : c);
  }
  while (!words.empty() && words.back() == ' ') {
    words.pop_back();
  }
  return words;
}

DbFault faultOf(Engine engine, const QSqlError& error) {
  const QString code = error.nativeErrorCode();
  if (engine == Engine::kSqlite) {
    return isOfNoFormat(error) ? DbFault::kCorrupt : sqliteFault(code.toInt());
  }
  return postgresqlFault(code);
}

void ConnectionState::fail(std::string_view sql, const QSqlError& error) {
  const DbFault fault = faultOf(engine, error);
  if (depth > 0) {
    abandon();
  }
  const Wording wording = wordingOf(fault);
  Text what = wording.what;
  // The first line of the driver's message names constraint or syntax; PostgreSQL's further lines contain
  // values.
  const std::string detail = error.databaseText().section(QLatin1Char('\n'), 0, 0).trimmed().toStdString();
  if (fault == DbFault::kOther || fault == DbFault::kCheck || fault == DbFault::kNotNull ||
      fault == DbFault::kUnique || fault == DbFault::kUnreachable) {
    if (!detail.empty()) {
      what = Text::verbatim("%1: %2", wording.what, detail);
    }
  }
  const bool ofTheDisk = fault == DbFault::kOther && engine == Engine::kSqlite && isOfTheDisk(error);
  throw DbError(fault, operationOf(sql), what, location,
                ofTheDisk ? Text::tr("Check the disk, and whether it is full") : wording.remedy);
}

namespace {

ErrorCode codeOf(DbFault fault) {
  switch (fault) {
    case DbFault::kCorrupt:
      return ErrorCode::kVerifyFailed;
    case DbFault::kFull:
      return ErrorCode::kFileUnwritable;
    default:
      return ErrorCode::kDatabase;
  }
}

}  // namespace

DbError::DbError(DbFault fault, const std::string& operation, const Text& what, const Text& where,
                 const Text& remedy)
    // If the server is unreachable, the last statement tells the reader nothing.
    : Error(codeOf(fault),
            operation.empty() || fault == DbFault::kUnreachable ? what : Text::tr("%1 (%2)", what, operation),
            where, remedy),
      fault_(fault),
      operation_(operation) {}

bool DbError::retryable() const noexcept {
  return fault_ == DbFault::kBusy || fault_ == DbFault::kUnreachable || fault_ == DbFault::kConflict;
}

}  // namespace torsio
