// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/server_roles.h"

#include <algorithm>
#include <array>

#include "db/connection/row_reader.h"
#include "db/repository/people/person_data.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::string_view kRead = "SELECT";
constexpr std::string_view kAdd = "SELECT, INSERT";
constexpr std::string_view kChange = "SELECT, INSERT, UPDATE";
constexpr std::string_view kRemove = "SELECT, INSERT, DELETE";
constexpr std::string_view kAll = "SELECT, INSERT, UPDATE, DELETE";

/// Rights of the station role beyond inserting into append-only tables: drafts and states.
struct StationRight {
  std::string_view table;
  std::string_view rights;
};
constexpr std::array kStationRights{
    // Filled only by the owner or by functions with the owner's rights.
    StationRight{"erasure_gate", kRead},  // an open gate is a finding
    StationRight{"erasure", kRead},
    StationRight{"role", kRead},
    StationRight{"operation", kRead},
    StationRight{"role_operation", kRead},
    StationRight{"schema_migration", kRead},
    // Named once.
    StationRight{"rater_class", kAdd},
    StationRight{"occasion", kAdd},
    StationRight{"consent_purpose", kAdd},
    StationRight{"curriculum", kAdd},
    StationRight{"rubric", kAdd},
    // With a state; frozen columns stay frozen.
    StationRight{"centre", kAll},
    StationRight{"setting", kChange},
    StationRight{"person", kChange},
    StationRight{"person_identity", kChange},
    StationRight{"trainee", kAll},  // removed with the import that added it, unless referenced
    StationRight{"rater", kAll},
    StationRight{"roster_import", kChange},
    StationRight{"roster_import_person", kAdd},
    StationRight{"retention_rule", kAll},
    StationRight{"app_user", kChange},
    StationRight{"user_role", kRemove},
    StationRight{"sign_in_failure", kAll},
    StationRight{"kiosk_code", kChange},
    StationRight{"invitation", kChange},
    StationRight{"person_request", kChange},
    StationRight{"day_slot", kAll},
    StationRight{"cohort", kChange},
    StationRight{"training_group", kChange},
    StationRight{"enrolment", kChange},
    StationRight{"allocation_seed", kChange},
    StationRight{"live_call", kChange},
    StationRight{"station_state", kAll},
    StationRight{"learning_event", kAll},
    StationRight{"record_copy", kChange},
    StationRight{"seal_salt", kAll},
    StationRight{"curriculum_draft", kChange},
    StationRight{"mark_draft", kAll},
    StationRight{"mark_draft_row", kAll},
    StationRight{"draft_viewing", kAll},
    StationRight{"evaluation_draft", kAll},
    StationRight{"watch_account", kAll},
    StationRight{"paper_entry", kAll},
    StationRight{"paper_entry_row", kAll},
};

constexpr std::string_view kActor = "current_setting('torsio.actor', true)";

/// Operations that permit seeing all marks; one is enough.
constexpr std::string_view kSeesAllMarks =
    "SELECT EXISTS (SELECT 1 FROM app_user u JOIN user_role r ON r.user_id = u.id"
    " JOIN role_operation o ON o.role_code = r.role_code"
    " WHERE u.id = current_setting('torsio.actor', true) AND u.state = 'active' AND o.operation_code IN"
    " ('mark.view_coded', 'mark.release', 'results.compute', 'evaluation.setup', 'audit.view',"
    " 'database.restore'))";

/// Operations that permit adding other raters' marks: typing paper sheets, importing data sets.
constexpr std::string_view kAddsMarksOfOthers =
    "SELECT EXISTS (SELECT 1 FROM app_user u JOIN user_role r ON r.user_id = u.id"
    " JOIN role_operation o ON o.role_code = r.role_code"
    " WHERE u.id = current_setting('torsio.actor', true) AND u.state = 'active'"
    " AND o.operation_code = 'study.setup')";

constexpr std::string_view kActorPerson =
    "SELECT person_id FROM app_user WHERE id = current_setting('torsio.actor', true) AND state = 'active'";

