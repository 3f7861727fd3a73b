// SPDX-License-Identifier: GPL-3.0-or-later
// A scripted twist with each model, recorded and replayed by the program.
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/cli/program.h"

namespace torsio::test {
namespace {

class RecordCommand : public ::testing::TestWithParam<std::string> {};

TEST_P(RecordCommand, StoresATrialThatNamesItsModelAndReplaysBitForBit) {
  const auto folder = emptyFolder("record-" + GetParam());
  const std::string database = " --database " + (folder / "torsio.sqlite").string();

  const ProgramRun recorded = runTorsio(
      "record --duration 6 --json --ridges 12 --sections 13 --model " + GetParam() + database, folder);
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  const auto trial = nlohmann::json::parse(recorded.out);
  const ProgramRun replayed =
      runTorsio("replay " + trial.at("trial").get<std::string>() + " --verify --json" + database, folder);

  EXPECT_EQ(trial.at("model"), GetParam());
  EXPECT_EQ(trial.at("samples"), 6000);
  ASSERT_EQ(replayed.code, 0) << replayed.err;
  const auto replay = nlohmann::json::parse(replayed.out);
  EXPECT_TRUE(replay.at("identical").get<bool>());
  EXPECT_EQ(replay.at("model"), GetParam());
}

INSTANTIATE_TEST_SUITE_P(Models, RecordCommand, ::testing::Values("twist", "fem", "msm"),
                         [](const auto& one) { return one.param; });

TEST(RecordCommandLine, RejectsAnUnknownModel) {
  const auto folder = emptyFolder("record-unknown");

  const ProgramRun run =
      runTorsio("record --model cloth --database " + (folder / "torsio.sqlite").string(), folder);

  EXPECT_EQ(run.code, 2);
  EXPECT_NE(run.err.find("cloth"), std::string::npos);
}

}  // namespace
}  // namespace torsio::test
