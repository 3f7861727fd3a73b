// SPDX-License-Identifier: GPL-3.0-or-later

#include "tests/db/test_database.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "db/connection/row_reader.h"
#include "db/migrations/migrations.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/system/audit_verification.h"
#include "tests/db/sample_record.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

std::string uniqueName() {
  std::string name = "t_" + SystemIdSource().newUuid();
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

const char* server() {
  return std::getenv("TORSIO_TEST_POSTGRES");
}

}  // namespace

TemporaryFolder::TemporaryFolder() : path_(fs::temp_directory_path() / ("torsio_" + uniqueName())) {
  fs::create_directories(path_);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::permissions(path_, fs::perms::owner_all, ignored);
  fs::remove_all(path_, ignored);
}

bool DatabaseTest::onPostgresql() {
  const char* engine = std::getenv("TORSIO_DB_TEST_ENGINE");
  return engine != nullptr && std::string(engine) == "postgresql";
}

void DatabaseTest::SetUp() {
  if (!onPostgresql()) {
    folder_.emplace();
    locator_ = (folder_->path() / "record.sqlite").string();
    return;
  }
  if (server() == nullptr) {
    GTEST_SKIP()
        << "no PostgreSQL server: export TORSIO_TEST_POSTGRES=$(tests/support/start-postgres.sh start)";
  }
  schema_ = uniqueName();
  locator_ = std::string(server()) + "?schema=" + schema_;
  openDatabase(server(), OpenMode::kReadWrite).executeVerbatim("CREATE SCHEMA " + schema_);
}

void DatabaseTest::TearDown() {
  connection_.reset();
  if (schema_.empty()) {
    return;
  }
  Connection connection = openDatabase(server(), OpenMode::kReadWrite);
  connection.executeVerbatim("SET client_min_messages = warning");
  connection.executeVerbatim("DROP SCHEMA " + schema_ + " CASCADE");
}

Connection DatabaseTest::open(int busyTimeout_ms) const {
  return openDatabase(locator_, OpenMode::kCreate, busyTimeout_ms);
}

Connection DatabaseTest::openWithSchema() const {
  return openRecord(locator_, OpenMode::kCreate, {.softwareVersion = "test"});
}

Connection& DatabaseTest::connection() {
  return connection_ ? *connection_ : connection_.emplace(openWithSchema());
}

std::int64_t numberFrom(Connection& connection, const std::string& sql) {
  Statement row = connection.prepare(sql);
  row.execute();
  return row.step() ? row.int64(0) : -1;
}

namespace {

using Key = std::pair<std::string, std::string>;  // table and row

bool comesWithTheSchema(std::string_view table) {
  return std::find(kGrowingSeeds.begin(), kGrowingSeeds.end(), table) != kGrowingSeeds.end();
}

/// The newest seals, without salts.
std::map<Key, RowSeal> newestSeals(Connection& connection) {
  std::map<Key, RowSeal> newest;
  forEachSeal(connection, [&](std::int64_t /*sequence*/, std::int64_t /*position*/, const RowSeal& seal) {
    newest[{seal.table, seal.key}] = seal;
  });
  return newest;
}

std::map<Key, std::string> saltsIn(Connection& connection) {
  std::map<Key, std::string> salts;
  forEachSelected(connection, "SELECT table_name, row_key, salt FROM seal_salt", [&](const Statement& row) {
    salts[{row.text(0), row.text(1)}] = row.text(2);
  });
  return salts;
}

/// Seals that the present rows need but do not have.
std::vector<RowSeal> missingSeals(Connection& connection) {
  std::map<Key, RowSeal> newest = newestSeals(connection);
  const std::map<Key, std::string> salts = saltsIn(connection);
  std::vector<RowSeal> missing;
  for (const SealRule& rule : kSealRules) {
    if (rule.sealing != Sealing::kOnce && rule.sealing != Sealing::kEachChange) {
      continue;
    }
    forEachSealable(connection, rule,
                    [&](const SealShape& shape, std::span<const Value> row, const std::string& hash) {
                      const Key key{std::string(rule.table), shape.keyOf(row)};
                      const auto sealed = newest.find(key);
                      const auto salt = salts.find(key);
                      const std::string personal =
                          shape.personal(row, salt == salts.end() ? std::string() : salt->second);
                      const bool fits = sealed != newest.end() && sealed->second.rowHash == hash &&
                                        sealed->second.personalHash == personal;
                      if (!fits && !comesWithTheSchema(rule.table)) {
                        missing.push_back(sealedRow(shape, row, hash));
                      }
                      if (sealed != newest.end()) {
                        newest.erase(sealed);
                      }
                    });
  }
  for (const auto& [key, seal] : newest) {
    if (!seal.removed) {
      missing.push_back({.table = seal.table, .key = seal.key, .removed = true});
    }
  }
  return missing;
}

}  // namespace