/// A rater sees the others' marks once every assigned rater has submitted, to compare disagreements.
constexpr std::string_view kCaseIsCommitted =
    "SELECT EXISTS (SELECT 1 FROM assignment a WHERE a.enrolment_id = case_enrolment AND a.occasion ="
    " case_occasion AND a.rater_id = actor_person()) AND NOT EXISTS (SELECT 1 FROM assignment a WHERE"
    " a.enrolment_id = case_enrolment AND a.occasion = case_occasion"
    " AND NOT EXISTS (SELECT 1 FROM training_mark m WHERE m.assignment_id = a.id)"
    " AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal w WHERE w.assignment_id = a.id AND w.withdrawn"
    " AND NOT EXISTS (SELECT 1 FROM assignment_withdrawal v WHERE v.assignment_id = w.assignment_id"
    " AND v.sequence > w.sequence)))";

/// A trainee sees their own marks once released.
constexpr std::string_view kIsReleasedToActor =
    "SELECT coalesce((SELECT r.released FROM enrolment e JOIN mark_release r ON r.cohort_id = e.cohort_id"
    " WHERE e.id = case_enrolment AND e.trainee_id = actor_person() AND r.occasion = case_occasion"
    " ORDER BY r.sequence DESC LIMIT 1), FALSE)";

/// Replaces each `?` of an erase statement by the person's id.
std::string withPerson(std::string condition) {
  for (std::size_t at = condition.find('?'); at != std::string::npos; at = condition.find('?', at)) {
    condition.replace(at, 1, "erased_id");
  }
  return condition;
}

/// Body of the server function that does what erasePerson() does, for administrators permitted to erase.
std::string eraseBody() {
  std::string body =
      "\n#variable_conflict use_variable\nBEGIN\n"
      "  IF NOT EXISTS (SELECT 1 FROM app_user u JOIN user_role r ON r.user_id = u.id JOIN role_operation o"
      " ON o.role_code = r.role_code WHERE u.id = " +
      std::string(kActor) +
      " AND u.id = erased_by AND u.state = 'active' AND o.operation_code = 'person.erase') THEN\n"
      "    RAISE EXCEPTION 'nobody who may erase is signed in' USING ERRCODE = '42501';\n"
      "  END IF;\n"
      "  INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (erased_id, why, at_us);\n";
  for (const PersonRule& rule : kPersonRules) {
    if (rule.condition.empty() || rule.onErase == OnErase::kKeep) {
      continue;
    }
    const std::string table(rule.table);
    body += "  " +
            (rule.onErase == OnErase::kDelete ? "DELETE FROM " + table
                                              : "UPDATE " + table + " SET " + std::string(rule.cleared)) +
            " WHERE " + withPerson(std::string(rule.condition)) + ";\n";
  }
  return body +
         "  DELETE FROM erasure_gate WHERE id = erased_id;\n"
         "  INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us)"
         " VALUES (erased_id, erased_by, why, at_us);\n"
         "END ";
}

struct ServerFunction {
  std::string_view name;
  std::string_view arguments;  ///< in CREATE FUNCTION syntax
  std::string_view result;
  std::string_view language;
};
constexpr std::array kServerFunctions{
    ServerFunction{"sees_all_marks", "", "boolean", "sql STABLE"},
    ServerFunction{"adds_marks_of_others", "", "boolean", "sql STABLE"},
    ServerFunction{"actor_person", "", "text", "sql STABLE"},
    ServerFunction{"case_is_committed", "case_enrolment text, case_occasion text", "boolean", "sql STABLE"},
    ServerFunction{"is_released_to_actor", "case_enrolment text, case_occasion text", "boolean",
                   "sql STABLE"},
    ServerFunction{"erase_person", "erased_id text, erased_by text, why text, at_us bigint", "void",
                   "plpgsql"}};

