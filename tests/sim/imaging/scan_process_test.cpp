// SPDX-License-Identifier: GPL-3.0-or-later
// Scans in a process of their own: what it answers, and what becomes of one that does not.
// A scan that is looked at: turned to the patient's axes, made small, with the organ's mask; and the brush.
#include "sim/imaging/apart/scan_process.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <unistd.h>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/imaging/apart/scan_mail.h"
#include "sim/imaging/surface/scan_preview.h"
#include "tests/support/other_program.h"
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

/// Another program in the place of the one that reads scans.
struct OtherScanReader : testing::OtherProgram {
  explicit OtherScanReader(const std::string& script)
      : OtherProgram("TORSIO_SCAN_PROGRAM", apartFile("reader.sh"), script) {}
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

/// A bar of 40 HU in air, upright, 40 mm thick and 120 mm long, its middle at the origin.
ScanRead uprightBar() {
  const TriangleMesh bar = testing::shifted(testing::capsule(0.02, 0.08, 32, 16), {0, 0, -0.04});
  ScanRead read;
  read.volume = testing::blankScanAround(bar, {2, 2, 3}, 16.0);
  testing::fillWith(read.volume, bar, 40);
  return read;
}

std::int16_t valueAt(const ScanVolume& volume, const Vec3& place_mm) {
  const Vec3 at = volume.voxelAt(place_mm);
  return volume
      .values[volume.index(static_cast<std::size_t>(at.x + 0.5), static_cast<std::size_t>(at.y + 0.5),
                           static_cast<std::size_t>(at.z + 0.5))];
}

double maskVolume_ml(const ScanPreview& preview) {
  return 0.001 * preview.volume.voxel_mm3() *
         static_cast<double>(std::count(preview.within.begin(), preview.within.end(), 1));
}

TEST(ScanPreview, TurnsAnyScanToThePatientsAxes) {
  // A cube of its own value to the left, at the back, at the head; the scan runs the other way along each.
  ScanRead read;
  read.volume.count = {30, 20, 40};
  read.volume.step_mm = {Vec3{0, 0, -2}, Vec3{-3, 0, 0}, Vec3{0, -1.5, 0}};
  read.volume.origin_mm = {30, 30, 30};
  read.volume.values.assign(30U * 20U * 40U, -1000);
  for (std::size_t k = 0; k < 40; ++k) {
    for (std::size_t j = 0; j < 20; ++j) {
      for (std::size_t i = 0; i < 30; ++i) {
        const Vec3 at =
            read.volume.place_mm({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
        if (at.x > 5 && at.x < 20 && at.y > 8 && at.y < 24 && at.z > 10 && at.z < 26) {
          read.volume.values[read.volume.index(i, j, k)] = 70;
        }
      }
    }
  }
  const ScanPreview preview = previewOfScan(read, {}, false);
  EXPECT_GT(preview.volume.step_mm[0].x, 0.0);
  EXPECT_GT(preview.volume.step_mm[1].y, 0.0);
  EXPECT_GT(preview.volume.step_mm[2].z, 0.0);
  EXPECT_TRUE(preview.within.empty());
  for (const Vec3& place_mm : {Vec3{12, 16, 18}, Vec3{-12, 16, 18}, Vec3{12, -16, 18}, Vec3{12, 16, -18}}) {
    EXPECT_EQ(valueAt(preview.volume, place_mm), valueAt(read.volume, place_mm)) << place_mm.x;
  }
  EXPECT_EQ(valueAt(preview.volume, {12, 16, 18}), 70);
}

TEST(ScanPreview, KeepsToSoManyVoxelsAndShowsTheOrganWhereItIs) {
  const ScanRead read = uprightBar();
  constexpr double kMost = 5000.0;
  const ScanPreview preview = previewOfScan(read, {}, true, kMost);
  EXPECT_LE(static_cast<double>(preview.volume.values.size()), kMost);
  ASSERT_EQ(preview.within.size(), preview.volume.values.size());
  const double bar_ml = 134.0;  // 0.02^2 pi 0.08 + 4/3 0.02^3 pi
  EXPECT_NEAR(preview.volume_ml.value(), bar_ml, 5.0);
  EXPECT_NEAR(maskVolume_ml(preview), bar_ml, 12.0);
}

TEST(ScanPreview, BrushesTheMaskAndTheSurface) {
  const ScanRead read = uprightBar();
  ScanRequest request;
  const double whole_m3 = signedVolume_m3(surfaceOfScan(read, request, "scan").mesh);
  // A knob of 20 mm that sticks out to the left by half; then the upper end is cut off.
  request.brush = {{{20, 0, 0}, 10.0, true}, {{0, 0, 50}, 30.0, false}};
  const ScanSurface mended = surfaceOfScan(read, request, "scan");
  EXPECT_EQ(checkMesh(mended.mesh).euler, 2);
  const auto [left, right] = std::minmax_element(mended.mesh.vertices_m.begin(), mended.mesh.vertices_m.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
  EXPECT_NEAR(right->x, 0.030, 0.0015);
  EXPECT_NEAR(left->x, -0.020, 0.001);
  const auto top = std::max_element(mended.mesh.vertices_m.begin(), mended.mesh.vertices_m.end(),
                                    [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
  EXPECT_LT(top->z, 0.033);
  EXPECT_LT(signedVolume_m3(mended.mesh), 0.8 * whole_m3);
  const auto told = std::find_if(mended.remarks.begin(), mended.remarks.end(),
                                 [](const ScanRemark& remark) { return remark.code == "D19"; });
  ASSERT_NE(told, mended.remarks.end());
  EXPECT_THAT(told->what.str(), HasSubstr("corrected by hand"));
  // The preview of the other process shows the same.
  EXPECT_NEAR(previewOfScan(read, request, true).volume_ml.value(), 1e6 * signedVolume_m3(mended.mesh), 3.0);
}

TEST(ScanPreview, RefusesABrushThatLeavesNothingOrIsOutOfRange) {
  const ScanRead read = uprightBar();
  ScanRequest request{.brush = {{{0, 0, 0}, 90.0, false}}};
  EXPECT_THROW(static_cast<void>(surfaceOfScan(read, request, "scan")), Error);
  request.brush = {{{std::numeric_limits<double>::quiet_NaN(), 0, 0}, 5.0, true}};
  EXPECT_THROW(requireScanRequest(request), Error);
  request.brush = {{{0, 0, 0}, 500.0, true}};
  EXPECT_THROW(requireScanRequest(request), Error);
}

/// The bar as a file.
ScanRequest barFileRequest() {
  ScanRequest request;
  request.source =
      std::filesystem::path(::testing::TempDir()) / ("preview-" + std::to_string(getpid()) + "-bar.nii");
  writeFileAtomically(request.source, testing::niftiBytes(uprightBar().volume));
  return request;
}

TEST(ScanPreview, ComesFromAnotherProcessAsItIs) {
  ScanRequest request = barFileRequest();
  for (int n = 0; n < 2500; ++n) {  // more than one word holds
    request.brush.push_back({{20.0 + 1e-3 * n, 0, 0}, 8.0, true});
  }
  const ScanPreview apart = previewApart(request, true);
  const ScanPreview here = previewOfScan(request, true);
  EXPECT_EQ(apart.kind, "NIfTI");
  EXPECT_EQ(apart.volume.count, here.volume.count);
  EXPECT_EQ(apart.volume.values, here.volume.values);
  EXPECT_EQ(apart.within, here.within);
  EXPECT_EQ(apart.volume_ml, here.volume_ml);
  EXPECT_TRUE(previewApart(request, false).within.empty());
}

TEST(ScanPreview, IsGivenUpWhenNobodyWantsItAnyMore) {
  struct GivenUp {};
  const ScanRequest request = barFileRequest();
  EXPECT_THROW(static_cast<void>(previewApart(request, true, [](ScanStep, double) { throw GivenUp{}; })),
               GivenUp);
}

TEST(ScanPreview, TrustsNoBytesOfAnotherProcess) {
  ScanPreview preview = previewOfScan(uprightBar(), {}, false, 1000.0);
  const std::string mail = mailOf(preview);
  EXPECT_EQ(previewOfMail(mail, "scan").volume.values, preview.volume.values);
  for (const std::size_t cut : {std::size_t{0}, std::size_t{5}, mail.size() / 2, mail.size() - 1}) {
    EXPECT_THROW(static_cast<void>(previewOfMail(std::string_view(mail).substr(0, cut), "scan")), Error);
  }
  preview.volume.count = {100'000, 100'000, 100'000};
  EXPECT_THROW(static_cast<void>(previewOfMail(mailOf(preview), "scan")), Error);
}

}  // namespace
}  // namespace torsio
