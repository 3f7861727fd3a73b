// SPDX-License-Identifier: GPL-3.0-or-later
// An instrument out of a mesh of it: pieces, one body, open jaws, handles, and what is none.
// An instrument as a file: what is written reads as the shipped one does.
#include "sim/scene/instrument_import.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>
#include <string>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/pose.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"
#include "sim/scene/instrument_file.h"
#include "sim/scene/scene_file.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;

constexpr double kLie_rad = 0.8;
const Vec3 kLieAbout{0.48, 0.6, 0.64};
const Vec3 kLieAt_m{0.3, -0.05, 0.02};

TriangleMesh grasperPiece(const std::string& name) {
  return importMesh(
      std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/instruments" / ("grasper_" + name + ".ply"),
      {.scale_m = 0.001, .organ = false});
}

/// A mesh of the grasper's frame as it lies in a CAD file.
TriangleMesh inFile(const TriangleMesh& mesh) {
  return testing::shifted(testing::turned(mesh, kLieAbout, kLie_rad), kLieAt_m);
}

Vec3 inFile(const Vec3& direction) {
  return rotateAbout(direction, kLieAbout, kLie_rad);
}

/// The jaw of the grasper opened by an angle about its hinge.
TriangleMesh opened(TriangleMesh jaw, double angle_deg) {
  const Vec3 pivot_m{0, 0, 0.02};
  for (Vec3& v : jaw.vertices_m) {
    v = pivot_m + rotateAbout(v - pivot_m, {1, 0, 0}, radians(angle_deg));
  }
  return jaw;
}

TriangleMesh grasperInFile(double opening_deg = 0.0) {
  TriangleMesh whole = inFile(grasperPiece("shaft"));
  whole = testing::together(whole, inFile(opened(grasperPiece("jaw_upper"), opening_deg)));
  whole = testing::together(whole, inFile(opened(grasperPiece("jaw_lower"), -opening_deg)));
  return whole;
}

InstrumentImportRequest ofMesh() {
  InstrumentImportRequest request;
  request.file = "tool.stl";
  return request;
}

std::string refusalOf(const TriangleMesh& mesh, const InstrumentImportRequest& request) {
  return testing::refusalText([&] { return toolOfMesh({mesh, {}}, request); });
}

/// The largest distance of the vertices of `a` from `b`.
double farthest_mm(const TriangleMesh& a, const TriangleMesh& b) {
  const CollisionMesh surface(b);
  double most_m = 0.0;
  for (const Vec3& v : a.vertices_m) {
    most_m = std::max(most_m, std::abs(surface.closest(v).distance_m));
  }
  return 1000.0 * most_m;
}

bool isNoted(const ToolSurface& tool, const std::string& code) {
  return std::any_of(tool.remarks.begin(), tool.remarks.end(),
                     [&code](const ScanRemark& one) { return one.code == code; });
}

TEST(InstrumentImport, TakesThePiecesOfAGrasperApartAsTheyWere) {
  InstrumentImportRequest request = ofMesh();
  request.jawAxis = inFile(Vec3{1, 0, 0});

  const ToolSurface tool = toolOfMesh({grasperInFile(), {}}, request);

  EXPECT_LT(norm(tool.tip_mm - 1000.0 * kLieAt_m), 0.2);
  EXPECT_GT(dot(tool.axes[2], inFile(Vec3{0, 0, 1})), std::cos(0.005));
  EXPECT_GT(dot(tool.axes[0], inFile(Vec3{1, 0, 0})), std::cos(0.005));
  EXPECT_NEAR(tool.length_mm, 250.0, 0.5);
  EXPECT_NEAR(tool.shaftRadius_mm, 2.5, 0.05);
  EXPECT_GT(tool.tipRadius_mm, 0.5);
  EXPECT_LT(farthest_mm(tool.shaft, grasperPiece("shaft")), 0.5);
  EXPECT_LT(farthest_mm(tool.upperJaw, grasperPiece("jaw_upper")), 0.2);
  EXPECT_LT(farthest_mm(tool.lowerJaw, grasperPiece("jaw_lower")), 0.2);
  // Its teeth are whole.
  EXPECT_NEAR(checkMesh(tool.upperJaw).volume_m3 / checkMesh(grasperPiece("jaw_upper")).volume_m3, 1.0, 1e-3);
}

