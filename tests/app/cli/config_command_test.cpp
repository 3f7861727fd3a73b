// SPDX-License-Identifier: GPL-3.0-or-later
// torsio config, and that commands, doctor and review desk take what the configuration of the computer says.
#include <filesystem>
#include <string>
#include <sys/stat.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/configuration.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

class ConfigCommand : public ::testing::Test {
 protected:
  void write(const std::string& text) const { writeFileAtomically(file(), text); }
  [[nodiscard]] fs::path file() const { return folder_ / "torsio.conf"; }
  [[nodiscard]] ProgramRun run(const std::string& arguments) const {
    return runTorsio(
        arguments, folder_,
        "-u XDG_DATA_HOME -u XDG_CONFIG_HOME HOME=" + folder_.string() + " TORSIO_CONFIG=" + file().string());
  }
  const fs::path folder_ = emptyFolder("config");
};

TEST_F(ConfigCommand, NamesTheLineOfEveryKindOfFaultAndWhatToWrite) {
  const struct {
    const char* text;
    const char* line;
    const char* says;
  } faults[] = {
      {"# a comment\n\nrecrod = /a\n", "line 3", "Did you mean record?"},
      {"colour of the walls = blue\n", "line 1", "Write one of: record, "},
      {"kiosk yes\n", "line 1", "key = value"},
      {"kiosk = perhaps\n", "line 1", "Write yes or no"},
      {"language = fr\n", "line 1", "Write en or zh_CN"},
      {"theme = pink  # nice\n", "line 1", "cannot be pink. Write light or dark"},
      {"passfile = pgpass\n", "line 1", "begins with /"},
      {"log.level = loud\n", "line 1", "Write error, warning, info or debug"},
      {"log.file = torsio.log\n", "line 1", "begins with /"},
      {"station =\n", "line 1", "has no value"},
      {"station = A\nstation = B\n", "line 2", "already set in line 1"},
      {"record = torsio.sqlite\n", "line 1", "begins with /"},
      {"record = postgresql://me:secret@server/torsio\n", "line 1", "passfile = "},
      {"device = omnii\n", "line 1", "Choose one of"},
      {"serve.certificate = /nowhere/desk.pem\n", "line 1", "cannot be read"},
  };
  for (const auto& fault : faults) {
    write(fault.text);
    const ProgramRun checked = run("config check");
    EXPECT_NE(checked.code, 0) << fault.text;
    EXPECT_NE(checked.err.find(file().string() + ", " + fault.line), std::string::npos) << checked.err;
    EXPECT_NE(checked.err.find(fault.says), std::string::npos) << checked.err;
    EXPECT_EQ(checked.err.find("secret"), std::string::npos) << checked.err;
  }
}

TEST_F(ConfigCommand, TakesAFileOfAnyEditorAndDoesNotWaitForAPipe) {
  write("\xEF\xBB\xBFstation = OR-3\r\nkiosk = no\r\n");
  EXPECT_EQ(run("config check").code, 0);
  EXPECT_EQ(nlohmann::json::parse(run("station show --json").out).at("name"), "OR-3");
  fs::remove(file());
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  EXPECT_EQ(run("config check").code, static_cast<int>(ErrorCode::kFileUnreadable));
}

TEST_F(ConfigCommand, AFaultStopsWhatWouldUseItAndNothingElse) {
  write("recrod = /a\n");
  for (const char* stopped : {"settings list --as-system", "demo --help", "serve"}) {
    EXPECT_EQ(run(stopped).code, static_cast<int>(ErrorCode::kBadData)) << stopped;
  }
  EXPECT_EQ(run("--version").code, 0);
  EXPECT_EQ(run("help doctor").code, 0);
  EXPECT_NE(run("doctor").out.find("failed  configuration: " + file().string() + ", line 1"),
            std::string::npos);
}

TEST_F(ConfigCommand, ShowsEachKeyItsValueAndWhereItComesFrom) {
  write("record = " + (folder_ / "own.sqlite").string() + "\nstation = OR-3\n");
  const nlohmann::json shown = nlohmann::json::parse(run("config show --json").out);
  EXPECT_EQ(shown.at("file"), file().string());
  ASSERT_EQ(shown.at("settings").size(), kConfiguredKeys.size());
  for (std::size_t i = 0; i < kConfiguredKeys.size(); ++i) {
    const nlohmann::json& one = shown.at("settings")[i];
    EXPECT_EQ(one.at("key"), kConfiguredKeys[i]->name);
    EXPECT_FALSE(one.at("origin").get<std::string>().empty());
  }
  EXPECT_EQ(shown.at("settings")[0].at("value"), (folder_ / "own.sqlite").string());
  EXPECT_EQ(shown.at("settings")[0].at("origin"), "set in " + file().string() + ", line 1");
  EXPECT_EQ(shown.at("settings")[2].at("value"), "OR-3");
  EXPECT_EQ(nlohmann::json::parse(run("station show --json").out).at("name"), "OR-3");
  EXPECT_NE(run("station renew").err.find(file().string() + ", line 2"), std::string::npos);
}

TEST_F(ConfigCommand, CommandsAndDoctorUseTheRecordThatItNames) {
  const fs::path record = folder_ / "of-the-computer.sqlite";
  write("record = " + record.string() + "\n");
  const ProgramRun missing = run("report trace a");
  EXPECT_NE(missing.err.find(record.string()), std::string::npos) << missing.err;
  EXPECT_NE(run("doctor").out.find("there is no record yet: " + record.string()), std::string::npos);
  const ProgramRun named = run("report trace --database " + (folder_ / "named.sqlite").string() + " a");
  EXPECT_NE(named.err.find("named.sqlite"), std::string::npos) << named.err;
}

// The window's data of an account and those that commands look at are the same.
TEST_F(ConfigCommand, WithoutConfigurationTheRecordIsTheOneOfTheWindow) {
  write("");
  const fs::path settings = folder_ / ".config/torsio/torsio.conf";
  fs::create_directories(settings.parent_path());
  writeFileAtomically(settings, "[station]\ndatabase=" + (folder_ / "chosen.sqlite").string() + "\n");
  EXPECT_NE(run("doctor").out.find("there is no record yet: " + (folder_ / "chosen.sqlite").string()),
            std::string::npos);
  fs::remove(settings);
  EXPECT_NE(run("config show").out.find((folder_ / ".local/share/torsio/torsio/torsio.sqlite").string()),
            std::string::npos);
}

TEST(Configuration, WhatTheGuideListsIsWhatTheProgramKnows) {
  const std::string guide = readFile(TORSIO_SOURCE_DIR "/docs/deployment.md");
  for (const ConfiguredKey* key : kConfiguredKeys) {
    EXPECT_NE(guide.find("| `" + std::string(key->name) + "` | "), std::string::npos) << key->name;
  }
}

}  // namespace
}  // namespace torsio
