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
#include <nlohmann/json.hpp>

#include "app/maintenance/anchor.h"
#include "assessment/people/account.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/demonstration_data.h"
#include "db/repository/system/setting_repository.h"
#include "sim/base/digest.h"
#include "tests/app/care/killed_program.h"
#include "tests/app/cli/program.h"
#include "tests/db/full_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using test::emptyFolder;
using test::killInstants;
using test::ProgramRun;
using test::runAndKill;
using test::runProgram;

constexpr int kInstants = 10;

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
  [[nodiscard]] ProgramRun run(const std::vector<std::string>& arguments,
                               const char* program = TORSIO_PROGRAM) const {
    return runProgram(program, lineOf(arguments), folder_);
  }
  /// Kills the command at instants over the time that it takes; `before` and `after` each of them. Then it
  /// must do its work, with the code 0.
  void killEverywhere(const std::vector<std::string>& arguments, const std::function<void()>& before,
                      const std::function<void()>& after, const char* program = TORSIO_PROGRAM,
                      int usually = kInstants) const {
    before();
    const auto begin = std::chrono::steady_clock::now();
    const ProgramRun first = run(arguments, program);
    ASSERT_EQ(first.code, 0) << first.err;
    const auto whole =
        std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
    after();
    const int kills = killInstants(usually);
    for (int i = 0; i < kills && !HasFailure(); ++i) {
      before();
      ASSERT_TRUE(runAndKill(arguments, whole * (i + 1) / kills, program));
      after();
      expectWholeRecord();
    }
    before();
    const ProgramRun last = run(arguments, program);
    EXPECT_EQ(last.code, 0) << "after the kills: " << last.err;
    after();
  }
  void emptySchema(const std::string& address) const {
    Connection server = open();
    const std::string schema = parseLocator(address).schema;
    server.executeVerbatim("SET client_min_messages = warning");
    server.executeVerbatim("DROP SCHEMA " + schema + " CASCADE");
    server.executeVerbatim("CREATE SCHEMA " + schema);
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
  EXPECT_EQ(run({"db", "backup", "--as-system", file("b.backup"), "--database", file("record.sqlite")}).code,
            0);
  EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, 1);
  expectNothingHalf();
}

TEST_F(KilledCare, ABackupThatIsReplacedIsTheOldOneOrTheNewOne) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server is backed up by its own tools";
  }
  makeRecord("other.sqlite", "other");
  ASSERT_EQ(run({"db", "backup", "--as-system", file("old.backup"), "--database", file("other.sqlite")}).code,
            0);
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
    emptySchema(target);
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
      EXPECT_TRUE(onPostgresql()) << "a file without a record";
      return;  // killed before the schema was made
    }
    EXPECT_TRUE(person.empty() || person.starts_with("real")) << person;
    EXPECT_TRUE(person.empty() || isSound(moved)) << "rows of a record that is not whole";
  });
  expectNothingHalf();
}

/// What only the window does, on a record of which everything is asked: on either engine, with an
/// administrator.
class KilledWindow : public KilledCare {
 protected:
  static constexpr const char* kPassword = "four walls and a lamp";

  void SetUp() override {
    if (onPostgresql() && std::getenv("TORSIO_KILL_INSTANTS") == nullptr) {
      GTEST_SKIP() << "makes a schema anew each time; TORSIO_KILL_INSTANTS says how often";
    }
    KilledCare::SetUp();
    if (!IsSkipped() && !onPostgresql()) {
      Connection made = openRecord(file("template.sqlite"), OpenMode::kCreate, {.softwareVersion = "test"});
      fill(made);
    }
  }
  static void fill(Connection& connection) {
    const FullRecord real(connection, "real", false);
    const FullRecord simulated(connection, "demo", true);
    connection.execute("INSERT INTO person_identity (person_id, full_name) VALUES (?, ?)",
                       {real.traineeId, "Li Na"});
    SettingRepository(connection).set("two_people", "no", 1);
    AccessRepository access(connection, PasswordCost::kTest);
    access.addUser({.id = "u-office", .login = "office", .roles = {"administrator"}}, kPassword);
    access.setPassword("u-office", access.sealPassword("office", kPassword), false);
  }
  [[nodiscard]] std::string target() const { return onPostgresql() ? locator() : file("care.sqlite"); }
  /// The record as it was.
  void makeAnew() const {
    if (!onPostgresql()) {
      removeDatabase(file("care.sqlite"));
      fs::copy_file(file("template.sqlite"), file("care.sqlite"));
      return;
    }
    emptySchema(locator());
    Connection connection = openWithSchema();
    fill(connection);
  }
  [[nodiscard]] std::vector<std::string> act(const std::string& name,
                                             const std::vector<std::string>& rest = {}) const {
    std::vector<std::string> words{name, target(), "office", kPassword};
    words.insert(words.end(), rest.begin(), rest.end());
    return words;
  }
  void killActEverywhere(
      const std::vector<std::string>& words, const std::function<void(Connection&)>& after,
      const std::function<void()>& before = [] {}) const {
    killEverywhere(
        words,
        [&] {
          makeAnew();
          before();
        },
        [&] {
          Connection record = openRecord(target(), OpenMode::kReadWrite);
          if (onPostgresql()) {  // what the killed program had sent comes to its end first
            const Transaction waits(record);
            record.executeVerbatim("LOCK TABLE person IN ACCESS EXCLUSIVE MODE");
          }
          EXPECT_TRUE(isSound(record));
          after(record);
        },
        TORSIO_WINDOW_ACT, 3);
  }
};

