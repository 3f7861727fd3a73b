// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/demonstration_data.h"

#include <algorithm>
#include <map>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/person_data.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/schema_tables.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/error.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"
#include "tests/support/stored_rows.h"

namespace torsio {
namespace {

class DemonstrationDataTest : public DatabaseTest {
 protected:
  static void remove(Connection& connection) {
    removeDemonstration(connection, "admin", "room 1", "the real course begins", kSampleTime_us);
  }
  /// Digests of the real rows of every table, without audit trail (which grows) and present states of
  /// stations.
  static std::vector<TableDigest> realRows(Connection& connection) {
    std::map<std::string, std::string> conditions;
    for (const DemonstrationRows& rows : demonstrationRows(connection)) {
      conditions[rows.table] = rows.condition;
    }
    Transaction transaction(connection);
    std::vector<TableDigest> digests;
    for (const SchemaTable& table : tablesInReferenceOrder(connection)) {
      if (table.name == "audit_entry" || table.name == "row_seal" || table.name == "seal_salt" ||
          table.name == "station_state") {
        continue;
      }
      const std::string& condition = conditions.at(table.name);
      digests.push_back(
          digestOf(connection, table, condition == "FALSE" ? "" : " WHERE NOT (" + condition + ")"));
    }
    return digests;
  }
};

TEST_F(DemonstrationDataTest, RemovesEverySimulatedRowAndNoRealOne) {
  const FullRecord real(connection(), "real", false);
  const FullRecord simulated(connection(), "demo", true);
  const std::vector<TableDigest> before = realRows(connection());
  const std::vector<AuditEntry> trail = AuditRepository(connection()).entries();
  std::int64_t simulatedRows = 0;
  for (const DemonstrationRows& rows : demonstrationRows(connection())) {
    EXPECT_TRUE(rows.rows > 0 || rows.condition == "FALSE") << rows.table << " has nothing to remove";
    simulatedRows += rows.rows;
  }

  const std::vector<DemonstrationRows> removed =
      removeDemonstration(connection(), "admin", "room 1", "the real course begins", kSampleTime_us);

  std::int64_t removedRows = 0;
  for (const DemonstrationRows& rows : removed) {
    removedRows += rows.rows;
  }
  EXPECT_EQ(removedRows, simulatedRows);
  for (const DemonstrationRows& rows : demonstrationRows(connection())) {
    EXPECT_EQ(rows.rows, 0) << rows.table;
  }
  for (const SchemaTable& table : tablesInReferenceOrder(connection())) {
    if (!table.has("demonstration")) {
      continue;
    }
    EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM " + table.name + " WHERE demonstration = TRUE"),
              0);
  }
  EXPECT_EQ(realRows(connection()), before);
  const std::vector<AuditEntry> after = AuditRepository(connection()).entries();
  ASSERT_GT(after.size(), trail.size());
  for (std::size_t i = 0; i < trail.size(); ++i) {
    EXPECT_EQ(after[after.size() - trail.size() + i].entryHash, trail[i].entryHash);
  }
}

TEST_F(DemonstrationDataTest, IsRecordedInTheAuditTrailWhichStillVerifies) {
  const FullRecord real(connection(), "real", false);
  const FullRecord simulated(connection(), "demo", true);

  remove(connection());

  AuditRepository audit(connection());
  const std::vector<AuditFinding> findings = verifyAuditTrail(connection());
  EXPECT_TRUE(findings.empty()) << findings.at(0).objectKind << ": " << findings.at(0).what;
  const AuditEntry last = audit.entries().at(0);
  EXPECT_EQ(last.action, storedText(AuditAction::kDemonstrationRemove));
  EXPECT_EQ(last.actor, "admin");
  EXPECT_EQ(last.station, "room 1");
  EXPECT_EQ(last.reason, "the real course begins");
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM erasure_gate"), 0);
  EXPECT_EQ(faultFrom([&] { connection().execute("DELETE FROM trial"); }), DbFault::kAppendOnly);
}

TEST_F(DemonstrationDataTest, ARemovedRealMarkIsStillDetected) {
  if (onPostgresql()) {
    GTEST_SKIP() << "the trigger is taken off in the words of SQLite";
  }
  const FullRecord real(connection(), "real", false);
  const FullRecord simulated(connection(), "demo", true);
  remove(connection());
  connection().executeVerbatim("PRAGMA foreign_keys = OFF");
  connection().executeVerbatim("DROP TRIGGER training_mark_no_DELETE");
  connection().executeVerbatim("DELETE FROM training_mark");

  const std::vector<AuditFinding> findings = verifyAuditTrail(connection());

  EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const AuditFinding& finding) {
    return finding.objectKind == "training_mark" && finding.what == "was recorded, but is missing";
  }));
}

TEST_F(DemonstrationDataTest, RemovesAnErasedSimulatedPersonToo) {
  SampleRecord sample(connection(), 2);
  erasePerson(connection(), sample.trainees[0].person.id, "admin", "tried out", kSampleTime_us);

  remove(connection());

  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM person"), 0);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM erasure"), 0);
}

TEST_F(DemonstrationDataTest, ClearsASimulatedTrialFromItsStation) {
  const FullRecord simulated(connection(), "demo", true);
  StationRepository(connection())
      .heartbeat({.station = "room 2", .trialId = simulated.trialId, .userId = "u"});

  remove(connection());

  EXPECT_EQ(stationOnBoard(connection(), "room 2")->trialId, "");
  EXPECT_EQ(stationOnBoard(connection(), "room 2")->userId, "u");
}

TEST_F(DemonstrationDataTest, IsRefusedWhileARealRowRefersToASimulatedOne) {
  const FullRecord simulated(connection(), "demo", true);
  connection().execute(
      "INSERT INTO app_user (id, login, person_id, password_hash, must_change_password, state, failed_count,"
      " locked_until_utc_us, created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
      {"u", "real user", simulated.raterId, "", false, "active", 0, 0, 0, false});
  const std::int64_t people = numberFrom(connection(), "SELECT count(*) FROM person");

  const Refusal refusal = refusalFrom([&] { remove(connection()); });

  EXPECT_EQ(refusal.code, ErrorCode::kBadData);
  EXPECT_NE(refusal.text.find("1 row refers from app_user to simulated rows of person"), std::string::npos)
      << refusal.text;
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM person"), people);
  EXPECT_EQ(numberFrom(connection(), "SELECT count(*) FROM erasure_gate"), 0);
}

}  // namespace
}  // namespace torsio
