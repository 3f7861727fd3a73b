// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts to hide a change by somebody with access to the file, on both engines.

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/mark.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/migrations/backup.h"
#include "db/migrations/migrations.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/file_io.h"
#include "sim/core/random.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {

namespace {

/// A record with one sealed mark.
class TamperTest : public DatabaseTest {
 protected:
  /// Adds a trigger that gives every new mark 99 points.
  void addScoreRaisingTrigger() {
    if (onPostgresql()) {
      connection_->executeVerbatim(
          "CREATE FUNCTION raise_score() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN NEW.score_steps = 99;"
          " RETURN NEW; END $$");
      connection_->executeVerbatim(
          "CREATE TRIGGER raise_score BEFORE INSERT ON training_mark FOR EACH ROW EXECUTE FUNCTION "
          "raise_score()");
    } else {
      connection_->executeVerbatim(
          "CREATE TRIGGER raise_score AFTER INSERT ON training_mark BEGIN UPDATE training_mark SET "
          "score_steps "
          "= 99"
          " WHERE id = NEW.id; END");
    }
  }
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    connection_.emplace(openWithSchema());
    sample_.emplace(*connection_, 2);
    const SubmittedMark mark = markOf(0);
    RatingRepository(*connection_, "ward").submit(std::span(&mark, 1));
    markId_ = mark.id;
  }
  [[nodiscard]] SubmittedMark markOf(std::size_t trainee) {
    SubmittedMark mark;
    mark.id = sample_->ids.newUuid();
    mark.enrolmentId = sample_->enrolments[trainee].id;
    mark.raterId = sample_->chiefs[0].person.id;
    mark.occasionCode = "pre";
    mark.score_steps = 40;
    mark.comment = "steady";
    mark.submittedUtc_us = kSampleTime_us;
    return mark;
  }
  void TearDown() override {
    connection_.reset();
    DatabaseTest::TearDown();
  }

  void dropTriggers(const std::string& table) {
    for (const std::string& trigger : onPostgresql() ? std::vector<std::string>{"_append_only"}
                                                     : std::vector<std::string>{"_no_UPDATE", "_no_DELETE"}) {
      connection_->executeVerbatim("DROP TRIGGER " + table + trigger +
                                   (onPostgresql() ? " ON " + table : ""));
    }
  }
  /// Appends a forged entry with valid hashes.
  void forgeEntry(AuditAction action, const std::string& hash) {
    AuditRepository(*connection_)
        .append({.atUtc_us = kSampleTime_us,
                 .actor = "somebody",
                 .station = "ward",
                 .action = action,
                 .objectKind = AuditObject::kTrainingMark,
                 .objectId = markId_,
                 .objectHash = hash});
  }
  [[nodiscard]] bool finds(const std::string& what) {
    const std::vector<AuditFinding> findings = verifyAuditTrail(*connection_);
    return std::any_of(findings.begin(), findings.end(), [&](const AuditFinding& finding) {
      return finding.what.find(what) != std::string::npos;
    });
  }

  std::optional<Connection> connection_;
  std::optional<SampleRecord> sample_;
  std::string markId_;
};

TEST_F(TamperTest, AnUntouchedRecordHasNoFinding) {
  EXPECT_TRUE(schemaFindings(*connection_).empty());
  EXPECT_TRUE(verifyAuditTrail(*connection_).empty());
}

TEST_F(TamperTest, ARemovedTriggerIsNamed) {
  dropTriggers("training_mark");

  const std::vector<SchemaFinding> findings = schemaFindings(*connection_);

  ASSERT_EQ(findings.size(), onPostgresql() ? 1U : 2U);
  EXPECT_NE(findings[0].part.find("trigger training_mark_"), std::string::npos);
  EXPECT_NE(findings[0].what.find("missing"), std::string::npos);
}

TEST_F(TamperTest, ATriggerThatAltersSubmissionsIsNamed) {
  addScoreRaisingTrigger();

  const std::vector<SchemaFinding> findings = schemaFindings(*connection_);

  ASSERT_FALSE(findings.empty());
  EXPECT_NE(findings.back().part.find("raise_score"), std::string::npos);
  EXPECT_NE(findings.back().what.find("somebody added it"), std::string::npos);
}

