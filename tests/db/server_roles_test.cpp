// SPDX-License-Identifier: GPL-3.0-or-later
// Rights of the station role on a prepared server, tested with psql as anybody with the password could use
// it.
#include "db/repository/people/server_roles.h"

#include <cstdlib>
#include <filesystem>
#include <future>
#include <optional>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "db/connection/locator.h"
#include "db/connection/row_reader.h"
#include "db/migrations/dialect.h"
#include "db/migrations/migrations.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/person_data.h"
#include "db/repository/people/second_factor_repository.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/people/stored_password.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/demonstration_data.h"
#include "db/repository/system/schema_tables.h"
#include "sim/core/file_io.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStationPassword = "the word of the stations";
constexpr const char* kPassword = "seven kites above the bay";
constexpr const char* kNow = "SELECT (extract(epoch FROM clock_timestamp()) * 1000000)::bigint";

std::vector<std::string> allTables(Connection& connection) {
  std::vector<std::string> tables{"schema_migration"};
  for (const SchemaTable& table : tablesInReferenceOrder(connection)) {
    tables.push_back(table.name);
  }
  return tables;
}

std::set<std::string> closedTables() {
  std::set<std::string> tables;
  for (const Migration& step : embeddedMigrations()) {
    for (const std::string& table : appendOnlyTables(step.sql)) {
      tables.insert(table);
    }
  }
  return tables;
}

std::string findingsIn(Connection& connection) {
  std::string text;
  for (const AuditFinding& finding : verifyAuditTrail(connection)) {
    text += std::to_string(finding.sequence) + " " + finding.objectKind + " " + finding.objectId + ": " +
            finding.what + "\n";
  }
  return text;
}

/// A record with two raters and a trainee who can sign in, on a server with roles.
class ServerRolesTest : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (!onPostgresql()) {
      GTEST_SKIP() << "an SQLite file has no roles";
    }
    if (IsSkipped()) {
      return;
    }
    owner_ = parseLocator(locator());
    role_ = "station_" + owner_.schema.substr(owner_.schema.size() - 8);
    connection_.emplace(openWithSchema());
    real_.emplace(*connection_, "real", false);
    writeServerRoles(*connection_, allTables(*connection_), closedTables(), role_);
    connection_->executeVerbatim("ALTER ROLE " + role_ + " PASSWORD '" + kStationPassword + "'");
    addUser("u-rater", "rater", "(SELECT rater_id FROM training_mark LIMIT 1)");
    addUser("u-other", "rater", "NULL");
    addUser("u-trainee", "trainee", "(SELECT trainee_id FROM enrolment LIMIT 1)");
    addUser("u-office", "administrator", "NULL");
    addUser("u-second", "administrator", "NULL");
    addUser("u-allocator", "allocator", "NULL");
  }
  void TearDown() override {
    if (connection_) {
      Transaction transaction(*connection_);
      waitForRightsOfDatabase(*connection_);
      connection_->executeVerbatim("DROP OWNED BY " + role_);
      connection_->executeVerbatim("DROP ROLE " + role_);
      transaction.commit();
      connection_.reset();
    }
    DatabaseTest::TearDown();
  }

  void addUser(const std::string& id, const std::string& role, const std::string& person) {
    connection_->execute(
        "INSERT INTO app_user (id, login, person_id, password_hash, must_change_password, state,"
        " failed_count, locked_until_utc_us, created_utc_us, demonstration) VALUES (?, ?, " +
            person + ", '', FALSE, 'active', 0, 0, 0, FALSE)",
        {id, id});
    connection_->execute("INSERT INTO user_role (user_id, role_code) VALUES (?, ?)", {id, role});
  }
  [[nodiscard]] std::string stationLocator() const {
    Locator station = owner_;
    station.user = role_;
    station.password = kStationPassword;
    return addressOf(station);
  }
  /// Output of psql for these commands as the station role, or its error message.
  [[nodiscard]] std::string psql(const std::string& sql) const {
    const std::string out = (folder_.path() / "out").string();
    const std::string command =
        "PGPASSWORD='" + std::string(kStationPassword) + "' psql -X -q -A -t -v ON_ERROR_STOP=1 -h " +
        owner_.host + " -p " + std::to_string(owner_.port) + " -U " + role_ + " -d " + owner_.database +
        " -c \"SET search_path TO " + owner_.schema + "\" -c \"" + sql + "\" > " + out + " 2>&1";
    (void)!std::system(command.c_str());
    std::string text = readFile(out);
    while (!text.empty() && text.back() == '\n') {
      text.pop_back();
    }
    return text;
  }
  struct Act {
    std::string sql;
    bool allowed;
  };
  /// Output of psql for each act, in one session.
  [[nodiscard]] std::vector<std::string> answersTo(const std::vector<Act>& acts) const {
    std::string script = "SET search_path TO " + owner_.schema + ";\n";
    for (const Act& act : acts) {
      script += "\\echo ==\n" + act.sql + ";\n";
    }
    const fs::path file = folder_.path() / "script.sql";
    writeFileAtomically(file, script);
    const std::string out = (folder_.path() / "out").string();
    const std::string command = "PGPASSWORD='" + std::string(kStationPassword) + "' psql -X -q -A -t -h " +
                                owner_.host + " -p " + std::to_string(owner_.port) + " -U " + role_ + " -d " +
                                owner_.database + " -f " + file.string() + " > " + out + " 2>&1";
    (void)!std::system(command.c_str());
    std::vector<std::string> answers;
    std::istringstream lines(readFile(out));
    for (std::string line; std::getline(lines, line);) {
      if (line == "==") {
        answers.emplace_back();
      } else if (!answers.empty()) {
        answers.back() += line + "\n";
      }
    }
    return answers;
  }
  /// Token of a session as a sign-in gives it; empty for users that do not exist.
  [[nodiscard]] std::string tokenOf(const std::string& user) const {
    return selectFirst(*connection_, "SELECT new_session(id, FALSE) FROM app_user WHERE id = ?", {user},
                       readText)
        .value_or("");
  }
  /// Output of psql for these commands as the station role, in a session of this user.
  [[nodiscard]] std::string as(const std::string& user, const std::string& sql) const {
    const std::string answer =
        psql("SELECT set_config('torsio.session', '" + tokenOf(user) + "', false); " + sql);
    return answer.substr(std::min(answer.find('\n'), answer.size() - 1) + 1);
  }

  /// SQL that adds the next version of the rater's mark.
  [[nodiscard]] std::string amendedMark() const {
    return selectFirst(
               *connection_,
               "SELECT format('INSERT INTO training_mark (id, enrolment_id, rater_id, occasion, version,"
               " trial_id, score_steps, scale_lo_steps, scale_hi_steps, steps_per_point, amend_reason,"
               " submitted_utc_us, demonstration, assignment_id) VALUES (''amended'', %L, %L, %L, %L,"
               " %L, %L, %L, %L, %L, ''why'', %L, %L, %L)', enrolment_id, rater_id, occasion,"
               " version + 1, trial_id, score_steps, scale_lo_steps, scale_hi_steps, steps_per_point,"
               " submitted_utc_us, demonstration, assignment_id) FROM training_mark",
               {}, readText)
        .value_or("");
  }

  /// Id of a request by this user.
  [[nodiscard]] std::string requestOf(const std::string& user, const std::string& act,
                                      const std::string& subject, const std::string& detail = "{}") const {
    const std::string id = "request-" + act + "-" + user;
    Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
    tellSession(station, tokenOf(user));
    station.execute(
        "INSERT INTO duty_request (id, act, subject, detail_json, reason, requested_by,"
        " requested_utc_us) VALUES (?, ?, ?, ?, ?, ?, ?)",
        {id, act, subject, detail, "why", user, numberFrom(station, kNow)});
    return id;
  }
  [[nodiscard]] static std::string decisionOn(const std::string& request, const std::string& user) {
    return "INSERT INTO duty_decision (request_id, decision, decided_by, decided_utc_us) VALUES ('" +
           request + "', 'confirmed', '" + user + "', 2)";
  }

  static constexpr const char* kSeeds = "SELECT count(*) FROM allocation_seed";
  void sealSeeds() {
    connection_->executeVerbatim("ALTER TABLE allocation_seed DISABLE TRIGGER ALL");
    connection_->executeVerbatim("UPDATE allocation_seed SET revealed_utc_us = NULL");
    connection_->executeVerbatim("ALTER TABLE allocation_seed ENABLE TRIGGER ALL");
    ASSERT_GT(numberFrom(*connection_, kSeeds), 0);
  }

  void expectRefused(const std::string& act) const {
    const std::string answer = as("u-office", act);
    EXPECT_TRUE(answer.find("permission denied") != std::string::npos ||
                answer.find("must be owner") != std::string::npos ||
                answer.find("must be superuser") != std::string::npos)
        << act << ": " << answer;
  }

  TemporaryFolder folder_;
  Locator owner_;
  std::string role_;
  mutable std::optional<Connection> connection_;
  std::optional<FullRecord> real_;
};

