// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/anatomy/shipped_files.h"
#include "sim/core/angle.h"
#include "sim/core/file_io.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

const fs::path kAssets = fs::path(TORSIO_SOURCE_DIR) / "assets";
constexpr double kMillimetre_m = 0.001;

Vec3 pointMm(const nlohmann::json& value) {
  return kMillimetre_m *
         Vec3{value.at(0).get<double>(), value.at(1).get<double>(), value.at(2).get<double>()};
}

TEST(OrganFiles, AreWhatTheGeneratorWrites) {
  for (const ShippedFile& file : shippedFiles()) {
    const std::string shipped = readFile(kAssets / file.path);

    // Integers and IEEE basic operations only: the same bytes on every platform.
    EXPECT_TRUE(shipped == file.bytes) << file.path << " differs: run torsio_make_organs";
    EXPECT_LT(shipped.size(), 1'000'000U);
    EXPECT_THAT(shipped.substr(0, 1000), HasSubstr("synthetic"));
    EXPECT_THAT(shipped.substr(0, 1000), HasSubstr("CC0-1.0"));
  }
}

struct OrganCase {
  const char* file;
  double leastVolume_ml, mostVolume_ml;
  double length_mm;  // largest side of the box
  std::size_t leastTriangles, mostTriangles;
};

class OrganFile : public ::testing::TestWithParam<OrganCase> {};

TEST_P(OrganFile, IsAClosedSurfaceOfGenusZeroInLifeSize) {
  const OrganCase& c = GetParam();
  MeshRepairs repairs;

  const TriangleMesh mesh = importMesh(kAssets / "organs" / c.file, {}, &repairs);

  const MeshReport report = checkMesh(mesh);
  EXPECT_FALSE(repairs.any()) << repairs.text();
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_EQ(report.components, 1U);
  EXPECT_GT(report.volume_m3 * 1e6, c.leastVolume_ml);
  EXPECT_LT(report.volume_m3 * 1e6, c.mostVolume_ml);
  constexpr double kSize_mm = 5.0;
  EXPECT_NEAR(report.largestSide_m() / kMillimetre_m, c.length_mm, kSize_mm);
  EXPECT_GE(report.triangles, c.leastTriangles);
  EXPECT_LE(report.triangles, c.mostTriangles);
}

TEST_P(OrganFile, HasWellShapedTrianglesAndNoSharpFold) {
  const TriangleMesh mesh = importMesh(kAssets / "organs" / GetParam().file);

  double sharpest = 180.0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const TriangleMesh::Triangle& t = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 e = normalized(mesh.vertices_m[t[(k + 1) % 3]] - mesh.vertices_m[t[k]]);
      const Vec3 f = normalized(mesh.vertices_m[t[(k + 2) % 3]] - mesh.vertices_m[t[k]]);
      sharpest = std::min(sharpest, degrees(std::acos(dot(e, f))));
    }
  }
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  double fold = 1.0;
  const auto normal = [&mesh](std::uint32_t triangle) {
    const TriangleMesh::Triangle& t = mesh.triangles[triangle];
    return normalized(
        cross(mesh.vertices_m[t[1]] - mesh.vertices_m[t[0]], mesh.vertices_m[t[2]] - mesh.vertices_m[t[0]]));
  };
  for (std::size_t i = 0; i + 1 < edges.size(); i += 2) {
    fold = std::min(fold, dot(normal(edges[i].triangle), normal(edges[i + 1].triangle)));
  }

  constexpr double kSharpest_deg = 30.0;  // an even mesh has 60; the worst shipped triangle has 34
  constexpr double kFold = 0.35;          // cosine between neighbours: 70 degrees, at the webs of the fingers
  EXPECT_GE(sharpest, kSharpest_deg);
  EXPECT_GT(fold, kFold);
}

INSTANTIATE_TEST_SUITE_P(
    Shipped, OrganFile,
    ::testing::Values(
        // Sources: docs of the assets. Forearm 262 mm and hand 193 mm with bent fingers; forearm and hand of
        // a man hold 1.3 to 2 litres. Stomach without oesophagus: checked box 166 x 99 x 189 mm, 711 ml.
        OrganCase{"forearm.ply", 1300, 2000, 446, 15000, 20000},
        OrganCase{"former/stomach.ply", 690, 730, 189, 9000, 11000},
        // The same curve a little wider, with stub, pylorus and bulb.
        OrganCase{"stomach.ply", 690, 790, 198, 19000, 23000},
        OrganCase{"intestine.ply", 90, 115, 190, 18000, 22000},
        OrganCase{"former/intestine.ply", 90, 115, 190, 5000, 9000},
        // Testis: an ellipsoid of 50 x 30 x 20 mm (15.7 ml), a cord of 60 mm and radius 6 (6.8 ml),
        // epididymis.
        OrganCase{"testis.ply", 20, 27, 113, 15000, 25000},
        // Sigmoid: 619 mm with a mean radius of 33 mm: 2.1 l.
        OrganCase{"sigmoid.ply", 1900, 2400, 309, 15000, 25000},
        // Closed loop: 357 mm with a radius of 12.8 mm.
        OrganCase{"bowel_loop.ply", 170, 200, 166, 18000, 24000},
        // Midgut: an ellipsoid of 124 x 70 x 104 mm (473 ml) less the grooves, a stalk of 12 and a limb of 13
        // ml.
        OrganCase{"midgut.ply", 370, 480, 129, 15000, 25000},
        OrganCase{"former/midgut.ply", 380, 490, 134, 15000, 25000}),
    [](const auto& test) {
      const fs::path file(test.param.file);
      return file.parent_path().string() + file.stem().string();
    });