void disarm(Connection& connection) {
  if (connection.engine() == Engine::kPostgresql) {
    connection.executeVerbatim("SET session_replication_role = replica");
    return;
  }
  connection.executeVerbatim("PRAGMA foreign_keys = OFF");
  connection.executeVerbatim("PRAGMA ignore_check_constraints = ON");
  for (const std::string& trigger :
       selectAll(connection, "SELECT name FROM sqlite_master WHERE type = 'trigger'", {}, readText)) {
    connection.executeVerbatim("DROP TRIGGER \"" + trigger + "\"");
  }
}

std::vector<std::string> allFindings(Connection& connection) {
  std::vector<std::string> findings;
  for (const AuditFinding& finding : verifyAuditTrail(connection)) {
    findings.push_back(finding.objectKind + " " + finding.objectId + ": " + finding.what);
  }
  for (const SchemaFinding& finding : schemaFindings(connection)) {
    findings.push_back(finding.part + ": " + finding.what);
  }
  return findings;
}

void forgeSeals(Connection& connection, AuditAction action, AuditObject object, const std::string& objectId) {
  Transaction transaction(connection);
  const std::vector<RowSeal> seals = missingSeals(connection);
  AuditRepository(connection)
      .append({.atUtc_us = kSampleTime_us,
               .actor = "somebody",
               .station = "ward",
               .action = action,
               .objectKind = object,
               .objectId = objectId});
  writeSeals(connection, seals, {.atUtc_us = kSampleTime_us, .actor = "somebody", .entries = 1});
  transaction.commit();
}

void rewriteTrail(Connection& connection) {
  Transaction transaction(connection);
  for (const RowSeal& seal : missingSeals(connection)) {
    connection.execute(
        "UPDATE row_seal SET row_hash = ?, personal_hash = ?, removed = ? WHERE table_name = ? AND row_key = "
        "?",
        {seal.rowHash, seal.personalHash, seal.removed, seal.table, seal.key});
    connection.execute("UPDATE seal_salt SET salt = ? WHERE table_name = ? AND row_key = ?",
                       {seal.salt, seal.table, seal.key});
  }
  std::map<std::int64_t, SealDigest> digests;
  forEachSeal(connection, [&](std::int64_t sequence, std::int64_t position, const RowSeal& seal) {
    digests[sequence].add(position, seal);
  });
  std::vector<AuditEntry> entries;
  AuditRepository(connection).forEach([&](const AuditEntry& entry) { entries.push_back(entry); });
  std::string previous;
  for (AuditEntry& entry : entries) {
    if (const auto digest = digests.find(entry.sequence); digest != digests.end()) {
      entry.objectHash = digest->second.hex();
    }
    entry.previousHash = previous;
    entry.entryHash = auditHash(entry);
    previous = entry.entryHash;
    connection.execute(
        "UPDATE audit_entry SET object_hash = ?, previous_hash = ?, entry_hash = ? WHERE sequence = ?",
        {entry.objectHash, entry.previousHash, entry.entryHash, entry.sequence});
  }
  transaction.commit();
}

}  // namespace torsio