// A station that was updated before its server changes nothing and says who has to do what; one that is
// behind names the version that it needs.
TEST_F(ServerRolesTest, AStationAheadOfOrBehindItsServerSaysWhatToUpdate) {
  Connection station = openDatabase(stationLocator(), OpenMode::kReadWrite);
  std::vector<Migration> steps = embeddedMigrations();
  const std::int64_t next = steps.back().version + 1;
  steps.push_back(parseMigration("000" + std::to_string(next) + "_next",
                                 "-- description: next\n-- compatible_from: 1\n"
                                 "CREATE TABLE a_next (x BIGINT PRIMARY KEY);\n"));

  const Refusal ahead = refusalFrom([&] { migrate(station, steps, {.softwareVersion = "9.1.0"}); });

  EXPECT_EQ(ahead.code, ErrorCode::kPermission) << ahead.text;
  EXPECT_NE(ahead.text.find("torsio db prepare-server"), std::string::npos) << ahead.text;
  EXPECT_EQ(checkSchema(station, embeddedMigrations()).version, next - 1);

  migrate(*connection_, steps, {.softwareVersion = "9.1.0", .backup = false});
  const Refusal behind = refusalFrom([&] { (void)checkSchema(station, embeddedMigrations()); });

  EXPECT_EQ(behind.code, ErrorCode::kNewerSchema) << behind.text;
  EXPECT_NE(behind.text.find("to version 9.1.0"), std::string::npos) << behind.text;
}

TEST_F(ServerRolesTest, EveryMutableTableIsDeclaredAndNoAppendOnlyOneCanChange) {
  const std::set<std::string> closed = closedTables();
  ASSERT_TRUE(closed.contains("training_mark"));
  ASSERT_TRUE(closed.contains("audit_entry"));

  std::vector<Act> acts;
  for (const std::string& table : allTables(*connection_)) {
    const std::optional<std::string_view> declared = declaredRightsOn(table);
    ASSERT_TRUE(declared || closed.contains(table)) << table << " needs a line in server_roles.cpp";
    const std::string_view rights = declared.value_or("SELECT, INSERT");
    const bool mayRemove = rights.find("DELETE") != std::string_view::npos;
    const bool mayChange = rights.find("UPDATE") != std::string_view::npos;
    EXPECT_FALSE(closed.contains(table) && (mayRemove || mayChange)) << table;
    acts.push_back({"DELETE FROM " + table + " WHERE FALSE", mayRemove});
    acts.push_back({"TRUNCATE " + table, false});
    acts.push_back({"ALTER TABLE " + table + " DISABLE TRIGGER ALL", false});
  }
  const std::vector<std::string> answers = answersTo(acts);
  ASSERT_EQ(answers.size(), acts.size());
  for (std::size_t i = 0; i < acts.size(); ++i) {
    const bool refused = answers[i].find("permission denied") != std::string::npos ||
                         answers[i].find("must be owner") != std::string::npos;
    EXPECT_EQ(!refused, acts[i].allowed) << acts[i].sql << ": " << answers[i];
  }
}

TEST_F(ServerRolesTest, TheStationCannotRewriteForgeOrOpenTheGate) {
  for (const char* act :
       {"UPDATE training_mark SET score_steps = 1", "UPDATE audit_entry SET reason = ''",
        "DELETE FROM audit_entry", "DELETE FROM trial_chunk",
        "UPDATE role_operation SET role_code = 'trainee'",
        "INSERT INTO role_operation (role_code, operation_code) VALUES ('trainee', 'user.manage')",
        "INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES ('a', 'b', 1)",
        "INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us) VALUES ('a', 'b', 'c', 1)",
        "UPDATE schema_migration SET version = 2", "CREATE TABLE mine (id TEXT)",
        "DROP TRIGGER training_mark_append_only ON training_mark", "SET ROLE torsio"}) {
    expectRefused(act);
  }
}

TEST_F(ServerRolesTest, TheStationReachesOnlyItsTables) {
  for (const char* act :
       {"COPY training_mark TO PROGRAM 'cat'",
        "COPY training_mark TO '/tmp/stolen'",
        "COPY training_mark FROM PROGRAM 'cat'",
        "SELECT pg_read_file('/etc/passwd')",
        "SELECT lo_import('/etc/passwd')",
        "SELECT pg_ls_dir('.')",
        "SELECT passwd FROM pg_shadow",
        "CREATE FUNCTION mine() RETURNS int LANGUAGE sql AS 'SELECT 1'",
        "CREATE EXTENSION dblink",
        "CREATE TRIGGER mine BEFORE INSERT ON training_mark FOR EACH ROW"
        " EXECUTE FUNCTION suppress_redundant_updates_trigger()",
        "CREATE RULE mine AS ON INSERT TO training_mark DO INSTEAD NOTHING",
        "ALTER TABLE training_mark DISABLE ROW LEVEL SECURITY",
        "DROP POLICY torsio_select ON training_mark",
        "CREATE OR REPLACE FUNCTION sees_all_marks() RETURNS boolean LANGUAGE sql AS 'SELECT TRUE'",
        "SET session_replication_role = replica",
        "SET SESSION AUTHORIZATION torsio",
        "ALTER ROLE CURRENT_USER SUPERUSER",
        "CREATE ROLE mine",
        "BEGIN; LOCK TABLE audit_entry",
        "CREATE SCHEMA mine"}) {
    expectRefused(act);
  }
  // A temporary table named like a table of the record must not be used by the owner's functions.
  EXPECT_EQ(psql("CREATE TEMP TABLE app_user AS SELECT 'x'::text AS id, 'active'::text AS state,"
                 " (SELECT rater_id FROM assignment LIMIT 1) AS person_id;"
                 " CREATE TEMP TABLE server_session AS SELECT 'x'::text AS user_id, FALSE AS practice,"
                 " encode(sha256('y'), 'hex') AS token_hash, 9000000000000000 AS until_utc_us;"
                 " SELECT set_config('torsio.session', 'y', false); SELECT count(*) FROM training_mark")
                .substr(2),
            "0");
}

