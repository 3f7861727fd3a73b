// SPDX-License-Identifier: GPL-3.0-or-later
// Every change of a row used by reports is sealed in its own transaction.

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/schema_tables.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

class RowLedgerTest : public SampleTest {};

std::vector<AuditEntry> sealsIn(Connection& connection) {
  std::vector<AuditEntry> seals;
  AuditRepository(connection).forEach([&](const AuditEntry& entry) {
    if (entry.action == storedText(AuditAction::kRecordSeal)) {
      seals.push_back(entry);
    }
  });
  return seals;
}

TEST_F(RowLedgerTest, EveryTableHasOneRuleWithExistingColumns) {
  std::vector<SchemaTable> tables = tablesInReferenceOrder(connection());
  tables.push_back({"schema_migration", {{"version"}, {"software_version"}, {"applied_utc_us"}}, {}});
  std::map<std::string, const SealRule*> rules;
  for (const SealRule& rule : kSealRules) {
    EXPECT_TRUE(rules.emplace(rule.table, &rule).second) << "two rules: " << rule.table;
    const bool explained =
        rule.sealing == Sealing::kElsewhere || rule.sealing == Sealing::kNot || !rule.unsealed.empty();
    EXPECT_EQ(explained, !rule.reason.empty()) << rule.table << ": what is not sealed needs its reason";
  }
  for (const SchemaTable& table : tables) {
    ASSERT_TRUE(rules.contains(table.name)) << "neither sealed nor listed with a reason: " << table.name;
    const SealRule& rule = *rules.at(table.name);
    for (const std::string_view list : {rule.key, rule.personal, rule.unsealed}) {
      for (const std::string& column : columnsOf(list)) {
        EXPECT_TRUE(table.has(column)) << table.name << "." << column;
      }
    }
    rules.erase(table.name);
  }
  EXPECT_TRUE(rules.empty()) << "no such table: " << rules.begin()->first;
}

TEST_F(RowLedgerTest, TheKeysOfTheRulesMatchTheSchema) {
  if (onPostgresql()) {
    GTEST_SKIP() << "both engines run the same steps";
  }
  for (const SealRule& rule : kSealRules) {
    EXPECT_EQ(columnsOf(rule.key),
              selectAll(connection(), "SELECT name FROM pragma_table_info(?) WHERE pk > 0 ORDER BY pk",
                        {rule.table}, readText))
        << rule.table;
  }
}

TEST_F(RowLedgerTest, PersonalDataAreSealedWithASalt) {
  for (const PersonRule& erased : kPersonRules) {
    const SealRule* rule = sealRuleOf(erased.table);
    if (rule == nullptr || erased.onErase != OnErase::kClear) {
      continue;
    }
    const std::vector<std::string> personal = columnsOf(rule->personal);
    for (const std::string& cleared : columnsOf(erased.cleared)) {
      const std::string column = cleared.substr(0, cleared.find(' '));
      EXPECT_TRUE(column == "state" || std::find(personal.begin(), personal.end(), column) != personal.end())
          << erased.table << "." << column;
    }
  }
}

TEST_F(RowLedgerTest, OneTransactionIsSealedByOneEntryOfItsAuthor) {
  const SampleRecord sample(connection(), 2);
  const std::size_t before = sealsIn(connection()).size();

  {
    Transaction together(connection());
    StudyRepository study(connection());
    study.setEnrolmentState(sample.enrolments[0].id, EnrolmentState::kCompleted);
    study.setEnrolmentState(sample.enrolments[1].id, EnrolmentState::kWithdrawn);
    AuditRepository(connection())
        .append({.atUtc_us = 77,
                 .actor = "admin",
                 .station = "office",
                 .action = AuditAction::kEnrolmentSetState,
                 .objectKind = AuditObject::kEnrolment});
    together.commit();
  }

  const std::vector<AuditEntry> seals = sealsIn(connection());
  ASSERT_EQ(seals.size(), before + 1);
  EXPECT_EQ(seals.back().actor, "admin");
  EXPECT_EQ(seals.back().station, "office");
  EXPECT_EQ(seals.back().atUtc_us, 77);
  EXPECT_EQ(seals.back().newJson, R"({"entries":1,"rows":2})");
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
}

