// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/server_roles.h"

#include <algorithm>
#include <array>

#include "db/connection/row_reader.h"
#include "db/repository/people/person_data.h"
#include "db/repository/people/server_functions.h"
#include "db/repository/people/stored_password.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::string_view kRead = "SELECT";
constexpr std::string_view kAdd = "SELECT, INSERT";
constexpr std::string_view kChange = "SELECT, INSERT, UPDATE";
constexpr std::string_view kRemove = "SELECT, INSERT, DELETE";
constexpr std::string_view kAll = "SELECT, INSERT, UPDATE, DELETE";
constexpr std::string_view kNothing;

/// Rights of the station role beyond inserting into append-only tables: drafts and states.
struct StationRight {
  std::string_view table;
  std::string_view rights;
};
constexpr std::array kStationRights{
    // Filled only by the owner or by functions with the owner's rights.
    StationRight{"server_session", kNothing},
    StationRight{"password_pepper", kNothing},
    StationRight{"erasure_gate", kRead},  // an open gate is a finding
    StationRight{"erasure", kRead},
    StationRight{"role", kRead},
    StationRight{"operation", kRead},
    StationRight{"role_operation", kRead},
    StationRight{"schema_migration", kRead},
    StationRight{"site", kRead},
    StationRight{"site_delivery", kRead},
    StationRight{"site_row", kRead},
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
    StationRight{"second_factor", kAll},
    StationRight{"second_factor_secret", kChange},
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

/// Row policy of a table. A `SELECT` in parentheses is evaluated once per statement, not once per row.
struct RowPolicy {
  std::string_view table;
  std::string_view seen;       ///< rows that the current user may read
  std::string_view added;      ///< rows that the current user may add
  std::string_view changed{};  ///< rows as the current user may change them; empty: as `added`
  std::string_view removed{};  ///< empty: as `changed`
  std::string_view whole{};    ///< the operation with which one sees every row; empty: see requireEveryRow()
};
constexpr std::string_view kOwnerAlone = "no operation";  // as RowPolicy::whole: no role has it
constexpr std::string_view kEverything = "TRUE";
constexpr std::string_view kKnown = "(SELECT is_known())";
constexpr std::string_view kSeesAll = "(SELECT sees_all_marks())";
constexpr std::string_view kAddsOthers = "(SELECT adds_marks_of_others())";
constexpr std::string_view kManagesUsers = "(SELECT session_may('user.manage'))";
constexpr std::string_view kOwnAccess =
    "(SELECT session_may('user.manage')) OR user_id IN ((SELECT session_user_id()), (SELECT "
    "invited_account()))";
constexpr std::string_view kOfTheMark =
    "EXISTS (SELECT 1 FROM training_mark m WHERE m.id = mark_id AND (m.rater_id = (SELECT actor_person())"
    " OR m.demonstration OR (SELECT adds_marks_of_others())))";
constexpr std::string_view kOfTheSheet =
    "EXISTS (SELECT 1 FROM assignment a WHERE a.id = assignment_id AND a.rater_id = (SELECT actor_person()))";
constexpr std::string_view kOwnRater = "rater_id = (SELECT actor_person())";
constexpr std::string_view kOwnOrSimulatedRater = "rater_id = (SELECT actor_person()) OR demonstration";
constexpr std::string_view kSeesAllOrOwnRater =
    "(SELECT sees_all_marks()) OR rater_id = (SELECT actor_person())";

/// Tables whose rows only some may see, or change.
constexpr std::array kRowPolicies{
    RowPolicy{
        .table = "training_mark",
        .seen = "(SELECT sees_all_marks()) OR rater_id = (SELECT actor_person())"
                " OR case_is_committed(enrolment_id, occasion)"
                " OR is_released_to_actor(enrolment_id, occasion)",
        .added = "rater_id = (SELECT actor_person()) OR demonstration OR (SELECT adds_marks_of_others())"},
    RowPolicy{.table = "training_mark_row",
              .seen = "EXISTS (SELECT 1 FROM training_mark m WHERE m.id = mark_id)",
              .added = kOfTheMark},
    RowPolicy{.table = "mark_viewing",
              .seen = "EXISTS (SELECT 1 FROM training_mark m WHERE m.id = mark_id)",
              .added = kOfTheMark},
    RowPolicy{.table = "mark_draft",
              .seen = "(SELECT sees_all_marks()) OR EXISTS (SELECT 1 FROM assignment a"
                      " WHERE a.id = assignment_id AND a.rater_id = (SELECT actor_person()))",
              .added = kOfTheSheet},
    RowPolicy{.table = "mark_draft_row",
              .seen = "EXISTS (SELECT 1 FROM mark_draft d WHERE d.assignment_id ="
                      " mark_draft_row.assignment_id)",
              .added = kOfTheSheet},
    RowPolicy{.table = "draft_viewing", .seen = kOfTheSheet, .added = kOfTheSheet},
    RowPolicy{.table = "watch_account", .seen = kOwnRater, .added = kOwnRater},
    RowPolicy{.table = "paper_entry", .seen = kAddsOthers, .added = kAddsOthers},
    RowPolicy{.table = "paper_entry_row", .seen = kAddsOthers, .added = kAddsOthers},
    RowPolicy{.table = "self_score",
              .seen = "(SELECT sees_all_marks()) OR trainee_id = (SELECT actor_person())",
              .added = "trainee_id = (SELECT actor_person()) OR demonstration"},
    RowPolicy{.table = "self_score_row",
              .seen = "EXISTS (SELECT 1 FROM self_score s WHERE s.id = self_score_id)",
              .added = "EXISTS (SELECT 1 FROM self_score s WHERE s.id = self_score_id AND"
                       " (s.trainee_id = (SELECT actor_person()) OR s.demonstration))"},
    RowPolicy{.table = "rater_warmup", .seen = kSeesAllOrOwnRater, .added = kOwnOrSimulatedRater},
    RowPolicy{.table = "evaluation_mark", .seen = kSeesAllOrOwnRater, .added = kOwnOrSimulatedRater},
    RowPolicy{.table = "evaluation_draft", .seen = kOwnRater, .added = kOwnRater},
    // Means of marks.
    RowPolicy{.table = "training_result", .seen = kSeesAll, .added = kSeesAll},
    RowPolicy{.table = "training_group_result", .seen = kSeesAll, .added = kSeesAll},
    RowPolicy{.table = "evaluation_result", .seen = kSeesAll, .added = kSeesAll},
    RowPolicy{.table = "composite_result", .seen = kSeesAll, .added = kSeesAll},
    // Names.
    RowPolicy{.table = "person_identity",
              .seen = "(SELECT session_may('person.view_identity')) OR person_id = (SELECT actor_person())",
              .added = "(SELECT session_may('person.edit'))",
              .whole = "person.view_identity"},
    RowPolicy{.table = "roster_import_person",
              .seen = "(SELECT session_may('person.view_identity'))",
              .added = kKnown,
              .whole = "person.view_identity"},
    RowPolicy{.table = "seal_salt",
              .seen = "(SELECT is_known() OR invited_account() IS NOT NULL)",
              .added = kEverything},
    RowPolicy{.table = "record_copy", .seen = kEverything, .added = kEverything},
    // Groups, and the seed that draws them.
    RowPolicy{.table = "training_group",
              .seen = "(SELECT session_may('allocation.view')) OR is_own_group(id)",
              .added = kKnown,
              .whole = "allocation.view"},
    RowPolicy{.table = "enrolment",
              .seen = "(SELECT session_may('allocation.view')) OR is_own_case(id)"
                      " OR is_told_elsewhere(trainee_id)",
              .added = kKnown,
              .whole = "allocation.view"},
    RowPolicy{.table = "allocation",
              .seen = "(SELECT session_may('allocation.view')) OR is_own_case(enrolment_id)",
              .added = "demonstration OR (SELECT session_may('allocation.run'))",
              .whole = "allocation.view"},
    RowPolicy{.table = "allocation_seed",
              .seen = "revealed_utc_us IS NOT NULL OR may_read_seed(design_id)",
              .added = "is_simulated_design(design_id) OR ((SELECT session_may('allocation.run'))"
                       " AND revealed_utc_us IS NULL)",
              .changed = "may_open_seed(design_id)",
              .whole = kOwnerAlone},
    // Accounts, and what needs two people.
    RowPolicy{.table = "app_user",
              .seen = kEverything,
              .added = "may_add_account(person_id, password_hash, pin_hash, demonstration)",
              .changed = "may_change_account(id, login, person_id, password_hash, pin_hash, demonstration,"
                         " state)"},
    RowPolicy{.table = "user_role",
              .seen = kEverything,
              .added = "may_give_role(user_id, role_code)",
              .removed = "may_take_role(user_id, role_code)"},
    RowPolicy{.table = "second_factor",
              .seen = kOwnAccess,
              .added = "user_id = (SELECT session_user_id())",
              .removed = "may_drop_second_factor(user_id)",
              .whole = "user.manage"},
    RowPolicy{.table = "second_factor_secret",
              .seen = "user_id = (SELECT session_user_id())",
              .added = "user_id = (SELECT session_user_id())",
              .whole = kOwnerAlone},
    RowPolicy{.table = "kiosk_code", .seen = kManagesUsers, .added = kManagesUsers, .whole = "user.manage"},
    RowPolicy{.table = "invitation",
              .seen = kOwnAccess,
              .added = "may_invite(user_id)",
              .changed = "may_change_invitation(id, user_id, state)",
              .whole = "user.manage"},
    RowPolicy{.table = "duty_request",
              .seen = "requested_by = (SELECT session_user_id()) OR (SELECT session_may('user.manage'))"
                      " OR (SELECT session_may('allocation.view'))",
              .added = "may_request(act, subject, requested_by, requested_utc_us)",
              .whole = "allocation.view"},
    RowPolicy{.table = "duty_decision",
              .seen = kEverything,
              .added = "may_decide(request_id, decision, decided_by)"},
    RowPolicy{.table = "mark_release", .seen = kEverything, .added = "(SELECT session_may('mark.release'))"},
    RowPolicy{.table = "setting", .seen = kEverything, .added = "may_set(name, value)"},
    RowPolicy{
        .table = "frozen_dataset", .seen = kEverything, .added = "may_freeze(cohort_id, demonstration)"},
    RowPolicy{
        .table = "signature",
        .seen = kEverything,
        .added = "user_id = (SELECT session_user_id()) OR demonstration OR (SELECT adds_marks_of_others())"},
    RowPolicy{.table = "audit_entry", .seen = kEverything, .added = "may_write_as(actor)"},
};

/// Tables to which a station adds while nobody has signed in there: what its recordings bring with them, its
/// own state, and what goes with every change.
constexpr std::array<std::string_view, 9> kOpenToStations{
    "trial",         "trial_chunk",    "trial_end",       "trial_digest", "exposure",
    "station_state", "learning_event", "sign_in_failure", "row_seal"};

/// Functions of earlier versions.
constexpr std::array<std::string_view, 3> kFormerFunctions{"open_session_with_invitation", "end_sessions",
                                                           "may_set_rule"};

/// The policy of a table that the station role may change; null: it only reads the table.
std::optional<RowPolicy> policyOf(std::string_view table) {
  if (declaredRightsOn(table).value_or(kAdd).find("INSERT") == std::string_view::npos ||
      std::find(kOpenToStations.begin(), kOpenToStations.end(), table) != kOpenToStations.end()) {
    return std::nullopt;
  }
  const auto* found = std::find_if(kRowPolicies.begin(), kRowPolicies.end(),
                                   [&](const RowPolicy& one) { return one.table == table; });
  return found != kRowPolicies.end() ? *found
                                     : RowPolicy{.table = table, .seen = kEverything, .added = kKnown};
}

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

std::string bodyOf(const ServerFunction& function) {
  return function.body.empty() ? eraseBody() : std::string(function.body);
}

/// Removes what an earlier version made, too: it would stay open to stations. After dropPolicies().
void dropFunctions(Connection& connection) {
  std::set<std::string> names(kFormerFunctions.begin(), kFormerFunctions.end());
  for (const ServerFunction& one : serverFunctions()) {
    names.emplace(one.name);
  }
  for (const std::string& name : names) {
    for (const std::string& drop :
         selectAll(connection,
                   "SELECT format('DROP FUNCTION %s', oid::regprocedure) FROM pg_proc"
                   " WHERE pronamespace = current_schema()::text::regnamespace AND proname = ?",
                   {name}, readText)) {
      connection.executeVerbatim(drop);
    }
  }
}

void makeFunctions(Connection& connection, const std::string& schema, const std::string& role) {
  for (const ServerFunction& one : serverFunctions()) {
    const std::string name(one.name);
    connection.executeVerbatim("CREATE OR REPLACE FUNCTION " + name + "(" + std::string(one.arguments) +
                               ") RETURNS " + std::string(one.result) + " LANGUAGE " +
                               std::string(one.language) + " SECURITY DEFINER SET search_path = \"" + schema +
                               "\", pg_temp AS $$" + bodyOf(one) + "$$");
    connection.executeVerbatim("REVOKE ALL ON FUNCTION " + name + " FROM PUBLIC");
    if (one.ofStations) {
      connection.executeVerbatim("GRANT EXECUTE ON FUNCTION " + name + " TO " + role);
    }
  }
}

void dropPolicies(Connection& connection) {
  for (const std::string& drop :
       selectAll(connection,
                 "SELECT format('DROP POLICY %I ON %I', policyname, tablename) FROM pg_policies"
                 " WHERE schemaname = current_schema() UNION ALL"
                 " SELECT format('ALTER TABLE %I DISABLE ROW LEVEL SECURITY', relname) FROM pg_class"
                 " WHERE relnamespace = current_schema()::text::regnamespace AND relrowsecurity",
                 {}, readText)) {
    connection.executeVerbatim(drop);
  }
}

void makePolicies(Connection& connection, std::span<const std::string> tables, const std::string& role) {
  for (const std::string& table : tables) {
    const std::optional<RowPolicy> policy = policyOf(table);
    if (!policy) {
      continue;
    }
    const auto make = [&](const std::string& act, const std::string& clause) {
      const std::string name = "torsio_" + act;
      connection.executeVerbatim("CREATE POLICY " + name + " ON " + table + " FOR " + act + " TO " + role +
                                 " " + clause);
    };
    const std::string changed(policy->changed.empty() ? policy->added : policy->changed);
    const std::string removed(policy->removed.empty() ? changed : std::string(policy->removed));
    make("SELECT", "USING (" + std::string(policy->seen) + ")");
    make("INSERT", "WITH CHECK (" + std::string(policy->added) + ")");
    make("UPDATE", "USING (" + changed + ") WITH CHECK (" + changed + ")");
    make("DELETE", "USING (" + removed + ")");
    connection.executeVerbatim("ALTER TABLE " + table + " ENABLE ROW LEVEL SECURITY");
  }
}

/// Makes the pepper, and takes from stored passwords what words could be tried on.
void hidePasswords(Connection& connection) {
  connection.executeVerbatim(
      "INSERT INTO password_pepper SELECT 1, replace(gen_random_uuid()::text || gen_random_uuid()::text, '-',"
      " '') WHERE NOT EXISTS (SELECT 1 FROM password_pepper)");
  struct Stored {
    std::string id;
    std::string password;
    std::string pin;
  };
  for (const Stored& user :
       selectAll(connection, "SELECT id, password_hash, pin_hash FROM app_user", {}, [](RowReader& row) {
         return Stored{row.text(), row.text(), row.text()};
       })) {
    const std::string password = hiddenPassword(connection, user.password);
    const std::string pin = hiddenPassword(connection, user.pin);
    if (password != user.password || pin != user.pin) {
      connection.execute("UPDATE app_user SET password_hash = ?, pin_hash = ? WHERE id = ?",
                         {password, pin.empty() ? Value() : Value(pin), user.id});
    }
  }
}

}  // namespace