TEST_F(ServerRolesTest, RowsThatAStationInsertsByHandAreDetected) {
  ASSERT_EQ(findingsIn(*connection_), "");
  const std::string entry =
      as("u-office",
         "INSERT INTO audit_entry SELECT sequence + 1, at_utc_us, 'u-office', station, action, object_kind,"
         " object_id, old_json, new_json, 'forged', object_hash, previous_hash, entry_hash FROM audit_entry"
         " ORDER BY sequence DESC LIMIT 1");
  EXPECT_EQ(entry.find("ERROR"), std::string::npos) << entry;
  EXPECT_NE(findingsIn(*connection_), "");
}

TEST_F(ServerRolesTest, MarksAreVisibleOnlyToThoseConcerned) {
  const std::string marks = "SELECT count(*) FROM training_mark";
  const std::string rows = "SELECT count(*) FROM training_mark_row";
  ASSERT_EQ(numberFrom(*connection_, marks), 1);

  EXPECT_EQ(psql(marks), "0");  // no current user
  EXPECT_EQ(psql(rows), "0");
  EXPECT_EQ(as("u-rater", marks), "1");
  EXPECT_EQ(as("u-rater", rows), std::to_string(numberFrom(*connection_, rows)));
  EXPECT_EQ(as("u-other", marks), "0");
  EXPECT_EQ(as("u-other", rows), "0");
  EXPECT_EQ(as("u-office", marks), "1");
  EXPECT_EQ(as("u-trainee", "SELECT count(*) FROM evaluation_mark"), "0");
  EXPECT_EQ(as("u-other", "SELECT count(*) FROM mark_draft"), "0");

  connection_->executeVerbatim(
      "INSERT INTO mark_release SELECT e.cohort_id, m.occasion, 1000, FALSE, 'no', 'a', 1"
      " FROM training_mark m JOIN enrolment e ON e.id = m.enrolment_id");
  EXPECT_EQ(as("u-trainee", marks), "0");
  connection_->executeVerbatim(
      "INSERT INTO mark_release SELECT e.cohort_id, m.occasion, 1001, TRUE, 'yes', 'a', 1"
      " FROM training_mark m JOIN enrolment e ON e.id = m.enrolment_id");
  EXPECT_EQ(as("u-trainee", marks), "1");
  const std::string forged = as("u-other", amendedMark());
  EXPECT_NE(forged.find("row-level security"), std::string::npos) << forged;
  EXPECT_NE(as("u-trainee", amendedMark()).find("row-level security"), std::string::npos);
  EXPECT_EQ(numberFrom(*connection_, marks), 1);
  EXPECT_EQ(as("u-rater", amendedMark()).find("ERROR"), std::string::npos);
  EXPECT_EQ(numberFrom(*connection_, marks), 2);
}

TEST_F(ServerRolesTest, EveryTableWithMarksOrMeansIsRestricted) {
  const std::set<std::string> open{"rubric_anchor"};  // explains marks, contains none
  std::vector<std::string> tables;
  std::string counts;
  for (const std::string& table :
       selectAll(*connection_,
                 "SELECT DISTINCT table_name::text FROM information_schema.columns"
                 " WHERE table_schema = current_schema() AND column_name IN ('score_steps', 'overall_steps',"
                 " 'mean', 'weighted_mean', 'composite', 'panel_offset_steps') ORDER BY 1",
                 {}, readText)) {
    if (!open.contains(table)) {
      tables.push_back(table);
      counts += "SELECT '" + table + " ' || count(*) FROM " + table + "; ";
    }
  }
  ASSERT_GT(tables.size(), 12U);

  std::string none;
  for (const std::string& table : tables) {
    none += (none.empty() ? "" : "\n") + table + " 0";
    EXPECT_GT(numberFrom(*connection_, "SELECT count(*) FROM " + table), 0) << table;
  }
  EXPECT_EQ(as("nobody", counts), none);
  EXPECT_EQ(as("u-other", counts), none);
  const std::string own = as("u-trainee", counts);
  EXPECT_NE(own.find("self_score 1"), std::string::npos) << own;
  EXPECT_NE(own.find("training_result 0"), std::string::npos) << own;
  EXPECT_NE(own.find("paper_entry 0"), std::string::npos) << own;
  EXPECT_NE(own.find("rater_warmup 0"), std::string::npos) << own;
  EXPECT_NE(as("u-rater", counts).find("rater_warmup 1"), std::string::npos);
  const std::string office = as("u-office", counts);
  for (const std::string& table : tables) {  // a draft belongs to its author
    EXPECT_EQ(office.find(table + " 0") != std::string::npos, table == "evaluation_draft") << office;
  }
}

TEST_F(ServerRolesTest, WhoTypesPaperSheetsAddsMarksOfAllRaters) {
  const std::string rows =
      "INSERT INTO training_mark_row SELECT 'amended', revision_id, row_code, score_steps,"
      " not_assessable_reason FROM training_mark_row";

  EXPECT_EQ(as("u-office", amendedMark() + "; " + rows).find("ERROR"), std::string::npos);

  EXPECT_EQ(numberFrom(*connection_, "SELECT count(*) FROM training_mark"), 2);
  EXPECT_GT(numberFrom(*connection_, "SELECT count(*) FROM training_mark_row WHERE mark_id = 'amended'"), 0);
}

TEST_F(ServerRolesTest, HiddenMarksAreNotReportedAsMissing) {
  Connection station = openRecord(stationLocator(), OpenMode::kReadOnly);
  for (const char* user : {"", "u-other", "u-trainee"}) {
    tellSession(station, tokenOf(user));
    EXPECT_EQ(refusalFrom([&] { (void)verifyAuditTrail(station); }).code, ErrorCode::kPermission) << user;
  }
  tellSession(station, tokenOf("u-office"));
  EXPECT_EQ(findingsIn(station), "");
}

TEST_F(ServerRolesTest, TheProgramWorksAsTheStationAndKeepsTheTrail) {
  Connection station = openRecord(stationLocator(), OpenMode::kCreate, {.softwareVersion = "test"});
  EXPECT_FALSE(isOwnerOfTables(station));
  EXPECT_TRUE(isOwnerOfTables(*connection_));

  const NewAuditEntry entry{.atUtc_us = 1,
                            .actor = "u-office",
                            .station = {},
                            .action = AuditAction::kUserSignIn,
                            .objectKind = AuditObject::kAppUser};
  EXPECT_THROW(AuditRepository(station).append(entry), DbError);  // nobody has signed in
  tellSession(station, tokenOf("u-office"));
  AuditRepository(station).append(entry);

  EXPECT_EQ(findingsIn(station), "");
  EXPECT_TRUE(schemaFindings(*connection_, serverParts()).empty());
}

