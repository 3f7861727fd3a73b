// SPDX-License-Identifier: GPL-3.0-or-later
// torsio settings and torsio report freeze and statement, signed in as an administrator.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/study/study_statements.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

TEST(SettingsCommand, ListsAndSetsWhatTheCentreChooses) {
  StudyCentre centre;
  const std::filesystem::path folder = emptyFolder("settings");
  writeFileAtomically(folder / "password", std::string(kStudyPassword) + "\n");
  const auto run = [&](const std::string& command, const std::string& login) {
    return runTorsio("settings " + command + " --database " + centre.session().key().locator + " --as " +
                         login + " --password-fd 3 3<" + (folder / "password").string(),
                     folder);
  };

  EXPECT_EQ(run("set review.minimum_watched_percent 60", "administrator").code, 0);
  EXPECT_EQ(run("set review.speeds 0.5,2", "administrator").code, 0);
  EXPECT_EQ(run("set review.minimum_watched_percent 160", "administrator").code,
            static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(run("set review.minimum_watched_percent 10", "rater").code,
            static_cast<int>(ErrorCode::kPermission));

  EXPECT_DOUBLE_EQ(centreSetting<kMinimumWatched_percent>(centre.connection()), 60.0);
  const ProgramRun listed = run("list --json", "administrator");
  const nlohmann::json all = nlohmann::json::parse(listed.out, nullptr, false);
  ASSERT_TRUE(all.is_array()) << listed.err;
  EXPECT_EQ(all[2]["name"], "review.speeds");
  EXPECT_EQ(all[2]["value"], "0.5,1,2");
  EXPECT_TRUE(all[2]["in_report"]);
}

TEST(ReportCommand, AnInterimStateIsFrozenByTwoPeople) {
  StudyCentre centre;
  const PaperStudy study = centre.addStudy(2, 2);
  createAssignments(centre.as("administrator"), study.plan());
  SettingRepository(centre.connection()).set(kTwoPeople.name, "yes", 0);
  const std::filesystem::path folder = emptyFolder("freeze");
  writeFileAtomically(folder / "password", std::string(kStudyPassword) + "\n");
  const auto freeze = [&](const std::string& options) {
    return runTorsio("report freeze --cohort Study --name look --database " + centre.session().key().locator +
                         " --as administrator --password-fd 3 " + options + " 3<" +
                         (folder / "password").string() + " 4<" + (folder / "password").string(),
                     folder);
  };

  EXPECT_EQ(freeze("").code, static_cast<int>(ErrorCode::kBadData)) << "nobody said why";
  EXPECT_EQ(freeze("--incomplete why").code, static_cast<int>(ErrorCode::kPermission));
  const ProgramRun done = freeze("--incomplete why --with statistician --with-password-fd 4");
  EXPECT_EQ(done.code, 0) << done.err;
  EXPECT_NE(done.out.find("0 of 12 sheets"), std::string::npos) << done.out;

  const FrozenRow frozen = frozenData(centre.as("administrator"), study.cohortId).at(0);
  EXPECT_EQ(frozen.askedBy, "administrator");
  EXPECT_EQ(frozen.createdBy, "statistician");
  EXPECT_EQ(frozen.whyIncomplete, "why");
}

TEST(ReportCommand, StatesWhatTheStudySaysAboutItself) {
  StudyCentre centre;
  const PaperStudy study = centre.addStudy(2);
  const std::filesystem::path folder = emptyFolder("statement");
  writeFileAtomically(folder / "password", std::string(kStudyPassword) + "\n");
  const auto state = [&](const std::string& words) {
    return runTorsio("report statement " + words + " --json --database " + centre.session().key().locator +
                         " --as administrator --password-fd 3 3<" + (folder / "password").string(),
                     folder);
  };

  EXPECT_EQ(state("ethics 'board of the house, 12/26'").code, 0);
  EXPECT_NE(state("weather fine").code, 0);
  const nlohmann::json all = nlohmann::json::parse(state("").out, nullptr, false);
  ASSERT_TRUE(all.is_object());
  EXPECT_EQ(all["ethics"], "board of the house, 12/26");
  EXPECT_EQ(all["funding"], "");
  EXPECT_EQ(studyStatements(centre.as("administrator"), study.cohortId).size(), 1U);
  EXPECT_EQ(state("ethics ''").code, 0);
  EXPECT_TRUE(studyStatements(centre.as("administrator"), study.cohortId).empty());
}

}  // namespace
}  // namespace torsio