TEST(InstrumentImport, ClosesJawsThatAreDrawnOpen) {
  InstrumentImportRequest request = ofMesh();
  request.drawnOpen_deg = 25.0;

  const ToolSurface tool = toolOfMesh({grasperInFile(25.0), {}}, request);

  EXPECT_GT(std::abs(dot(tool.axes[0], inFile(Vec3{1, 0, 0}))), std::cos(0.02));
  EXPECT_NEAR(tool.pivot_mm, 20.0, 0.05);
  EXPECT_NEAR(tool.length_mm, 250.0, 0.5);
  EXPECT_LT(norm(tool.tip_mm - 1000.0 * kLieAt_m), 0.5);
  const bool sameWayUp = dot(tool.axes[0], inFile(Vec3{1, 0, 0})) > 0.0;
  EXPECT_LT(farthest_mm(tool.upperJaw, grasperPiece(sameWayUp ? "jaw_upper" : "jaw_lower")), 6.0);
  double highest_m = 0.0;
  for (const Vec3& v : tool.upperJaw.vertices_m) {
    highest_m = std::max(highest_m, v.y);
  }
  EXPECT_LT(highest_m, 0.0035);  // closed: no higher than the shaft is thick
}

TEST(InstrumentImport, CutsABodyOfOnePieceAndClosesTheCuts) {
  const TriangleMesh bar = testing::capsule(0.004, 0.16, 48, 60);

  const ToolSurface tool = toolOfMesh({inFile(bar), {}}, ofMesh());

  EXPECT_NEAR(tool.length_mm, 168.0, 0.5);
  EXPECT_NEAR(tool.shaftRadius_mm, 4.0, 0.1);
  double sum_m3 = 0.0;
  for (const TriangleMesh* part : {&tool.shaft, &tool.upperJaw, &tool.lowerJaw}) {
    const MeshReport report = checkMesh(*part);
    EXPECT_TRUE(report.closed() && report.oriented() && report.manifold());
    EXPECT_GT(report.volume_m3, 0.0);
    sum_m3 += report.volume_m3;
  }
  EXPECT_NEAR(sum_m3 / checkMesh(bar).volume_m3, 1.0, 1e-3);
  EXPECT_NEAR(checkMesh(tool.upperJaw).volume_m3 / checkMesh(tool.lowerJaw).volume_m3, 1.0, 0.02);
}

TEST(InstrumentImport, FindsTheShaftBesideALargeHandle) {
  TriangleMesh whole = grasperInFile();
  TriangleMesh handle = testing::prism(testing::rectangleOutline(0.012, 0.11, 6), 0.06, 6);
  whole = testing::together(whole, inFile(testing::shifted(handle, {0.0, -0.05, 0.245})));
  InstrumentImportRequest request = ofMesh();
  request.jawAxis = inFile(Vec3{1, 0, 0});

  const ToolSurface tool = toolOfMesh({whole, {}}, request);

  EXPECT_GT(dot(tool.axes[2], inFile(Vec3{0, 0, 1})), std::cos(radians(1.0)));
  EXPECT_LT(norm(tool.tip_mm - 1000.0 * kLieAt_m), 2.0);
  EXPECT_NEAR(tool.length_mm, 305.0, 1.5);
  EXPECT_NEAR(tool.shaftRadius_mm, 2.5, 0.3);
}

TEST(InstrumentImport, TakesTheOtherEndForTheTipWhenThatIsSaid) {
  InstrumentImportRequest request = ofMesh();
  request.tip_mm = 1000.0 * kLieAt_m + 250.0 * inFile(Vec3{0, 0, 1});

  EXPECT_LT(dot(toolOfMesh({grasperInFile(), {}}, request).axes[2], inFile(Vec3{0, 0, 1})), -0.99);
}

TEST(InstrumentImport, ShowsAnOpenSurfaceAsItIs) {
  TriangleMesh mesh = grasperInFile();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 3);

  const ToolSurface tool = toolOfMesh({mesh, {}}, ofMesh());

  EXPECT_TRUE(isNoted(tool, "M11"));
  EXPECT_TRUE(isNoted(tool, "D22"));  // the hinge was assumed
}

