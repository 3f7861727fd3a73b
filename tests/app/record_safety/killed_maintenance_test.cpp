// SPDX-License-Identifier: GPL-3.0-or-later
// Every maintenance command may be killed at any instant, and the disk may become full at any instant: the
// record stays sound, output is complete or missing, and the command works when repeated.
// TORSIO_KILL_INSTANTS and TORSIO_FULL_DISK_INSTANTS set the number of instants; a command has some hundreds.
#include "tests/app/record_safety/killed_maintenance.h"

#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/moved_record.h"
#include "app/services/maintenance/anchor.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/locator.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/demonstration_data.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/file_io.h"
#include "tests/db/sample_record.h"
#include "tests/support/compared_heads.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

class KilledMaintenance : public CutOffMaintenance {
 protected:
  /// Tests independent of the engine run once.
  void SetUp() override {
    if (onPostgresql() && !aboutServers()) {
      GTEST_SKIP() << "what it writes does not depend on the engine";
    }
    CutOffMaintenance::SetUp();
  }
  static bool aboutServers() {
    const std::string name = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    return name.find("CopyTo") != std::string::npos || name.find("Server") != std::string::npos ||
           name.find("NewRecord") != std::string::npos;
  }
  static void put(const std::string& from, const std::string& to) {
    removeDatabase(to);
    fs::copy_file(from, to);
  }
  void backUpOther() const {
    makeRecord("other.sqlite", "other");
    ASSERT_EQ(
        run({"db", "backup", "--as-system", file("old.backup"), "--database", file("other.sqlite")}).code, 0);
  }

