// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/server_move.h"

#include <set>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/services/access/first_run.h"
#include "app/services/access/moved_record.h"
#include "app/services/base/build_info.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/maintenance/record_restore.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/dialect.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/schema_tables.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

std::string locatorOf(const ServerAddress& address, const std::string& password) {
  if (address.host.empty() || address.database.empty() || address.user.empty()) {
    refuseParameter(Text::tr("the address of the server is not complete"), "",
                    Text::tr("Give the computer, the database and the account"));
  }
  Locator server{.engine = Engine::kPostgresql,
                 .user = address.user,
                 .password = password,
                 .host = address.host,
                 .port = address.port,
                 .database = address.database,
                 .schema = address.schema};
  if (!address.tlsMode.empty()) {
    server.parameters.push_back({"sslmode", address.tlsMode});
  }
  if (!address.rootCertificate.empty()) {
    server.parameters.push_back({"sslrootcert", address.rootCertificate});
  }
  std::string locator = addressOf(server);
  (void)parseLocator(locator);  // throws if no valid address results
  return locator;
}

std::string oneText(Connection& connection, const std::string& sql) {
  Statement row = connection.prepare(sql);
  row.execute();
  std::string text;
  while (row.step()) {
    text = row.text(0);
  }
  return text;
}

bool opens(const std::string& locator) {
  try {
    (void)openDatabase(locator, OpenMode::kReadOnly);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Fills in the database's content and why the record cannot be moved there.
void inspectDatabase(Connection& connection, ServerCheck& check) {
  try {
    check.schemaVersion = checkSchema(connection, embeddedMigrations()).version;
  } catch (const Error& error) {
    check.hindrance = error.happened();
    return;
  }
  check.holdsRecord = check.schemaVersion > 0 && !isEmptyRecord(connection);
  if (check.holdsRecord) {
    check.hindrance = "there is a record in this database already";
    return;
  }
  Statement row =
      connection.prepare("SELECT coalesce(has_schema_privilege(current_schema(), 'CREATE'), FALSE)");
  row.execute();
  bool may = false;
  while (row.step()) {
    may = row.boolean(0);
  }
  if (!may) {
    check.hindrance = "this account may not make tables there";
  }
}

/// Returns the locator to store. Throws if it cannot be opened.
std::string requireLastingLocator(const ServerAddress& address) {
  std::string locator = lastingLocator(address);
  if (opens(locator)) {
    return locator;
  }
  throw Error(ErrorCode::kDatabase,
              Text::tr("the server does not let this station in without the typed password"),
              parseLocator(locator).shown(),
              Text::tr("Put the line shown here into the password file of this computer's account"));
}

void requireNoUnstoredTrials(const std::string& locator, const std::filesystem::path& folder) {
  const UnstoredTrials waiting = unstoredTrials(locator, folder);
  if (waiting.trials.empty()) {
    return;
  }
  refuse(Text::tr("recordings of this station still wait in files (%1)", waiting.trials.size()),
         folder.string(), Text::tr("Start Torsio again at this station, which stores them, then try again"));
}

constexpr double kCopyFrom = 0.02;  // share of the total progress; before it, the server is checked

}  // namespace

std::string typedLocator(const ServerAddress& address) {
  return locatorOf(address, address.password);
}

std::string lastingLocator(const ServerAddress& address) {
  return locatorOf(address, {});
}

std::string passwordFileLine(const ServerAddress& address) {
  return address.host + ":" + std::to_string(address.port) + ":" + address.database + ":" + address.user +
         ":PASSWORD";
}

ServerCheck checkServer(SessionContext& session, const ServerAddress& address) {
  session.require(Operation::kDatabaseRestore);
  ServerCheck check;
  Connection connection = openDatabase(typedLocator(address), OpenMode::kReadOnly);
  check.location = connection.location();
  check.server = "PostgreSQL " + oneText(connection, "SELECT current_setting('server_version')");
  inspectDatabase(connection, check);
  check.opensWithoutPassword = address.password.empty() || opens(lastingLocator(address));
  return check;
}

CopyReport moveToServer(SessionContext& session, const ServerAddress& address,
                        const ProgressCallback& progress, const std::filesystem::path& unstored) {
  session.require(Operation::kDatabaseRestore);
  requireNobodyAtWork(session);
  requireNoUnstoredTrials(session.key().locator, unstored);
  tellProgress(progress, Text::tr("Checking the server"), 0.0);
  const ServerCheck check = checkServer(session, address);
  if (!check.hindrance.empty()) {
    refuse(check.hindrance, check.location,
           Text::tr("Let the server's administrator make an empty database"));
  }
  return copyDatabase(session, typedLocator(address), partOf(progress, kCopyFrom, 1.0));
}

std::string switchToServer(SessionContext& session, const ServerAddress& address, const CopyReport& copied) {
  session.require(Operation::kDatabaseRestore);
  requireNobodyAtWork(session);
  if (AuditRepository(session.connection()).length() != copied.auditEntries) {
    refuse(Text::tr("something was written to this record after it was copied"),
           session.connection().location(), Text::tr("Make an empty database on the server and copy again"));
  }
  std::string locator = requireLastingLocator(address);
  noteMoving(session, locator);  // from here on only one of the two lives
  Connection there = openDatabase(locator, OpenMode::kReadWrite);
  const SessionContext server(there, session.ids(), session.key(), [&session] { return session.now_us(); });
  server.note(AuditAction::kDatabaseSwitch, AuditObject::kDatabase, parseLocator(locator).shown(),
              {{"tables", copied.tables.size()}, {"rows", copied.rows}});
  noteMoved(session);
  return locator;
}

std::string joinServer(SessionContext& session, const ServerAddress& address,
                       const std::filesystem::path& unstored) {
  session.require(Operation::kDatabaseRestore);
  requireNoUnstoredTrials(session.key().locator, unstored);
  const ServerCheck check = checkServer(session, address);
  if (!check.holdsRecord) {
    refuse(Text::tr("there is no record in this database"), check.location,
           Text::tr("Copy the record of this station there"));
  }
  std::string locator = requireLastingLocator(address);
  if (lookAtRecord(locator) != RecordPlace::kCentre) {
    refuse(Text::tr("the record in this database contains no centre"), check.location,
           Text::tr("Set the centre up at the first station; this one can join then"));
  }
  const AuditNote note{
      .action = AuditAction::kDatabaseJoin, .objectKind = AuditObject::kDatabase, .objectId = check.location};
  Connection there = openUpToDate(locator);
  const SessionContext server(there, session.ids(), session.key(), [&session] { return session.now_us(); });
  server.note(note);
  session.note(note);
  return locator;
}

namespace {

void requireServer(Engine engine, const std::string& location) {
  if (engine != Engine::kPostgresql) {
    throw Error(ErrorCode::kUsage, Text::tr("an SQLite file has no roles of its own"), location,
                Text::tr("Name the address of a PostgreSQL server"));
  }
}

}  // namespace

OutdatedAccess prepareServer(const Maintainer& maintainer, const std::string& locator,
                             const std::string& stationRole) {
  requireServer(parseLocator(locator).engine, locator);
  MaintenanceDesk desk(
      maintainer, openRecord(locator, OpenMode::kReadWrite, {.softwareVersion = softwareVersion()}), locator);
  return prepareServer(desk.session(), stationRole);
}

OutdatedAccess prepareServer(SessionContext& session, const std::string& stationRole) {
  session.require(Operation::kDatabaseRestore);
  Connection& connection = session.connection();
  requireServer(connection.engine(), connection.location());
  if (!isOwnerOfTables(connection)) {
    throw Error(ErrorCode::kPermission, Text::tr("this account does not own the tables of the record"),
                connection.location(), Text::tr("Connect as the owner"));
  }
  std::set<std::string> appendOnly;
  for (const Migration& step : embeddedMigrations()) {
    for (const std::string& table : appendOnlyTables(step.sql)) {
      appendOnly.insert(table);
    }
  }
  std::vector<std::string> tables{"schema_migration"};
  for (const SchemaTable& table : tablesInReferenceOrder(connection)) {
    tables.push_back(table.name);
  }
  Transaction transaction(connection);
  writeServerRoles(connection, tables, appendOnly, stationRole);
  session.note(AuditAction::kDatabasePrepareServer, AuditObject::kDatabase, connection.location(),
               {{"station_role", stationRole}});
  OutdatedAccess outdated = AccessRepository(connection).outdatedAccess(session.now_us());
  transaction.commit();
  return outdated;
}

}  // namespace torsio