/// Row policy of a table. A `SELECT` in parentheses is evaluated once per statement, not once per row.
struct RowPolicy {
  std::string_view table;
  std::string_view seen;     ///< rows that the current user may read
  std::string_view changed;  ///< rows that the current user may add, change or remove
};
constexpr std::string_view kSeesAll = "(SELECT sees_all_marks())";
constexpr std::string_view kAddsOthers = "(SELECT adds_marks_of_others())";
constexpr std::string_view kOfTheMark =
    "EXISTS (SELECT 1 FROM training_mark m WHERE m.id = mark_id AND (m.rater_id = (SELECT actor_person())"
    " OR m.demonstration OR (SELECT adds_marks_of_others())))";
constexpr std::string_view kOfTheSheet =
    "EXISTS (SELECT 1 FROM assignment a WHERE a.id = assignment_id AND a.rater_id = (SELECT actor_person()))";
constexpr std::array kRowPolicies{
    RowPolicy{"training_mark",
              "(SELECT sees_all_marks()) OR rater_id = (SELECT actor_person())"
              " OR case_is_committed(enrolment_id, occasion) OR is_released_to_actor(enrolment_id, occasion)",
              "rater_id = (SELECT actor_person()) OR demonstration OR (SELECT adds_marks_of_others())"},
    RowPolicy{"training_mark_row", "EXISTS (SELECT 1 FROM training_mark m WHERE m.id = mark_id)", kOfTheMark},
    RowPolicy{"mark_viewing", "EXISTS (SELECT 1 FROM training_mark m WHERE m.id = mark_id)", kOfTheMark},
    RowPolicy{"mark_draft",
              "(SELECT sees_all_marks()) OR EXISTS (SELECT 1 FROM assignment a WHERE a.id = assignment_id"
              " AND a.rater_id = (SELECT actor_person()))",
              kOfTheSheet},
    RowPolicy{"mark_draft_row",
              "EXISTS (SELECT 1 FROM mark_draft d WHERE d.assignment_id ="
              " mark_draft_row.assignment_id)",
              kOfTheSheet},
    RowPolicy{"draft_viewing", kOfTheSheet, kOfTheSheet},
    RowPolicy{"watch_account", "rater_id = (SELECT actor_person())", "rater_id = (SELECT actor_person())"},
    RowPolicy{"paper_entry", kAddsOthers, kAddsOthers},
    RowPolicy{"paper_entry_row", kAddsOthers, kAddsOthers},
    RowPolicy{"self_score", "(SELECT sees_all_marks()) OR trainee_id = (SELECT actor_person())",
              "trainee_id = (SELECT actor_person()) OR demonstration"},
    RowPolicy{"self_score_row", "EXISTS (SELECT 1 FROM self_score s WHERE s.id = self_score_id)",
              "EXISTS (SELECT 1 FROM self_score s WHERE s.id = self_score_id AND"
              " (s.trainee_id = (SELECT actor_person()) OR s.demonstration))"},
    RowPolicy{"rater_warmup", "(SELECT sees_all_marks()) OR rater_id = (SELECT actor_person())",
              "rater_id = (SELECT actor_person()) OR demonstration"},
    RowPolicy{"evaluation_mark", "(SELECT sees_all_marks()) OR rater_id = (SELECT actor_person())",
              "rater_id = (SELECT actor_person()) OR demonstration"},
    RowPolicy{"evaluation_draft", "rater_id = (SELECT actor_person())", "rater_id = (SELECT actor_person())"},
    // Means of marks.
    RowPolicy{"training_result", kSeesAll, kSeesAll},
    RowPolicy{"training_group_result", kSeesAll, kSeesAll},
    RowPolicy{"evaluation_result", kSeesAll, kSeesAll},
    RowPolicy{"composite_result", kSeesAll, kSeesAll},
};