TEST_F(ServerRolesTest, ObjectsThatRedirectStationsAreFindingsAndPreparingRestoresThePolicies) {
  ASSERT_TRUE(schemaFindings(*connection_, serverParts()).empty());
  const auto finds = [this](const std::string& sql, const std::string& part) {
    const Transaction undone(*connection_);
    connection_->executeVerbatim(sql);
    const std::vector<SchemaFinding> findings = schemaFindings(*connection_, serverParts());
    ASSERT_EQ(findings.size(), 1U) << sql;
    EXPECT_EQ(findings[0].part, part);
  };
  const std::string hides = "CREATE POLICY hides ON trial_digest FOR SELECT TO " + role_ + " USING (FALSE)";
  finds("CREATE SCHEMA " + role_ + "; CREATE TABLE " + role_ + ".trial_digest (id text)",
        "table that is read instead " + role_ + ".trial_digest");
  finds("CREATE SCHEMA " + role_ + "_first; CREATE VIEW " + role_ + "_first.setting AS SELECT 1;" +
            "ALTER ROLE " + role_ + " SET search_path = " + role_ + "_first, " + owner_.schema,
        "table that is read instead " + role_ + "_first.setting");
  finds("ALTER ROLE " + role_ + " SET torsio.actor = 'u-office'", "setting that says who asks " + role_);
  finds(hides, "row policies of trial_digest");
  finds("ALTER TABLE trial ENABLE ROW LEVEL SECURITY", "row policies of trial");
  finds("ALTER TABLE training_mark DISABLE ROW LEVEL SECURITY", "row policies of training_mark");
  finds("CREATE POLICY hides ON training_mark AS RESTRICTIVE FOR SELECT TO " + role_ + " USING (FALSE)",
        "row policies of training_mark");

  connection_->executeVerbatim(hides + "; ALTER TABLE trial_digest ENABLE ROW LEVEL SECURITY;" +
                               "ALTER TABLE self_score DISABLE ROW LEVEL SECURITY");
  EXPECT_EQ(schemaFindings(*connection_, serverParts()).size(), 2U);
  writeServerRoles(*connection_, allTables(*connection_), closedTables(), role_);
  EXPECT_TRUE(schemaFindings(*connection_, serverParts()).empty());
}

TEST_F(ServerRolesTest, ErasingNeedsTheRightAndASecondPerson) {
  Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
  const std::string person = real_->traineeId;
  const std::string erased = "SELECT count(*) FROM erasure WHERE person_id = '" + person + "'";
  const std::string erase = "SELECT erase_person('" + person + "', 'u-office', 'why', 5)";
  tellSession(station, tokenOf("u-rater"));
  EXPECT_THROW(erasePerson(station, person, "u-rater", "asked", 5), DbError);
  tellSession(station, tokenOf("u-office"));
  EXPECT_THROW(erasePerson(station, person, "u-office", "asked", 5), DbError);  // nobody else asked for it
  const std::string request = requestOf("u-second", "erase", person);
  // A request by others does not make an act; neither does one's own, or a decision in another's name.
  EXPECT_NE(as("u-office", erase).find("nobody else"), std::string::npos);
  EXPECT_NE(as("u-second", decisionOn(request, "u-second") + "; " + erase).find("row-level security"),
            std::string::npos);
  EXPECT_NE(as("u-office", decisionOn(request, "u-second")).find("row-level security"), std::string::npos);
  EXPECT_NE(psql("SELECT set_config('torsio.actor', 'u-office', false); " + erase).find("signed in"),
            std::string::npos);
  EXPECT_EQ(numberFrom(*connection_, erased), 0);

  Transaction transaction(station);
  DutyRepository(station).decide(request, DutyDecision::kConfirmed, "u-office", 5);
  erasePerson(station, person, "u-office", "asked", 5);
  transaction.commit();

  EXPECT_EQ(numberFrom(*connection_, erased), 1);
  EXPECT_EQ(
      numberFrom(*connection_, "SELECT count(*) FROM person_identity WHERE person_id = '" + person + "'"), 0);
  EXPECT_EQ(numberFrom(*connection_, "SELECT count(*) FROM erasure_gate"), 0);
  EXPECT_EQ(findingsIn(*connection_), "");
  EXPECT_EQ(findingsIn(station), "");
}

TEST_F(ServerRolesTest, ADecisionCountsInItsTransactionOnly) {
  const std::string person = real_->traineeId;
  const std::string request = requestOf("u-second", "erase", person);
  EXPECT_EQ(as("u-office", decisionOn(request, "u-office")).find("ERROR"), std::string::npos);

  const std::string answer = as("u-office", "SELECT erase_person('" + person + "', 'u-office', 'why', 5)");

  EXPECT_NE(answer.find("nobody else"), std::string::npos) << answer;
}

TEST_F(ServerRolesTest, WhatASettingByHandSaysIsWorthNothing) {
  for (const char* user : {"u-office", "u-rater", "u-allocator"}) {
    const std::string claims = "SELECT set_config('torsio.actor', '" + std::string(user) +
                               "', false), set_config('torsio.session', '" + user + "', false); ";
    EXPECT_EQ(psql(claims + "SELECT count(*) FROM training_mark").substr(std::string(user).size() * 2 + 2),
              "0");
    EXPECT_EQ(psql(claims + "SELECT count(*) FROM person_identity").substr(std::string(user).size() * 2 + 2),
              "0");
  }
  // A token counts where it was given, and a trainee's opens no marks by a release of their own.
  const std::string token = tokenOf("u-office");
  connection_->executeVerbatim("UPDATE server_session SET client = '203.0.113.7'");
  EXPECT_EQ(
      psql("SELECT set_config('torsio.session', '" + token + "', false); SELECT count(*) FROM training_mark")
          .substr(token.size() + 1),
      "0");
  EXPECT_NE(as("u-trainee",
               "INSERT INTO mark_release SELECT cohort_id, occasion, sequence + 1, TRUE, 'mine',"
               " 'u-trainee', 1 FROM mark_release LIMIT 1")
                .find("row-level security"),
            std::string::npos);
  EXPECT_NE(psql("SELECT * FROM server_session").find("permission denied"), std::string::npos);
  EXPECT_NE(psql("SELECT new_session('u-office', FALSE)").find("permission denied"), std::string::npos);
}

TEST_F(ServerRolesTest, ASessionComesFromAPasswordThatTheServerCompares) {
  AccessRepository owner(*connection_, PasswordCost::kTest);
  owner.setPassword("u-office", owner.sealPassword("u-office", kPassword), false);
  const std::string stored =
      selectFirst(*connection_, "SELECT password_hash FROM app_user WHERE id = 'u-office'", {}, readText)
          .value_or("");
  ASSERT_TRUE(isHiddenPassword(stored)) << stored;
  Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
  AccessRepository access(station, PasswordCost::kTest);

  EXPECT_EQ(access.signIn("u-office", "another long password", 0).outcome, SignIn::kWrong);
  const SignInResult result = access.signIn("u-office", kPassword, 0);

  ASSERT_EQ(result.outcome, SignIn::kOk);
  ASSERT_EQ(result.serverToken.size(), 64U);
  tellSession(station, result.serverToken);
  EXPECT_GT(numberFrom(station, "SELECT count(*) FROM training_mark"), 0);
  access.endOwnServerSession();
  EXPECT_EQ(numberFrom(station, "SELECT count(*) FROM training_mark"), 0);
  // What a station may read is worth nothing as a proof, and no words can be tried on it.
  EXPECT_EQ(psql("SELECT open_session('u-office', (SELECT password_hash FROM app_user WHERE id = "
                 "'u-office'), FALSE)"),
            "");
  EXPECT_NE(psql("SELECT pepper FROM password_pepper").find("permission denied"), std::string::npos);
  EXPECT_NE(psql("SELECT peppered('', '')").find("permission denied"), std::string::npos);
  const std::string hash = hashLike(stored, kPassword);
  EXPECT_NE(selectFirst(station, "SELECT sealed_secret(?)", {hash}, readText).value_or(stored), stored);
  // The owner, and a file that the record is moved to, compare it with the pepper.
  EXPECT_TRUE(passwordMatches(*connection_, stored, kPassword));
  EXPECT_FALSE(passwordMatches(*connection_, stored, "another long password"));
}

