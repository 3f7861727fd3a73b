// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/migrations.h"

#include <algorithm>
#include <chrono>
#include <sstream>
#include <system_error>

#include <QDir>
#include <QFile>

#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/dialect.h"
#include "db/migrations/file_in_the_making.h"
#include "db/repository/base/copy_register.h"
#include "db/repository/base/row_ledger.h"
#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"

// Outside any namespace, as Qt requires: a static library registers its resources only on request.
static void registerMigrationFiles() {
  Q_INIT_RESOURCE(migrations);
}

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr const char* kInMemory = ":memory:";
// A second program started meanwhile waits for the record that the first one makes.
constexpr auto kMakingPatience = std::chrono::seconds(30);

// Held during a migration, so that a second station waits instead of migrating too ("TORM" in ASCII, and the
// schema: other records in the same database do not wait). A copy of a record holds it to its end.
constexpr const char* kAdvisoryLock =
    "SELECT pg_advisory_xact_lock(1414484557, hashtext(current_schema()::text))";

constexpr const char* kBookkeeping =
    "CREATE TABLE schema_migration ("
    " version BIGINT PRIMARY KEY,"
    " name TEXT NOT NULL,"
    " description TEXT NOT NULL,"
    " checksum TEXT NOT NULL,"
    " compatible_from BIGINT NOT NULL,"
    " software_version TEXT NOT NULL,"
    " applied_utc_us BIGINT NOT NULL)";

// Reason of the audit entry that seals rows left unsealed by an older version.
constexpr const char* kSealedOnUpgrade = "sealed on upgrade, not before";

struct AppliedStep {
  std::int64_t version = 0;
  std::int64_t compatibleFrom = 0;
  std::string checksum;
};

std::int64_t countOf(Connection& connection, std::string_view sql) {
  Statement query = connection.prepare(sql);
  query.execute();
  return query.step() ? query.int64(0) : 0;
}

bool hasTable(Connection& connection, const std::string& name) {
  return countOf(connection, connection.engine() == Engine::kSqlite
                                 ? "SELECT count(*) FROM sqlite_master WHERE name = '" + name + "'"
                                 : "SELECT count(*) FROM pg_tables WHERE tablename = '" + name +
                                       "' AND schemaname = current_schema()") > 0;
}

bool hasBookkeeping(Connection& connection) {
  return hasTable(connection, "schema_migration");
}

/// True if there are tables that are not ours; another program's SQLite file must never be migrated.
bool hasForeignTables(Connection& connection) {
  return connection.engine() == Engine::kSqlite &&
         countOf(connection, "SELECT count(*) FROM sqlite_master WHERE type = 'table'") > 0;
}

std::vector<AppliedStep> appliedSteps(Connection& connection) {
  std::vector<AppliedStep> steps;
  if (!hasBookkeeping(connection)) {
    return steps;
  }
  Statement query =
      connection.prepare("SELECT version, compatible_from, checksum FROM schema_migration ORDER BY version");
  query.execute();
  while (query.step()) {
    steps.push_back({query.int64(0), query.int64(1), query.text(2)});
  }
  return steps;
}

std::string headValue(const std::string& text, const std::string& key, const std::string& name) {
  const std::string start = "-- " + key + ": ";
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(start)) {
      return line.substr(start.size());
    }
  }
  refuse(Text::tr("the line \"%1...\" is missing", start), name, Text::tr("Add it"));
}

/// `seals`: seals rows that an older version left unsealed; after the last step only, as the rules know the
/// tables of all of them.
void applyStep(Connection& connection, const Migration& step, const MigrationOptions& options, bool seals) {
  Transaction transaction(connection);
  if (connection.engine() == Engine::kPostgresql) {
    connection.executeVerbatim(kAdvisoryLock);
  }
  const std::vector<AppliedStep> applied = appliedSteps(connection);
  if (!applied.empty() && applied.back().version >= step.version) {  // another program was faster
    transaction.commit();
    return;
  }
  if (applied.empty() && !hasBookkeeping(connection)) {
    connection.executeVerbatim(kBookkeeping);
  }
  for (const std::string& sql : statementsFor(connection.engine(), step.sql, step.name)) {
    connection.executeVerbatim(sql);
  }
  const std::int64_t now_us = options.now_us != 0 ? options.now_us : utcNow_us();
  connection.execute(
      "INSERT INTO schema_migration (version, name, description, checksum, compatible_from, software_version,"
      " applied_utc_us) VALUES (?, ?, ?, ?, ?, ?, ?)",
      {step.version, step.name, step.description, step.checksum, step.compatibleFrom, options.softwareVersion,
       now_us});
  if (seals && hasTable(connection, "row_seal")) {
    sealUnsealed(connection, kSealedOnUpgrade, now_us);
  }
  transaction.commit();
}

