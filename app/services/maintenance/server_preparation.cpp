// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/maintenance/server_preparation.h"

#include <set>
#include <vector>

#include "app/services/base/build_info.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/dialect.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/schema_tables.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

void requireServer(Engine engine, const std::string& location) {
  if (engine != Engine::kPostgresql) {
    throw Error(ErrorCode::kUsage, Text::tr("an SQLite file has no roles of its own"), location,
                Text::tr("Name the address of a PostgreSQL server"));
  }
}

}  // namespace

void prepareServer(const Maintainer& maintainer, const std::string& locator, const std::string& stationRole) {
  requireServer(parseLocator(locator).engine, locator);
  MaintenanceDesk desk(
      maintainer, openRecord(locator, OpenMode::kReadWrite, {.softwareVersion = softwareVersion()}), locator);
  prepareServer(desk.session(), stationRole);
}

void prepareServer(SessionContext& session, const std::string& stationRole) {
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
  session.note({.action = AuditAction::kDatabasePrepareServer,
                .objectKind = AuditObject::kDatabase,
                .objectId = connection.location(),
                .newJson = R"({"station_role":")" + stationRole + "\"}"});
  transaction.commit();
}

}  // namespace torsio
