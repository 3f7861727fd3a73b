// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/schema_check.h"

#include <map>
#include <sstream>

#include "db/migrations/dialect.h"
#include "db/migrations/migrations.h"

namespace torsio {

namespace {

/// What a part of the schema is made of, by its kind and name.
using Parts = std::map<std::string, std::string>;

Parts partsFrom(Connection& connection, const char* sql) {
  Parts parts;
  Statement row = connection.prepare(sql);
  row.execute();
  while (row.step()) {
    parts[row.text(0)] = row.text(1);
  }
  return parts;
}

Parts sqliteParts(Connection& connection) {
  return partsFrom(connection,
                   "SELECT type || ' ' || name, tbl_name || ' ' || coalesce(sql, '') || ' ' || typeof(type)"
                   " || typeof(name) || typeof(tbl_name) || typeof(sql) FROM sqlite_master"
                   " WHERE name NOT LIKE 'sqlite\\_stat%' ESCAPE '\\'");
}

/// Who may do what, and which steps were applied: rows that the steps fill, and nothing else.
Parts rightsIn(Connection& connection) {
  Parts parts =
      partsFrom(connection, "SELECT 'right ' || role_code || ' ' || operation_code, '' FROM role_operation");
  parts.merge(partsFrom(connection, "SELECT 'role ' || code, label FROM role"));
  parts.merge(partsFrom(connection, "SELECT 'operation ' || code, label FROM operation"));
  parts.merge(partsFrom(connection,
                        "SELECT 'step ' || version, name || ' ' || compatible_from || ' ' || checksum || ' '"
                        " || description FROM schema_migration"));
  return parts;
}

/// A trigger is "on" for every session, and its function has the body that the step gives it.
Parts postgresqlParts(Connection& connection) {
  Parts parts = partsFrom(connection,
                          "SELECT 'trigger ' || g.tgname, CASE g.tgenabled WHEN 'O' THEN 'on' ELSE 'off' END"
                          " FROM pg_trigger g JOIN pg_class t ON t.oid = g.tgrelid"
                          " WHERE t.relnamespace = current_schema()::regnamespace AND NOT g.tgisinternal");
  parts.merge(partsFrom(connection,
                        "SELECT 'function ' || p.proname, p.prosrc FROM pg_proc p"
                        " WHERE p.pronamespace = current_schema()::regnamespace"));
  return parts;
}

Parts expectedOnPostgresql() {
  Parts parts;
  for (const Migration& step : embeddedMigrations()) {
    for (const std::string& sql : statementsFor(Engine::kPostgresql, step.sql, step.name)) {
      std::istringstream words(sql);
      std::string create;
      std::string kind;
      std::string name;
      words >> create >> kind >> name;
      if (kind == "TRIGGER") {
        parts["trigger " + name] = "on";
      } else if (kind == "FUNCTION") {
        const std::size_t body = sql.find("$$") + 2;
        parts["function " + name.substr(0, name.find('('))] = sql.substr(body, sql.rfind("$$") - body);
      }
    }
  }
  return parts;
}

}  // namespace

Connection freshRecord() {
  Connection fresh = openDatabase(":memory:", OpenMode::kCreate);
  migrate(fresh, embeddedMigrations(), {.backup = false});
  return fresh;
}

std::vector<SchemaFinding> schemaFindings(Connection& connection,
                                          const std::map<std::string, std::string>& serverFunctions) {
  const bool sqlite = connection.engine() == Engine::kSqlite;
  if (const SchemaState state = checkSchema(connection, embeddedMigrations()); state.version != state.known) {
    return {};
  }
  Connection fresh = freshRecord();
  Parts expected = sqlite ? sqliteParts(fresh) : expectedOnPostgresql();
  Parts found = sqlite ? sqliteParts(connection) : postgresqlParts(connection);
  expected.merge(rightsIn(fresh));
  found.merge(rightsIn(connection));
  std::vector<SchemaFinding> findings;
  for (const auto& [part, made] : expected) {
    const auto present = found.find(part);
    if (present == found.end()) {
      findings.push_back({part, "is missing: somebody took it away"});
    } else if (present->second != made) {
      findings.push_back({part, "was changed, or switched off"});
    }
  }
  for (const auto& [part, made] : found) {
    const auto server = serverFunctions.find(part.substr(part.find(' ') + 1));
    if (part.starts_with("function ") && server != serverFunctions.end()) {
      if (server->second != made) {
        findings.push_back({part, "was changed, or is of another version: prepare the server again"});
      }
    } else if (!expected.contains(part)) {
      findings.push_back({part, "does not belong to the record: somebody added it"});
    }
  }
  return findings;
}

}  // namespace torsio