TEST_F(KilledWindow, APersonIsErasedWholeOrNot) {
  const std::string person = "real trainee";
  killActEverywhere(act("erase", {person}), [&person](Connection& record) {
    const auto number = [&](const std::string& sql) { return numberFrom(record, sql + "'" + person + "'"); };
    const std::int64_t erased = number("SELECT count(*) FROM person WHERE state = 'erased' AND id = ");
    EXPECT_EQ(number("SELECT count(*) FROM person WHERE id = "), 1);
    EXPECT_EQ(number("SELECT count(*) FROM person_identity WHERE person_id = "), 1 - erased);
    EXPECT_EQ(number("SELECT count(*) FROM erasure WHERE person_id = "), erased);
    EXPECT_EQ(number("SELECT count(*) FROM audit_entry WHERE action = 'person.erase' AND object_id = "),
              erased);
  });
}

TEST_F(KilledWindow, TheDemonstrationIsRemovedWholeOrNot) {
  std::int64_t real = 0;
  killActEverywhere(act("remove-demonstration"), [&real](Connection& record) {
    const auto people = [&](const char* which) {
      return numberFrom(record, std::string("SELECT count(*) FROM person WHERE demonstration = ") + which);
    };
    const std::int64_t removed =
        numberFrom(record, "SELECT count(*) FROM audit_entry WHERE action = 'demonstration.remove'");
    EXPECT_EQ(people("TRUE") == 0, removed == 1);
    real = real == 0 ? people("FALSE") : real;
    EXPECT_EQ(people("FALSE"), real);
  });
}

TEST_F(KilledWindow, APackageIsWholeOrNotThere) {
  if (onPostgresql()) {
    GTEST_SKIP() << "what it writes does not depend on the engine";
  }
  const fs::path package = folder_ / "package";
  killActEverywhere(
      act("package", {"real trainee", package.string()}),
      [&package](Connection& record) {
        if (!fs::exists(package)) {
          return;
        }
        for (const auto& one : nlohmann::json::parse(readFile(package / "manifest.json")).at("files")) {
          Digest digest;
          digest.update(std::string_view(readFile(package / one.at("file").get<std::string>())));
          EXPECT_EQ(digest.hex(), one.at("blake2b_256")) << one;
        }
        EXPECT_EQ(numberFrom(record, "SELECT count(*) FROM record_copy WHERE kind = 'package' AND place = '" +
                                         package.string() + "'"),
                  1);
      },
      [&package] { fs::remove_all(package); });
  expectNothingHalf();
}

TEST_F(KilledCare, AKeyIsWholeOrNotThereAndAWitnessKeepsWholeLines) {
  if (onPostgresql()) {
    GTEST_SKIP() << "what it writes does not depend on the engine";
  }
  killEverywhere(
      {"audit", "key", file("key")}, [this] { fs::remove(file("key")); },
      [this] {
        if (fs::exists(file("key"))) {
          EXPECT_EQ(publicAnchorKey(file("key")).size(), 64U);
        }
      },
      TORSIO_PROGRAM, 3);
  killEverywhere(
      {"audit", "head", "--key", file("key"), "--witness", file("heads"), "--database",
       file("record.sqlite")},
      [] {},
      [this] {
        if (fs::exists(file("heads"))) {
          EXPECT_TRUE(compareWithHeads(file("record.sqlite"), headsOf(file("heads")), {}).empty());
        }
      },
      TORSIO_PROGRAM, 3);
  expectNothingHalf();
}

TEST_F(KilledCare, ADemonstrationTakesThePlaceOfAnOlderOneWholeOrNot) {
  if (onPostgresql() || std::getenv("TORSIO_KILL_INSTANTS") == nullptr) {
    GTEST_SKIP() << "takes minutes; TORSIO_KILL_INSTANTS says how many";
  }
  const fs::path out = folder_ / "demonstration";
  ASSERT_EQ(run({"demo", "--out", out.string(), "--shorten", "600", "--seed", "7"}).code, 0);
  killEverywhere(
      {"demo", "--out", out.string(), "--shorten", "600", "--seed", "8"}, [] {},
      [&out] {
        Connection record = openRecord((out / "torsio.sqlite").string(), OpenMode::kReadWrite);
        EXPECT_TRUE(isSound(record));
        EXPECT_TRUE(holdsOnlySimulated(record));
      });
  for (const auto& entry : fs::directory_iterator(out)) {
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
  }
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