  [[nodiscard]] CutOff backup() const {
    return {
        .arguments = {"db", "backup", "--as-system", file("b.backup"), "--database", file("record.sqlite")},
        .before = [this] { fs::remove(file("b.backup")); },
        .after =
            [this] {
              if (fs::exists(file("b.backup"))) {
                EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, embeddedMigrations().back().version);
              }
              expectWholeRecord();
            },
        .done = [this] { return fs::exists(file("b.backup")); }};
  }
  [[nodiscard]] CutOff replacingBackup() const {
    return {.arguments = {"db", "backup", "--as-system", "--replace", file("b.backup"), "--database",
                          file("record.sqlite")},
            .before =
                [this] {
                  fs::copy_file(file("old.backup"), file("b.backup"), fs::copy_options::overwrite_existing);
                },
            .after =
                [this] {
                  EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, embeddedMigrations().back().version);
                  Connection backup = openDatabase(file("b.backup"), OpenMode::kReadOnly);
                  const std::string person = personIn(backup);
                  EXPECT_TRUE(person.starts_with("real") || person.starts_with("other")) << person;
                  expectWholeRecord();
                }};
  }
  /// Counts copies before a restore that contain the original record.
  [[nodiscard]] int originalsBeside() const {
    int originals = 0;
    for (const auto& entry : fs::directory_iterator(folder_)) {
      const std::string name = entry.path().filename().string();
      if (name.find("kept-before-restore") == 0 && name.ends_with(".sqlite")) {
        Connection kept = openDatabase(entry.path().string(), OpenMode::kReadOnly);
        originals += personIn(kept).starts_with("real") ? 1 : 0;
      }
    }
    return originals;
  }
  [[nodiscard]] CutOff restore() const {
    return {.arguments = {"db", "restore", "--as-system", "--other-centre", file("old.backup"), "--database",
                          file("kept.sqlite")},
            .before =
                [this] {
                  for (const auto& entry : fs::directory_iterator(folder_)) {
                    if (entry.path().filename().string().find("kept") == 0) {
                      fs::remove(entry.path());
                    }
                  }
                  fs::copy_file(file("record.sqlite"), file("kept.sqlite"));
                },
            .after =
                [this] {
                  Connection record = openRecord(file("kept.sqlite"), OpenMode::kReadWrite);
                  EXPECT_TRUE(isSound(record));
                  const std::string person = personIn(record);
                  EXPECT_TRUE(person.starts_with("real") || person.starts_with("other")) << person;
                  EXPECT_TRUE(person.starts_with("real") || originalsBeside() > 0) << "the original is gone";
                }};
  }
  [[nodiscard]] std::string moveTarget() const {
    return onPostgresql() ? addressWithoutPassword() : file("moved.sqlite");
  }
  [[nodiscard]] CutOff move(const std::string& target) const {
    return {.arguments = {"db", "copy", "--as-system", file("record.sqlite"), target},
            .before =
                [this, target] {
                  Connection record = openRecord(file("record.sqlite"), OpenMode::kReadWrite);
                  SettingRepository(record).set("record.moved_to", "", kSampleTime_us);
                  SettingRepository(record).set("record.moving_to", "", kSampleTime_us);
                  if (onPostgresql()) {
                    emptySchema(target);
                  } else {
                    removeDatabase(target);
                  }
                },
            .after =
                [this, target] {
                  expectWholeRecord();
                  if (const std::string person = personAt(target); !person.empty()) {
                    EXPECT_TRUE(person.starts_with("real")) << person;
                    Connection moved = openDatabase(target, OpenMode::kReadWrite);
                    EXPECT_TRUE(isSound(moved)) << "rows of a record that is not whole";
                    EXPECT_TRUE(moveNotice(moved).empty());
                    Connection record = openDatabase(file("record.sqlite"), OpenMode::kReadWrite);
                    EXPECT_FALSE(moveNotice(record).empty()) << "two records live";
                  }
                }};
  }
  /// Returns empty if nothing was moved there. An SQLite target has no file then.
  [[nodiscard]] std::string personAt(const std::string& target) const {
    if (!onPostgresql() && !fs::exists(target)) {
      return {};
    }
    Connection moved = openDatabase(target, OpenMode::kReadWrite);
    try {
      return personIn(moved);
    } catch (const DbError&) {
      EXPECT_TRUE(onPostgresql()) << "a file without a record";
      return {};
    }
  }
  [[nodiscard]] CutOff firstRecord() const {
    const std::string fresh = onPostgresql() ? addressWithoutPassword() : file("fresh.sqlite");
    return {.arguments = {"record", "--duration", "1", "--database", fresh},
            .before =
                [this, fresh] {
                  if (onPostgresql()) {
                    emptySchema(fresh);
                  } else {
                    removeDatabase(fresh);
                  }
                },
            .after =
                [fresh] {
                  if (onPostgresql() || fs::exists(fresh)) {
                    Connection made = openDatabase(fresh, OpenMode::kReadWrite);
                    const std::int64_t version = checkSchema(made, embeddedMigrations()).version;
                    const std::int64_t newest = embeddedMigrations().back().version;
                    EXPECT_TRUE(version == newest || onPostgresql()) << version;
                    if (version > 0 && version < newest) {  // the next start goes on
                      migrate(made, embeddedMigrations(), {});
                    }
                    EXPECT_TRUE(version == 0 || isSound(made));
                  }
                }};
  }
  [[nodiscard]] CutOff firstKey() const {
    return {.arguments = {"audit", "key", file("key")},
            .before = [this] { fs::remove(file("key")); },
            .after =
                [this] {
                  if (fs::exists(file("key"))) {
                    EXPECT_EQ(publicAnchorKey(file("key")).size(), 64U);
                  }
                },
            .done = [this] { return fs::exists(file("key")); }};
  }
  [[nodiscard]] CutOff head() const {
    return {.arguments = {"audit", "head", "--key", file("key"), "--witness", file("heads"), "--database",
                          file("record.sqlite")},
            .after = [this] {
              if (fs::exists(file("heads"))) {
                EXPECT_TRUE(compareWithHeads(file("record.sqlite"), headsOf(file("heads")), {}).empty());
              }
            }};
  }
  /// Replaces the first key; the witness has one head signed by it.
  [[nodiscard]] CutOff replacedKey() const {
    return {.arguments = {"audit", "key", file("next"), "--replaces", file("key"), "--witness", file("heads"),
                          "--database", file("record.sqlite")},
            .before =
                [this] {
                  fs::remove(file("next"));
                  fs::copy_file(file("first-heads"), file("heads"), fs::copy_options::overwrite_existing);
                },
            .after =
                [this] {
                  const std::vector<std::string> lines = headsOf(file("heads"));
                  EXPECT_TRUE(
                      compareWithHeads(file("record.sqlite"), lines, publicAnchorKey(file("key"))).empty());
                  EXPECT_LE(lines.size(), 2U);
                }};
  }
};

