// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/schema_check.h"

#include <cctype>
#include <map>
#include <sstream>

#include "db/migrations/dialect.h"
#include "db/migrations/migrations.h"

namespace torsio {

namespace {

/// Definitions of parts of the schema by kind and name.
using Parts = std::map<std::string, std::string>;

/// Formats a value with its type: bytes that spell a text differ from that text.
std::string describedValue(const Value& value) {
  if (const auto* text = std::get_if<std::string>(&value.storage())) {
    return "\"" + *text + "\"";
  }
  if (const auto* number = std::get_if<std::int64_t>(&value.storage())) {
    return std::to_string(*number);
  }
  return std::holds_alternative<std::monostate>(value.storage()) ? "nothing" : "something else";
}

/// Makes a part of each row: named by `prefix` and the first column, defined by all columns.
Parts partsFrom(Connection& connection, const std::string& prefix, const char* sql) {
  Parts parts;
  Statement row = connection.prepare(sql);
  row.execute();
  while (row.step()) {
    std::string& made = parts[prefix + row.text(0)];
    for (int column = 0; column < row.columnCount(); ++column) {
      made += (made.empty() ? "" : " ") + describedValue(row.value(column));
    }
  }
  return parts;
}

Parts sqliteParts(Connection& connection) {
  return partsFrom(connection, "",
                   "SELECT type || ' ' || name, type, name, tbl_name, sql FROM sqlite_master"
                   " WHERE name NOT LIKE 'sqlite\\_stat%' ESCAPE '\\'");
}

/// Permission matrix and applied migrations: the rows that only migrations fill.
Parts rightsIn(Connection& connection) {
  Parts parts =
      partsFrom(connection, "right ",
                "SELECT role_code || ' ' || operation_code, role_code, operation_code FROM role_operation");
  parts.merge(partsFrom(connection, "role ", "SELECT code, label FROM role"));
  parts.merge(partsFrom(connection, "operation ", "SELECT code, label FROM operation"));
  parts.merge(
      partsFrom(connection, "step ",
                "SELECT version, name, compatible_from, checksum, description FROM schema_migration"));
  return parts;
}

/// Columns, references, checks, keys and indices in a notation common to both engines.
Parts outlineOfSqlite(Connection& connection) {
  Parts parts =
      partsFrom(connection, "column ",
                "SELECT m.name || '.' || c.name, CASE c.type WHEN 'BLOB' THEN 'bytea' ELSE lower(c.type) END,"
                " c.\"notnull\" OR c.pk > 0 FROM sqlite_master m JOIN pragma_table_info(m.name) c"
                " WHERE m.type = 'table' AND m.name NOT LIKE 'sqlite\\_%' ESCAPE '\\'");
  parts.merge(partsFrom(connection, "references ",
                        "SELECT m.name || ' to ' || f.\"table\", count(DISTINCT f.id) FROM sqlite_master m"
                        " JOIN pragma_foreign_key_list(m.name) f WHERE m.type = 'table' GROUP BY 1"));
  parts.merge(partsFrom(connection, "checks of ",
                        "SELECT name, (length(sql) - length(replace(sql, 'CHECK (', ''))) / 7"
                        " FROM sqlite_master WHERE type = 'table' AND sql LIKE '%CHECK (%'"));
  parts.merge(partsFrom(connection, "keys of ",
                        "SELECT m.name, count(*) FROM sqlite_master m JOIN pragma_index_list(m.name) i"
                        " WHERE m.type = 'table' AND i.origin IN ('pk', 'u') GROUP BY 1"));
  parts.merge(partsFrom(connection, "index ",
                        "SELECT i.name, i.\"unique\", i.partial FROM sqlite_master m"
                        " JOIN pragma_index_list(m.name) i WHERE m.type = 'table' AND i.origin = 'c'"));
  return parts;
}

Parts outlineOfPostgresql(Connection& connection) {
  Parts parts = partsFrom(
      connection, "column ",
      "SELECT t.relname || '.' || a.attname, format_type(a.atttypid, a.atttypmod), a.attnotnull::int"
      " FROM pg_class t JOIN pg_attribute a ON a.attrelid = t.oid"
      " WHERE t.relnamespace = current_schema()::regnamespace AND t.relkind IN ('r', 'p')"
      " AND a.attnum > 0 AND NOT a.attisdropped");
  parts.merge(partsFrom(connection, "references ",
                        "SELECT t.relname || ' to ' || f.relname, count(*) FROM pg_constraint c"
                        " JOIN pg_class t ON t.oid = c.conrelid JOIN pg_class f ON f.oid = c.confrelid"
                        " WHERE c.connamespace = current_schema()::regnamespace AND c.contype = 'f'"
                        " AND c.convalidated GROUP BY 1"));
  parts.merge(partsFrom(connection, "checks of ",
                        "SELECT t.relname, count(*) FROM pg_constraint c JOIN pg_class t ON t.oid ="
                        " c.conrelid WHERE c.connamespace = current_schema()::regnamespace"
                        " AND c.contype = 'c' AND c.convalidated GROUP BY 1"));
  parts.merge(partsFrom(connection, "keys of ",
                        "SELECT t.relname, count(*) FROM pg_constraint c JOIN pg_class t ON t.oid ="
                        " c.conrelid WHERE c.connamespace = current_schema()::regnamespace"
                        " AND c.contype IN ('p', 'u') GROUP BY 1"));
  parts.merge(partsFrom(connection, "index ",
                        "SELECT n.relname, i.indisunique::int, (i.indpred IS NOT NULL)::int FROM pg_index i"
                        " JOIN pg_class n ON n.oid = i.indexrelid"
                        " WHERE n.relnamespace = current_schema()::regnamespace AND i.indisvalid"
                        " AND NOT EXISTS (SELECT 1 FROM pg_constraint c WHERE c.conindid = i.indexrelid)"));
  return parts;
}

/// Normalises a trigger to one line: PostgreSQL rewrites its parentheses, schema and order of events.
std::string plainTrigger(std::string made, const std::string& schema) {
  std::string plain;
  for (const char letter : made) {
    if (letter == '(' || letter == ')') {
      continue;
    }
    const bool blank = letter == ' ' || letter == '\n';
    if (!blank || (!plain.empty() && plain.back() != ' ')) {
      plain += blank ? ' ' : static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
  }
  const auto replaceAll = [&plain](const std::string& from, const std::string& to) {
    for (std::size_t at = plain.find(from); at != std::string::npos; at = plain.find(from, at + to.size())) {
      plain.replace(at, from.size(), to);
    }
  };
  replaceAll(" " + schema + ".", " ");
  replaceAll("update or delete", "delete or update");
  return plain;
}

/// Tables of other schemas that some account would read instead of the record's: in a schema of its own name,
/// or one that precedes on its search path.
Parts tablesReadInstead(Connection& connection) {
  return partsFrom(
      connection, "table that is read instead ",
      "SELECT n.nspname || '.' || c.relname FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace"
      " JOIN pg_class own ON own.relname = c.relname AND own.relkind IN ('r', 'p')"
      " AND own.relnamespace = current_schema()::regnamespace"
      " WHERE c.relnamespace <> own.relnamespace AND c.relkind IN ('r', 'p', 'v', 'm', 'f') AND ("
      "EXISTS (SELECT 1 FROM pg_roles r WHERE r.rolname = n.nspname AND NOT r.rolsuper"
      " AND has_schema_privilege(r.oid, own.relnamespace, 'USAGE'))"
      " OR EXISTS (SELECT 1 FROM pg_db_role_setting s CROSS JOIN LATERAL unnest(s.setconfig) AS one"
      " CROSS JOIN LATERAL string_to_array(translate(substr(one, 13), '\" ', ''), ',') AS path"
      " WHERE one LIKE 'search\\_path=%' AND s.setdatabase IN (0, (SELECT d.oid FROM pg_database d"
      " WHERE d.datname = current_database())) AND array_position(path, n.nspname::text)"
      " < array_position(path, current_schema()::text)))");
}

/// Triggers with their actions and whether they fire in every session, the bodies of their functions, and
/// anything that would bypass them.
Parts postgresqlParts(Connection& connection) {
  Statement name = connection.prepare("SELECT quote_ident(current_schema())");
  name.execute();
  const std::string schema = name.step() ? name.text(0) : std::string();
  Parts parts;
  Statement trigger = connection.prepare(
      "SELECT g.tgname, g.tgenabled = 'O', pg_get_triggerdef(g.oid)"
      " FROM pg_trigger g JOIN pg_class t ON t.oid = g.tgrelid"
      " WHERE t.relnamespace = current_schema()::regnamespace AND NOT g.tgisinternal");
  trigger.execute();
  while (trigger.step()) {
    parts["trigger " + trigger.text(0)] +=
        (trigger.boolean(1) ? "on " : "off ") + plainTrigger(trigger.text(2), schema);
  }
  parts.merge(partsFrom(connection, "rule ",
                        "SELECT tablename || ' ' || rulename, definition FROM pg_rules"
                        " WHERE schemaname = current_schema()"));
  parts.merge(partsFrom(connection, "setting that switches triggers off ",
                        "SELECT coalesce(r.rolname, 'all') FROM pg_db_role_setting s"
                        " LEFT JOIN pg_roles r ON r.oid = s.setrole"
                        " WHERE array_to_string(s.setconfig, ' ') LIKE '%session\\_replication\\_role%'"));
  parts.merge(partsFrom(connection, "setting that says who asks ",
                        "SELECT coalesce(r.rolname, 'all') FROM pg_db_role_setting s"
                        " LEFT JOIN pg_roles r ON r.oid = s.setrole"
                        " WHERE array_to_string(s.setconfig, ' ') LIKE '%torsio.%'"));
  parts.merge(tablesReadInstead(connection));
  parts.merge(
      partsFrom(connection, "row policies of ",
                "SELECT t.relname::text, CASE WHEN t.relrowsecurity THEN 'on' ELSE 'off' END ||"
                " coalesce((SELECT string_agg(' ' || p.polname || CASE WHEN p.polpermissive THEN ''"
                " ELSE ' restrictive' END, '' ORDER BY p.polname) FROM pg_policy p"
                " WHERE p.polrelid = t.oid), '') FROM pg_class t"
                " WHERE t.relnamespace = current_schema()::regnamespace AND t.relkind = 'r' AND"
                " (t.relrowsecurity OR EXISTS (SELECT 1 FROM pg_policy p WHERE p.polrelid = t.oid))"));
  Statement function = connection.prepare(
      "SELECT p.proname, p.prosrc FROM pg_proc p WHERE p.pronamespace = current_schema()::regnamespace");
  function.execute();
  while (function.step()) {
    parts["function " + function.text(0)] += function.text(1);
  }
  parts.merge(outlineOfPostgresql(connection));
  return parts;
}

Parts expectedOnPostgresql(Connection& fresh) {
  Parts parts = outlineOfSqlite(fresh);
  for (const Migration& step : embeddedMigrations()) {
    for (const std::string& sql : statementsFor(Engine::kPostgresql, step.sql, step.name)) {
      std::istringstream words(sql);
      std::string create;
      std::string kind;
      std::string name;
      words >> create >> kind >> name;
      if (kind == "TRIGGER") {
        parts["trigger " + name] = "on " + plainTrigger(sql, "");
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
                                          const std::map<std::string, std::string>& serverParts) {
  const bool sqlite = connection.engine() == Engine::kSqlite;
  const SchemaState state = checkSchema(connection, embeddedMigrations());
  if (state.version > state.known) {
    return {{"step " + std::to_string(state.version),
             "is not known to this program, so the schema was not compared: check with the newest program"}};
  }
  if (state.version != state.known) {
    return {};
  }
  Connection fresh = freshRecord();
  Parts expected = sqlite ? sqliteParts(fresh) : expectedOnPostgresql(fresh);
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
  bool prepared = false;
  for (const auto& [part, made] : found) {
    const auto server = serverParts.find(part);
    if (server != serverParts.end()) {
      prepared = true;
      if (server->second != made) {
        findings.push_back({part, "was changed, or is of another version: prepare the server again"});
      }
    } else if (!expected.contains(part)) {
      findings.push_back({part, "does not belong to the record: somebody added it"});
    }
  }
  for (const auto& [part, made] : serverParts) {
    if (prepared && !found.contains(part)) {
      findings.push_back({part, "is missing: prepare the server again"});
    }
  }
  return findings;
}

}  // namespace torsio