bool plainRole(const std::string& role) {
  return !role.empty() && std::all_of(role.begin(), role.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

void requireRole(Connection& connection, const std::string& role) {
  if (connection.engine() != Engine::kPostgresql) {
    throw Error(ErrorCode::kUsage, Text::tr("an SQLite file has no roles of its own"), connection.location(),
                Text::tr("Name the address of a PostgreSQL server"));
  }
  const std::string owner = selectFirst(connection, "SELECT current_user::text", {}, readText).value_or("");
  if (plainRole(role) && role != owner) {
    return;
  }
  refuseParameter(
      Text::tr("this cannot be the role of the stations"), role,
      Text::tr("Use a name of lower-case letters, digits and underscores that is not the owner's"));
}

void makeFunctions(Connection& connection, const std::string& schema, const std::string& role) {
  const std::map<std::string, std::string> parts = serverParts();
  for (const ServerFunction& one : kServerFunctions) {
    const std::string name(one.name);
    connection.executeVerbatim("CREATE OR REPLACE FUNCTION " + name + "(" + std::string(one.arguments) +
                               ") RETURNS " + std::string(one.result) + " LANGUAGE " +
                               std::string(one.language) + " SECURITY DEFINER SET search_path = \"" + schema +
                               "\", pg_temp AS $$" + parts.at("function " + name) + "$$");
    connection.executeVerbatim("REVOKE ALL ON FUNCTION " + name + " FROM PUBLIC");
    connection.executeVerbatim("GRANT EXECUTE ON FUNCTION " + name + " TO " + role);
  }
}

void makePolicies(Connection& connection, const std::string& role) {
  for (const std::string& drop :
       selectAll(connection,
                 "SELECT format('DROP POLICY %I ON %I', policyname, tablename) FROM pg_policies"
                 " WHERE schemaname = current_schema() UNION ALL"
                 " SELECT format('ALTER TABLE %I DISABLE ROW LEVEL SECURITY', relname) FROM pg_class"
                 " WHERE relnamespace = current_schema()::text::regnamespace AND relrowsecurity",
                 {}, readText)) {
    connection.executeVerbatim(drop);
  }
  for (const RowPolicy& policy : kRowPolicies) {
    const std::string table(policy.table);
    const auto make = [&](const std::string& act, const std::string& clause) {
      const std::string name = "torsio_" + act;
      connection.executeVerbatim("CREATE POLICY " + name + " ON " + table + " FOR " + act + " TO " + role +
                                 " " + clause);
    };
    const std::string changed(policy.changed);
    make("SELECT", "USING (" + std::string(policy.seen) + ")");
    make("INSERT", "WITH CHECK (" + changed + ")");
    make("UPDATE", "USING (" + changed + ") WITH CHECK (" + changed + ")");
    make("DELETE", "USING (" + changed + ")");
    connection.executeVerbatim("ALTER TABLE " + table + " ENABLE ROW LEVEL SECURITY");
  }
}

}  // namespace

std::optional<std::string_view> declaredRightsOn(std::string_view table) {
  const auto* found = std::find_if(kStationRights.begin(), kStationRights.end(),
                                   [&](const StationRight& one) { return one.table == table; });
  return found == kStationRights.end() ? std::nullopt : std::optional(found->rights);
}

std::map<std::string, std::string> serverParts() {
  std::map<std::string, std::string> parts{{"function sees_all_marks", std::string(kSeesAllMarks)},
                                           {"function adds_marks_of_others", std::string(kAddsMarksOfOthers)},
                                           {"function actor_person", std::string(kActorPerson)},
                                           {"function case_is_committed", std::string(kCaseIsCommitted)},
                                           {"function is_released_to_actor", std::string(kIsReleasedToActor)},
                                           {"function erase_person", eraseBody()}};
  for (const RowPolicy& policy : kRowPolicies) {
    const std::string table(policy.table);
    parts["row policies of " + table] =
        '"' + table + R"(" "on torsio_delete torsio_insert torsio_select torsio_update")";
  }
  return parts;
}