TEST_F(TamperTest, ADisabledGuardIsNamed) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "SQLite has no switch for one trigger";
  }
  connection_->executeVerbatim("ALTER TABLE training_mark DISABLE TRIGGER training_mark_append_only");
  connection_->executeVerbatim(
      "CREATE OR REPLACE FUNCTION refuse_thaw() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RETURN NEW; END "
      "$$");

  EXPECT_EQ(schemaFindings(*connection_).size(), 2U);
}

TEST_F(TamperTest, WaysAroundAServersGuardsAreNamed) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "SQLite's schema is compared word by word";
  }
  const auto finds = [this](const std::string& sql, const std::string& part) {
    const Transaction undone(*connection_);
    connection_->executeVerbatim(sql);
    const std::vector<SchemaFinding> findings = schemaFindings(*connection_);
    ASSERT_EQ(findings.size(), 1U) << sql;
    EXPECT_EQ(findings[0].part, part);
  };
  finds(
      "DROP TRIGGER training_mark_append_only ON training_mark;"
      "CREATE TRIGGER training_mark_append_only BEFORE UPDATE OR DELETE ON training_mark"
      " FOR EACH ROW WHEN (false) EXECUTE FUNCTION refuse_change()",
      "trigger training_mark_append_only");
  finds("CREATE RULE kept AS ON INSERT TO consent DO INSTEAD NOTHING", "rule consent kept");
  finds("ALTER TABLE training_mark ALTER score_steps TYPE numeric", "column training_mark.score_steps");
  finds("ALTER TABLE person ALTER state DROP NOT NULL", "column person.state");
  finds("ALTER TABLE person ADD nickname text", "column person.nickname");
  finds("ALTER TABLE person DROP CONSTRAINT person_state_check", "checks of person");
  finds("ALTER TABLE person_identity DROP CONSTRAINT person_identity_person_id_fkey",
        "references person_identity to person");
  finds("ALTER TABLE person DROP CONSTRAINT person_code_key", "keys of person");
}

TEST_F(TamperTest, AChangedMarkWithASecondSealIsDetected) {
  dropTriggers("training_mark");
  connection_->executeVerbatim("UPDATE training_mark SET score_steps = 90");
  forgeEntry(AuditAction::kMarkSubmit, std::string(64, 'a'));
  EXPECT_TRUE(finds("differs from what was recorded"));

  forgeSeals(*connection_, AuditAction::kMarkAmend, AuditObject::kTrainingMark, markId_);
  EXPECT_TRUE(finds("seals a row otherwise that was sealed before"));
}

TEST_F(TamperTest, ADeletedMarkWithAnEntryOfItsRemovalIsDetected) {
  dropTriggers("training_mark");
  connection_->executeVerbatim("DELETE FROM training_mark");
  forgeEntry(AuditAction::kDemonstrationRemove, "");

  EXPECT_TRUE(finds("was recorded, but is missing"));
}

TEST_F(TamperTest, AnInsertedTombstoneExcusesNoChangedSecond) {
  TrialRepository(*connection_, {.station = "ward"}).import(sampleTrial());
  ASSERT_TRUE(verifyAuditTrail(*connection_).empty());
  dropTriggers("trial_chunk");
  connection_->execute("UPDATE trial_chunk SET bytes = ?", {Blob(300)});
  connection_->executeVerbatim(
      "INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us)"
      " SELECT trainee_id, 'somebody', 'none', 1 FROM trial");

  EXPECT_FALSE(verifyAuditTrail(*connection_).empty());
}

TEST_F(TamperTest, ARightGrantedToTraineesIsNamed) {
  connection_->execute("INSERT INTO role_operation (role_code, operation_code) VALUES (?, ?)",
                       {"trainee", "user.manage"});
  connection_->execute("DELETE FROM role_operation WHERE role_code = ? AND operation_code = ?",
                       {"administrator", "audit.view"});

  const std::vector<SchemaFinding> findings = schemaFindings(*connection_);

  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].part, "right administrator audit.view");
  EXPECT_EQ(findings[1].part, "right trainee user.manage");
}