TEST_F(ServerRolesTest, ASealedSecretIsSeenByItsAccountAlone) {
  const std::string secret = newCodeSecret();
  AccessRepository owner(*connection_, PasswordCost::kTest);
  owner.setPassword("u-other", owner.sealPassword("u-other", kPassword), false);
  connection_->execute("DELETE FROM second_factor");
  const std::string seen = "SELECT count(*) FROM second_factor_secret";
  const std::string known = "SELECT count(*) FROM second_factor";
  const std::string dropped = "DELETE FROM second_factor WHERE user_id = 'u-other' RETURNING user_id";
  Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
  AccessRepository access(station, PasswordCost::kTest);
  const SignInResult entered = access.signIn("u-other", kPassword, kSampleTime_us);
  ASSERT_EQ(entered.outcome, SignIn::kOk);
  tellSession(station, entered.serverToken);
  SecondFactorRepository(station).add(
      "u-other", sealedCodeSecret(secret, kPassword, "u-other", PasswordCost::kTest), 0, {}, kSampleTime_us);
  access.endOwnServerSession();

  EXPECT_EQ(access.signIn("u-other", kPassword, kSampleTime_us).outcome, SignIn::kCodeNeeded);
  EXPECT_EQ(numberFrom(station, known), 0) << "no session is left";
  EXPECT_EQ(access.signIn("u-other", kPassword, kSampleTime_us, "", oneTimeCode(secret, 7)).outcome,
            SignIn::kCodeWrong);
  EXPECT_EQ(
      access.signIn("u-other", kPassword, kSampleTime_us, "", oneTimeCode(secret, codeStepAt(kSampleTime_us)))
          .outcome,
      SignIn::kOk);
  EXPECT_EQ(as("nobody", seen), "0");
  EXPECT_EQ(as("nobody", known), "0");
  EXPECT_EQ(as("u-rater", known), "0");
  EXPECT_EQ(as("u-office", seen), "0");
  EXPECT_EQ(as("u-office", known), "1");
  EXPECT_EQ(as("u-other", seen), "1");
  EXPECT_NE(as("u-office",
               "INSERT INTO second_factor (user_id, made_utc_us, last_step, recovery_codes)"
               " VALUES ('u-rater', 1, 0, '')")
                .find("row-level security"),
            std::string::npos);
  EXPECT_EQ(as("u-rater", dropped), "");
  EXPECT_EQ(as("u-office", dropped), "") << "not alone";
  const std::string request = requestOf("u-second", "reset_password", "u-other");
  EXPECT_EQ(as("u-office", decisionOn(request, "u-office") + "; " + dropped), "u-other");
  EXPECT_EQ(numberFrom(*connection_, seen), 0);
}

TEST_F(ServerRolesTest, PreparingHidesPasswordsThatWereStoredBefore) {
  const std::string hash = hashPassword(kPassword, PasswordCost::kTest);
  connection_->execute("UPDATE app_user SET password_hash = ?, pin_hash = ? WHERE id = 'u-rater'",
                       {hash, hash});
  writeServerRoles(*connection_, allTables(*connection_), closedTables(), role_);

  EXPECT_EQ(numberFrom(*connection_,
                       "SELECT count(*) FROM app_user WHERE password_hash LIKE '$argon2%'"
                       " OR pin_hash LIKE '$argon2%'"),
            0);
  Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
  EXPECT_EQ(AccessRepository(station, PasswordCost::kTest).signIn("u-rater", kPassword, 0).outcome,
            SignIn::kOk);
  const SignInResult practice =
      AccessRepository(station, PasswordCost::kTest).signInForPractice("u-rater", kPassword, 0);
  EXPECT_EQ(practice.outcome, SignIn::kOk);
  tellSession(station, practice.serverToken);  // a PIN opens no marks
  EXPECT_EQ(numberFrom(station, "SELECT count(*) FROM training_mark"), 0);
  EXPECT_EQ(findingsIn(*connection_), "");
}

TEST_F(ServerRolesTest, NobodyGivesThemselvesRightsOrPasswords) {
  const std::string hash = "server1$a$b$argon2id$v=19$m=8,t=1,p=1$AAAAAAAAAAAAAAAAAAAAAA";
  const std::string password = "UPDATE app_user SET password_hash = '" + hash + "' WHERE id = ";
  const std::string changed = " RETURNING id";
  const std::string role = "INSERT INTO user_role (user_id, role_code) VALUES ";
  const auto refused = [this](const std::string& user, const std::string& act) {
    const std::string answer = as(user, act);
    EXPECT_TRUE(answer.find("row-level security") != std::string::npos || answer.empty())
        << user << ": " << act << ": " << answer;
  };
  for (const char* user : {"", "u-other", "u-allocator", "u-office"}) {
    refused(user, password + "'u-rater'" + changed);
    refused(user, role + "('u-rater', 'allocator')");
    refused(user,
            "INSERT INTO invitation (id, user_id, token_hash, made_utc_us, expires_utc_us, state)"
            " VALUES ('i', 'u-rater', 'h', 1, 9000000000000000, 'open')");
    refused(user, "INSERT INTO setting (name, value, changed_utc_us) VALUES ('two_people', 'no', 1)");
  }
  refused("u-other", password + "'u-trainee'" + changed);
  refused("u-other",
          "INSERT INTO duty_request (id, act, subject, detail_json, reason, requested_by,"
          " requested_utc_us) VALUES ('d', 'erase', 'p', '{}', 'why', 'u-second', 1)");
  EXPECT_EQ(as("u-other", password + "'u-other'" + changed), "u-other");
  EXPECT_EQ(as("u-office", password + "'u-trainee'" + changed), "u-trainee");  // just a trainee

  // With another administrator's request, in one transaction; only the roles that were asked for.
  const std::string request = requestOf("u-second", "grant_roles", "u-other", R"({"roles": ["allocator"]})");
  refused("u-office", decisionOn(request, "u-office") + "; " + role + "('u-other', 'administrator')");
  EXPECT_EQ(as("u-office", decisionOn(request, "u-office") + "; " + role + "('u-other', 'allocator'); " +
                               password + "'u-other'")
                .find("ERROR"),
            std::string::npos);
  EXPECT_EQ(numberFrom(*connection_, "SELECT count(*) FROM user_role WHERE user_id = 'u-other'"), 2);
}

