// SPDX-License-Identifier: GPL-3.0-or-later
// A CT through the program: the organ, its report, and the patient's anonymity.
#include <algorithm>
#include <cctype>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/file_io.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "tests/app/cli/program.h"
#include "tests/support/dicom_files.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace torsio::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::int16_t kSoft_HU = 40;

/// A bar as thick as a forearm.
TriangleMesh bar() {
  return testing::capsule(0.03, 0.16, 36, 16);
}

nlohmann::json reconstructionOf(const std::string& words, const std::filesystem::path& folder, int code,
                                std::string* said = nullptr) {
  const ProgramRun run = runTorsio("organ reconstruct --json " + words, folder);
  EXPECT_EQ(run.code, code) << run.err;
  if (said != nullptr) {
    *said = run.out + run.err;
  }
  return nlohmann::json::parse(run.out, nullptr, false);
}

/// Expects nothing of the patient in writeDicomSeries(), in any spelling.
void expectNobody(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  for (const char* word : {"doe^jane", "doe", "jane", "pid4711", "4711", "19670401"}) {
    EXPECT_THAT(text, Not(HasSubstr(word)));
  }
}

TEST(ReconstructCommand, MakesAnOrganFromACtThatTwistsAndNamesNobody) {
  const auto folder = emptyFolder("reconstruct");
  ScanVolume scan = testing::blankScanAround(bar(), {3, 3, 4});
  testing::fillWith(scan, bar(), kSoft_HU);
  testing::writeDicomSeries(folder / "ct", scan, {.syntax = "rle", .names = "Doe_Jane_"});
  const auto organ = folder / "bar.organ";

  std::string said;
  const auto made =
      reconstructionOf((folder / "ct").string() + " --tissue skin --out " + organ.string(), folder, 0, &said);
  EXPECT_TRUE(made.at("accepted").get<bool>());
  EXPECT_LE(made.at("triangles").get<int>(), 20'000);
  EXPECT_GT(made.at("triangles").get<int>(), 5'000);
  EXPECT_NEAR(made.at("volume_ml").get<double>(), 1e6 * signedVolume_m3(bar()),
              0.01 * 1e6 * signedVolume_m3(bar()));
  EXPECT_EQ(made.at("euler").get<int>(), 2);
  EXPECT_GT(made.at("seconds").get<double>(), 0.0);
  EXPECT_LT(made.at("peak_mb").get<double>(), 3000.0);
  EXPECT_EQ(made.at("scan"), "CT, " + std::to_string(scan.count[2]) + " slices, skin");
  EXPECT_NEAR(made.at("level_hu").get<double>(), -480.0, 10.0);
  EXPECT_THAT(said, HasSubstr("Reading the scan"));
  expectNobody(said);
  expectNobody(readFile(organ));

  const ProgramRun twisted = runTorsio("twist --json --angle 30 --organ " + organ.string(), folder);
  EXPECT_EQ(twisted.code, 0) << twisted.err;

  // The same with a missing slice, reported by number because a file name might identify the patient.
  std::filesystem::remove(folder / "ct" / "Doe_Jane_45.dcm");
  const auto refused = reconstructionOf((folder / "ct").string() + " --tissue skin", folder, 6, &said);
  EXPECT_FALSE(refused.at("accepted").get<bool>());
  EXPECT_EQ(refused.at("findings")[0].at("code"), "D09");
  EXPECT_FALSE(refused.at("findings")[0].at("remedy").get<std::string>().empty());
  expectNobody(said);
  const auto mended = reconstructionOf((folder / "ct").string() + " --tissue skin --resample", folder, 0);
  EXPECT_THAT(mended.at("warnings").dump(), HasSubstr("D09"));
}

TEST(ReconstructCommand, FailsWithItsExitCodes) {
  const auto folder = emptyFolder("reconstruct-refused");
  const TriangleMesh ball = testing::capsule(0.04, 0.002, 36, 6);
  ScanVolume scan = testing::blankScanAround(ball, {4, 4, 4});
  testing::fillWith(scan, ball, kSoft_HU);
  const auto nifti = folder / "ball.nii.gz";
  writeFileAtomically(nifti, testing::gzipped(testing::niftiBytes(scan)));

  const auto judged =
      reconstructionOf(nifti.string() + " --tissue skin --out " + (folder / "b.organ").string(), folder, 6);
  EXPECT_EQ(judged.at("findings")[0].at("code"), "M20");
  EXPECT_EQ(judged.at("euler"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.organ"));
  EXPECT_EQ(reconstructionOf(nifti.string() + " --tissue skin --seed -900,0,0", folder, 6)
                .at("findings")[0]
                .at("code"),
            "D16");
  EXPECT_EQ(reconstructionOf(nifti.string() + " --tissue label 3", folder, 6).at("findings")[0].at("code"),
            "N07");
  EXPECT_EQ(reconstructionOf(folder.string() + " --tissue skin", folder, 6).at("findings")[0].at("code"),
            "D01");
  EXPECT_EQ(runTorsio("organ reconstruct " + nifti.string() + " --tissue bone", folder).code, 2);
  EXPECT_EQ(runTorsio("organ reconstruct " + nifti.string() + " --tissue label 3x", folder).code, 2);
  EXPECT_EQ(runTorsio("organ reconstruct " + nifti.string() + " --tissue label 0", folder).code, 7);
  EXPECT_EQ(runTorsio("organ reconstruct " + (folder / "none").string() + " --tissue skin", folder).code, 3);
}

}  // namespace
}  // namespace torsio::test