TEST_F(TamperTest, ARowAlteredByATriggerIsRefused) {
  if (!onPostgresql()) {
    connection_->executeVerbatim("DROP TRIGGER training_mark_no_UPDATE");
  }
  addScoreRaisingTrigger();
  const SubmittedMark mark = markOf(1);

  const Refusal refusal =
      refusalFrom([&] { RatingRepository(*connection_, "ward").submit(std::span(&mark, 1)); });

  EXPECT_EQ(refusal.code, ErrorCode::kVerifyFailed);
  EXPECT_NE(refusal.text.find("score_steps"), std::string::npos) << refusal.text;
  EXPECT_EQ(numberFrom(*connection_, "SELECT count(*) FROM training_mark"), 1);
}

/// A manipulation of the tables with another tool, and the table that a finding must name.
struct Act {
  const char* name;
  std::vector<std::string> statements;
  const char* found;
};

/// A record with two rows in every table.
class TamperWithRows : public DatabaseTest, public ::testing::WithParamInterface<Act> {};

TEST_P(TamperWithRows, IsFound) {
  Connection connection = openWithSchema();
  const FullRecord one(connection, "one", false);
  const FullRecord two(connection, "two", false);
  ASSERT_EQ(allFindings(connection), std::vector<std::string>{});
  Connection behind = open();
  disarm(behind);

  for (const std::string& statement : GetParam().statements) {
    behind.executeVerbatim(statement);
  }

  const std::vector<AuditFinding> findings = verifyAuditTrail(behind);
  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const AuditFinding& finding) {
    return finding.objectKind == GetParam().found;
  })) << (findings.empty() ? "nothing found" : findings[0].objectKind + ": " + findings[0].what);
}

INSTANTIATE_TEST_SUITE_P(
    Acts, TamperWithRows,
    ::testing::Values(
        Act{"GateOpenedUpdatedClosed",
            {"INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES ('x', 'none', 1)",
             "UPDATE training_mark SET score_steps = 100", "DELETE FROM erasure_gate"},
            "training_mark"},
        Act{"MovedToAnotherArm",
            {"UPDATE enrolment SET group_id = 'one group' WHERE id = 'two enrolment'"},
            "enrolment"},
        Act{"EnrolmentsOfTrialsSwapped",
            {"UPDATE trial SET enrolment_id = CASE enrolment_id WHEN 'one enrolment' THEN 'two enrolment' "
             "ELSE"
             " 'one enrolment' END"},
            "trial"},
        Act{"NamesSwapped", {"UPDATE person_identity SET full_name = full_name || ' '"}, "person_identity"},
        Act{"PasswordHashSet", {"UPDATE app_user SET password_hash = 'known'"}, "app_user"},
        Act{"RoleGiven",
            {"INSERT INTO user_role (user_id, role_code) SELECT id, 'allocator' FROM app_user"},
            "user_role"},
        Act{"CommentsEmptied", {"UPDATE training_mark SET comment = NULL"}, "training_mark"},
        Act{"RowOfASheetChanged", {"UPDATE training_mark_row SET score_steps = 10"}, "training_mark"},
        Act{"RowOfASheetTakenAway", {"DELETE FROM training_mark_row"}, "training_mark"},
        Act{"DigestsHalved",
            {"UPDATE trial_digest SET mean_absolute_error_deg = mean_absolute_error_deg / 2"},
            "trial_digest"},
        Act{"WeightOfAClass", {"UPDATE evaluation_class SET weight_milli = 1"}, "evaluation_class"},
        Act{"WeightOfAnIndex", {"UPDATE evaluation_index SET weight_milli = 1"}, "evaluation_index"},
        Act{"ResultRaised", {"UPDATE training_result SET mean = mean + 1"}, "assessment_run"},
        Act{"ConsentGranted", {"UPDATE consent SET granted = NOT granted"}, "consent"},
        Act{"ExposureStretched", {"UPDATE exposure SET duration_us = duration_us + 1"}, "exposure"},
        Act{"SettingChanged", {"UPDATE setting SET value = 'other'"}, "setting"},
        Act{"CallMoved", {"UPDATE live_call SET occasion = 'mid'"}, "live_call"},
        Act{"OccasionRenamed", {"UPDATE occasion SET label = 'later' WHERE code = 'pre'"}, "occasion"},
        Act{"SaltForgotten",
            {"DELETE FROM seal_salt WHERE table_name = 'person_identity'"},
            "person_identity"},
        Act{"SaltAdded",
            {"INSERT INTO seal_salt (table_name, row_key, salt) VALUES ('trial', 'x', 'y')"},
            "seal_salt"},
        Act{"SealTakenAway",
            {"DELETE FROM row_seal WHERE entry_sequence = (SELECT min(entry_sequence) FROM row_seal)"},
            "row_seal"},
        Act{"Tombstone",
            {"INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us) VALUES"
             " ('free', 'x', 'y', 1)"},
            "erasure"}),
    [](const ::testing::TestParamInfo<Act>& act) { return std::string(act.param.name); });

