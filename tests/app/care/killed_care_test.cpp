// SPDX-License-Identifier: GPL-3.0-or-later
// Every care command may be killed at any instant: the record stays whole, what it writes is whole or not
// there, and the same command does its work afterwards. TORSIO_KILL_INSTANTS says at how many instants.
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/audit_verification.h"
#include "tests/app/care/killed_program.h"
#include "tests/app/cli/program.h"
#include "tests/db/full_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using test::emptyFolder;
using test::killInstants;
using test::runAndKill;
using test::runTorsio;

std::string personIn(Connection& connection) {
  Statement row = connection.prepare("SELECT min(id) FROM person");
  row.execute();
  return row.step() ? row.text(0) : "";
}

bool isSound(Connection& connection) {
  return integrityFindings(connection).empty() && verifyAuditTrail(connection).empty();
}

/// A record in a file, and on the other engine a schema of its own to copy into.
class KilledCare : public DatabaseTest {
 protected:
  void SetUp() override {
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    folder_ =
        emptyFolder(std::string("killed-") + ::testing::UnitTest::GetInstance()->current_test_info()->name() +
                    (onPostgresql() ? "-server" : ""));
    makeRecord("record.sqlite", "real");
  }
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  void makeRecord(const std::string& name, const std::string& prefix) const {
    Connection connection = openRecord(file(name), OpenMode::kCreate, {.softwareVersion = "test"});
    const FullRecord rows(connection, prefix, false);
  }
  static std::string lineOf(const std::vector<std::string>& arguments) {
    std::string line;
    for (const std::string& argument : arguments) {
      line += " '" + argument + "'";
    }
    return line;
  }
  [[nodiscard]] int run(const std::vector<std::string>& arguments) const {
    return runTorsio(lineOf(arguments), folder_).code;
  }
  /// Kills the command at instants over the time that it takes; `before` and `after` each of them. Then it
  /// must do its work, with the code 0.
  void killEverywhere(const std::vector<std::string>& arguments, const std::function<void()>& before,
                      const std::function<void()>& after) const {
    before();
    const auto begin = std::chrono::steady_clock::now();
    ASSERT_EQ(run(arguments), 0) << runTorsio(lineOf(arguments), folder_).err;
    const auto whole =
        std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
    after();
    const int kills = killInstants(10);
    for (int i = 0; i < kills && !HasFailure(); ++i) {
      before();
      ASSERT_TRUE(runAndKill(arguments, whole * (i + 1) / kills));
      after();
      expectWholeRecord();
    }
    before();
    EXPECT_EQ(run(arguments), 0) << "after the kills";
    after();
  }
  /// The address of the server as it may stand on a command line; the password goes to a file of its own.
  [[nodiscard]] std::string addressWithoutPassword() const {
    Locator server = parseLocator(locator());
    std::ofstream(file("pgpass")) << server.host << ":" << server.port << ":*:" << server.user << ":"
                                  << server.password << "\n";
    fs::permissions(file("pgpass"), fs::perms::owner_read | fs::perms::owner_write);
    setenv("PGPASSFILE", file("pgpass").c_str(), 1);
    server.password.clear();
    return addressOf(server);
  }
  void expectWholeRecord() const {
    Connection record = openRecord(file("record.sqlite"), OpenMode::kReadWrite);
    EXPECT_TRUE(isSound(record));
    EXPECT_TRUE(personIn(record).starts_with("real"));
  }
  /// What a killed program leaves is swept by the next one.
  void expectNothingHalf() const {
    for (const auto& entry : fs::directory_iterator(folder_)) {
      EXPECT_EQ(entry.path().filename().string().find(".part"), std::string::npos) << entry.path();
    }
  }

  fs::path folder_;
};

TEST_F(KilledCare, ABackupIsWholeOrNotThere) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server is backed up by its own tools";
  }
  killEverywhere(
      {"db", "backup", "--as-system", file("b.backup"), "--database", file("record.sqlite")},
      [this] { fs::remove(file("b.backup")); },
      [this] {
        if (fs::exists(file("b.backup"))) {
          EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, 1);
        }
      });
  expectNothingHalf();
}

TEST_F(KilledCare, ALockThatNamesNobodyIsNoObstacle) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server is backed up by its own tools";
  }
  std::ofstream(file("b.backup.part.lock")).close();
  std::ofstream(file("b.backup.part-journal")) << "half";
  EXPECT_EQ(run({"db", "backup", "--as-system", file("b.backup"), "--database", file("record.sqlite")}), 0);
  EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, 1);
  expectNothingHalf();
}

TEST_F(KilledCare, ABackupThatIsReplacedIsTheOldOneOrTheNewOne) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server is backed up by its own tools";
  }
  makeRecord("other.sqlite", "other");
  ASSERT_EQ(run({"db", "backup", "--as-system", file("old.backup"), "--database", file("other.sqlite")}), 0);
  killEverywhere(
      {"db", "backup", "--as-system", "--replace", file("b.backup"), "--database", file("record.sqlite")},
      [this] { fs::copy_file(file("old.backup"), file("b.backup"), fs::copy_options::overwrite_existing); },
      [this] {
        EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, 1);
        Connection backup = openDatabase(file("b.backup"), OpenMode::kReadOnly);
        const std::string person = personIn(backup);
        EXPECT_TRUE(person.starts_with("real") || person.starts_with("other")) << person;
      });
  expectNothingHalf();
}

TEST_F(KilledCare, AMoveToAnotherDatabaseIsWholeOrEmpty) {
  const std::string target = onPostgresql() ? addressWithoutPassword() : file("moved.sqlite");
  const auto clear = [this, &target] {
    if (!onPostgresql()) {
      for (const char* part : {"", "-wal", "-shm", "-journal"}) {
        fs::remove(target + part);
      }
      return;
    }
    Connection server = open();
    const std::string schema = parseLocator(target).schema;
    server.executeVerbatim("SET client_min_messages = warning");
    server.executeVerbatim("DROP SCHEMA " + schema + " CASCADE");
    server.executeVerbatim("CREATE SCHEMA " + schema);
  };
  killEverywhere({"db", "copy", "--as-system", file("record.sqlite"), target}, clear, [this, &target] {
    if (!onPostgresql() && !fs::exists(target)) {
      return;
    }
    Connection moved = openDatabase(target, OpenMode::kReadWrite);
    std::string person;
    try {
      person = personIn(moved);
    } catch (const DbError&) {
      return;  // killed before the schema was made
    }
    EXPECT_TRUE(person.empty() || person.starts_with("real")) << person;
    EXPECT_TRUE(person.empty() || isSound(moved)) << "rows of a record that is not whole";
  });
}

TEST_F(KilledCare, TheRolesOfAServerAreWrittenWholeOrNot) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "an SQLite file has no roles";
  }
  {
    Connection connection = openWithSchema();
    const FullRecord rows(connection, "real", false);
  }
  const std::string schema = parseLocator(locator()).schema;
  const std::string role = "station_" + schema.substr(schema.size() - 8);
  killEverywhere(
      {"db", "prepare-server", "--as-system", addressWithoutPassword(), "--station-role", role}, [] {},
      [this] {
        Connection record = openRecord(locator(), OpenMode::kReadWrite);
        EXPECT_TRUE(isSound(record));
      });
  Connection connection = open();
  connection.executeVerbatim("DROP OWNED BY " + role);
  connection.executeVerbatim("DROP ROLE " + role);
}

}  // namespace
}  // namespace torsio