TEST_F(ServerRolesTest, WhatIsKeptOfALinkOrCardOpensNothing) {
  AccessRepository owner(*connection_, PasswordCost::kTest);
  const std::int64_t now_us = numberFrom(*connection_, kNow);
  owner.addInvitation("open", {"u-rater", now_us, now_us + 60'000'000}, "proof of the rater");
  owner.addInvitation("expired", {"u-other", 1, 2}, "proof of the other");
  owner.setKioskCode("card", "u-trainee", "proof of the card", 1);
  connection_->executeVerbatim(
      "INSERT INTO setting (name, value, changed_utc_us) VALUES ('kiosk_codes', 'yes', 1)"
      " ON CONFLICT (name) DO UPDATE SET value = 'yes'");

  // Of an earlier version, which kept the proof.
  connection_->executeVerbatim("UPDATE kiosk_code SET revoked_utc_us = 1 WHERE id <> 'card'");
  connection_->executeVerbatim("UPDATE invitation SET state = 'revoked' WHERE id NOT IN ('open', 'expired')");
  connection_->executeVerbatim(
      "INSERT INTO kiosk_code (id, user_id, code_hash, made_utc_us) VALUES ('old', 'u-trainee', 'proof', 1)");
  EXPECT_EQ(owner.outdatedAccess(now_us).cards, std::vector<UserId>{UserId("u-trainee")});
  EXPECT_TRUE(owner.outdatedAccess(now_us).links.empty());
  EXPECT_EQ(psql("SELECT open_session_with_code('proof')"), "");
  connection_->executeVerbatim("UPDATE kiosk_code SET revoked_utc_us = 1 WHERE id = 'old'");
  EXPECT_TRUE(owner.outdatedAccess(now_us).cards.empty());

  // Whoever manages users reads what is kept.
  const std::string kept = as("u-office", "SELECT token_hash FROM invitation WHERE id = 'open'");
  ASSERT_EQ(kept.size(), kKeptProof.size() + 64U);
  EXPECT_EQ(psql("SELECT open_invited_session('" + kept + "')"), "");
  EXPECT_EQ(psql("SELECT open_session_with_code('" +
                 as("u-office", "SELECT code_hash FROM kiosk_code WHERE id = 'card'") + "')"),
            "");
  EXPECT_EQ(psql("SELECT open_invited_session('proof of the other')"), "");  // expired
  EXPECT_NE(psql("SELECT open_session_with_invitation('" + kept + "')").find("does not exist"),
            std::string::npos);
  EXPECT_EQ(psql("SELECT open_session_with_code('proof of the card')").substr(0, 16), "u-trainee active");

  Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
  AccessRepository access(station, PasswordCost::kTest);
  tellSession(station, access.openInvitedSession("proof of the rater"));
  EXPECT_EQ(numberFrom(station, "SELECT count(*) FROM training_mark"), 0);  // for the password only
  EXPECT_EQ(numberFrom(station, "SELECT count(*) FROM person_identity"), 0);
  EXPECT_THROW(station.execute("UPDATE app_user SET state = 'disabled' WHERE id = 'u-rater'"), DbError);
  EXPECT_EQ(access.invited("proof of the rater", now_us), UserId("u-rater"));
  {
    const SealedSecret password = access.sealPassword("u-rater", kPassword);
    Transaction transaction(station);
    EXPECT_TRUE(access.useInvitation("proof of the rater", now_us));
    access.setPassword("u-rater", password, false);
    AuditRepository(station).append({.atUtc_us = now_us,
                                     .actor = {},
                                     .station = {},
                                     .action = AuditAction::kInvitationUse,
                                     .objectKind = AuditObject::kAppUser,
                                     .objectId = "u-rater"});
    transaction.commit();
  }
  const std::string findings = findingsIn(*connection_);
  EXPECT_EQ(findings.find("app_user u-rater"), std::string::npos) << findings;
  EXPECT_EQ(findings.find("invitation open"), std::string::npos) << findings;
  EXPECT_FALSE(access.useInvitation("proof of the rater", now_us));
  EXPECT_EQ(access.openInvitedSession("proof of the rater"), "");
  EXPECT_EQ(access.signIn("u-rater", kPassword, now_us).outcome, SignIn::kOk);
  EXPECT_NE(
      as("u-office", "UPDATE invitation SET state = 'open' WHERE id = 'open'").find("row-level security"),
      std::string::npos);
}