/// Creates the file of a new record and renames it once its tables exist, so that a killed program leaves no
/// incomplete record.
void makeRecord(const fs::path& file, const std::vector<Migration>& migrations,
                const MigrationOptions& options) {
  requireUsableFile(file, OpenMode::kCreate);
  const FileInTheMaking making(file, kMakingPatience);
  std::error_code failed;
  if (fs::exists(file, failed)) {  // another program was faster
    return;
  }
  {
    Connection fresh = openDatabase(making.path().string(), OpenMode::kCreate);
    migrate(fresh, migrations, options);
    disableWriteAheadLog(fresh);  // so that the file can be moved without its log
  }
  fs::rename(making.path(), file, failed);
  if (failed) {
    refuseUnwritable(file);
  }
}

[[noreturn]] void newerSchema(Connection& connection, const SchemaState& state) {
  Statement newest =
      connection.prepare("SELECT software_version FROM schema_migration ORDER BY version DESC LIMIT 1");
  newest.execute();
  const std::string writer = newest.step() ? newest.text(0) : "";
  throw Error(ErrorCode::kNewerSchema,
              Text::tr("was written by a newer version of Torsio (schema %1, this program knows %2)",
                       state.version, state.known),
              connection.location(), Text::tr("Update Torsio on this machine to version %1", writer));
}

/// Throws unless this account may change the tables of a server.
void requireOwnerOfSchema(Connection& connection, const SchemaState& state) {
  if (connection.engine() != Engine::kPostgresql || state.version == 0 ||
      countOf(connection,
              "SELECT count(*) FROM pg_tables WHERE tablename = 'schema_migration' AND schemaname ="
              " current_schema() AND pg_has_role(tableowner, 'MEMBER')") > 0) {
    return;
  }
  throw Error(
      ErrorCode::kPermission,
      Text::tr("the record on the server has schema %1, and this program needs %2", state.version,
               state.known),
      connection.location(),
      Text::tr("Let the owner of the record run torsio db prepare-server with this version; until then "
               "use the version of before on this machine"));
}

}  // namespace

Migration parseMigration(const std::string& name, const std::string& text) {
  Migration step;
  step.name = name;
  std::copy_if(text.begin(), text.end(), std::back_inserter(step.sql), [](char c) { return c != '\r'; });
  try {
    step.version = std::stoll(name.substr(0, 4));
    step.compatibleFrom = std::stoll(headValue(step.sql, "compatible_from", name));
  } catch (const std::logic_error&) {
    refuse(Text::tr("number of the step or of compatible_from cannot be read"), name,
           Text::tr("Name it NNNN_what.sql and write -- compatible_from: N"));
  }
  step.description = headValue(step.sql, "description", name);
  Digest digest;
  digest.update(std::string_view(step.sql));
  step.checksum = digest.hex();
  return step;
}

std::vector<Migration> embeddedMigrations() {
  registerMigrationFiles();
  std::vector<Migration> steps;
  const QDir folder(QStringLiteral(":/torsio/migrations"));
  for (const QString& entry : folder.entryList({QStringLiteral("*.sql")}, QDir::Files, QDir::Name)) {
    QFile file(folder.filePath(entry));
    TORSIO_EXPECTS(file.open(QIODevice::ReadOnly));
    steps.push_back(parseMigration(entry.chopped(4).toStdString(), file.readAll().toStdString()));
    TORSIO_EXPECTS(steps.back().version == static_cast<std::int64_t>(steps.size()));
  }
  TORSIO_EXPECTS(!steps.empty());
  return steps;
}

