// SPDX-License-Identifier: GPL-3.0-or-later
// An instrument out of a scan: the shipped grasper there and back.
#include "sim/imaging/surface/tool_surface.h"

#include <algorithm>
#include <cmath>
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
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"
#include "sim/imaging/apart/scan_process.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"
#include "tests/support/scan_files.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;

constexpr double kVoxel_mm = 0.7;
constexpr double kTilt_rad = 0.35;
const Vec3 kTiltAbout{0.6, 0.8, 0.0};
const Vec3 kPlace_m{0.012, -0.034, 0.21};

TriangleMesh grasperPart(const std::string& name) {
  return importMesh(
      std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/instruments" / ("grasper_" + name + ".ply"),
      {.scale_m = 0.001, .organ = false});
}

/// A mesh of the grasper's frame as it lies in the scan: askew, and away from the origin.
TriangleMesh inScan(const TriangleMesh& mesh) {
  return testing::shifted(testing::turned(mesh, kTiltAbout, kTilt_rad), kPlace_m);
}

/// A direction of the grasper's frame in the scan.
Vec3 inScan(const Vec3& direction) {
  TriangleMesh one;
  one.vertices_m = {direction};
  return testing::turned(one, kTiltAbout, kTilt_rad).vertices_m[0];
}

/// The grasper, its shaft cut at 90 mm, in air.
ScanRead grasperScan() {
  TriangleMesh shaft = grasperPart("shaft");
  for (Vec3& v : shaft.vertices_m) {
    v.z = std::min(v.z, 0.09);
  }
  ScanRead read;
  TriangleMesh all = inScan(shaft);
  for (const TriangleMesh& jaw : {inScan(grasperPart("jaw_upper")), inScan(grasperPart("jaw_lower"))}) {
    all.vertices_m.insert(all.vertices_m.end(), jaw.vertices_m.begin(), jaw.vertices_m.end());
  }
  read.volume = testing::blankScanAround(all, {kVoxel_mm, kVoxel_mm, kVoxel_mm}, 6.0);
  testing::fillWith(read.volume, inScan(shaft), 3000);
  testing::fillWith(read.volume, inScan(grasperPart("jaw_upper")), 3000);
  testing::fillWith(read.volume, inScan(grasperPart("jaw_lower")), 3000);
  return read;
}

ToolRequest grasperRequest() {
  ToolRequest request;
  request.threshold_HU = 1000.0;
  request.jawAxis = inScan(Vec3{1, 0, 0});
  return request;
}

/// The distance that 95 % of the vertices of `a` keep from `b`.
double p95_mm(const TriangleMesh& a, const TriangleMesh& b) {
  const CollisionMesh surface(b);
  std::vector<double> distances_mm;
  for (const Vec3& v : a.vertices_m) {
    distances_mm.push_back(1000.0 * std::abs(surface.closest(v).distance_m));
  }
  std::sort(distances_mm.begin(), distances_mm.end());
  return distances_mm[distances_mm.size() * 95 / 100];
}

TEST(ToolSurface, BringsTheShippedGrasperBackInItsOwnFrame) {
  const ToolSurface tool = toolOfScan(grasperScan(), grasperRequest(), "scan");
  EXPECT_LT(norm(tool.tip_mm - 1000.0 * kPlace_m), 1.0);
  EXPECT_GT(dot(tool.axes[2], inScan(Vec3{0, 0, 1})), std::cos(0.01));
  EXPECT_GT(dot(tool.axes[0], inScan(Vec3{1, 0, 0})), std::cos(0.01));
  EXPECT_NEAR(tool.length_mm, 90.0, 1.0);
  EXPECT_NEAR(tool.shaftRadius_mm, 2.5, 0.15);
  EXPECT_GT(tool.tipRadius_mm, 0.5);
  for (const auto& [made, name] : {std::pair{&tool.shaft, "shaft"}, std::pair{&tool.upperJaw, "jaw_upper"},
                                   std::pair{&tool.lowerJaw, "jaw_lower"}}) {
    const MeshReport report = checkMesh(*made);
    EXPECT_TRUE(report.closed() && report.oriented()) << name;
    EXPECT_GT(report.volume_m3, 0.0) << name;
  }
  EXPECT_LT(p95_mm(tool.upperJaw, grasperPart("jaw_upper")), kVoxel_mm);
  EXPECT_LT(p95_mm(tool.lowerJaw, grasperPart("jaw_lower")), kVoxel_mm);
  for (const Vec3& v : tool.shaft.vertices_m) {
    EXPECT_GT(v.z, 0.0185);  // it begins at the hinge
  }
}

TEST(ToolSurface, FindsTheTipAtTheOtherEndWhenThatIsSaid) {
  const ScanRead scan = grasperScan();
  ToolRequest request = grasperRequest();
  request.tip_mm = 1000.0 * kPlace_m + 90.0 * inScan(Vec3{0, 0, 1});
  const ToolSurface tool = toolOfScan(scan, request, "scan");
  EXPECT_LT(dot(tool.axes[2], inScan(Vec3{0, 0, 1})), -0.999);
}

TEST(ToolSurface, SaysWhyThereIsNoInstrument) {
  const ScanRead scan = grasperScan();
  const auto refusal = [&scan](const ToolRequest& request) {
    return testing::refusalText([&] { return toolOfScan(scan, request, "scan"); });
  };
  ToolRequest request = grasperRequest();
  request.threshold_HU = 2999.5;
  request.pivot_mm = 60.0;
  EXPECT_THAT(refusal(request), HasSubstr("D16"));
  request = grasperRequest();
  request.pivot_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(request), HasSubstr("out of range"));
  request = grasperRequest();
  request.shaft = Vec3{};
  EXPECT_THAT(refusal(request), HasSubstr("out of range"));
}

TEST(ToolSurface, ComesFromAnotherProcessAsItIs) {
  ToolRequest request = grasperRequest();
  request.source =
      std::filesystem::path(::testing::TempDir()) / ("tool-" + std::to_string(getpid()) + ".nii.gz");
  ScanRead scan;
  scan.volume = testing::blankScan({30, 30, 90}, {1, 1, 1}, {0, 0, 0});
  testing::fillWith(scan.volume,
                    testing::shifted(testing::capsule(0.005, 0.07, 24, 12), {0.015, 0.015, 0.01}), 2000);
  writeFileAtomically(request.source, testing::gzipped(testing::niftiBytes(scan.volume)));
  request.jawAxis = Vec3{1, 0, 0};
  request.pivot_mm = 15.0;
  const ToolSurface apart = toolApart(request);
  const ToolSurface here = toolOfScan(request);
  EXPECT_EQ(contentHash(apart.shaft), contentHash(here.shaft));
  EXPECT_EQ(contentHash(apart.upperJaw), contentHash(here.upperJaw));
  EXPECT_EQ(contentHash(apart.lowerJaw), contentHash(here.lowerJaw));
  EXPECT_EQ(apart.length_mm, here.length_mm);
  EXPECT_EQ(apart.pivot_mm, 15.0);
  EXPECT_EQ(apart.axes, here.axes);
  ASSERT_FALSE(apart.remarks.empty());  // jaws of another length than the force knows
  EXPECT_EQ(apart.remarks.back().code, "D22");
}

}  // namespace
}  // namespace torsio