TEST_F(TamperTest, TwoSwappedNamesAreDetected) {
  PeopleRepository people(*connection_);
  const std::vector<std::string> ids =
      selectAll(*connection_, "SELECT person_id FROM trainee ORDER BY person_id", {}, readText);
  people.setIdentity({ids[0], "Hua Tuo", "", "1"});
  people.setIdentity({ids[1], "Bian Que", "", "2"});
  ASSERT_TRUE(verifyAuditTrail(*connection_).empty());

  connection_->executeVerbatim(
      "UPDATE person_identity SET full_name = CASE full_name WHEN 'Hua Tuo' THEN 'Bian Que' ELSE 'Hua Tuo' "
      "END");

  EXPECT_EQ(verifyAuditTrail(*connection_).size(), 2U);
}

TEST_F(TamperTest, AnEraseInTheTrailExcusesNoOtherChangeOfTheRow) {
  const std::string trainee =
      selectAll(*connection_,
                "SELECT trainee_id FROM enrolment e JOIN training_mark m ON m.enrolment_id = e.id", {},
                readText)
          .at(0);
  disarm(*connection_);
  connection_->executeVerbatim("UPDATE training_mark SET score_steps = 90, comment = NULL");
  connection_->executeVerbatim(
      "INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us) VALUES ('" + trainee +
      "', 'x', 'y', 1)");

  forgeSeals(*connection_, AuditAction::kPersonErase, AuditObject::kPerson, trainee);

  EXPECT_TRUE(finds("seals a row otherwise that was sealed before"));
}

TEST_F(TamperTest, ARemovalOfTheDemonstrationExcusesNoRealMark) {
  disarm(*connection_);
  connection_->executeVerbatim("DELETE FROM training_mark");

  forgeSeals(*connection_, AuditAction::kDemonstrationRemove, AuditObject::kDemonstration, "");

  EXPECT_TRUE(finds("records a removal that did not take place"));
}

TEST_F(TamperTest, ATombstoneWithoutItsEntryIsDetectedEvenWithASeal) {
  disarm(*connection_);
  connection_->executeVerbatim(
      "INSERT INTO erasure (person_id, requested_by, reason, erased_utc_us) SELECT person_id, 'x', 'y', 1 "
      "FROM"
      " trainee");

  forgeSeals(*connection_, AuditAction::kPersonChange, AuditObject::kPerson, "p");

  EXPECT_TRUE(finds("records an erasure that did not take place"));
}

TEST_F(TamperTest, AGateLeftOpenIsDetected) {
  connection_->execute("INSERT INTO erasure_gate (id, reason, opened_utc_us) VALUES (?, ?, ?)",
                       {"x", "none", 1});

  EXPECT_TRUE(finds("is open: sealed rows can be changed"));
}

}  // namespace

namespace {

int changesWanted() {
  const char* wanted = std::getenv("TORSIO_TAMPER_CHANGES");
  return wanted == nullptr ? 40 : std::atoi(wanted);
}

std::set<std::string> findingsIn(Connection& connection) {
  const std::vector<std::string> all = allFindings(connection);
  return {all.begin(), all.end()};
}

/// True for columns without a seal, which the rules justify: "table.column", or "table.*".
bool carriesNothing(const std::string& table, const std::string& column) {
  for (const SealRule& rule : kSealRules) {
    if (rule.table != table) {
      continue;
    }
    if (rule.sealing == Sealing::kNot) {
      return true;
    }
    for (const std::string& unsealed : columnsOf(rule.unsealed)) {
      if (unsealed == column) {
        return true;
      }
    }
  }
  return false;
}

class Changer {
 public:
  explicit Changer(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_.next() % count); }

