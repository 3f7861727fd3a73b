// SPDX-License-Identifier: GPL-3.0-or-later
// What a peer, a file or an argument says reaches the terminal without commanding it, and JSON stays JSON.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/plain_text.h"
#include "tests/app/cli/program.h"
#include "tests/support/fake_tracker.h"

namespace torsio {
namespace {

using testing::FakeTracker;

const std::vector<std::string>& hostileTexts() {
  static const std::vector<std::string> kTexts{"\x1b]0;owned\x07",
                                               "\x1b[2J\x1b[31mred",
                                               "\xff\xfe\xc3",
                                               "\xe2\x80\xaegpj.exe",
                                               "\xc2\x9b"
                                               "31m",
                                               "over\rwritten",
                                               "\xe2\x81\xa6\x7f\x01",
                                               "\xf0\x9f"};
  return kTexts;
}

class OutsideText : public ::testing::Test {
 protected:
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return "'" + file(name) + "'";
  }
  void expectPlain(const ProgramRun& run, const std::string& what) {
    EXPECT_EQ(plainText(run.out), run.out) << what;
    EXPECT_EQ(plainText(run.err), run.err) << what;
    EXPECT_NE(run.code, static_cast<int>(ErrorCode::kInternal)) << what << run.err;
  }
  /// Each as lines of people and, where the command has it, as JSON.
  void expectPlain(const std::string& arguments) {
    expectPlain(runTorsio(arguments, folder_), arguments);
    const ProgramRun json = runTorsio(arguments + " --json", folder_);
    expectPlain(json, arguments);
    EXPECT_TRUE(json.out.empty() || nlohmann::json::accept(json.out)) << json.out;
  }

  std::filesystem::path folder_ = emptyFolder("outside");
};

TEST_F(OutsideText, TheFirstLineOfAWitnessFileAndAHead) {
  const std::string database = " --database " + file("r.sqlite");
  ASSERT_EQ(runTorsio("record --duration 1" + database, folder_).code, 0);
  for (const std::string& text : hostileTexts()) {
    expectPlain("audit verify --witness " + write("heads", text + "\n") + database);
    expectPlain("audit verify --since '" + text + "'" + database);
  }
}

TEST_F(OutsideText, NamesOfFilesOptionsCommandsAndWhatTheyHold) {
  for (const std::string& text : hostileTexts()) {
    expectPlain("audit verify --database '" + file(text) + "'");
    expectPlain("'" + text + "'");
    expectPlain("device check '--" + text + "'");
    expectPlain("device list --device '" + text + "'");
    expectPlain("twist --organ '" + text + "' --angle 10");
    expectPlain("twist --organ arm --angle '" + text + "'");
    const std::string table = write("t.csv", "rater," + text + ",score\n1," + text + ",x\n");
    expectPlain("agreement --method icc " + table);
    expectPlain("compare-groups " + table);
    expectPlain("standard-setting --method contrasting " + table);
    const std::string organ =
        write("o.json", "{\"id\": \"a\", \"title\": \"" + text + "\", \"" + text + "\": 1}");
    expectPlain("twist --organ " + organ + " --angle 10");
    const std::string mesh =
        write("m.obj", "mtllib " + text + "\no " + text + "\nv 0 0 0\nf 1 2 " + text + "\n");
    expectPlain("organ import " + mesh);
  }
}

TEST_F(OutsideText, NamesThatATrackerSends) {
  for (const std::string& text : hostileTexts()) {
    for (const bool json : {false, true}) {
      FakeTracker tracker;
      auto watched = std::async(std::launch::async, [&] {
        return runTorsio("tracker watch --seconds 60 --poses 1 --port " + std::to_string(tracker.port()) +
                             (json ? " --json" : ""),
                         folder_, "XDG_CONFIG_HOME=" + file("settings"));
      });
      ASSERT_TRUE(tracker.wait());
      ASSERT_TRUE(tracker.sendStatus(5, text));
      ASSERT_TRUE(tracker.sendTransform(text, {1.0, 2.0, 3.0}, 1'000'000));
      const ProgramRun shown = watched.get();

      expectPlain(shown, text);
      EXPECT_EQ(shown.code, 0) << shown.err;
      EXPECT_NE(shown.out.find(plainLine(text)), std::string::npos) << shown.out;
      EXPECT_TRUE(!json || nlohmann::json::accept(shown.out)) << shown.out;
    }
  }
}

}  // namespace
}  // namespace torsio
