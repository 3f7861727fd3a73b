// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a served day: levels, files, the journal's priorities, and nobody in any line.
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/base/log.h"
#include "db/connection/row_reader.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"
#include "tests/app/record_safety/killed_program.h"
#include "tests/app/support/review_centre.h"
#include "tests/app/web/served_desk.h"
#include "tests/app/web/serving_program.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kRemark = "the wrist was lame";

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// A configured computer with a centre that is served for a day.
struct LoggedDay {
  explicit LoggedDay(const std::string& level) : centre({.trial_s = 0.5}) {
    setWebPasswords(centre);
    writeFileAtomically(configuration(), "record = " + centre.locator() + "\nlog.level = " + level +
                                             "\nlog.file = " + log().string() + "\n");
    writeFileAtomically(centre.folder() / "password", std::string(kWebPassword) + "\n");
  }
  [[nodiscard]] fs::path configuration() const { return centre.folder() / "torsio.conf"; }
  [[nodiscard]] fs::path log() const { return centre.folder() / "torsio.log"; }

  /// People sign in, rightly and not, look at everything, score and submit.
  void serve() {
    ServingProgram served(centre, {"TORSIO_CONFIG=" + configuration().string()}, {}, false);
    const std::uint16_t port = served.port();
    ASSERT_NE(port, 0) << served.errors();
    WebClient client(port);
    client.headers = {{"Sec-Fetch-Site", "same-origin"}};
    EXPECT_FALSE(client.signIn("physician0", "physician0 is my name"));
    EXPECT_FALSE(client.signIn(kWebPassword, kWebPassword)) << "typed into the wrong field";
    ASSERT_TRUE(client.signIn("physician0", kWebPassword));
    const std::string path = "/api/cases/" + firstCase(client);
    (void)client.get(path);
    json sheet = sheetBody(0, 70, 80, 75);
    sheet["comment"] = kRemark;
    EXPECT_EQ(client.send("PUT", path + "/sheet", sheet).status, 200);
    (void)client.send("POST", path + "/submit", {{"sheet", sheet}});
    (void)client.get("/api/nothing/Trainee%201");
    (void)client.send("POST", "/api/sign-out", json::object());
    EXPECT_EQ(served.stopped(), 0);
    printed += served.errors();
  }
  void command(const std::string& words) {
    const ProgramRun run = runTorsio(words + " 3<" + (centre.folder() / "password").string(), centre.folder(),
                                     "TORSIO_CONFIG=" + configuration().string());
    EXPECT_NE(run.code, 0) << words;
  }

  ReviewCentre centre;
  std::string printed;
};

TEST(LoggedDay, NobodyIsInAnyLogOrReportForSupport) {
  LoggedDay day("debug");
  std::vector<std::string> secrets = day.centre.secrets();
  for (const char* column : {"full_name", "external_id", "email"}) {
    for (const std::string& value :
         selectAll(day.centre.connection(),
                   std::string("SELECT COALESCE(") + column + ", '') FROM person_identity", {}, readText)) {
      secrets.push_back(value);
    }
  }
  for (const std::string& login :
       selectAll(day.centre.connection(), "SELECT login FROM app_user", {}, readText)) {
    secrets.push_back(login);
  }
  secrets.insert(secrets.end(), {kWebPassword, kRemark, "Ada Lovelace", "is my name"});

  day.serve();
  day.command("settings list --as 'Ada Lovelace' --password-fd 3");
  day.command("invite 'Ada Lovelace' --as administrator --password-fd 3");
  day.command("export tables --out /nowhere/at/all --login physician0 --password-fd 3");
  day.command("competence --trainee 'Ada Lovelace'");
  const ProgramRun support = runTorsio("support --out " + (day.centre.folder() / "support.json").string(),
                                       day.centre.folder(), "TORSIO_CONFIG=" + day.configuration().string());
  EXPECT_EQ(support.code, 0) << support.err;

  const std::string log = readFile(day.log());
  const json report = json::parse(readFile(day.centre.folder() / "support.json"));
  EXPECT_FALSE(report.at("log").empty());
  EXPECT_GT(report.at("checks").size(), 10U);
  for (const std::string& text : {log, day.printed, report.dump()}) {
    for (const std::string& secret : secrets) {
      EXPECT_TRUE(secret.size() < 4 || text.find(secret) == std::string::npos) << secret << "\n" << text;
    }
  }
}

TEST(LoggedDay, EachLineHasTimeLevelAndAnAnswerByItsPatternOrACause) {
  LoggedDay day("info");
  day.serve();
  day.command("report trace nothing");

  const std::regex answer(
      "\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d\\.\\d{3}Z info: (-|GET a page|(GET|PUT|POST) "
      "[a-z0-9/*_.-]+) "
      "\\d{3} \\d+ ms");
  const std::regex cause("\\S+Z (info: The review desk .*|error: error of kind \\d+.*)");
  const std::vector<std::string> lines = linesOf(readFile(day.log()));
  EXPECT_GT(lines.size(), 8U);
  for (const std::string& line : lines) {
    EXPECT_TRUE(std::regex_match(line, answer) || std::regex_match(line, cause)) << line;
  }
  EXPECT_TRUE(std::regex_match(lines.back(), cause)) << lines.back();
  EXPECT_EQ(day.printed, "") << "the file has the log";
}

TEST(LoggedDay, TheLevelLeavesOutWhatIsLessGrave) {
  LoggedDay day("warning");
  day.serve();
  EXPECT_FALSE(fs::exists(day.log()));
}

// The journal announces itself by the device and inode of the stream that it reads.
TEST(LoggedDay, TheJournalIsToldTheLevelOfEachLine) {
  const fs::path folder = emptyFolder("journal");
  const std::string program = "'JOURNAL_STREAM=$(stat -L -c %d:%i /proc/self/fd/2) exec " TORSIO_PROGRAM
                              " report trace nothing --database /nowhere.sqlite'";
  const ProgramRun journal = runProgram("sh -c", program, folder, "TORSIO_CONFIG=");
  EXPECT_TRUE(journal.err.starts_with("<3>torsio: ")) << journal.err;
  const ProgramRun terminal = runTorsio("report trace nothing --database /nowhere.sqlite", folder,
                                        "TORSIO_CONFIG= JOURNAL_STREAM=1:2");
  EXPECT_TRUE(terminal.err.starts_with("torsio: ")) << terminal.err;
}

TEST(LoggedDay, AFullFileMakesRoomAndFiveAreKept) {
  LoggedDay day("info");
  for (int round = 0; round < 7; ++round) {
    writeFileAtomically(day.log(), std::string(kLogFile_bytes, static_cast<char>('a' + round)));
    day.command("report trace nothing");
  }
  EXPECT_LT(fs::file_size(day.log()), 1000U);
  for (int age = 1; age < kLogFiles; ++age) {
    EXPECT_EQ(readFile(day.log().string() + "." + std::to_string(age))[0], 'a' + 7 - age);
  }
  EXPECT_FALSE(fs::exists(day.log().string() + "." + std::to_string(kLogFiles)));
  EXPECT_EQ(fs::status(day.log()).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

}  // namespace
}  // namespace torsio::web