  /// Another value of the same type.
  Value other(const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value.storage())) {
      return *number == 0 || *number == 1 ? 1 - *number
                                          : *number + 1 - 2 * static_cast<std::int64_t>(below(2));
    }
    if (const auto* flag = std::get_if<bool>(&value.storage())) {
      return !*flag;
    }
    if (const auto* number = std::get_if<double>(&value.storage())) {
      return *number * 0.5 + 0.01;
    }
    if (const auto* text = std::get_if<std::string>(&value.storage())) {
      std::string changed = *text;
      if (changed.empty() || below(4) == 0) {
        return changed + "x";
      }
      char& letter = changed[below(changed.size())];
      letter = letter == 'a' ? 'b' : 'a';
      return changed;
    }
    if (const auto* bytes = std::get_if<Blob>(&value.storage())) {
      Blob changed = *bytes;
      if (changed.empty()) {
        return Blob{std::byte{1}};
      }
      changed[below(changed.size())] ^= std::byte{1};
      return changed;
    }
    return "something";
  }

 private:
  Random random_;
};

class RandomTamper : public DatabaseTest {};

TEST_F(RandomTamper, ValuesOfAnotherTypeAndMissingColumnsAreFindings) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server keeps the kind of every column";
  }
  const FullRecord real(connection(), "real", false);
  Connection behind = open();
  disarm(behind);
  const std::set<std::string> before = findingsIn(behind);
  for (const char* change : {"UPDATE operation SET label = CAST(label AS BLOB) WHERE code = 'practice'",
                             "UPDATE role SET code = CAST(code AS BLOB) WHERE code = 'trainee'",
                             "UPDATE schema_migration SET name = CAST(name AS BLOB)",
                             "UPDATE audit_entry SET reason = CAST(reason AS BLOB) WHERE sequence = 1",
                             "UPDATE row_seal SET row_hash = CAST(row_hash AS BLOB) WHERE position = 1",
                             "UPDATE seal_salt SET salt = CAST(salt AS BLOB)",
                             "UPDATE trial_chunk SET digest = CAST(digest AS BLOB)",
                             "ALTER TABLE consent RENAME COLUMN purpose TO purpoze"}) {
    const Transaction undone(behind);
    behind.executeVerbatim(change);
    EXPECT_NE(findingsIn(behind), before) << change;
  }
}

TEST_F(RandomTamper, EveryChangeOfAnyColumnIsDetected) {
  const FullRecord real(connection(), "real", false);
  const FullRecord simulated(connection(), "demo", true);
  Connection behind = open();
  disarm(behind);
  const std::set<std::string> before = findingsIn(behind);
  std::vector<SchemaTable> tables = tablesInReferenceOrder(behind);
  tables.push_back(
      {"schema_migration", {{"version"}, {"name"}, {"description"}, {"checksum"}, {"compatible_from"}}, {}});
  Changer changer(20251121);
  int made = 0;
  std::map<std::string, int> leftOut;
  std::vector<std::string> missed;

  for (int tries = 0; made < changesWanted() && tries < 50 * changesWanted(); ++tries) {
    const SchemaTable& table = tables[changer.below(tables.size())];
    const std::string column = table.columns[changer.below(table.columns.size())].name;
    if (carriesNothing(table.name, column)) {
      ++leftOut[table.name + "." + column];
      continue;
    }
    const Transaction undone(behind);
    std::vector<std::vector<Value>> rows;
    std::vector<std::string> names;
    forEachSelected(behind, "SELECT * FROM " + table.name, [&](const Statement& row) {
      rows.push_back(valuesOf(row));
      names = columnNamesOf(row);
    });
    if (rows.empty()) {
      continue;
    }
    const std::vector<Value>& row = rows[changer.below(rows.size())];
    std::vector<Value> values;
    std::string where;
    for (const SealRule& rule : kSealRules) {
      if (rule.table != table.name) {
        continue;
      }
      for (const std::string& key : columnsOf(rule.key)) {
        where += (where.empty() ? " WHERE " : " AND ") + key + " = ?";
        values.push_back(
            row[static_cast<std::size_t>(std::find(names.begin(), names.end(), key) - names.begin())]);
      }
    }
    const Value was =
        row[static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin())];
    values.insert(values.begin(), changer.other(was));
    try {
      behind.prepare("UPDATE " + table.name + " SET " + column + " = ?" + where).execute(values);
    } catch (const DbError&) {
      continue;  // the column's rules reject the value
    }
    ++made;
    bool found = false;
    try {
      found = findingsIn(behind) != before;
    } catch (const Error&) {
      found = true;                           // the record cannot be opened, with an explanation
    } catch (const std::exception& broken) {  // verification must not fail on tampered data
      missed.push_back(table.name + "." + column + ": " + broken.what());
      continue;
    }
    if (!found) {
      missed.push_back(table.name + "." + column);
    }
  }

  EXPECT_EQ(made, changesWanted());
  EXPECT_EQ(missed, std::vector<std::string>{});
  std::cout << made << " changes, " << made - static_cast<int>(missed.size()) << " found; " << leftOut.size()
            << " columns carry nothing by the rules\n";
}

