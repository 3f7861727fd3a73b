// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <chrono>
#include <fstream>
#include <functional>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/moved_record.h"
#include "app/services/access/station_name.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/interrupted_move.h"
#include "app/services/maintenance/kept_backups.h"
#include "app/services/maintenance/maintenance_desk.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/maintenance/record_restore.h"
#include "app/services/maintenance/retention.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/people/retention.h"
#include "assessment/domain/study/station_state.h"
#include "db/connection/connection.h"
#include "db/migrations/backup.h"
#include "db/migrations/file_in_the_making.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/system/setting_repository.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "sim/record/content_hash.h"
#include "sim/record/trial_file.h"
#include "tests/app/support/audit_entries.h"
#include "tests/db/sample_record.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// A record with real and simulated rows in every table, with an administrator signed in.
class MaintenanceTest : public ::testing::Test {
 protected:
  MaintenanceTest()
      : database_((folder_.path() / "record.sqlite").string()),
        connection_(openRecord(database_, OpenMode::kCreate, {.softwareVersion = "test"})),
        real_(connection_, "real", false),
        simulated_(connection_, "demo", true) {
    for (const std::string role : {"trainee", "rater", "administrator", "allocator", "statistician"}) {
      connection_.execute(
          "INSERT INTO app_user (id, login, password_hash, must_change_password, state, failed_count,"
          " locked_until_utc_us, created_utc_us, demonstration) VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)",
          {"u-" + role, role, "", false, "active", 0, 0, kSampleTime_us, false});
      connection_.execute("INSERT INTO user_role (user_id, role_code) VALUES (?, ?)", {"u-" + role, role});
    }
    SettingRepository(connection_).set("two_people", "no", kSampleTime_us);  // one administrator may do
                                                                             // everything
  }

