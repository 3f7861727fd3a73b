// SPDX-License-Identifier: GPL-3.0-or-later
// torsio doctor: what it finds on a record, and what it says to do.
#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <QTcpServer>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/installation/installation_check.h"
#include "app/services/maintenance/copies.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/trial/station_repository.h"
#include "sim/core/clock.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
#include "tests/app/cli/program.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

class Doctor : public ::testing::Test {
 protected:
  Doctor() { of_ = {.locator = centre_.session().key().locator, .now_us = centre_.session().now_us()}; }

  /// Registers a backup that lies on this disk.
  void backUp(std::int64_t made_us) {
    const std::filesystem::path file = emptyFolder("doctor-backup") / "one.sqlite";
    writeFileAtomically(file, "a backup");
    registerCopy(centre_.connection(), CopyKind::kBackup, file, made_us);
  }

  InstallationCheck check(const std::string& name) const {
    for (const InstallationCheck& one : checkInstallation(of_)) {
      if (one.name == name) {
        return one;
      }
    }
    return {"", CheckState::kSkipped, Text::verbatim("no such check"), {}};
  }

  StudyCentre centre_;
  Installation of_;
};

TEST_F(Doctor, SaysWhatToDoAboutEverythingThatIsNotGood) {
  std::set<std::string> names;
  const std::vector<InstallationCheck> checks = checkInstallation(of_);
  for (const InstallationCheck& one : checks) {
    EXPECT_TRUE(names.insert(one.name).second) << one.name;
    EXPECT_FALSE(one.finding.empty()) << one.name;
    if (one.state == CheckState::kWarning || one.state == CheckState::kFailed) {
      EXPECT_FALSE(one.remedy.empty()) << one.name;
    } else {
      EXPECT_TRUE(one.remedy.empty()) << one.name;
    }
  }
  for (const char* name :
       {"record", "schema", "access", "backup", "copies", "fleet", "disk", "clock", "key", "witness",
        "certificate", "real_time", "memory", "device", "display", "graphics"}) {
    EXPECT_TRUE(names.contains(name)) << name;
  }
  EXPECT_EQ(check("record").state, CheckState::kGood);
  EXPECT_EQ(check("schema").state, CheckState::kGood);
}

TEST_F(Doctor, CountsInvitationsThatOpenNothingAnyMore) {
  EXPECT_EQ(check("access").state, CheckState::kGood);
  centre_.connection().execute(
      "INSERT INTO invitation (id, user_id, token_hash, made_utc_us, expires_utc_us, state)"
      " VALUES ('old', ?, 'a proof', 1, ?, 'open')",
      {AccessRepository(centre_.connection()).users().front().id, of_.now_us + 1});
  EXPECT_EQ(check("access").state, CheckState::kWarning);
  EXPECT_NE(check("access").finding.str().find("1 invitation"), std::string::npos);
}

TEST_F(Doctor, MissesABackupAndFindsAnOldOne) {
  EXPECT_EQ(check("backup").state, CheckState::kFailed);

  backUp(of_.now_us);
  EXPECT_EQ(check("backup").state, CheckState::kGood);

  of_.now_us += 8 * kDay_us;
  EXPECT_EQ(check("backup").state, CheckState::kWarning);
}

TEST_F(Doctor, FindsAStationOfAnotherVersionUntilItIsForgotten) {
  StationRepository(centre_.connection())
      .heartbeat({.station = "arm-2", .softwareVersion = "0.0.9", .heartbeatUtc_us = of_.now_us});
  const InstallationCheck fleet = check("fleet");
  EXPECT_EQ(fleet.state, CheckState::kWarning);
  EXPECT_NE(fleet.finding.str().find("arm-2 (0.0.9)"), std::string::npos) << fleet.finding.str();

  of_.now_us += 31 * kDay_us;
  EXPECT_EQ(check("fleet").state, CheckState::kGood);
}

TEST_F(Doctor, FindsAClockBehindTheAuditTrail) {
  setCentreSettingNamed(centre_.as("administrator"), "review.minimum_watched_percent", "60");  // audited
  EXPECT_EQ(check("trail_clock").state, CheckState::kGood);
  of_.now_us = AuditRepository(centre_.connection()).entries({.limit = 1}).at(0).atUtc_us - kDay_us;
  EXPECT_EQ(check("trail_clock").state, CheckState::kFailed);
}