TEST_F(RowLedgerTest, ChangesOutsideATransactionAreSealedAndRolledBackOnesAreNot) {
  const EnrolmentId enrolment = sample().enrolments[0].id;
  const std::size_t before = sealsIn(connection()).size();

  connection().execute("UPDATE enrolment SET state = ? WHERE id = ?", {"completed", enrolment});
  {
    const Transaction givenUp(connection());
    connection().execute("UPDATE enrolment SET state = ? WHERE id = ?", {"withdrawn", enrolment});
  }
  connection().execute("UPDATE enrolment SET state = ? WHERE id = ?", {"withdrawn", "nobody"});

  EXPECT_EQ(sealsIn(connection()).size(), before + 1);
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
}

TEST_F(RowLedgerTest, EveryKindOfChangeIsSealed) {
  const FullRecord record(connection(), "real", false);

  connection().execute(
      "INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)"
      " ON CONFLICT (name) DO UPDATE SET value = excluded.value",
      {"a", "1", 1});
  connection().execute(
      "INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)"
      " ON CONFLICT (name) DO UPDATE SET value = excluded.value",
      {"a", "2", 2});
  connection().execute("INSERT INTO setting (name, value, changed_utc_us) VALUES ('b', 'literal', 1)");
  connection().execute(
      "INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)"
      " ON CONFLICT (name) DO NOTHING",
      {"b", "never", 2});
  connection().execute(
      "INSERT INTO setting (name, value, changed_utc_us) SELECT name || '2', value, 3 FROM setting"
      " WHERE name = ?",
      {"b"});
  connection().execute("UPDATE setting SET value = value || '!' WHERE name = 'b'");
  connection().execute("DELETE FROM setting WHERE name = 'a'");

  EXPECT_EQ(allFindings(connection()), std::vector<std::string>{});
  EXPECT_EQ(numberFrom(connection(),
                       "SELECT count(*) FROM row_seal WHERE table_name = 'setting' AND row_key ="
                       " 'a' AND removed"),
            1);
}

TEST_F(RowLedgerTest, ALegitimateChangeDoesNotHideATamperedRow) {
  const FullRecord record(connection(), "real", false);
  const auto set = [&](const char* name, const char* value) {
    connection().execute(
        "INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)"
        " ON CONFLICT (name) DO UPDATE SET value = excluded.value",
        {name, value, 1});
  };
  set("a", "1");
  set("b", "1");
  connection().executeVerbatim("UPDATE person SET level = 'expert' WHERE id = 'real trainee'");
  connection().executeVerbatim("UPDATE setting SET value = '7' WHERE name = 'a'");
  connection().executeVerbatim("INSERT INTO setting (name, value, changed_utc_us) VALUES ('c', '7', 1)");

  connection().execute("UPDATE person SET sex = ? WHERE id = ? AND state <> ?",
                       {"female", "real trainee", ""});
  set("a", "2");
  set("b", "2");
  connection().execute("UPDATE setting SET changed_utc_us = 2 WHERE name = ?", {"c"});
  connection().execute("UPDATE setting SET changed_utc_us = ? WHERE name = 'b'", {3});

  const std::string behind = ": was changed behind the trail before this change of it";
  EXPECT_EQ(
      allFindings(connection()),
      (std::vector<std::string>{"person real trainee" + behind, "setting a" + behind, "setting c" + behind}));
}

TEST_F(RowLedgerTest, CountingFailedSignInsIsNotSealed) {
  const FullRecord record(connection(), "real", false);
  const std::size_t before = sealsIn(connection()).size();

  connection().execute("UPDATE app_user SET failed_count = ?, locked_until_utc_us = ?", {3, 99});

  EXPECT_EQ(sealsIn(connection()).size(), before);
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
}