TEST_F(ServerRolesTest, WhoeverAsksNeedsTheRightAndIsAnotherRealPerson) {
  const std::string person = real_->traineeId;
  const std::int64_t now_us = numberFrom(*connection_, kNow);
  const auto asked = [&](const std::string& id, const std::string& user, std::int64_t at_us) {
    return "INSERT INTO duty_request (id, act, subject, detail_json, reason, requested_by, requested_utc_us)"
           " VALUES ('" +
           id + "', 'erase', '" + person + "', '{}', 'why', '" + user + "', " + std::to_string(at_us) + ")";
  };
  const auto refused = [this](const std::string& user, const std::string& act) {
    EXPECT_NE(as(user, act).find("row-level security"), std::string::npos) << user << ": " << act;
  };
  for (const char* user : {"u-rater", "u-trainee", "u-other", "u-allocator"}) {
    refused(user, asked("d", user, now_us));
  }
  refused("u-second", asked("d", "u-second", now_us - 2 * 86'400'000'000));
  refused("u-second", asked("d", "u-second", now_us + 20 * 86'400'000'000));

  // Requests that were there before the asker lost the right, are too old, or come from a simulated person.
  addUser("u-simulated", "administrator", "NULL");
  connection_->executeVerbatim("UPDATE app_user SET demonstration = TRUE WHERE id = 'u-simulated'");
  refused("u-simulated", asked("d", "u-simulated", now_us));
  for (const char* user : {"u-rater", "u-simulated"}) {
    connection_->executeVerbatim(asked("by " + std::string(user), user, now_us));
    refused("u-office", decisionOn("by " + std::string(user), "u-office"));
  }
  connection_->executeVerbatim(asked("old", "u-second", now_us - 15 * 86'400'000'000));
  refused("u-office", decisionOn("old", "u-office"));
  connection_->executeVerbatim(asked("real", "u-second", now_us));
  refused("u-simulated", decisionOn("real", "u-simulated"));
  EXPECT_EQ(as("u-office", decisionOn("real", "u-office")).find("ERROR"), std::string::npos);
  // What concerns simulated people only, they may.
  addUser("u-puppet", "rater", "NULL");
  connection_->executeVerbatim("UPDATE app_user SET demonstration = TRUE WHERE id = 'u-puppet'");
  const std::string simulated =
      requestOf("u-simulated", "grant_roles", "u-puppet", R"({"roles": ["rater"]})");
  EXPECT_EQ(as("u-office", decisionOn(simulated, "u-office")).find("ERROR"), std::string::npos);

  // The way round: as a simulated person, then as oneself.
  const std::string entered =
      as("u-office", "SELECT open_simulated_session((SELECT id FROM app_user WHERE demonstration LIMIT 1));" +
                         asked("mine", "u-simulated", now_us));
  EXPECT_NE(entered.find("row-level security"), std::string::npos) << entered;
}

TEST_F(ServerRolesTest, APersonGetsNoSecondAccount) {
  const auto added = [](const std::string& id, const std::string& person) {
    return "INSERT INTO app_user (id, login, person_id, password_hash, must_change_password, state,"
           " failed_count, locked_until_utc_us, created_utc_us, demonstration) VALUES ('" +
           id + "', '" + id + "', " + person + ", '', FALSE, 'active', 0, 0, 0, FALSE)";
  };
  const std::string rater = "(SELECT person_id FROM app_user WHERE id = 'u-rater')";
  connection_->executeVerbatim("UPDATE app_user SET person_id = NULL WHERE id = 'u-trainee'");
  const std::string other =
      selectFirst(*connection_, "SELECT trainee_id FROM enrolment LIMIT 1", {}, readText).value_or("");
  const auto refused = [](const std::string& answer) {
    return answer.find("row-level security") != std::string::npos;
  };
  EXPECT_TRUE(refused(as("u-office", added("again", rater))));
  connection_->executeVerbatim("UPDATE app_user SET state = 'disabled' WHERE id = 'u-rater'");
  EXPECT_TRUE(refused(as("u-office", added("again", rater))));
  // A transaction that would not see an account that another one adds meanwhile.
  const std::vector<std::string> answers =
      answersTo({{"SELECT set_config('torsio.session', '" + tokenOf("u-office") + "', false)", true},
                 {"BEGIN ISOLATION LEVEL REPEATABLE READ", true},
                 {added("first", "'" + other + "'"), false},
                 {"ROLLBACK", true}});
  EXPECT_TRUE(refused(answers.at(2))) << answers.at(2);

  EXPECT_EQ(as("u-office", added("nobody", "NULL")).find("ERROR"), std::string::npos);
  EXPECT_EQ(as("u-office", added("first", "'" + other + "'")).find("ERROR"), std::string::npos);
  EXPECT_TRUE(refused(as("u-office", added("second", "'" + other + "'"))));
}

TEST_F(ServerRolesTest, ARatersFirstAccountHasNoPasswordBeforeTwoDrawOne) {
  connection_->executeVerbatim("UPDATE app_user SET person_id = NULL");
  const std::string rater =
      selectFirst(*connection_, "SELECT rater_id FROM training_mark LIMIT 1", {}, readText).value_or("");
  const auto added = [&](const char* password, const char* pin, const char* demonstration) {
    return as("u-office",
              "BEGIN; INSERT INTO app_user (id, login, person_id, password_hash, pin_hash,"
              " must_change_password, state, failed_count, locked_until_utc_us, created_utc_us,"
              " demonstration) VALUES ('new', 'new', '" +
                  rater + "', " + password + ", " + pin + ", FALSE, 'active', 0, 0, 0, " + demonstration +
                  "); COMMIT");
  };
  const auto refused = [](const std::string& answer) {
    return answer.find("row-level security") != std::string::npos;
  };
  EXPECT_TRUE(refused(added("'known'", "NULL", "FALSE")));
  EXPECT_TRUE(refused(added("''", "'known'", "FALSE")));
  EXPECT_TRUE(refused(added("'known'", "NULL", "TRUE"))) << "simulated in name only";
  EXPECT_EQ(added("''", "NULL", "FALSE"), "");
  const std::string set = "UPDATE app_user SET password_hash = 'known' WHERE id = 'new'";
  EXPECT_TRUE(refused(as("u-office", set)));
  const std::string request = requestOf("u-second", "reset_password", "new");
  EXPECT_EQ(
      as("u-office", "BEGIN; " + decisionOn(request, "u-office") + "; " + set + "; COMMIT").find("ERROR"),
      std::string::npos);

  connection_->executeVerbatim("DELETE FROM app_user WHERE id = 'new'");
  connection_->executeVerbatim(
      "INSERT INTO setting (name, value, changed_utc_us) VALUES ('two_people', 'no', 1)");
  EXPECT_EQ(added("'known'", "NULL", "FALSE").find("ERROR"), std::string::npos);
}

TEST_F(ServerRolesTest, OnlyWhoMayEditSettingsWritesThem) {
  const auto set = [](const std::string& name) {
    return "INSERT INTO setting (name, value, changed_utc_us) VALUES ('" + name +
           "', 'yes', 1) ON CONFLICT (name) DO UPDATE SET value = excluded.value";
  };
  for (const char* user : {"u-trainee", "u-rater", "u-allocator", ""}) {
    for (const char* name : {"kiosk_codes", "record.moving_to", "record.moved_to", "language", "anything"}) {
      EXPECT_NE(as(user, set(name)).find("row-level security"), std::string::npos) << user << " " << name;
    }
    EXPECT_EQ(as(user, "UPDATE setting SET value = 'no' RETURNING name"), "") << user;
  }
  for (const char* name : {"kiosk_codes", "record.moving_to", "language"}) {
    EXPECT_EQ(as("u-office", set(name)).find("ERROR"), std::string::npos) << name;
  }
}

TEST_F(ServerRolesTest, NobodyMakesTheOtherAdministratorPowerlessAlone) {
  const std::string disable = "UPDATE app_user SET state = 'disabled' WHERE id = 'u-second'";
  const std::string demote = "DELETE FROM user_role WHERE user_id = 'u-second' RETURNING role_code";
  EXPECT_NE(as("u-office", disable).find("row-level security"), std::string::npos);
  EXPECT_EQ(as("u-office", demote), "");
  EXPECT_NE(as("u-office", "INSERT INTO setting (name, value, changed_utc_us) VALUES ('two_people', 'no', 1)")
                .find("row-level security"),
            std::string::npos);
  EXPECT_EQ(as("u-office", "UPDATE app_user SET state = 'disabled' WHERE id = 'u-other' RETURNING id"),
            "u-other");  // of others one decides

  // The other one may agree; to a role for themselves not.
  const std::string more =
      requestOf("u-office", "grant_roles", "u-second", R"({"roles": ["administrator", "rater"]})");
  EXPECT_NE(as("u-second", decisionOn(more, "u-second")).find("row-level security"), std::string::npos);
  addUser("u-third", "administrator", "NULL");
  const std::string none = requestOf("u-third", "grant_roles", "u-second", R"({"roles": []})");
  EXPECT_EQ(as("u-second", "BEGIN; " + decisionOn(none, "u-second") + "; " + demote + "; ROLLBACK"),
            "administrator");
  EXPECT_EQ(as("u-office", decisionOn(none, "u-office") + "; " + demote), "administrator");
  EXPECT_EQ(as("u-office", disable).find("ERROR"), std::string::npos);
}

TEST_F(ServerRolesTest, AnUnknownNameIsAnsweredAsLateAsAKnownOne) {
  Connection station = openRecord(stationLocator(), OpenMode::kReadWrite);
  AccessRepository access(station, PasswordCost::kTest);
  for (const char* login : {"u-office", "nobody"}) {
    const std::int64_t from_us = numberFrom(*connection_, kNow);
    EXPECT_EQ(access.signIn(login, kPassword, 0).outcome, SignIn::kWrong);
    EXPECT_GE(numberFrom(*connection_, kNow) - from_us, 250'000) << login;
  }
}

TEST_F(ServerRolesTest, SeedAndGroupsAreClosedToAStation) {
  sealSeeds();
  for (const char* user : {"", "u-rater", "u-trainee", "u-office", "u-allocator"}) {
    EXPECT_EQ(as(user, kSeeds), "0") << user;
  }
  EXPECT_EQ(as("u-allocator", "UPDATE allocation_seed SET revealed_utc_us = 5 RETURNING seed"), "");
  for (const char* table : {"allocation", "enrolment", "training_group"}) {
    const std::string rows = "SELECT count(*) FROM " + std::string(table);
    ASSERT_GT(numberFrom(*connection_, rows), 0) << table;
    EXPECT_EQ(as("", rows), "0") << table;
    EXPECT_EQ(as("u-other", rows), "0") << table;
    EXPECT_NE(as("u-allocator", rows), "0") << table;
  }
  EXPECT_EQ(as("u-rater", "SELECT count(*) FROM training_group"), "0");
}

TEST_F(ServerRolesTest, AnAllocatorReadsASealedSeedOnlyBehindAnEntryThatStays) {
  sealSeeds();
  const std::string design =
      selectFirst(*connection_, "SELECT min(design_id) FROM allocation_seed", {}, readText).value_or("");
  const auto entry = [](const std::string& user, const std::string& action, const std::string& object) {
    return "INSERT INTO audit_entry SELECT max(sequence) + 1, 1, '" + user + "', 'ward', '" + action +
           "', 'allocation_design', '" + object + "', '', '', '', '', '', '' FROM audit_entry";
  };
  const std::string takenOut = entry("u-allocator", "allocation.take_seed", design);

  // What can be rolled back opens nothing.
  EXPECT_EQ(as("u-allocator", "BEGIN; " + takenOut + "; " + kSeeds + "; ROLLBACK"), "0");
  EXPECT_EQ(as("u-allocator", "BEGIN; SAVEPOINT s; " + takenOut + "; RELEASE s; " + kSeeds + "; ROLLBACK"),
            "0");
  EXPECT_EQ(as("u-allocator", kSeeds), "0");

  EXPECT_EQ(as("u-allocator", takenOut), "");
  EXPECT_EQ(as("u-allocator", kSeeds), "1");
  EXPECT_EQ(as("u-office", kSeeds), "0") << "another one's entry";
  EXPECT_EQ(as("u-allocator", entry("u-allocator", "allocation.draw", design)), "");
  EXPECT_EQ(as("u-allocator", kSeeds), "0") << "once drawn, it is closed again";
  EXPECT_EQ(as("u-allocator", entry("u-allocator", "allocation.take_seed", "another design")), "");
  EXPECT_EQ(as("u-allocator", kSeeds), "0");
  EXPECT_EQ(as("u-office", entry("u-office", "allocation.take_seed", design)), "");
  EXPECT_EQ(as("u-office", kSeeds), "0") << "not an allocator";
}

/// What nobody has to sign in for: everything else is closed, table by table.
TEST_F(ServerRolesTest, WithoutASignInTheMatrixIsClosed) {
  static const std::set<std::string> kAdded{
      "trial",    "trial_chunk", "trial_end",      "trial_digest",    "exposure",    "station_state",
      "row_seal", "seal_salt",   "learning_event", "sign_in_failure", "record_copy", "audit_entry"};
  static const std::set<std::string> kHidden{"allocation",           "allocation_seed",
                                             "composite_result",     "draft_viewing",
                                             "duty_request",         "enrolment",
                                             "evaluation_draft",     "evaluation_mark",
                                             "evaluation_result",    "invitation",
                                             "kiosk_code",           "mark_draft",
                                             "mark_draft_row",       "mark_viewing",
                                             "paper_entry",          "paper_entry_row",
                                             "person_identity",      "rater_warmup",
                                             "roster_import_person", "seal_salt",
                                             "second_factor",        "second_factor_secret",
                                             "self_score",           "self_score_row",
                                             "training_group",       "training_group_result",
                                             "training_mark",        "training_mark_row",
                                             "training_result",      "watch_account"};
  sealSeeds();
  std::vector<std::string> tables;
  std::vector<Act> acts;
  for (const std::string& table : allTables(*connection_)) {
    std::string row =
        selectFirst(*connection_, "SELECT to_jsonb(t)::text FROM " + table + " t LIMIT 1", {}, readText)
            .value_or("");
    if (row.empty()) {
      EXPECT_TRUE(table == "server_session" || table == "erasure_gate") << table;
      row = "{}";
    }
    tables.push_back(table);
    acts.push_back({"SELECT count(*) FROM " + table, false});
    acts.push_back({"INSERT INTO " + table + " SELECT (jsonb_populate_record(NULL::" + table + ", $row$" +
                        row + "$row$)).*",
                    false});
  }
  const std::vector<std::string> answers = answersTo(acts);
  ASSERT_EQ(answers.size(), 2 * tables.size());
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string& seen = answers[2 * i];
    const std::string& added = answers[2 * i + 1];
    const bool hidden = seen == "0\n" || seen.find("permission denied") != std::string::npos;
    const bool refused = added.find("row-level security") != std::string::npos ||
                         added.find("permission denied") != std::string::npos;
    EXPECT_EQ(hidden, kHidden.contains(tables[i]) || tables[i] == "server_session" ||
                          tables[i] == "password_pepper" || tables[i] == "erasure_gate")
        << tables[i] << ": " << seen;
    EXPECT_EQ(!refused, kAdded.contains(tables[i])) << tables[i] << ": " << added;
  }
}

TEST_F(ServerRolesTest, AStationIsToldWhoMayRemoveTheDemonstration) {
  {
    Connection station = openDatabase(stationLocator(), OpenMode::kReadWrite);
    try {
      (void)removeDemonstration(station, "u-office", "ward", "why", 1);
      ADD_FAILURE() << "a station removed rows";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kPermission);
      EXPECT_NE(error.remedy().find("owns the database"), std::string::npos) << error.remedy();
    }
  }
  EXPECT_NO_THROW((void)removeDemonstration(*connection_, "u-office", "ward", "why", 1));
}

TEST_F(ServerRolesTest, PreparingTwiceChangesNothingAndTheOwnerIsNotAStation) {
  writeServerRoles(*connection_, allTables(*connection_), closedTables(), role_);

  EXPECT_EQ(as("u-office", "SELECT count(*) FROM training_mark"), "1");
  EXPECT_EQ(refusalFrom([&] {
              writeServerRoles(*connection_, allTables(*connection_), closedTables(), owner_.user);
            }).code,
            ErrorCode::kBadParameter);
  EXPECT_EQ(refusalFrom([&] {
              writeServerRoles(*connection_, allTables(*connection_), closedTables(), "a b");
            }).code,
            ErrorCode::kBadParameter);
}

TEST_F(ServerRolesTest, ConcurrentPreparationsWaitForEachOther) {
  const std::vector<std::string> tables = allTables(*connection_);
  const auto prepareOften = [&] {
    Connection own = openRecord(locator(), OpenMode::kReadWrite);
    for (int i = 0; i < 5; ++i) {
      writeServerRoles(own, tables, closedTables(), role_);
    }
  };
  std::future<void> other = std::async(std::launch::async, prepareOften);
  EXPECT_NO_THROW(prepareOften());
  EXPECT_NO_THROW(other.get());
}

}  // namespace
}  // namespace torsio
