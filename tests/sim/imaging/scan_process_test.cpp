// SPDX-License-Identifier: GPL-3.0-or-later
// Scans in a process of their own: what it answers, and what becomes of one that does not.
#include "sim/imaging/apart/scan_process.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/imaging/apart/scan_mail.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"
#include "tests/support/scan_files.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::filesystem::path apartFile(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("apart-" + std::to_string(getpid()) + "-" + name);
}

/// A bar in a CT.
ScanRequest barRequest() {
  ScanRequest request{.source = apartFile("bar.nii.gz")};
  const TriangleMesh bar = testing::capsule(0.02, 0.06, 24, 8);
  ScanVolume scan = testing::blankScanAround(bar, {4, 4, 4}, 16.0);
  testing::fillWith(scan, bar, 40);
  writeFileAtomically(request.source, testing::gzipped(testing::niftiBytes(scan)));
  return request;
}

/// Puts another program in the place of the one that reads scans.
class OtherScanReader {
 public:
  explicit OtherScanReader(const std::string& script) : before_(std::getenv("TORSIO_SCAN_PROGRAM")) {
    const std::filesystem::path file = apartFile("reader.sh");
    std::ofstream(file) << "#!/bin/sh\n" << script << '\n';
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    setenv("TORSIO_SCAN_PROGRAM", file.c_str(), 1);
  }
  ~OtherScanReader() { setenv("TORSIO_SCAN_PROGRAM", before_.c_str(), 1); }
  OtherScanReader(const OtherScanReader&) = delete;
  OtherScanReader& operator=(const OtherScanReader&) = delete;

 private:
  std::string before_;
};

std::string refusalApart(const ScanRequest& request, const HelperLimits& limits = kScanLimits) {
  return testing::refusalText([&] { return scanApart(request, {}, limits); }, ErrorCode::kFileUnreadable);
}

TEST(ScanApart, AnswersWithTheSameSurfaceAndTellsHowFarItIs) {
  const ScanRequest request = barRequest();
  std::vector<ScanStep> steps;
  const ScanApart apart = scanApart(request, [&steps](ScanStep step, double fraction) {
    EXPECT_GE(fraction, 0.0);
    EXPECT_LE(fraction, 1.0);
    if (steps.empty() || steps.back() != step) {
      steps.push_back(step);
    }
  });
  const ScanSurface here = surfaceOfScan(request);
  EXPECT_EQ(contentHash(apart.surface.mesh), contentHash(here.mesh));
  EXPECT_EQ(apart.surface.kind, "NIfTI, skin");
  EXPECT_EQ(apart.surface.count, here.count);
  EXPECT_EQ(apart.surface.level_HU, here.level_HU);
  EXPECT_EQ(apart.surface.rawTriangles, here.rawTriangles);
  EXPECT_GT(apart.peak_MB, 1.0);
  EXPECT_THAT(steps, ::testing::ElementsAre(ScanStep::kReading, ScanStep::kSegmenting, ScanStep::kDrawing,
                                            ScanStep::kThinning));
}

TEST(ScanApart, RefusesWhatTheOtherProcessRefuses) {
  ScanRequest request = barRequest();
  request.tissue = ScanTissue::kLabel;
  request.label = 9;
  EXPECT_THAT(refusalApart(request), StartsWith("N07"));
  request.source = apartFile("none.nii");
  EXPECT_THROW(static_cast<void>(scanApart(request)), Error);
  EXPECT_NE(refusalApart(barRequest(), {30, 60, 60}), "accepted");  // too little memory to begin with
}

TEST(ScanApart, OutlivesAReaderThatCrashesHangsOrTalksNonsense) {
  const ScanRequest request = barRequest();
  {
    const OtherScanReader crashing("kill -SEGV $$");
    EXPECT_THAT(refusalApart(request), HasSubstr("crashed on this scan (signal 11)"));
  }
  {
    const OtherScanReader hanging("exec sleep 100");
    EXPECT_THAT(refusalApart(request, {1000, 60, 0}), HasSubstr("did not come to an end"));
  }
  {
    const OtherScanReader talking("echo nonsense of any length >&3");
    EXPECT_THAT(refusalApart(request), ::testing::AnyOf(StartsWith("D04"), StartsWith("M05")));
  }
  {
    const OtherScanReader silent("exit 0");
    EXPECT_THAT(refusalApart(request), StartsWith("D04 the reader gave no answer"));
  }
}

TEST(ScanApart, HearsTheLastNewsOfAReaderThatEndsAtOnce) {
  const OtherScanReader quick(R"(printf '\000\144\001\144\002\144\003\144' >&4)");
  std::vector<ScanStep> steps;
  EXPECT_THROW(static_cast<void>(scanApart(
                   barRequest(), [&steps](ScanStep step, double /*fraction*/) { steps.push_back(step); })),
               Error);  // it gave no answer
  EXPECT_THAT(steps, ::testing::ElementsAre(ScanStep::kReading, ScanStep::kSegmenting, ScanStep::kDrawing,
                                            ScanStep::kThinning));
}

TEST(ScanApart, CarriesARequestInWords) {
  ScanRequest request{.source = "some folder/scan",
                      .tissue = ScanTissue::kWall,
                      .label = 12,
                      .seed_mm = Vec3{-1.25, 1.0 / 3.0, 1e-9},
                      .box_mm = ScanBox{Vec3{-1, -2, -3}, Vec3{1, 2, 3}},
                      .wall_mm = 4.1,
                      .series = 3,
                      .resample = true,
                      .fluid = true};
  const std::vector<std::string> words = wordsOf(request);
  std::vector<const char*> bare;
  for (const std::string& word : words) {
    bare.push_back(word.c_str());
  }
  const auto read = requestOfWords(bare);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->source, request.source);
  EXPECT_EQ(read->tissue, request.tissue);
  EXPECT_EQ(read->label, 12);
  EXPECT_EQ(read->series, 3);
  EXPECT_TRUE(read->resample);
  EXPECT_EQ(read->seed_mm, request.seed_mm);
  EXPECT_EQ(read->box_mm, request.box_mm);
  EXPECT_EQ(read->wall_mm, request.wall_mm);
  EXPECT_TRUE(read->fluid);
  bare.pop_back();
  EXPECT_FALSE(requestOfWords(bare).has_value());
}

}  // namespace
}  // namespace torsio
