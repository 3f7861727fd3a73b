// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration as a user starts it, but shortened further.
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using test::emptyFolder;
using test::ProgramRun;
using test::runTorsio;

constexpr const char* kShort = " --shorten 150 --seed 7";  // eight seconds per phase: one or two twists

std::string trialIn(const std::string& summary) {
  const std::string lead = "torsio replay ";
  const std::size_t at = summary.find(lead);
  return at == std::string::npos ? "" : summary.substr(at + lead.size(), 36);
}

void writesReportTableAndDatabaseAndReplaysBitForBit(const ProgramRun& demo, const fs::path& folder) {
  for (const char* name : {"cohort.pdf", "cohort.csv", "torsio.sqlite"}) {
    EXPECT_GT(fs::file_size(folder / "a" / name), 1000U) << name;
  }
  EXPECT_EQ(readFile(folder / "a" / "cohort.pdf").substr(0, 5), "%PDF-");
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(folder / "a")) {
    ++files;
  }
  EXPECT_EQ(files, 3U) << "nothing but the three files";

  const std::string trial = trialIn(demo.out);
  const std::string database = " --database " + (folder / "a" / "torsio.sqlite").string();
  const ProgramRun replay = runTorsio("replay " + trial + database + " --verify", folder);
  EXPECT_EQ(replay.code, 0) << replay.err;
  EXPECT_NE(replay.out.find("bit-identical"), std::string::npos) << replay.out;
  const ProgramRun unknown = runTorsio("replay ffffffff" + database, folder);
  EXPECT_EQ(unknown.code, static_cast<int>(ErrorCode::kBadData)) << unknown.err;
}

TEST(Demonstration, RejectsAnUnknownReportLanguage) {
  const fs::path folder = emptyFolder("demo-language");

  const ProgramRun refused = runTorsio("demo --out " + (folder / "out").string() + " --language tlh", folder);

  EXPECT_EQ(refused.code, static_cast<int>(ErrorCode::kUsage)) << refused.err;
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// A single test, because each demonstration takes seconds.
TEST(Demonstration, ReplaysAndReproducesItsTableInEveryReportLanguage) {
  const fs::path folder = emptyFolder("demo-twice");

  const ProgramRun first = runTorsio("demo --out " + (folder / "a").string() + kShort, folder);
  const ProgramRun second =
      runTorsio("demo --out " + (folder / "b").string() + kShort + " --language zh_CN", folder);

  ASSERT_EQ(first.code, 0) << first.err;
  ASSERT_EQ(second.code, 0) << second.err;
  EXPECT_EQ(readFile(folder / "a" / "cohort.csv"), readFile(folder / "b" / "cohort.csv"));
  writesReportTableAndDatabaseAndReplaysBitForBit(first, folder);
}

}  // namespace
}  // namespace torsio