class OrganMarkers : public ::testing::TestWithParam<const char*> {};

TEST_P(OrganMarkers, AreTenNamesOnTheSkinRoundTheZeroLine) {
  const std::string stem = GetParam();
  const auto json = nlohmann::json::parse(readFile(kAssets / "organs" / (stem + "_markers.json")));
  const CollisionMesh skin(importMesh(kAssets / "organs" / (stem + ".ply")));
  constexpr double kWritten_m = 2e-5;  // written in hundredths of a millimetre
  const auto onSkin = [&](const nlohmann::json& p) { return std::abs(skin.closest(pointMm(p)).distance_m); };

  ASSERT_EQ(json.at("markers").size(), 10U);
  std::map<std::string, Vec3> places;
  for (const auto& marker : json.at("markers")) {
    places[marker.at("name").get<std::string>()] = pointMm(marker.at("position_mm"));
    EXPECT_LT(onSkin(marker.at("position_mm")), kWritten_m) << marker;
    EXPECT_GT(marker.at("arc_mm").get<double>(), 0.0);
    EXPECT_LT(marker.at("arc_mm").get<double>(), json.at("length_mm").get<double>());
    EXPECT_GE(marker.at("angle_deg").get<double>(), 0.0);
  }
  EXPECT_EQ(places.size(), 10U);
  EXPECT_GT(json.at("zero_line_mm").size(), 8U);
  for (const auto& point : json.at("zero_line_mm")) {
    EXPECT_LT(onSkin(point), kWritten_m) << point;
  }
  // What the names say of the place, LPS.
  if (stem == "intestine" || stem == "bowel_loop") {
    EXPECT_GT(places.at("top, antimesenteric border").z, places.at("top, mesenteric border").z + 0.02);
  } else if (stem == "sigmoid") {
    EXPECT_GT(places.at("top, taenia libera").z, places.at("top, mesenteric border").z + 0.06);
    EXPECT_GT(places.at("descending limb, taenia libera").x,
              places.at("descending limb, mesenteric border").x);
    EXPECT_LT(places.at("rectal limb, taenia libera").x, places.at("rectal limb, mesenteric border").x);
  } else if (stem == "testis") {
    EXPECT_GT(places.at("epididymis, body").y, 0.009);
    EXPECT_LT(places.at("testis, middle, medial").x, places.at("testis, middle, lateral").x);
    EXPECT_LT(places.at("testis, lower pole, front").z, places.at("cord, upper end, front").z);
  } else {
    EXPECT_GT(places.at("pack, left").x, 0.03);
    EXPECT_LT(places.at("pack, right").x, -0.05);
    EXPECT_GT(places.at("pack, above").z, places.at("pack, below").z + 0.04);
    EXPECT_LT(places.at("pack, front, above").y, places.at("stalk, root, left").y);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, OrganMarkers,
                         ::testing::Values("intestine", "bowel_loop", "testis", "sigmoid", "midgut"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ArmMarkers, LieOnTheSkinAtTheirAngles) {
  const auto json = nlohmann::json::parse(readFile(kAssets / "organs" / "forearm_markers.json"));
  const CollisionMesh skin(importMesh(kAssets / "organs" / "forearm.ply"));

  ASSERT_EQ(json.at("markers").size(), 10U);
  int number = 0;
  for (const auto& marker : json.at("markers")) {
    const Vec3 p = pointMm(marker.at("position_mm"));
    EXPECT_EQ(marker.at("number").get<int>(), ++number);
    constexpr double kWritten_m = 2e-5;  // written in hundredths of a millimetre
    EXPECT_LT(std::abs(skin.closest(p).distance_m), kWritten_m) << marker;
    const double angle = std::atan2(p.y, p.x) - radians(marker.at("angle_deg").get<double>());
    EXPECT_NEAR(std::cos(angle), 1.0, 1e-5) << marker;
    EXPECT_NEAR(marker.at("arc_mm").get<double>(), p.z / kMillimetre_m, 0.01) << marker;
    EXPECT_LE(marker.at("arc_mm").get<double>(), json.at("length_mm").get<double>());
  }
}

TEST(ArmMarkers, CountTheirAnglesFromALineOnTheRadialSide) {
  const auto json = nlohmann::json::parse(readFile(kAssets / "organs" / "forearm_markers.json"));
  const CollisionMesh skin(importMesh(kAssets / "organs" / "forearm.ply"));
  const auto& line = json.at("zero_line_mm");

  ASSERT_GT(line.size(), 20U);
  double before_m = 0.0;
  for (const auto& point : line) {
    const Vec3 p = pointMm(point);
    EXPECT_LT(std::abs(skin.closest(p).distance_m), 2e-5) << point;
    EXPECT_GT(p.x, 0.025) << point;  // radial
    EXPECT_NEAR(p.y, 0.0, 1e-5) << point;
    EXPECT_GT(p.z, before_m) << point;
    before_m = p.z;
  }
  // From the elbow to the wrist crease, without the rounded rim of the cut.
  EXPECT_LT(pointMm(line.front()).z, 0.012);
  EXPECT_GT(pointMm(line.back()).z, 0.25);
  EXPECT_LT(pointMm(line.back()).z, pointMm(json.at("wrist_mm")).z);
}

TEST(ArmMarkers, AreThoseOfARightHand) {
  const auto json = nlohmann::json::parse(readFile(kAssets / "organs" / "forearm_markers.json"));
  const auto marker = [&json](std::size_t number) {
    return pointMm(json.at("markers").at(number - 1).at("position_mm"));
  };

  // Right hand: seen from the back with fingers up, the thumb is on the left.
  const Vec3 fingers{0, 0, 1};
  const Vec3 back = marker(5) - marker(6);
  const Vec3 thumb = marker(7) - marker(9);
  EXPECT_GT(dot(cross(thumb, back), fingers), 0.0);
  EXPECT_GT(marker(10).z, marker(8).z);
  // Marker 8 is compared over time: it must lie far from the axis (32 mm in the plausibility estimate).
  EXPECT_GT(std::hypot(marker(8).x, marker(8).y), 0.03);
}

TEST(ArmFile, HasTheGirthsOfAMan) {
  const TriangleMesh mesh = importMesh(kAssets / "organs" / "forearm.ply");
  const CollisionMesh skin(mesh);
  const auto widthAt = [&skin](double z_m, const Vec3& direction) {
    double inside = 0.0;
    double outside = 0.1;
    for (int i = 0; i < 40; ++i) {
      const double r = 0.5 * (inside + outside);
      (skin.closest(r * direction + Vec3{0, 0, z_m}).distance_m < 0.0 ? inside : outside) = r;
    }
    return inside;
  };

  // Girths in mm at shares of the 262 mm between elbow and wrist (ANSUR II, wrist 176; anatomy table).
  for (const auto& [share, girth_mm] : std::map<double, double>{{0.22, 285}, {0.5, 240}, {0.8, 183}}) {
    double girth_m = 0.0;
    Vec3 previous;
    constexpr int kSides = 90;
    for (int i = 0; i <= kSides; ++i) {
      const double a = 2.0 * kPi * i / kSides;
      const Vec3 direction{std::cos(a), std::sin(a), 0.0};
      const Vec3 p = widthAt(share * 0.262, direction) * direction;
      if (i > 0) {
        girth_m += norm(p - previous);
      }
      previous = p;
    }
    EXPECT_NEAR(girth_m / kMillimetre_m, girth_mm, 0.01 * girth_mm) << share;
  }
}

TEST(GrasperFiles, AgreeWithTheirDescription) {
  const auto json = nlohmann::json::parse(readFile(kAssets / "instruments" / "grasper.json"));
  for (const auto& [part, name] : json.at("meshes").items()) {
    const TriangleMesh mesh = importMesh(kAssets / "instruments" / name.get<std::string>(),
                                         {.scale_m = kMillimetre_m, .organ = false});
    const MeshReport report = checkMesh(mesh);
    EXPECT_TRUE(report.closed() && report.manifold() && report.oriented()) << part;
    EXPECT_GT(report.volume_m3, 0.0) << part;
    if (part == "shaft") {
      EXPECT_NEAR(report.boxMax_m.z, kMillimetre_m * json.at("shaft_length_mm").get<double>(), 1e-6);
      EXPECT_NEAR(report.boxMax_m.x, kMillimetre_m * json.at("shaft_radius_mm").get<double>(), 1e-6);
      continue;
    }
    if (part == "hand") {
      // It holds the end of the shaft, far from the jaws, and is a hand's size.
      const double end_m = kMillimetre_m * json.at("shaft_length_mm").get<double>();
      EXPECT_GT(report.boxMin_m.z, 0.5 * end_m);
      EXPECT_LT(report.boxMin_m.z, end_m);
      EXPECT_LT(report.boxMin_m.y, 0.0);
      EXPECT_GT(report.boxMax_m.y, 0.0);
      EXPECT_LT(report.boxMax_m.y - report.boxMin_m.y, 0.15);
      continue;
    }
    EXPECT_NEAR(report.boxMin_m.z, 0.0, 1e-6) << part;  // the tip is the origin
    EXPECT_EQ(report.boxMin_m.y > 0.0, part == "upper_jaw");
    EXPECT_EQ(report.boxMax_m.y < 0.0, part == "lower_jaw");
  }
}

}  // namespace
}  // namespace torsio