SchemaState checkSchema(Connection& connection, const std::vector<Migration>& migrations) {
  SchemaState state;
  state.known = migrations.empty() ? 0 : migrations.back().version;
  const std::vector<AppliedStep> applied = appliedSteps(connection);
  if (applied.empty()) {
    if (!hasBookkeeping(connection) && hasForeignTables(connection)) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("is a database of another program"),
                  connection.location(), Text::tr("Choose another file"));
    }
    return state;
  }
  state.version = applied.back().version;
  state.compatibleFrom = applied.back().compatibleFrom;
  for (std::size_t i = 1; i < applied.size(); ++i) {
    if (applied[i].version != applied[i - 1].version + 1) {  // steps are applied one after the other
      throw Error(ErrorCode::kVerifyFailed,
                  Text::tr("its list of schema steps was changed: step %1 is followed by step %2",
                           applied[i - 1].version, applied[i].version),
                  connection.location(), Text::tr("Restore the latest backup"));
    }
  }
  const bool readable = connection.readOnly() && state.compatibleFrom <= state.known;
  if (state.version > state.known && !readable) {
    newerSchema(connection, state);
  }
  for (const AppliedStep& step : applied) {
    if (step.version > state.known) {
      continue;
    }
    if (step.version < 1) {
      throw Error(ErrorCode::kVerifyFailed, Text::tr("its list of schema steps was changed"),
                  connection.location(), Text::tr("Restore the latest backup"));
    }
    const Migration& known = migrations[static_cast<std::size_t>(step.version - 1)];
    if (known.checksum != step.checksum) {
      throw Error(ErrorCode::kVerifyFailed,
                  Text::tr("schema step %1 differs from the one that was applied", known.name),
                  connection.location(),
                  Text::tr("Use the program that made this database, or restore a backup"));
    }
  }
  return state;
}

MigrationReport migrate(Connection& connection, const std::vector<Migration>& migrations,
                        const MigrationOptions& options) {
  const SchemaState state = checkSchema(connection, migrations);
  MigrationReport report{.fromVersion = state.version, .toVersion = state.known, .backup = std::nullopt};
  if (state.version >= state.known) {
    return report;
  }
  requireOwnerOfSchema(connection, state);
  if (connection.engine() == Engine::kSqlite && state.version > 0 && options.backup &&
      connection.location() != kInMemory) {
    const fs::path file = connection.location();
    fs::path copy = file;
    copy += ".schema-" + std::to_string(state.version) + ".sqlite";
    copy = freeName(copy);  // an older copy may be the only one of its data
    backupSqlite(connection, copy);
    report.backup = copy;
  }
  for (const Migration& step : migrations) {
    if (step.version > state.version) {
      applyStep(connection, step, options, state.version > 0 && step.version == state.known);
    }
  }
  return report;
}

Connection openRecord(const std::string& locator, OpenMode mode, const MigrationOptions& options) {
  const std::vector<Migration> migrations = embeddedMigrations();
  if (const Locator parsed = parseLocator(locator);
      parsed.engine == Engine::kSqlite && mode != OpenMode::kReadOnly) {
    recoverRecord(parsed.file);
    std::error_code ignored;
    if (mode == OpenMode::kCreate && parsed.file != kInMemory && !fs::exists(parsed.file, ignored)) {
      makeRecord(parsed.file, migrations, options);
    }
  }
  Connection connection = openDatabase(locator, mode);
  if (mode != OpenMode::kReadOnly) {
    const MigrationReport report = migrate(connection, migrations, options);
    sealChanges(connection);
    if (report.backup) {
      CopyRegister(connection)
          .add({.kind = CopyKind::kBeforeSchema,
                .place = fs::absolute(*report.backup).string(),
                .station = options.station,
                .madeUtc_us = options.now_us != 0 ? options.now_us : utcNow_us()});
    }
    return connection;
  }
  const SchemaState state = checkSchema(connection, migrations);
  if (state.version < state.known) {
    throw Error(ErrorCode::kDatabase,
                state.version == 0 ? Text::tr("contains no Torsio record")
                                   : Text::tr("has an older schema than this program"),
                connection.location(),
                Text::tr("Open it once for writing, so that it can be brought up to date"));
  }
  return connection;
}

bool isBeingFilled(Connection& connection) {
  if (connection.engine() != Engine::kPostgresql) {
    return false;
  }
  const Transaction look(connection, Transaction::Purpose::kReadOnly);
  Statement lock =
      connection.prepare("SELECT pg_try_advisory_xact_lock(1414484557, hashtext(current_schema()::text))");
  lock.execute();
  return !lock.step() || !lock.boolean(0);
}

}  // namespace torsio