TEST(InstrumentImport, ThinsAFineMesh) {
  const ToolSurface tool = toolOfMesh({inFile(testing::capsule(0.004, 0.16, 300, 200)), {}}, ofMesh());

  EXPECT_LT(tool.shaft.triangles.size() + tool.upperJaw.triangles.size() + tool.lowerJaw.triangles.size(),
            45'000U);
  EXPECT_NEAR(tool.length_mm, 168.0, 0.5);
}

TEST(InstrumentImport, SaysWhyAMeshIsNoInstrument) {
  EXPECT_THAT(refusalOf({}, ofMesh()), HasSubstr("M06"));
  TriangleMesh small = grasperInFile();
  for (Vec3& v : small.vertices_m) {
    v = 0.001 * v;
  }
  EXPECT_THAT(refusalOf(small, ofMesh()), HasSubstr("M09"));
  EXPECT_THAT(refusalOf(small, ofMesh()), HasSubstr("metres"));
  EXPECT_THAT(refusalOf(testing::capsule(0.017, 0.004, 24, 8), ofMesh()), HasSubstr("M20"));
  TriangleMesh far = grasperInFile();
  far.vertices_m[7].x = 1e7;
  EXPECT_THAT(refusalOf(far, ofMesh()), ::testing::AnyOf(HasSubstr("M07"), HasSubstr("M09")));
  far.vertices_m[7].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusalOf(far, ofMesh()), HasSubstr("M07"));
  TriangleMesh sheet{.vertices_m = {{0, 0, 0}, {0.01, 0, 0}, {0.01, 0, 0.2}, {0, 0, 0.2}},
                     .triangles = {{0, 1, 2}, {0, 2, 3}}};
  EXPECT_THAT(refusalOf(sheet, ofMesh()), HasSubstr("M18"));
  InstrumentImportRequest request = ofMesh();
  request.pivot_mm = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusalOf(grasperInFile(), request), HasSubstr("out of range"));
  request = ofMesh();
  request.drawnOpen_deg = 120.0;
  EXPECT_THAT(refusalOf(grasperInFile(), request), HasSubstr("0 to 90"));
}

TEST(InstrumentImport, ReadsTheFileInAnotherProcess) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("tool-mesh-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  InstrumentImportRequest request = ofMesh();
  request.file = folder / "tool.ply";
  writePly(request.file, grasperInFile());
  EXPECT_NEAR(importInstrument(request).length_mm, 250.0, 0.5);

  request.file = folder / "tool.txt";
  writeFileAtomically(request.file, "solid nothing\n");
  EXPECT_THAT(testing::refusal([&] { return importInstrument(request); }).happened(), HasSubstr("M02"));
}

const std::filesystem::path kShippedAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

TriangleMesh shippedPart(const std::string& name) {
  return importMesh(kShippedAssets / "instruments" / ("grasper_" + name + ".ply"),
                    {.scale_m = 0.001, .organ = false});
}

/// The shipped grasper as if a scan had shown it.
ToolSurface shippedTool() {
  ToolSurface tool;
  tool.shaft = shippedPart("shaft");
  tool.upperJaw = shippedPart("jaw_upper");
  tool.lowerJaw = shippedPart("jaw_lower");
  tool.length_mm = 250.0;
  tool.pivot_mm = 20.0;
  tool.shaftRadius_mm = 2.5;
  tool.tipRadius_mm = 2.5;
  return tool;
}

/// Names of all fields, those within others after their own, without the hand, which no scan of a tool shows.
std::set<std::string> fieldsOf(const std::filesystem::path& file) {
  std::set<std::string> names;
  const nlohmann::json json = nlohmann::json::parse(readFile(file)).flatten();
  for (const auto& [name, value] : json.items()) {
    if (name != "/meshes/hand") {
      names.insert(name);
    }
  }
  return names;
}

TEST(InstrumentFile, ReadsAsTheShippedOneDoes) {
  const std::filesystem::path assets =
      std::filesystem::path(::testing::TempDir()) / ("instrument-" + std::to_string(getpid()));
  std::filesystem::create_directories(assets / "instruments");
  const std::filesystem::path file = assets / "instruments" / "mine.json";
  writeInstrument(file, shippedTool(), {});

  const Instrument mine = readInstrument(assets, "mine");
  const Instrument shipped = readInstrument(kShippedAssets, "grasper");
  EXPECT_EQ(mine.id, "mine");
  EXPECT_DOUBLE_EQ(mine.tipRadius_m, shipped.tipRadius_m);
  EXPECT_DOUBLE_EQ(mine.shaftLength_m, shipped.shaftLength_m);
  EXPECT_DOUBLE_EQ(mine.gripReach_m, shipped.gripReach_m);
  EXPECT_EQ(fieldsOf(file), fieldsOf(kShippedAssets / "instruments" / "grasper.json"));
  const TriangleMesh jaw =
      importMesh(assets / "instruments" / "mine_jaw_upper.ply", {.scale_m = 0.001, .organ = false});
  EXPECT_EQ(jaw.triangles.size(), shippedPart("jaw_upper").triangles.size());
}

TEST(InstrumentFile, RefusesMeasuresThatNoInstrumentHas) {
  ToolSurface tool = shippedTool();
  tool.length_mm = 5.0;
  EXPECT_THROW(writeInstrument("mine.json", tool, {}), Error);
  tool = shippedTool();
  EXPECT_THROW(writeInstrument("mine.json", tool, {.tipRadius_mm = 200.0}), Error);
  EXPECT_FALSE(std::filesystem::exists("mine.json"));
}

}  // namespace
}  // namespace torsio