/// Everything in a file: its schema and the hash of every table.
std::vector<std::string> contentOf(Connection& connection) {
  std::vector<std::string> content = selectAll(
      connection,
      "SELECT coalesce(type, '') || coalesce(name, '') || coalesce(sql, '') FROM sqlite_master ORDER BY 1",
      {}, readText);
  const Transaction look(connection, Transaction::Purpose::kReadOnly);
  for (SchemaTable& table : tablesInReferenceOrder(connection)) {
    std::erase_if(table.columns,
                  [&](const TableColumn& column) { return carriesNothing(table.name, column.name); });
    if (table.columns.empty()) {
      continue;
    }
    const TableDigest digest = digestOf(connection, table);
    content.push_back(digest.table + " " + std::to_string(digest.rows) + " " + digest.hash);
  }
  content.push_back(
      selectAll(connection, "SELECT name || checksum || compatible_from FROM schema_migration", {}, readText)
          .at(0));
  return content;
}

TEST_F(RandomTamper, EveryFlippedByteIsDetectedOrHarmless) {
  if (onPostgresql()) {
    GTEST_SKIP() << "the files of a server are not Torsio's";
  }
  {
    Connection connection = openWithSchema();
    const FullRecord real(connection, "real", false);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
    connection.executeVerbatim("PRAGMA page_size = 512");  // fewer empty bytes
    connection.executeVerbatim("VACUUM");
  }
  const std::string sound = readFile(locator());
  const std::string copy = locator() + ".flipped";
  std::vector<std::string> content;
  {
    Connection connection = openRecord(locator(), OpenMode::kReadOnly);
    content = contentOf(connection);
    ASSERT_TRUE(integrityFindings(connection).empty());
    ASSERT_EQ(allFindings(connection), std::vector<std::string>{});
  }
  Changer changer(7);
  int found = 0;
  int without = 0;
  for (int i = 0; i < changesWanted(); ++i) {
    std::string bytes = sound;
    std::size_t at = changer.below(bytes.size());
    for (int tries = 0; bytes[at] == 0 && tries < 200; ++tries) {  // most of a small file is empty
      at = changer.below(bytes.size());
    }
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << changer.below(8)));
    std::ofstream(copy, std::ios::binary) << bytes;
    bool tells = false;
    bool same = false;
    try {
      Connection connection = openRecord(copy, OpenMode::kReadOnly);
      tells = !integrityFindings(connection).empty() || !allFindings(connection).empty();
      same = !tells && contentOf(connection) == content;  // without schema differences
    } catch (const Error&) {
      tells = true;
    } catch (const std::exception& broken) {
      ADD_FAILURE() << "byte " << at << ": " << broken.what();
      continue;
    }
    found += tells ? 1 : 0;
    without += same ? 1 : 0;
    EXPECT_TRUE(tells || same) << "byte " << at << " of " << bytes.size() << ": "
                               << sound.substr(at - std::min<std::size_t>(at, 60), 120);
  }
  std::cout << found << " flipped bytes found, " << without << " without effect\n";
}

}  // namespace

}  // namespace torsio