TEST_F(Doctor, LooksAtTheRestIfThereIsNoRecord) {
  of_.locator = (emptyFolder("doctor") / "none.sqlite").string();
  EXPECT_EQ(check("record").state, CheckState::kFailed) << "it was named";
  EXPECT_EQ(check("backup").state, CheckState::kSkipped);
  EXPECT_NE(check("disk").state, CheckState::kSkipped);
  EXPECT_FALSE(std::filesystem::exists(of_.locator)) << "it changes nothing";
}

TEST_F(Doctor, DoesNotWaitForAServerThatIsSilent) {
  QTcpServer silent;  // accepts and never answers
  ASSERT_TRUE(silent.listen(QHostAddress::LocalHost));
  of_.locator =
      "postgresql://station@127.0.0.1:" + std::to_string(silent.serverPort()) + "/torsio?sslmode=disable";
  const std::vector<InstallationCheck> checks = checkInstallation(of_);
  ASSERT_GT(checks.size(), 15U);
  EXPECT_EQ(checks[2].name, "record");
  EXPECT_EQ(checks[2].state, CheckState::kFailed);
  EXPECT_EQ(checks[3].state, CheckState::kSkipped);
}

TEST_F(Doctor, RefusesARecordOfANewerSchema) {
  centre_.connection().execute(
      "INSERT INTO schema_migration (version, name, description, checksum, compatible_from, "
      "software_version, "
      "applied_utc_us) VALUES (999, 'future', 'later', 'x', 999, '9', 1)");
  EXPECT_EQ(check("record").state, CheckState::kGood);
  EXPECT_EQ(check("schema").state, CheckState::kFailed);
  EXPECT_EQ(check("copies").state, CheckState::kSkipped);
}

TEST_F(Doctor, NamesAMissingCertificate) {
  EXPECT_EQ(check("certificate").state, CheckState::kSkipped);
  of_.certificate = emptyFolder("doctor") / "none.pem";
  EXPECT_EQ(check("certificate").state, CheckState::kFailed);
}

TEST_F(Doctor, CreatesNoFolderAndSurvivesAHomeThatCannotBeWritten) {
  const std::filesystem::path folder = emptyFolder("doctor");
  const std::filesystem::path home = folder / "home";
  const ProgramRun run = runTorsio("doctor --json", folder, "-u XDG_DATA_HOME HOME=" + home.string());
  EXPECT_EQ(run.code, 0) << run.err;
  const nlohmann::json said = nlohmann::json::parse(run.out, nullptr, false);
  ASSERT_TRUE(said.is_object()) << run.out << run.err;
  EXPECT_EQ(said["checks"][1]["name"], "configuration");
  EXPECT_EQ(said["checks"][2]["name"], "record");
  EXPECT_EQ(said["checks"][2]["state"], "warning");
  EXPECT_FALSE(std::filesystem::exists(home)) << "it changes nothing";
}

TEST_F(Doctor, PrintsItsChecksAndEndsWithACodeForMonitoring) {
  const std::filesystem::path folder = emptyFolder("doctor");
  const std::string command = "doctor --json --database " + of_.locator;

  const ProgramRun run = runTorsio(command, folder);
  EXPECT_EQ(run.code, static_cast<int>(ErrorCode::kVerifyFailed)) << "there is no backup";
  const nlohmann::json said = nlohmann::json::parse(run.out, nullptr, false);
  ASSERT_TRUE(said.is_object()) << run.out << run.err;
  EXPECT_EQ(said["state"], "failed");
  ASSERT_GT(said["checks"].size(), 10U);
  for (const nlohmann::json& one : said["checks"]) {
    EXPECT_TRUE(one["name"].is_string() && one["state"].is_string() && one["remedy"].is_string()) << one;
  }

  backUp(utcNow_us());
  EXPECT_EQ(runTorsio(command, folder).code, 0);
}

}  // namespace
}  // namespace torsio
