// SPDX-License-Identifier: GPL-3.0-or-later
// torsio settings, signed in as an administrator.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/access/centre_settings.h"
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

}  // namespace
}  // namespace torsio
