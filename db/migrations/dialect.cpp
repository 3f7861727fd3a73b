// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/migrations/dialect.h"

#include <sstream>

#include "sim/core/error.h"

namespace torsio {

namespace {

using Statements = std::vector<std::string>;

std::vector<std::string> wordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) {
    words.push_back(word);
  }
  return words;
}

[[noreturn]] void bad(const Text& what, const std::string& where) {
  refuse(what, where, Text::tr("Correct the migration file"));
}

Statements appendOnlySupport(Engine engine) {
  if (engine == Engine::kSqlite) {
    return {};
  }
  // SQLSTATE TR001 is ours; db/connection/db_error.cpp maps it.
  return {
      "CREATE FUNCTION refuse_change() RETURNS trigger LANGUAGE plpgsql AS $$\n"
      "BEGIN\n"
      "  IF TG_OP <> 'TRUNCATE' AND EXISTS (SELECT 1 FROM erasure_gate) THEN\n"
      "    IF TG_OP = 'DELETE' THEN RETURN OLD; END IF;\n"
      "    RETURN NEW;\n"
      "  END IF;\n"
      "  RAISE EXCEPTION 'append-only: %', TG_TABLE_NAME USING ERRCODE = 'TR001';\n"
      "END $$",
      "CREATE FUNCTION refuse_thaw() RETURNS trigger LANGUAGE plpgsql AS $$\n"
      "BEGIN\n"
      "  RAISE EXCEPTION 'frozen: %', TG_TABLE_NAME USING ERRCODE = 'TR001';\n"
      "END $$"};
}

/// `gated`: changes are allowed while erasure_gate holds a row.
Statements appendOnly(Engine engine, const std::string& table, bool gated) {
  if (engine == Engine::kPostgresql) {
    const std::string function = gated ? "refuse_change()" : "refuse_thaw()";
    return {"CREATE TRIGGER " + table + "_append_only BEFORE UPDATE OR DELETE ON " + table +
                " FOR EACH ROW EXECUTE FUNCTION " + function,
            "CREATE TRIGGER " + table + "_no_truncate BEFORE TRUNCATE ON " + table +
                " FOR EACH STATEMENT EXECUTE FUNCTION " + function};
  }
  const std::string gate = gated ? " WHEN NOT EXISTS (SELECT 1 FROM erasure_gate)" : "";
  Statements triggers;
  for (const char* act : {"UPDATE", "DELETE"}) {
    triggers.push_back("CREATE TRIGGER " + table + "_no_" + act + " BEFORE " + act + " ON " + table + gate +
                       " BEGIN SELECT RAISE(ABORT, 'append-only: " + table + "'); END");
  }
  return triggers;
}

Statements frozen(Engine engine, const std::string& table, const std::string& column) {
  const std::string head =
      "CREATE TRIGGER " + table + "_" + column + "_frozen BEFORE UPDATE OF " + column + " ON " + table;
  const std::string when = "OLD." + column + " IS DISTINCT FROM NEW." + column;
  if (engine == Engine::kPostgresql) {
    return {head + " FOR EACH ROW WHEN (" + when + ") EXECUTE FUNCTION refuse_thaw()"};
  }
  return {head + " WHEN OLD." + column + " IS NOT NEW." + column +
          " BEGIN SELECT RAISE(ABORT, 'frozen: " + table + "'); END"};
}

Statements macro(Engine engine, const std::string& token, const std::string& where) {
  const std::vector<std::string> words = wordsOf(token);
  if (words.size() == 1 && words[0] == "append_only_support") {
    return appendOnlySupport(engine);
  }
  if (words.size() == 2 && words[0] == "append_only") {
    return appendOnly(engine, words[1], true);
  }
  if (words.size() == 2 && words[0] == "immutable") {
    return appendOnly(engine, words[1], false);
  }
  if (words.size() == 3 && words[0] == "frozen") {
    return frozen(engine, words[1], words[2]);
  }
  bad(Text::tr("unknown token {{%1}}", token), where);
}

std::string withTypes(Engine engine, std::string sql, const std::string& where) {
  const std::string token = "{{blob}}";
  const std::string type = engine == Engine::kSqlite ? "BLOB" : "BYTEA";
  for (std::size_t at = sql.find(token); at != std::string::npos; at = sql.find(token, at)) {
    sql.replace(at, token.size(), type);
  }
  if (sql.find("{{") != std::string::npos) {
    bad(Text::tr("unknown token in a statement"), where);
  }
  return sql;
}

}  // namespace

std::vector<std::string> appendOnlyTables(std::string_view migration) {
  std::vector<std::string> tables;
  std::istringstream in{std::string(migration)};
  for (std::string line; std::getline(in, line);) {
    for (const std::string_view token : {"{{append_only ", "{{immutable "}) {
      if (line.starts_with(token) && line.find("}}") != std::string::npos) {
        tables.push_back(line.substr(token.size(), line.find("}}") - token.size()));
      }
    }
  }
  return tables;
}

std::vector<std::string> statementsFor(Engine engine, std::string_view migration, const std::string& where) {
  std::istringstream in{std::string(migration)};
  Statements statements;
  std::string current;
  for (std::string line; std::getline(in, line);) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r')) {
      line.pop_back();
    }
    if (line.empty() || line.starts_with("--")) {
      continue;
    }
    if (current.empty() && line.starts_with("{{") && line.ends_with("}}")) {
      for (std::string& made : macro(engine, line.substr(2, line.size() - 4), where)) {
        statements.push_back(std::move(made));
      }
      continue;
    }
    current += (current.empty() ? "" : "\n") + line;
    if (line.back() != ';') {
      continue;
    }
    current.pop_back();
    statements.push_back(withTypes(engine, std::move(current), where));
    current.clear();
  }
  if (!current.empty()) {
    bad(Text::tr("a statement lacks its ;"), where);
  }
  return statements;
}

}  // namespace torsio
