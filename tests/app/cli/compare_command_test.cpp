// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/cli/program.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

/// A lattice so coarse that a run takes seconds.
const std::string kCoarse = "compare --ridges 12 --sections 9 --rings 2 --substeps 4 --ramp 0.2 --out ";

TEST(CompareCommand, ComparesTheModelsOfTheArmAndWritesItsReport) {
  const fs::path folder = emptyFolder("compare");
  const fs::path measured = fs::path(TORSIO_TEST_DATA) / "comparison" / "markers_synthetic.csv";

  const ProgramRun run =
      runTorsio(kCoarse + (folder / "out").string() + " --organ wrist --torque -0.01 --measured " +
                    measured.string() + " --json",
                folder);

  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["organ"], "Right forearm");
  EXPECT_EQ(json["torque_nm"], -0.01);
  EXPECT_EQ(json["models"].size(), 6U);
  EXPECT_EQ(json["measured"][7]["subjects"], 2);
  EXPECT_NE(run.err.find("Equilibrium"), std::string::npos) << "progress";
  for (const char* name :
       {"comparison.pdf", "comparison.json", "models.csv", "meshes.csv", "markers.csv", "course.csv"}) {
    EXPECT_TRUE(fs::exists(folder / "out" / name)) << name;
  }
}

TEST(CompareCommand, ReadsMarkersFromAFileAndMeasurementsFromCameras) {
  const fs::path folder = emptyFolder("compare-markers");
  const fs::path markers = folder / "markers.json";
  std::ofstream(markers)
      << R"({"markers": [{"number": 1, "name": "crease", "position_mm": [0.00, -22.40, 262.00]}]})";
  const fs::path tracks = folder / "tracks.trc";
  std::ofstream(tracks) << "PathFileType\t4\t(X/Y/Z)\ttracks.trc\nDataRate\tNumFrames\tNumMarkers\tUnits\n"
                           "50\t2\t1\tcm\nFrame#\tTime\tcrease\n\t\tX1\tY1\tZ1\n"
                           "1\t0\t1\t2\t3\n2\t0.02\t1\t2\t4\n";

  const ProgramRun run = runTorsio(kCoarse + (folder / "out").string() + " --torque -0.01 --markers " +
                                       markers.string() + " --measured " + tracks.string() + " --json",
                                   folder);

  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  ASSERT_EQ(json["measured"].size(), 1U);
  EXPECT_NEAR(json["measured"][0]["displacement_m"].get<double>(), 0.01, 1e-12);  // 1 cm along z
  EXPECT_EQ(json["models"][1]["settled"]["marker_displacements_m"].size(), 1U);
}

TEST(CompareCommand, AJawRotatesEveryModel) {
  const fs::path folder = emptyFolder("compare-jaw");

  const ProgramRun run = runTorsio(
      kCoarse + (folder / "out").string() + " --torque -0.01 --ends clamped-free --grasp 0.7 --json", folder);

  ASSERT_EQ(run.code, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["ends"], "clamped-free");
  EXPECT_EQ(json["grasp"], 0.7);
  const double reference_rad = json["models"][0]["settled"]["angle_rad"];
  EXPECT_LT(reference_rad, -0.05);
  EXPECT_EQ(json["models"][3]["id"], "rod");
  // On such a coarse lattice the jaw is one section, in the rod everything within half a radius: a third
  // stiffer. On 61 sections they differ by 2 %.
  EXPECT_NEAR(json["models"][3]["settled"]["angle_rad"].get<double>() / reference_rad, 0.75, 0.1);
  for (const auto& model : json["models"]) {
    EXPECT_LT(model["moving"]["angle_rad"], -0.02) << model["id"];
  }
}

TEST(CompareCommand, FailsWithTheDocumentedCodes) {
  const fs::path folder = emptyFolder("compare-refused");
  const auto codeOf = [&](const std::string& arguments) {
    return runTorsio(kCoarse + (folder / "out").string() + " " + arguments, folder).code;
  };

  EXPECT_EQ(codeOf("--torque 0"), static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(codeOf("--nu 0.5"), static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(codeOf("--ends clamped-free --grasp 1.2"), static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(codeOf("--ends clamped-free --grasp 0.01"), static_cast<int>(ErrorCode::kBadParameter));
  EXPECT_EQ(codeOf("--grasp 0.5"), static_cast<int>(ErrorCode::kUsage));
  EXPECT_EQ(codeOf("--organ leg"), static_cast<int>(ErrorCode::kUsage));
  EXPECT_EQ(codeOf("--calibration none"), static_cast<int>(ErrorCode::kUsage));
  EXPECT_EQ(codeOf("--measured /nowhere.csv"), static_cast<int>(ErrorCode::kFileMissing));
  EXPECT_EQ(codeOf("--markers /nowhere.json"), static_cast<int>(ErrorCode::kFileMissing));
  EXPECT_EQ(codeOf("--organ intestine --measured /nowhere.csv"), static_cast<int>(ErrorCode::kFileMissing));
  EXPECT_FALSE(fs::exists(folder / "out"));
}

// A scripted twist with each model, recorded and replayed by the program.

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

// The demonstration as a user starts it, but shortened further.

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