TEST_F(RowLedgerTest, SealsContainNoPersonalDataAndAnEraseRemovesTheSalt) {
  SampleRecord sample(connection(), 2);
  const PersonId person = sample.trainees[0].person.id;
  PeopleRepository(connection()).setIdentity({person, "Hua Tuo", "hua@example.org", "7"});
  const auto saltsOf = [&] {
    Statement row = connection().prepare("SELECT count(*) FROM seal_salt WHERE row_key = ?");
    row.execute({person});
    return row.step() ? row.int64(0) : -1;
  };
  ASSERT_GE(saltsOf(), 1);

  erasePerson(connection(), person, "admin", "asked for it", kSampleTime_us);

  EXPECT_EQ(saltsOf(), 0);
  EXPECT_TRUE(verifyAuditTrail(connection()).empty());
  for (const std::string& hash :
       selectAll(connection(), "SELECT personal_hash FROM row_seal", {}, readText)) {
    EXPECT_TRUE(hash.empty() || hash.size() == 64U);
  }
}

TEST_F(RowLedgerTest, AMigrationSealsExistingRowsAndSaysSo) {
  Connection old = open();
  migrate(old, embeddedMigrations(), {.softwareVersion = "older"});
  old.execute("INSERT INTO centre (id, name, created_utc_us, demonstration) VALUES ('c', 'clinic', 1, ?)",
              {false});
  ASSERT_FALSE(verifyAuditTrail(old).empty());
  std::vector<Migration> steps = embeddedMigrations();
  steps.push_back({.version = steps.back().version + 1,
                   .name = "0002_next",
                   .description = "next",
                   .sql = "CREATE TABLE later (id TEXT PRIMARY KEY);",
                   .checksum = "x"});

  migrate(old, steps, {.softwareVersion = "newer", .now_us = 5, .backup = false});

  const std::vector<AuditEntry> seals = sealsIn(old);
  ASSERT_EQ(seals.size(), 1U);
  EXPECT_EQ(seals[0].reason, "sealed on upgrade, not before");
  old.executeVerbatim("UPDATE centre SET name = 'other'");
  const std::vector<AuditFinding> findings = verifyAuditTrail(old);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].objectKind, "centre");
}

TEST(ChangedStatementTest, ParsesTheRepositoriesStatements) {
  const auto insert = changedBy(
      "INSERT INTO mark_release (cohort_id, occasion, sequence) VALUES (?, ?, (SELECT "
      "COALESCE(MAX(r.sequence), 0)"
      " + 1 FROM mark_release r WHERE r.cohort_id = ?))");
  ASSERT_TRUE(insert);
  EXPECT_EQ(insert->table, "mark_release");
  EXPECT_EQ(insert->placeholderOf("occasion"), 1);
  EXPECT_EQ(insert->placeholderOf("sequence"), -1);

  const auto update =
      changedBy("UPDATE app_user SET state = 'a, b', failed_count = 0, pin_hash = ? WHERE id = ?");
  ASSERT_TRUE(update);
  EXPECT_EQ(update->columns.size(), 3U);
  EXPECT_EQ(update->placeholderOf("pin_hash"), 0);
  EXPECT_EQ(update->where, "id = ?");
  EXPECT_EQ(update->whereFrom, 1);
  const auto nested = changedBy("UPDATE training_group SET arm_id = (SELECT id FROM arm WHERE code = ?)");
  ASSERT_TRUE(nested);
  EXPECT_EQ(nested->where, "");

  const auto replace = changedBy(
      "INSERT INTO setting (name, value) VALUES (?, ?) ON CONFLICT (name) DO UPDATE SET value = "
      "excluded.value");
  ASSERT_TRUE(replace);
  EXPECT_EQ(replace->onConflict, ChangedStatement::OnConflict::kUpdate);
  EXPECT_EQ(replace->replaced, std::vector<std::string>{"value"});
  EXPECT_FALSE(changedBy("SELECT 1 FROM setting"));
}

}  // namespace
}  // namespace torsio
