// SPDX-License-Identifier: GPL-3.0-or-later
// torsio xapi against a test server, from the first setting to a statement that nobody accepts.
#include <filesystem>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "db/repository/people/access_repository.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/connectors/xapi/xapi_centre.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using testing::TestLrs;

class XapiCommand : public ::testing::Test {
 protected:
  XapiCommand() {
    writeFileAtomically(folder_ / "password", "a long enough password\n");
    writeFileAtomically(folder_ / "wrong", "a wrong password\n");
    writeFileAtomically(folder_ / "secret", std::string(TestLrs::kSecret) + "\n");
    centre_.asAdministrator();
    AccessRepository access(centre_.connection(), PasswordCost::kTest);  // one of their own
    access.setPassword("the administrator", access.sealPassword("admin", "a long enough password"), false);
    centre_.centre().become("T-01");
  }

  ProgramRun run(const std::string& arguments) {
    return runTorsio("xapi " + arguments, folder_, "XDG_CONFIG_HOME=" + (folder_ / "settings").string());
  }
  [[nodiscard]] std::string record() { return " --database " + centre_.centre().session().key().locator; }
  [[nodiscard]] std::string signedIn(const std::string& password = "password") {
    return record() + " --login admin --password-fd 3 3<" + (folder_ / password).string();
  }
  ProgramRun turnOn() {
    return run("set --endpoint " + centre_.store().endpoint() +
               " --home-page https://skills.example.org --on" + signedIn());
  }
  ProgramRun giveKey() {
    return run("key --user '" + std::string(TestLrs::kUser) + "' --secret-fd 4 4<" +
               (folder_ / "secret").string());
  }
  nlohmann::json status() {
    const ProgramRun shown = run("status --json" + signedIn());
    EXPECT_EQ(shown.code, 0) << shown.err;
    return nlohmann::json::parse(shown.out, nullptr, false);
  }

  fs::path folder_ = emptyFolder("xapi");
  XapiCentre centre_;
};

TEST_F(XapiCommand, ReportsEventsToTheStoreAndListsRefusedOnes) {
  EXPECT_FALSE(status()["on"].get<bool>());
  const ProgramRun on = turnOn();
  EXPECT_EQ(on.code, 0) << on.err;
  EXPECT_NE(on.out.find("Sending: on, to " + centre_.store().endpoint()), std::string::npos);
  EXPECT_EQ(run("send" + record()).code, static_cast<int>(ErrorCode::kBadData));  // no key yet
  EXPECT_EQ(giveKey().code, 0);
  centre_.run();
  centre_.store().refuse("/completed");
  EXPECT_EQ(status()["waiting"], 3);  // begun, ended, passed

  const ProgramRun sent = run("send --json" + record());
  EXPECT_EQ(sent.code, 0) << sent.err;
  const nlohmann::json done = nlohmann::json::parse(sent.out, nullptr, false);
  EXPECT_EQ(done["delivered"], 2);
  EXPECT_EQ(done["refused"], 1);
  const nlohmann::json after = status();
  EXPECT_EQ(after["delivered"], 2);
  ASSERT_EQ(after["dead"].size(), 1U);
  EXPECT_EQ(after["dead"][0]["kind"], "completed");
  EXPECT_FALSE(after["dead"][0]["answer"].get<std::string>().empty());

  centre_.store().refuse("");
  EXPECT_EQ(run("retry" + signedIn()).out, "1 will be tried again\n");
  EXPECT_EQ(run("send" + record()).out, "Delivered 1, refused for good 0, later 0\n");
  EXPECT_EQ(centre_.store().stored().size(), 3U);
  EXPECT_TRUE(centre_.store().complaints().empty());
}

TEST_F(XapiCommand, ARefusingStoreIsExitCodeFourAndNothingIsLost) {
  turnOn();
  giveKey();
  centre_.run();
  centre_.store().become(TestLrs::Fault::kBusy);

  const ProgramRun busy = run("send" + record());

  EXPECT_EQ(busy.code, static_cast<int>(ErrorCode::kFileUnreadable));
  EXPECT_NE(busy.err.find("does not accept anything now"), std::string::npos);
  const nlohmann::json waits = status();
  EXPECT_EQ(waits["waiting"], 3);
  EXPECT_FALSE(waits["trouble"].get<std::string>().empty());
  centre_.store().become(TestLrs::Fault::kNone);
  EXPECT_EQ(run("retry" + signedIn()).code, 0);
  EXPECT_EQ(run("send" + record()).out, "Delivered 3, refused for good 0, later 0\n");
}

TEST_F(XapiCommand, RejectsUnauthorisedUsersAndUnencryptedAddresses) {
  EXPECT_EQ(run("status --json" + signedIn("wrong")).code, static_cast<int>(ErrorCode::kPermission));
  EXPECT_EQ(run("status" + record()).code, static_cast<int>(ErrorCode::kUsage));
  const ProgramRun clear = run(
      "set --endpoint http://lrs.example.org/xapi --home-page https://skills.example.org --on" + signedIn());
  EXPECT_EQ(clear.code, static_cast<int>(ErrorCode::kBadParameter)) << clear.err;
  EXPECT_FALSE(status()["on"].get<bool>());
}

TEST_F(XapiCommand, MakesTheSecretReadableByTheAccountOnly) {
  turnOn();
  giveKey();
  EXPECT_TRUE(status()["key_at_this_station"].get<bool>());
  int found = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_ / "settings")) {
    if (entry.is_regular_file() && readFile(entry.path()).find(TestLrs::kSecret) != std::string::npos) {
      ++found;
      EXPECT_EQ(entry.status().permissions() & (fs::perms::group_all | fs::perms::others_all),
                fs::perms::none);
    }
  }
  EXPECT_EQ(found, 1);
  EXPECT_NE(run("key").out.find("has no key any more"), std::string::npos);
  EXPECT_FALSE(status()["key_at_this_station"].get<bool>());
}

}  // namespace
}  // namespace torsio