TEST_F(KilledMaintenance, ABackupIsCompleteOrMissing) {
  killEverywhere(backup());
  fillDiskEverywhere(backup());
  expectNothingHalf();
}

TEST_F(KilledMaintenance, ALockWithoutAnOwnerIsNoObstacle) {
  std::ofstream(file("b.backup.part.lock")).close();
  std::ofstream(file("b.backup.part-journal")) << "half";
  EXPECT_EQ(run({"db", "backup", "--as-system", file("b.backup"), "--database", file("record.sqlite")}).code,
            0);
  EXPECT_EQ(checkBackup(file("b.backup")).schemaVersion, embeddedMigrations().back().version);
  expectNothingHalf();
}

TEST_F(KilledMaintenance, AReplacedBackupIsTheOldOneOrTheNewOne) {
  backUpOther();
  killEverywhere(replacingBackup());
  fillDiskEverywhere(replacingBackup());
  expectNothingHalf();
}

TEST_F(KilledMaintenance, ARestoreLeavesTheOldRecordOrTheNewOneAndKeepsTheOld) {
  backUpOther();
  killEverywhere(restore());
  fillDiskEverywhere(restore());
  expectNothingHalf();
}

TEST_F(KilledMaintenance, ACopyToAnotherDatabaseIsCompleteOrEmpty) {
  const std::string target = moveTarget();
  killEverywhere(move(target));
  if (!onPostgresql()) {
    fillDiskEverywhere(move(target));
  }
  expectNothingHalf();
}

TEST_F(KilledMaintenance, ANewRecordHasItsTablesOrDoesNotExist) {
  killEverywhere(firstRecord());
  if (!onPostgresql()) {
    fillDiskEverywhere(firstRecord());
  }
  expectNothingHalf();
}

TEST_F(KilledMaintenance, AKeyIsCompleteOrMissingAndAWitnessHasOnlyCompleteLines) {
  killEverywhere(firstKey());
  fillDiskEverywhere(firstKey());
  killEverywhere(head());
  fillDiskEverywhere(head());
  expectNothingHalf();
}

TEST_F(KilledMaintenance, AnInterruptedKeyReplacementIsResumed) {
  ASSERT_EQ(run({"audit", "key", file("key")}).code, 0);
  ASSERT_EQ(run({"audit", "head", "--key", file("key"), "--witness", file("first-heads"), "--database",
                 file("record.sqlite")})
                .code,
            0);
  killEverywhere(replacedKey());
  fillDiskEverywhere(replacedKey());
  expectNothingHalf();

  EXPECT_EQ(headsOf(file("heads")).size(), 2U);
  EXPECT_EQ(run(replacedKey().arguments).code, 0) << "what is done is done";
  EXPECT_EQ(headsOf(file("heads")).size(), 2U);
  EXPECT_TRUE(
      compareWithHeads(file("record.sqlite"), headsOf(file("heads")), publicAnchorKey(file("next"))).empty());
  fs::copy_file(file("key"), file("other"));
  EXPECT_EQ(
      run({"audit", "key", file("other"), "--replaces", file("next"), "--database", file("record.sqlite")})
          .code,
      static_cast<int>(ErrorCode::kFileUnwritable))
      << "a key that took nobody's place is not another's successor";
}

