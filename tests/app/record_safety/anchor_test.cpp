// SPDX-License-Identifier: GPL-3.0-or-later
// Heads of the audit trail stored elsewhere detect what no check of the file alone can detect.
#include "app/services/maintenance/anchor.h"

#include <sys/stat.h>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/error.h"
#include "tests/app/cli/program.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// A record, a key, and a witness with one signed head.
class Anchor : public ::testing::Test {
 protected:
  Anchor()
      : folder_(emptyFolder(std::string("anchor-") +
                            ::testing::UnitTest::GetInstance()->current_test_info()->name())) {
    Connection connection = openRecord(file("record.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(connection, "real", false);
    append(connection, "first");
    append(connection, "second");
  }
  void SetUp() override {
    ASSERT_EQ(run("audit key " + file("key")).code, 0);
    ASSERT_EQ(run("audit head" + database() + " --key " + file("key") + " --witness " + file("witness")).code,
              0);
  }

  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string database() const { return " --database " + file("record.sqlite"); }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const { return runTorsio(arguments, folder_); }
  [[nodiscard]] ProgramRun verified() const {
    return run("audit verify" + database() + " --witness " + file("witness") + " --key " + file("key"));
  }
  static void append(Connection& connection, const std::string& reason) {
    AuditRepository(connection)
        .append({.atUtc_us = kSampleTime_us,
                 .actor = "admin",
                 .station = "office",
                 .action = AuditAction::kPersonChange,
                 .objectKind = AuditObject::kPerson,
                 .objectId = "p",
                 .reason = reason});
  }
  /// Opens the record as an attacker with access to the file.
  [[nodiscard]] Connection pryOpen() const {
    Connection connection = openDatabase(file("record.sqlite"), OpenMode::kReadWrite);
    connection.executeVerbatim("DROP TRIGGER audit_entry_no_UPDATE");
    connection.executeVerbatim("DROP TRIGGER audit_entry_no_DELETE");
    return connection;
  }
  /// Restores the triggers, so that only the rows differ.
  static void close(Connection& connection) {
    for (const char* act : {"UPDATE", "DELETE"}) {
      connection.executeVerbatim(
          std::string("CREATE TRIGGER audit_entry_no_") + act + " BEFORE " + act +
          " ON audit_entry BEGIN SELECT RAISE(ABORT, 'append-only: audit_entry'); END");
    }
  }
  static constexpr int kVerifyFailed = static_cast<int>(ErrorCode::kVerifyFailed);

  fs::path folder_;
};

TEST_F(Anchor, ARecordThatOnlyGrewMatchesItsWitness) {
  {
    Connection connection = openRecord(file("record.sqlite"), OpenMode::kReadWrite);
    append(connection, "later");
  }

  const ProgramRun run = verified();

  EXPECT_EQ(run.code, 0) << run.out << run.err;
}

TEST_F(Anchor, ADeletedLatestEntryIsDetected) {
  {
    Connection connection = pryOpen();
    connection.executeVerbatim(
        "DELETE FROM audit_entry WHERE sequence = (SELECT max(sequence) FROM audit_entry)");
    close(connection);
  }

  EXPECT_EQ(run("audit verify" + database()).code, 0) << "the file alone tells nothing";
  const ProgramRun found = verified();
  EXPECT_EQ(found.code, kVerifyFailed);
  EXPECT_NE(found.out.find("it was truncated, or this is an older file"), std::string::npos) << found.out;
}

TEST_F(Anchor, ARewrittenChainIsDetected) {
  {
    Connection connection = pryOpen();
    std::string previous;
    for (AuditEntry entry : [&] {
           std::vector<AuditEntry> all;
           AuditRepository(connection).forEach([&all](const AuditEntry& one) { all.push_back(one); });
           return all;
         }()) {
      entry.reason += " (as somebody would like it)";
      entry.previousHash = previous;
      entry.entryHash = auditHash(entry);
      connection.execute(
          "UPDATE audit_entry SET reason = ?, previous_hash = ?, entry_hash = ? WHERE sequence = ?",
          {entry.reason, entry.previousHash, entry.entryHash, entry.sequence});
      previous = entry.entryHash;
    }
    close(connection);
  }

  EXPECT_EQ(run("audit verify" + database()).code, 0) << "the file alone tells nothing";
  const ProgramRun found = verified();
  EXPECT_EQ(found.code, kVerifyFailed);
  EXPECT_NE(found.out.find("the audit trail was rewritten"), std::string::npos) << found.out;
}

TEST_F(Anchor, AnOlderFileInTheRecordsPlaceIsDetected) {
  const ProgramRun backup = run("db backup --as-system " + file("older.sqlite") + database());
  ASSERT_EQ(backup.code, 0);
  EXPECT_NE(backup.out.find("torsio-head 1 "), std::string::npos) << "to be noted beside the backup";
  {
    Connection connection = openRecord(file("record.sqlite"), OpenMode::kReadWrite);
    append(connection, "something to forget");
  }
  const ProgramRun head = run("audit head" + database() + " --key " + file("key"));
  ASSERT_EQ(head.code, 0) << head.err;
  for (const char* part : {"", "-wal", "-shm"}) {
    fs::remove(file("record.sqlite") + part);
  }
  fs::copy_file(file("older.sqlite"), file("record.sqlite"));

  const ProgramRun found = run("audit verify" + database() + " --since '" +
                               head.out.substr(0, head.out.find('\n')) + "' --key " + file("key"));

  EXPECT_EQ(found.code, kVerifyFailed) << found.out << found.err;
}

TEST_F(Anchor, AWitnessSignedOrChangedBySomebodyElseIsDetected) {
  ASSERT_EQ(run("audit key " + file("other")).code, 0);
  ASSERT_EQ(run("audit head" + database() + " --key " + file("other") + " --witness " + file("forged")).code,
            0);
  std::string changed = readFile(file("witness"));
  changed.replace(changed.find(" 1 ") + 3, 1, "9");
  writeFileAtomically(file("changed"), changed);

  for (const char* witness : {"forged", "changed"}) {
    const ProgramRun found =
        run("audit verify" + database() + " --witness " + file(witness) + " --key " + file("key"));
    EXPECT_EQ(found.code, kVerifyFailed) << witness << found.out;
  }
}

TEST_F(Anchor, AReplacedKeyIsValidOnlyForItsPeriod) {
  const ProgramRun replaced = run("audit key " + file("new") + " --replaces " + file("key") + database() +
                                  " --witness " + file("witness"));
  ASSERT_EQ(replaced.code, 0) << replaced.err;
  {
    Connection connection = openRecord(file("record.sqlite"), OpenMode::kReadWrite);
    append(connection, "later");
  }
  ASSERT_EQ(run("audit head" + database() + " --key " + file("new") + " --witness " + file("witness")).code,
            0);
  const auto code = [this](const std::string& witness, const std::string& key) {
    return run("audit verify" + database() + " --witness " + file(witness) + " --key " + file(key)).code;
  };

  EXPECT_EQ(code("witness", "new"), 0) << "the new key vouches for the older one";
  EXPECT_EQ(code("witness", "key"), 0) << "the older key named its successor";
  EXPECT_EQ(run("audit verify" + database() + " --witness " + file("witness")).code, 0);

  const std::string witness = readFile(file("witness"));
  writeFileAtomically(file("late"), witness + run("audit head" + database() + " --key " + file("key")).out);
  EXPECT_EQ(code("late", "new"), kVerifyFailed) << "the older key signed after it was replaced";

  std::string forged = witness;
  const std::size_t line = forged.find("torsio-key 1 ");
  ASSERT_NE(line, std::string::npos);
  forged[forged.find('\n', line) - 1] = forged[forged.find('\n', line) - 1] == '0' ? '1' : '0';
  writeFileAtomically(file("forged"), forged);
  EXPECT_EQ(code("forged", "new"), kVerifyFailed);
}

TEST_F(Anchor, HeadsFromBeforeTheFirstKeyCountWithALaterSignedOne) {
  ASSERT_EQ(run("audit head" + database() + " --witness " + file("mixed")).code, 0);
  const std::string verify =
      "audit verify" + database() + " --witness " + file("mixed") + " --key " + file("key");
  EXPECT_EQ(run(verify).code, kVerifyFailed) << "nobody signed anything";

  ASSERT_EQ(run("audit head" + database() + " --witness " + file("mixed") + " --key " + file("key")).code, 0);

  EXPECT_EQ(run(verify).code, 0);
}

TEST_F(Anchor, ATruncatedLineIsNoHeadAndDoesNotAffectOthers) {
  const std::string whole = readFile(file("witness"));
  const std::string head = whole.substr(0, whole.size() - 1);
  for (const std::size_t kept : {std::size_t{1}, std::size_t{12}, head.size() / 2, head.size() - 1}) {
    writeFileAtomically(file("witness"), whole + head.substr(0, kept));
    EXPECT_EQ(headsOf(file("witness")), std::vector<std::string>{head}) << kept;
    appendToWitness(file("witness"), head);
    EXPECT_EQ(readFile(file("witness")), whole + whole) << kept;
  }
  writeFileAtomically(file("witness"), head);
  appendToWitness(file("witness"), head);
  EXPECT_EQ(readFile(file("witness")), whole + whole) << "a whole line without its end stays";
  writeFileAtomically(file("notes"), "a text of somebody");
  EXPECT_THROW(appendToWitness(file("notes"), head), Error);
  EXPECT_EQ(readFile(file("notes")), "a text of somebody");
}

TEST_F(Anchor, AWitnessThatNeverEndsIsRefusedAtOnce) {
  ASSERT_EQ(mkfifo(file("pipe").c_str(), 0600), 0);
  for (const std::string& endless : {file("pipe"), std::string("/dev/zero"), folder_.string()}) {
    const ProgramRun read = runTorsio("audit verify" + database() + " --witness " + endless, folder_,
                                      "timeout 30 prlimit --as=4000000000");
    EXPECT_EQ(read.code, static_cast<int>(ErrorCode::kFileUnreadable)) << endless << read.err;
    const ProgramRun key =
        runTorsio("audit verify" + database() + " --witness " + file("witness") + " --key " + endless,
                  folder_, "timeout 30 prlimit --as=4000000000");
    EXPECT_EQ(key.code, static_cast<int>(ErrorCode::kFileUnreadable)) << endless << key.err;
  }
  const ProgramRun table = runTorsio("compare-groups /dev/zero", folder_, "timeout 60");
  EXPECT_EQ(table.code, static_cast<int>(ErrorCode::kFileUnreadable)) << table.err;
}

TEST_F(Anchor, HeadsAreWrittenOnlyToAFileOfHeads) {
  const std::string letter = "Dear colleague,\nthis is no witness.\n";
  writeFileAtomically(file("letter"), letter);
  fs::create_symlink(file("letter"), file("link"));
  fs::create_symlink(file("nothing yet"), file("dangling"));
  fs::create_symlink(file("witness"), file("to the witness"));
  for (const char* name : {"letter", "link", "dangling", "to the witness"}) {
    const ProgramRun refused = run("audit head" + database() + " --witness '" + file(name) + "'");
    EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kFileUnwritable)) << name << refused.err;
  }
  EXPECT_EQ(readFile(file("letter")), letter);
  EXPECT_FALSE(fs::exists(file("nothing yet")));

  writeFileAtomically(file("empty"), "");
  writeFileAtomically(file("killed"), "torsio-head 1 2 ab");
  for (const char* name : {"empty", "killed", "new", "witness"}) {
    const ProgramRun written = run("audit head" + database() + " --witness " + file(name));
    EXPECT_EQ(written.code, 0) << name << written.err;
  }
  EXPECT_EQ(run("audit verify" + database() + " --witness " + file("killed")).code, 0);
}

TEST_F(Anchor, TheKeyIsReadableOnlyByItsOwnerAndNeverOverwritten) {
  const std::string key = readFile(file("key"));
  EXPECT_EQ(fs::status(file("key")).permissions(), fs::perms::owner_read | fs::perms::owner_write);

  EXPECT_EQ(run("audit key " + file("key")).code, static_cast<int>(ErrorCode::kFileUnwritable));
  EXPECT_EQ(readFile(file("key")), key);
  fs::permissions(file("key"), fs::perms::others_read, fs::perm_options::add);
  EXPECT_EQ(run("audit head" + database() + " --key " + file("key")).code,
            static_cast<int>(ErrorCode::kPermission));
}

}  // namespace
}  // namespace torsio