  SessionContext sessionOf(const std::string& role) {
    Actor actor{.userId = "u-" + role, .login = role};
    actor.roles = {role};
    return {connection_, ids_, {database_, "room 1", actor}, [this] { return now_us_; }};
  }
  [[nodiscard]] fs::path in(const std::string& name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
  std::string database_;
  Connection connection_;
  SeededIdSource ids_{7};
  FullRecord real_;
  FullRecord simulated_;
  std::int64_t now_us_ = kSampleTime_us;
};

TEST_F(MaintenanceTest, OnlyTheAdministratorMayDoAnyOfIt) {
  for (const char* role : {"trainee", "rater", "allocator", "statistician"}) {
    SessionContext session = sessionOf(role);
    const auto refused = [&](auto&& act) {
      EXPECT_EQ(refusalFrom(act).code, ErrorCode::kPermission) << role;
    };
    refused([&] { backUpDatabase(session, in("b.sqlite")); });
    refused([&] { (void)checkDatabase(session); });
    refused([&] { (void)retentionQueue(session); });
    refused([&] { setRetentionRule(session, kRetainLeft, 30, "law"); });
    refused([&] { lockRecords(session, std::array{PersonId(real_.traineeId)}, "why"); });
    refused([&] { (void)eraseDue(session, {}, "why", false); });
    refused([&] { (void)demonstrationSize(session); });
    refused([&] { removeDemonstrationData(session, "why"); });
    refused([&] { exportPersonPackage(session, real_.traineeId, in("p"), "asked"); });
    refused([&] { erasePersonRecord(session, real_.traineeId, "asked"); });
  }
  EXPECT_FALSE(fs::exists(in("b.sqlite")));
  EXPECT_FALSE(fs::exists(in("p")));
}

TEST_F(MaintenanceTest, AnEraseCanNameEveryCopyThatStillHoldsThePerson) {
  SessionContext office = sessionOf("administrator");
  backUpDatabase(office, in("backup.sqlite"));
  exportPersonPackage(office, real_.traineeId, in("package"), "asked");
  exportPersonPackage(office, simulated_.traineeId, in("other"), "asked");
  SettingRepository(connection_).set("copy_keep_days", "10", now_us_);
  const auto places = [&] {
    std::set<std::string> found;
    for (const ListedCopy& listed : copiesHolding(office, real_.traineeId)) {
      EXPECT_EQ(listed.dueUtc_us, now_us_ + 10 * std::int64_t{86'400'000'000});
      EXPECT_EQ(listed.copy.station, stationName());
      found.insert(listed.copy.place);
    }
    return found;
  };

  EXPECT_EQ(places(), (std::set<std::string>{in("backup.sqlite").string(), in("package").string()}));
  fs::remove(in("backup.sqlite"));
  EXPECT_EQ(places(), std::set<std::string>{in("package").string()});
  EXPECT_EQ(readFile(in("package") / "manifest.json").find("\"entries\": 0"), std::string::npos);
  EXPECT_TRUE(verifyAuditTrail(connection_).empty());
}

TEST_F(MaintenanceTest, AnEraseNamesTheFilesThatKilledRestoresPutAside) {
  SessionContext office = sessionOf("administrator");
  fs::copy_file(in("record.sqlite"), in("record.sqlite.before-restore-3"));

  std::vector<std::string> places;
  for (const ListedCopy& listed : copiesHolding(office, real_.traineeId)) {
    places.push_back(listed.copy.place);
  }

  EXPECT_EQ(places, std::vector<std::string>{in("record.sqlite.before-restore-3").string()});
  fs::remove(in("record.sqlite.before-restore-3"));
  EXPECT_TRUE(copiesHolding(office, real_.traineeId).empty());
}

TEST_F(MaintenanceTest, AMovedRecordTakesNothingNewUntilTheMoveIsTakenBack) {
  SessionContext office = sessionOf("administrator");
  SessionContext rater = sessionOf("rater");
  const auto adds = [&] { office.require(Operation::kPersonEdit); };
  const auto marks = [&] { rater.require(Operation::kMarkSubmit); };
  noteMoving(office, "postgresql://server/torsio");
  noteMoved(office);

  for (const std::function<void()>& act : {std::function<void()>(adds), std::function<void()>(marks)}) {
    const auto refused = refusalFrom(act);
    EXPECT_EQ(refused.code, ErrorCode::kDatabase);
    EXPECT_NE(refused.text.find("this record has moved to postgresql://server:5432/torsio"),
              std::string::npos)
        << refused.text;
  }
  EXPECT_NO_THROW(office.require(Operation::kPersonViewCoded));
  EXPECT_NO_THROW(office.require(Operation::kAuditView));
  EXPECT_THROW((void)copyDatabase(office, in("second.sqlite").string()), Error);

  EXPECT_THROW(takeBackMove(office, ""), Error);
  EXPECT_THROW(takeBackMove(rater, "mine"), Error);
  takeBackMove(office, "a rehearsal");
  EXPECT_NO_THROW(adds());
  EXPECT_NO_THROW(marks());
  EXPECT_THROW(takeBackMove(office, "again"), Error);
  EXPECT_TRUE(verifyAuditTrail(connection_).empty());
}

TEST_F(MaintenanceTest, OnlyOneOfTwoRecordsLivesWhereverAMoveIsInterrupted) {
  SessionContext office = sessionOf("administrator");
  const std::string target = in("moved.sqlite").string();
  const auto adds = [](SessionContext& session) { session.require(Operation::kPersonEdit); };
  // Right before copying.
  {
    Transaction transaction(connection_);
    office.note(AuditAction::kDatabaseMove, AuditObject::kDatabase, target);
    noteMoving(office, target);
    transaction.commit();
  }
  EXPECT_EQ(refusalFrom([&] { adds(office); }).code, ErrorCode::kDatabase);
  EXPECT_FALSE(moveNotice(connection_).empty());
  EXPECT_FALSE(settleMove(office).empty());  // there is nothing: undone
  EXPECT_NO_THROW(adds(office));
  EXPECT_TRUE(moveNotice(connection_).empty());

  // Right after copying: the copy lives, the source does not.
  (void)copyDatabase(office, target, {}, CopyUse::kMove);
  EXPECT_EQ(refusalFrom([&] { adds(office); }).code, ErrorCode::kDatabase);
  {
    Connection there = openRecord(target, OpenMode::kReadWrite);
    EXPECT_TRUE(moveNotice(there).empty());
    SessionContext theirs(there, office.ids(), office.key(), [&office] { return office.now_us(); });
    EXPECT_NO_THROW(adds(theirs));
    EXPECT_TRUE(verifyAuditTrail(there).empty());
  }
  EXPECT_FALSE(settleMove(office).empty());
  EXPECT_EQ(movedTo(connection_), target);
  EXPECT_TRUE(settleMove(office).empty());
  EXPECT_NE(moveNotice(connection_).str().find("has moved to"), std::string::npos);
  EXPECT_TRUE(verifyAuditTrail(connection_).empty());
}

TEST_F(MaintenanceTest, ACopyThatIsStillWrittenIsWaitedFor) {
  SessionContext office = sessionOf("administrator");
  const std::string target = in("moved.sqlite").string();
  const FileInTheMaking making(target);
  noteMoving(office, target);

  EXPECT_TRUE(settleMove(office).empty());

  EXPECT_FALSE(moveNotice(connection_).empty());
}

TEST_F(MaintenanceTest, ABackupContainsItsAuditEntryAndPassesItsTestRestore) {
  SessionContext office = sessionOf("administrator");

  const BackupContent content = backUpDatabase(office, in("backup.sqlite"));

  EXPECT_EQ(content.trials, 2);
  EXPECT_EQ(content.marks, 4);
  const std::string before = readFile(in("backup.sqlite"));
  const BackupCheck check = verifyBackup(in("backup.sqlite"));
  EXPECT_TRUE(check.database.sound());
  EXPECT_EQ(readFile(in("backup.sqlite")), before);
  Connection copy = openDatabase(in("backup.sqlite").string(), OpenMode::kReadOnly);
  EXPECT_EQ(AuditRepository(copy).entries().at(0).action, "database.backup");
  EXPECT_TRUE(checkDatabase(office).sound());
}

TEST(RestoreWish, TheSecondPersonReadsWhoseBackupReplacesWhoseRecord) {
  RestorePlan plan{.backup = "/srv/b.sqlite",
                   .backupHash = "h",
                   .presentCentre = "City hospital",
                   .backupCentre = "Harbour clinic"};
  EXPECT_EQ(wishFor(plan, "why").shown, "b.sqlite");
  plan.otherCentre = true;
  EXPECT_EQ(wishFor(plan, "why").shown, "b.sqlite \xC2\xB7 Harbour clinic \xE2\x86\x92 City hospital");
}

TEST(KeptBackups, TheNewestOfEachDayWeekAndMonthStay) {
  using namespace std::chrono;
  const sys_days last = sys_days(2026y / November / 30);  // a Monday
  std::vector<std::int64_t> made_us;
  std::vector<sys_days> days;
  for (int back = 0; back < 500; ++back) {
    for (const auto time : {hours(1), hours(13)}) {
      days.push_back(last - std::chrono::days(back));
      made_us.push_back(duration_cast<microseconds>((days.back() + time).time_since_epoch()).count());
    }
  }
  const std::vector<std::size_t> gone = outdated({.days = 7, .weeks = 5, .months = 12}, made_us);
  std::set<sys_days> kept;
  for (std::size_t i = 0; i < made_us.size(); ++i) {
    if (std::find(gone.begin(), gone.end(), i) == gone.end()) {
      EXPECT_EQ(i % 2, 1U) << "of a day, the later one";
      kept.insert(days[i]);
    }
  }
  std::set<sys_days> wanted;
  for (int back = 0; back < 7; ++back) {
    wanted.insert(last - std::chrono::days(back));
  }
  for (const sys_days sunday :
       {2026y / November / 29, 2026y / November / 22, 2026y / November / 15, 2026y / November / 8}) {
    wanted.insert(sunday);  // and this Monday, the newest of its week
  }
  for (int back = 1; back < 12; ++back) {
    const year_month month = 2026y / November - months(back);
    wanted.insert(sys_days(month / std::chrono::last));
  }
  EXPECT_EQ(kept, wanted);
}

TEST(KeptBackups, TheNewestStaysWhateverTheRuleAndTheOrder) {
  std::mt19937 random(7);
  for (int round = 0; round < 200; ++round) {
    std::vector<std::int64_t> made_us;
    for (int i = 0; i < 1 + round % 40; ++i) {
      made_us.push_back(static_cast<std::int64_t>(random()) * 30'000);
    }
    const KeepRule rule{.days = 1 + static_cast<int>(random() % 3),
                        .weeks = static_cast<int>(random() % 3),
                        .months = static_cast<int>(random() % 3)};
    const std::vector<std::size_t> gone = outdated(rule, made_us);
    const auto newest =
        static_cast<std::size_t>(std::max_element(made_us.begin(), made_us.end()) - made_us.begin());
    EXPECT_EQ(std::count(gone.begin(), gone.end(), newest), 0);
    EXPECT_LE(made_us.size() - gone.size(), static_cast<std::size_t>(rule.days + rule.weeks + rule.months));
  }
}

TEST_F(MaintenanceTest, ARestoreStatesWhatWillBeLostBeforeAnythingIsDone) {
  SessionContext office = sessionOf("administrator");
  backUpDatabase(office, in("backup.sqlite"));
  const FullRecord later(connection_, "later", false);

  const RestorePlan plan = planRestore(office, in("backup.sqlite"));

  EXPECT_EQ(plan.present.trials, plan.restored.trials + 1);
  EXPECT_EQ(plan.lostTrials, 1);
  EXPECT_EQ(plan.lostMarks, 2);  // one of a training study, one of an evaluation
  EXPECT_EQ(plan.restored.marks, 4);
  EXPECT_EQ(plan.erasedSince, 0);
}

TEST_F(MaintenanceTest, PeopleErasedAfterTheBackupStayErased) {
  SessionContext office = sessionOf("administrator");
  backUpDatabase(office, in("backup.sqlite"));
  erasePersonRecord(office, real_.traineeId, "asked for it");

  const RestorePlan plan = planRestore(office, in("backup.sqlite"));
  EXPECT_EQ(plan.erasedSince, 1);
  const auto prepared = prepareRestore(office, plan);

  EXPECT_TRUE(fs::exists(prepared->safety()));
  Connection ready = openDatabase(temporaryBeside(database_).string(), OpenMode::kReadOnly);
  EXPECT_EQ(numberFrom(ready, "SELECT count(*) FROM erasure WHERE reason = 'asked for it'"), 1);
  EXPECT_EQ(
      numberFrom(ready, "SELECT count(*) FROM person_identity WHERE person_id = '" + real_.traineeId + "'"),
      0);
  EXPECT_TRUE(verifyAuditTrail(ready).empty());
  EXPECT_EQ(AuditRepository(ready).entries().at(0).action, "database.restore");
}

TEST_F(MaintenanceTest, ACancelledRestoreLeavesTheRecordAndNoFiles) {
  SessionContext office = sessionOf("administrator");
  backUpDatabase(office, in("backup.sqlite"));
  const RestorePlan plan = planRestore(office, in("backup.sqlite"));

  { const auto prepared = prepareRestore(office, plan); }

  EXPECT_FALSE(fs::exists(temporaryBeside(database_)));
  EXPECT_TRUE(checkDatabase(office).sound());
}

TEST_F(MaintenanceTest, ARecordThatSomebodyHasOpenIsNotReplaced) {
  SessionContext office = sessionOf("administrator");
  backUpDatabase(office, in("backup.sqlite"));
  const auto prepared = prepareRestore(office, planRestore(office, in("backup.sqlite")));

  EXPECT_EQ(refusalFrom([&] { prepared->takeOver(); }).code, ErrorCode::kDatabase);

  EXPECT_TRUE(checkDatabase(office).sound());
}

TEST_F(MaintenanceTest, NothingIsReplacedDuringARunOrWhileAnotherStationIsConnected) {
  SessionContext office = sessionOf("administrator");
  StationRepository stations(connection_);
  stations.heartbeat({.station = "room 2", .heartbeatUtc_us = now_us_});
  const std::int64_t longAgo_us = now_us_ - 2 * kStationSilence_us;
  stations.heartbeat({.station = "room 3", .heartbeatUtc_us = longAgo_us});

  EXPECT_EQ(othersAtWork(office), std::vector<Text>{Text::verbatim("the station room 2 is connected")});
  EXPECT_EQ(refusalFrom([&] { (void)planRestore(office, in("backup.sqlite")); }).code, ErrorCode::kDatabase);
  stations.leave("room 2");
  TrialHeader header = sampleHeader("a trial that runs", "");
  TrialRepository(connection_, {.station = "room 1"}).begin(header);
  stations.heartbeat({.station = "room 1", .trialId = header.trialId, .heartbeatUtc_us = now_us_});

  EXPECT_EQ(othersAtWork(office),
            std::vector<Text>{Text::verbatim("a run is in progress at the station room 1")});
}

TEST_F(MaintenanceTest, ABackupWithAChangedMarkIsNotRestored) {
  SessionContext office = sessionOf("administrator");
  backUpDatabase(office, in("backup.sqlite"));
  {
    Connection forged = openDatabase(in("backup.sqlite").string(), OpenMode::kReadWrite);
    forged.executeVerbatim("DROP TRIGGER training_mark_no_UPDATE");
    forged.executeVerbatim("UPDATE training_mark SET score_steps = 100");
  }
  EXPECT_FALSE(verifyBackup(in("backup.sqlite")).database.sound());

  const Refusal refusal = refusalFrom([&] {
    restoreRecord({.systemAccount = "me", .ownsFile = [](const std::string&) { return true; }},
                  in("backup.sqlite"), in("target.sqlite").string());
  });

  EXPECT_EQ(refusal.code, ErrorCode::kVerifyFailed);
  EXPECT_FALSE(fs::exists(in("target.sqlite")));
}

TEST_F(MaintenanceTest, AFailedCopyLeavesNoNewFile) {
  connection_.executeVerbatim("DROP TRIGGER training_mark_no_UPDATE");
  connection_.executeVerbatim("UPDATE training_mark SET score_steps = 100");
  SessionContext office = sessionOf("administrator");
  EXPECT_EQ(refusalFrom([&] { (void)copyDatabase(office, in("copy.sqlite").string()); }).code,
            ErrorCode::kBadData);
  EXPECT_FALSE(fs::exists(in("copy.sqlite")));
  EXPECT_EQ(refusalFrom([&] { (void)copyDatabase(office, database_); }).code, ErrorCode::kUsage);
}

TEST_F(MaintenanceTest, ThePackageOfAPersonContainsTablesRecordingsAndValidHashes) {
  SessionContext office = sessionOf("administrator");

  const PersonPackage package = exportPersonPackage(office, real_.traineeId, in("package"), "asked");

  EXPECT_EQ(package.recordings, 1);
  EXPECT_GE(package.tables, 20);
  const Trial trial = readTrialFile(in("package") / "recordings" / (real_.trialId + ".torsio-trial"));
  verifyContent(trial);
  EXPECT_EQ(trial.summary.samples, 2000);
  const auto manifest = nlohmann::json::parse(readFile(in("package") / "manifest.json"));
  std::size_t files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(in("package"))) {
    files += entry.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(manifest["files"].size() + 1, files);  // all except the manifest itself
  for (const auto& file : manifest["files"]) {
    Digest digest;
    digest.update(std::string_view(readFile(in("package") / file["file"].get<std::string>())));
    EXPECT_EQ(digest.hex(), file["blake2b_256"].get<std::string>()) << file["file"];
  }
  const auto people = nlohmann::json::parse(readFile(in("package") / "tables" / "person.json"));
  ASSERT_EQ(people.size(), 1U);
  EXPECT_EQ(people[0]["code"], "real-T");
  EXPECT_NE(readFile(in("package") / "README.txt").find("Everything that the training centre"),
            std::string::npos);
  EXPECT_EQ(AuditRepository(connection_).entries().at(0).action, "person.export");
  EXPECT_EQ(refusalFrom([&] { exportPersonPackage(office, real_.traineeId, in("package"), ""); }).code,
            ErrorCode::kFileUnwritable);
  EXPECT_EQ(refusalFrom([&] { exportPersonPackage(office, "nobody", in("none"), ""); }).code,
            ErrorCode::kBadData);
}

TEST_F(MaintenanceTest, APackageContainsNothingOfAnotherOneThatWasKilled) {
  SessionContext office = sessionOf("administrator");
  fs::create_directories(in("package.part") / "recordings");
  std::ofstream(in("package.part") / "recordings" / "of somebody else.torsio-trial") << "samples";

  exportPersonPackage(office, real_.traineeId, in("package"), "asked");

  EXPECT_FALSE(fs::exists(in("package") / "recordings" / "of somebody else.torsio-trial"));
  EXPECT_EQ(readFile(in("package") / "manifest.json").find("somebody else"), std::string::npos);
  EXPECT_FALSE(fs::exists(in("package.part")));
}

TEST_F(MaintenanceTest, ATextThatASpreadsheetWouldExecuteIsWrittenAsText) {
  connection_.execute("UPDATE person_identity SET full_name = ? WHERE person_id = ?",
                      {"=HYPERLINK(\"x\")", real_.traineeId});
  Statement who = connection_.prepare("SELECT person_id FROM person_identity WHERE full_name LIKE ?");
  who.execute({"=HYPER%"});
  std::string person;
  while (who.step()) {
    person = who.text(0);
  }
  if (person.empty()) {
    connection_.execute("INSERT INTO person_identity (person_id, full_name) VALUES (?, ?)",
                        {real_.traineeId, "=HYPERLINK(\"x\")"});
  }
  SessionContext office = sessionOf("administrator");

  exportPersonPackage(office, real_.traineeId, in("package"), "asked");

  const std::string csv = readFile(in("package") / "tables" / "person_identity.csv");
  EXPECT_NE(csv.find("\"'=HYPERLINK(\"\"x\"\")\""), std::string::npos) << csv;
}

TEST_F(MaintenanceTest, RemovingTheDemonstrationKeepsTheRealPeople) {
  SessionContext office = sessionOf("administrator");
  const DemonstrationSize size = demonstrationSize(office);
  EXPECT_EQ(size.people, 2);
  EXPECT_EQ(size.trials, 1);
  EXPECT_EQ(size.marks, 2);

  const DemonstrationSize removed = removeDemonstrationData(office, "the course begins");

  EXPECT_EQ(removed.rows, size.rows);
  EXPECT_EQ(demonstrationSize(office).rows, 0);
  EXPECT_TRUE(PeopleRepository(connection_).findTrainee("real-T").has_value());
  EXPECT_FALSE(PeopleRepository(connection_).findTrainee("demo-T").has_value());
  EXPECT_TRUE(checkDatabase(office).sound());
}

TEST_F(MaintenanceTest, TheRetentionQueueIsReviewedBeforeAnythingIsErased) {
  SessionContext office = sessionOf("administrator");
  Trainee other;
  other.person = {.id = "other", .code = "R-2", .createdUtc_us = kSampleTime_us};
  Trainee appeal;
  appeal.person = {.id = "appeal", .code = "R-3", .createdUtc_us = kSampleTime_us};
  PeopleRepository(connection_).addTrainees(std::vector<Trainee>{other, appeal});
  setRetentionRule(office, kRetainTrainee, 30, "contract");
  now_us_ += 31 * kDay_us;
  lockRecords(office, std::array{PersonId("appeal")}, "an appeal is open");
  const std::vector<PersonId> chosen{"other", "appeal"};

  const RetentionOutcome dry = eraseDue(office, chosen, "", true);
  EXPECT_EQ(PeopleRepository(connection_).findTrainee("R-2")->person.state, PersonState::kActive);
  const RetentionOutcome done = eraseDue(office, chosen, "yearly review", false);

  ASSERT_EQ(dry.erased.size(), 1U);
  ASSERT_EQ(done.erased.size(), 1U);
  EXPECT_EQ(done.erased[0].code, "R-2");
  ASSERT_EQ(done.skipped.size(), 1U);
  EXPECT_EQ(done.skipped[0].hold->reason, "an appeal is open");
  EXPECT_EQ(PeopleRepository(connection_).findTrainee("R-2")->person.state, PersonState::kErased);
  EXPECT_EQ(PeopleRepository(connection_).findTrainee("R-3")->person.state, PersonState::kActive);
  const AuditEntry entry = AuditRepository(connection_).entries().at(0);
  EXPECT_EQ(entry.action, "person.erase");
  EXPECT_EQ(entry.actor, "u-administrator");
  EXPECT_EQ(entry.reason, "yearly review (retention: trainee)");
  EXPECT_EQ(refusalFrom([&] { (void)eraseDue(office, chosen, "again", false); }).code, ErrorCode::kBadData);
  EXPECT_EQ(refusalFrom([&] { extendRecords(office, std::array{PersonId("appeal")}, now_us_, "late"); }).code,
            ErrorCode::kBadParameter);
  EXPECT_EQ(refusalFrom([&] { lockRecords(office, std::array{PersonId("appeal")}, ""); }).code,
            ErrorCode::kBadParameter);
}

TEST_F(MaintenanceTest, EveryChangeIsAuditedAndTheTrailVerifies) {
  SessionContext office = sessionOf("administrator");
  Trainee due;
  due.person = {.id = "due", .code = "R-2", .createdUtc_us = kSampleTime_us};
  PeopleRepository(connection_).addTrainees({&due, 1});
  const auto audited = [&](const char* action, const std::function<void()>& change) {
    expectAudited(connection_, "u-administrator", action, change);
    EXPECT_TRUE(verifyAuditTrail(connection_).empty()) << action;
  };

  audited("database.backup", [&] { backUpDatabase(office, in("backup.sqlite")); });
  audited("database.check", [&] { (void)checkDatabase(office); });
  audited("retention.rule", [&] { setRetentionRule(office, kRetainTrainee, 30, "contract"); });
  now_us_ += 31 * kDay_us;
  const std::vector<PersonId> chosen{"due"};
  audited("retention.lock", [&] { lockRecords(office, chosen, "an appeal is open"); });
  audited("retention.extend", [&] { extendRecords(office, chosen, now_us_ + kDay_us, "not read yet"); });
  audited("retention.release", [&] { releaseRecords(office, chosen, "the appeal is closed"); });
  now_us_ += 2 * kDay_us;
  audited("person.erase", [&] { (void)eraseDue(office, chosen, "yearly review", false); });
  audited("person.export", [&] { exportPersonPackage(office, real_.traineeId, in("package"), "asked"); });
  audited("demonstration.remove", [&] { removeDemonstrationData(office, "the course begins"); });
  audited("person.erase", [&] { erasePersonRecord(office, real_.traineeId, "asked"); });
}

}  // namespace
}  // namespace torsio