void writeServerRoles(Connection& connection, std::span<const std::string> tables,
                      const std::set<std::string>& appendOnly, const std::string& role) {
  requireRole(connection, role);
  Transaction transaction(connection);
  waitForRightsOfDatabase(connection);
  connection.executeVerbatim("SET LOCAL client_min_messages = warning");  // no notices about missing objects
  const std::string schema =
      selectFirst(connection, "SELECT current_schema()::text", {}, readText).value_or("public");
  const std::string database =
      selectFirst(connection, "SELECT current_database()::text", {}, readText).value_or("");
  if (!selectFirst(connection, "SELECT 1 FROM pg_roles WHERE rolname = ?", {role}, readInt64)) {
    connection.executeVerbatim("CREATE ROLE " + role +
                               " LOGIN NOSUPERUSER NOCREATEDB NOCREATEROLE NOREPLICATION NOBYPASSRLS");
  }
  const std::string inSchema = " IN SCHEMA \"" + schema + "\" FROM ";
  for (const std::string& whom : {std::string("PUBLIC"), role}) {
    connection.executeVerbatim("REVOKE ALL ON ALL TABLES" + inSchema + whom);
    connection.executeVerbatim("REVOKE ALL ON SCHEMA \"" + schema + "\" FROM " + whom);
  }
  connection.executeVerbatim("GRANT CONNECT ON DATABASE \"" + database + "\" TO " + role);
  connection.executeVerbatim("GRANT USAGE ON SCHEMA \"" + schema + "\" TO " + role);
  for (const std::string& table : tables) {
    const std::optional<std::string_view> declared = declaredRightsOn(table);
    TORSIO_EXPECTS(declared || appendOnly.contains(table));
    connection.executeVerbatim("GRANT " + std::string(declared.value_or(kAdd)) + " ON " + table + " TO " +
                               role);
  }
  makeFunctions(connection, schema, role);
  makePolicies(connection, role);
  transaction.commit();
}

void waitForRightsOfDatabase(Connection& connection) {
  connection.executeVerbatim("SELECT pg_advisory_xact_lock(1414484562)");  // "TORR" in ASCII
}

bool isOwnerOfTables(Connection& connection) {
  return selectFirst(connection,
                     "SELECT count(*) FROM pg_tables WHERE schemaname = current_schema()"
                     " AND tablename = 'audit_entry' AND tableowner = current_user",
                     {}, readInt64)
             .value_or(0) > 0;
}

void requireEveryRow(Connection& connection) {
  if (connection.engine() != Engine::kPostgresql ||
      selectFirst(connection,
                  "SELECT count(*) FROM pg_class WHERE relnamespace = current_schema()::text::regnamespace"
                  " AND relrowsecurity AND row_security_active(oid)",
                  {}, readInt64)
              .value_or(0) == 0 ||
      selectFirst(connection, std::string(kSeesAllMarks), {}, readBoolean).value_or(false)) {
    return;
  }
  throw Error(ErrorCode::kPermission, Text::tr("this server account sees no marks while nobody is signed in"),
              connection.location(),
              Text::tr("Give the address with the account that owns the record, or do it at the window"));
}

void setCurrentUser(Connection& connection, const std::string& userId) {
  if (connection.engine() != Engine::kPostgresql) {
    return;
  }
  std::string quoted;
  for (const char c : userId) {
    quoted += c == '\'' ? std::string("''") : std::string(1, c);
  }
  connection.executeVerbatim("SELECT set_config('torsio.actor', '" + quoted + "', false)");
}

bool eraseOnServer(Connection& connection, const std::string& personId, const std::string& requestedBy,
                   const std::string& reason, std::int64_t utc_us) {
  if (connection.engine() != Engine::kPostgresql || isOwnerOfTables(connection)) {
    return false;
  }
  // Selects a row without columns: the function returns nothing.
  (void)selectFirst(connection, "SELECT count(*) FROM (SELECT erase_person(?, ?, ?, ?)) AS done",
                    {personId, requestedBy, reason, utc_us}, readInt64);
  return true;
}

}  // namespace torsio