std::optional<std::string_view> declaredRightsOn(std::string_view table) {
  const auto* found = std::find_if(kStationRights.begin(), kStationRights.end(),
                                   [&](const StationRight& one) { return one.table == table; });
  return found == kStationRights.end() ? std::nullopt : std::optional(found->rights);
}

std::map<std::string, std::string> serverParts() {
  std::map<std::string, std::string> parts;
  for (const ServerFunction& function : serverFunctions()) {
    parts["function " + std::string(function.name)] = bodyOf(function);
  }
  for (const PersonRule& rule : kPersonRules) {  // every table has one
    const std::string table(rule.table);
    if (policyOf(table)) {
      parts["row policies of " + table] =
          '"' + table + R"(" "on torsio_delete torsio_insert torsio_select torsio_update")";
    }
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
    if (declared != kNothing) {
      connection.executeVerbatim("GRANT " + std::string(declared.value_or(kAdd)) + " ON " + table + " TO " +
                                 role);
    }
  }
  dropPolicies(connection);
  dropFunctions(connection);
  makeFunctions(connection, schema, role);
  makePolicies(connection, tables, role);
  hidePasswords(connection);
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
      selectFirst(connection, "SELECT sees_all_marks()", {}, readBoolean).value_or(false)) {
    return;
  }
  throw Error(ErrorCode::kPermission, Text::tr("this server account sees no marks while nobody is signed in"),
              connection.location(),
              Text::tr("Give the address with the account that owns the record, or do it at the window"));
}

std::set<std::string> tablesSeenInPart(Connection& connection) {
  std::set<std::string> tables;
  if (connection.engine() != Engine::kPostgresql || !isPrepared(connection) || isOwnerOfTables(connection)) {
    return tables;
  }
  for (const RowPolicy& policy : kRowPolicies) {
    if (!policy.whole.empty() &&
        !selectFirst(connection, "SELECT session_may(?)", {std::string(policy.whole)}, readBoolean)
             .value_or(false)) {
      tables.insert(std::string(policy.table));
    }
  }
  return tables;
}

void tellSession(Connection& connection, const std::string& token) {
  if (connection.engine() != Engine::kPostgresql) {
    return;
  }
  const bool plain = std::all_of(token.begin(), token.end(),
                                 [](char c) { return (c >= 'a' && c <= 'f') || (c >= '0' && c <= '9'); });
  TORSIO_EXPECTS(plain);
  connection.executeVerbatim("SELECT set_config('torsio.session', '" + token + "', false)");
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