TEST_F(KilledMaintenance, ADemonstrationReplacesAnOlderOneCompletelyOrNotAtAll) {
  if (std::getenv("TORSIO_KILL_INSTANTS") == nullptr) {
    GTEST_SKIP() << "takes minutes; TORSIO_KILL_INSTANTS says how many";
  }
  const auto making = [](const fs::path& out, const char* seed) {
    return std::vector<std::string>{"demo", "--out", out.string(), "--shorten", "600", "--seed", seed};
  };
  const auto expectDemonstration = [](const fs::path& out) {
    Connection record = openRecord((out / "torsio.sqlite").string(), OpenMode::kReadWrite);
    EXPECT_TRUE(isSound(record));
    EXPECT_TRUE(holdsOnlySimulated(record));
  };
  const fs::path out = folder_ / "demonstration";
  const fs::path seen = folder_ / "seen";
  ASSERT_EQ(run(making(out, "7")).code, 0);
  CutOff cut{.arguments = making(out, "8"), .after = [&] { expectDemonstration(out); }, .atMost = 12};
  killEverywhere(cut);

  lookEverywhere(cut, [&] {
    fs::remove_all(seen);
    fs::copy(out, seen, fs::copy_options::recursive);
    expectDemonstration(seen);
  });

  ASSERT_EQ(run(making(seen, "9")).code, 0) << "over what a kill left";
  expectDemonstration(seen);
  for (const fs::path& folder : {out, seen}) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << entry.path();
    }
  }
}

TEST_F(KilledMaintenance, AWorkbookIsCompleteOrMissing) {
  const auto whole = [this] {
    const std::string book = file("book.xlsx");
    if (fs::exists(book)) {
      const std::string bytes = readFile(book);
      EXPECT_NE(bytes.find("PK\x05\x06"), std::string::npos) << "no end of the archive";
    }
    expectWholeRecord();
  };
  const CutOff cut{
      .arguments = {"export", "workbook", "--out", file("book.xlsx"), "--database", file("record.sqlite")},
      .before = [this] { fs::remove(file("book.xlsx")); },
      .after = whole};
  killEverywhere(cut);
  fillDiskEverywhere(cut);
  expectNothingHalf();
}

TEST_F(KilledMaintenance, ADataSetIsCompleteOrMissing) {
  const fs::path set = file("set");
  const auto whole = [&] {
    if (!fs::exists(set)) {
      return;
    }
    const nlohmann::json package = nlohmann::json::parse(readFile(set / "datapackage.json"));
    for (const auto& resource : package.at("resources")) {
      EXPECT_TRUE(fs::exists(set / resource.at("path").get<std::string>())) << resource;
    }
    EXPECT_TRUE(fs::exists(set / "README.md"));
  };
  const CutOff cut{.arguments = {"dataset", "export", "--title", "T", "--licence", "CC-BY-4.0", "--out",
                                 set.string(), "--database", file("record.sqlite")},
                   .before = [&set] { fs::remove_all(set); },
                   .after = whole,
                   .done = [&set] { return fs::exists(set); }};
  killEverywhere(cut);
  fillDiskEverywhere(cut);
  expectNothingHalf();
}

TEST_F(KilledMaintenance, TheRolesOfAServerAreWrittenCompletelyOrNotAtAll) {
  if (!onPostgresql()) {
    GTEST_SKIP() << "an SQLite file has no roles";
  }
  {
    Connection connection = openWithSchema();
    const FullRecord rows(connection, "real", false);
  }
  const std::string schema = parseLocator(locator()).schema;
  const std::string role = "station_" + schema.substr(schema.size() - 8);
  const CutOff cut{
      .arguments = {"db", "prepare-server", "--as-system", addressWithoutPassword(), "--station-role", role},
      .after = [this] {
        Connection record = openRecord(locator(), OpenMode::kReadWrite);
        EXPECT_TRUE(isSound(record));
      }};
  killEverywhere(cut);
  Connection connection = open();
  connection.executeVerbatim(  // of a version that kept another proof
      "INSERT INTO kiosk_code (id, user_id, code_hash, made_utc_us)"
      " SELECT 'old', MIN(user_id), 'proof', 1 FROM kiosk_code");
  EXPECT_NE(run(cut.arguments).out.find("1 kiosk card and 0 invitations of an earlier version"),
            std::string::npos);
  connection.executeVerbatim("DROP OWNED BY " + role);
  connection.executeVerbatim("DROP ROLE " + role);
}

}  // namespace
}  // namespace torsio
