// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped stomach against published dimensions (docs/organ-dimensions.md) and against its own data.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/anatomy/curves.h"
#include "sim/anatomy/forearm.h"
#include "sim/anatomy/remesh.h"
#include "sim/anatomy/tube.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/portable_math.h"
#include "sim/core/random.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/lattice/side_branch.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/organ_like_shapes.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

TEST(MonotoneCurve, PassesThroughItsPointsWithoutOvershoot) {
  const MonotoneCurve curve({0, 1, 3, 4, 6}, {0, 0, 5, 5, 2});

  EXPECT_DOUBLE_EQ(curve(3), 5.0);
  EXPECT_DOUBLE_EQ(curve(6), 2.0);
  EXPECT_EQ(curve(-1), 0.0);
  EXPECT_EQ(curve(9), 2.0);
  for (double x = 0.0; x < 1.0; x += 0.05) {
    EXPECT_EQ(curve(x), 0.0);
  }
  for (double x = 3.0; x < 4.0; x += 0.05) {
    EXPECT_DOUBLE_EQ(curve(x), 5.0);
  }
  for (double x = 1.0; x < 3.0; x += 0.05) {
    EXPECT_GE(curve(x + 0.05), curve(x));
  }
}

TEST(SplineCurve, RunsStraightThroughPointsOnALine) {
  const SplineCurve straight({{0, 0, 0}, {1, 2, 0}, {2, 4, 0}, {3, 6, 0}, {4, 8, 0}});
  EXPECT_NEAR(straight.chordLength(), 4.0 * std::sqrt(5.0), 1e-12);
  EXPECT_NEAR(norm(straight(0.3 * straight.chordLength()) - Vec3{1.2, 2.4, 0.0}), 0.0, 1e-12);
}

TEST(FramesAlong, AreOrthonormalEquidistantAndDoNotSpin) {
  // A quarter circle of radius 50: 25 pi long; a frame in its plane stays in its plane.
  std::vector<Vec3> points;
  for (int i = 0; i <= 16; ++i) {
    points.push_back({50.0 * std::cos(kPi * i / 32), 50.0 * std::sin(kPi * i / 32), 0.0});
  }

  const std::vector<CurveFrame> frames = framesAlong(SplineCurve(points), 101, {1, 0, 0});

  constexpr double kSpline = 1e-3;  // 16 cubic pieces against the circle
  EXPECT_NEAR(frames.back().arc, 25.0 * kPi, kSpline);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const CurveFrame& f = frames[k];
    ASSERT_NEAR(norm(f.e1), 1.0, 1e-12);
    ASSERT_NEAR(norm(cross(f.e1, f.e2) - f.tangent), 0.0, 1e-12);
    ASSERT_NEAR(f.e1.z, 0.0, 1e-9);
    ASSERT_NEAR(norm(f.e1 - normalized(f.centre)), 0.0, kSpline);
    if (k > 0) {
      ASSERT_NEAR(norm(f.centre - frames[k - 1].centre), frames.back().arc / 100, kSpline);
    }
  }
}

TEST(ClosedTube, HasTheVolumeOfItsSections) {
  // A straight ellipse 20 x 12 mm thick, 100 mm long, with half ellipsoids of height 8 at the ends.
  const SplineCurve line({{0, 0, 0}, {0, 0, 30}, {0, 0, 60}, {0, 0, 100}});
  const auto flat = [](double, double) { return 0.0; };

  const TriangleMesh tube = closedTube(
      framesAlong(line, 60, {1, 0, 0}), 120, {.first = 1.0, .last = 1.0},
      [](double) {
        return SectionSize{10.0, 6.0};
      },
      flat);

  const MeshReport report = checkMesh(tube);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  const double exact = kPi * 10 * 6 * 100 + 4.0 / 3.0 * kPi * 10 * 6 * 8;
  EXPECT_NEAR(report.volume_m3 / exact, 1.0, 0.005);  // 120 sides, 6 rings a dome
  EXPECT_NEAR(report.largestSide_m(), 116.0, 1e-9);
}

TEST(ZeroSurface, OfABallHasItsVolumeAndGenus) {
  const SampleGrid grid{{-1.3, -1.3, -1.3}, 0.1, {27, 27, 27}};

  const TriangleMesh ball = zeroSurface(grid, 1.0, [](const Vec3& p) { return norm(p) - 1.0; });

  const MeshReport report = checkMesh(ball);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_NEAR(report.volume_m3, 4.0 / 3.0 * kPi, 0.03);  // inscribed facets of 0.1
}

TEST(ZeroSurface, IsClosedAndManifoldForNoiseToo) {
  Random random(7);
  std::vector<double> noise(20 * 20 * 20);
  for (double& v : noise) {
    v = random.uniform() - 0.5;
  }
  const SampleGrid grid{{0, 0, 0}, 1.0, {20, 20, 20}};
  constexpr double kNeverSkip = 1e9;

  const TriangleMesh mesh = zeroSurface(grid, kNeverSkip, [&noise](const Vec3& p) {
    const auto i = [](double x) { return static_cast<std::size_t>(std::lround(x)); };
    const bool border = std::min({p.x, p.y, p.z}) < 0.5 || std::max({p.x, p.y, p.z}) > 18.5;
    return border ? 1.0 : noise[(i(p.z) * 20 + i(p.y)) * 20 + i(p.x)];
  });

  const MeshReport report = checkMesh(mesh);
  EXPECT_GT(report.triangles, 10000U);
  EXPECT_EQ(report.boundaryEdges, 0U);
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.oriented());
}

TEST(Remeshed, KeepsShapeAndTopologyAndEvensTheEdges) {
  const TriangleMesh fine = testing::torus(60.0, 20.0, 160, 60);
  constexpr double kEdge = 5.0;

  const TriangleMesh mesh = remeshed(fine, [](const Vec3&) { return kEdge; });

  const MeshReport report = checkMesh(mesh);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 1);
  EXPECT_NEAR(report.volume_m3 / signedVolume_m3(fine), 1.0, 0.02);
  EXPECT_EQ(report.degenerateFaces, 0U);
  const CollisionMesh surface(fine);
  for (const Vec3& v : mesh.vertices_m) {
    ASSERT_LT(std::abs(surface.closest(v).distance_m), 1e-9);
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double edge = norm(mesh.vertices_m[t[k]] - mesh.vertices_m[t[(k + 1) % 3]]);
      ASSERT_GT(edge, 0.5 * kEdge);
      ASSERT_LT(edge, 1.6 * kEdge);
    }
  }
}

TEST(MakeArm, FollowsThePersonsMeasures) {
  // A woman of ANSUR II: forearm, palm, breadth and fingers shorter (finger lengths scaled by 72.4 / 76.8).
  ArmMeasures woman{.forearmLength_mm = 236.0};
  for (double& girth : woman.girth_mm) {
    girth *= 155.0 / 176.0;
  }
  woman.palmLength_mm = 108.7;
  woman.handBreadth_mm = 78.2;
  woman.handThickness_mm = 26.0;
  for (double& finger : woman.fingerLength_mm) {
    finger *= 72.4 / 76.8;
  }

  const Arm arm = makeArm(woman);

  const MeshReport report = checkMesh(arm.surface);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_DOUBLE_EQ(arm.wrist_m.z, 0.236);
  EXPECT_NEAR(report.volume_m3, 1.526e-3 * (155.0 * 155.0) / (176.0 * 176.0) * 236.0 / 262.0, 0.1e-3);
  EXPECT_NEAR(report.boxMin_m.z, 0.0, 2e-5);  // the elbow's disc; smoothing moves its rim by some micrometres
}

TEST(MakeArm, HasTheWristThatItIsGiven) {
  ArmMeasures slim;
  setWrist(slim, 56.0, 40.0);

  const Arm arm = makeArm(slim);

  const CollisionMesh skin(arm.surface);
  const auto reach_mm = [&skin, &arm](const Vec3& way) {
    double inside_m = 0.0;
    double outside_m = 0.06;
    for (int i = 0; i < 40; ++i) {
      const double r = 0.5 * (inside_m + outside_m);
      // Below the wrist bones.
      (skin.closest(arm.wrist_m + Vec3{0, 0, -0.045} + r * way).distance_m < 0.0 ? inside_m : outside_m) = r;
    }
    return 1000.0 * inside_m;
  };
  EXPECT_NEAR(reach_mm({0, 1, 0}) + reach_mm({0, -1, 0}), 40.0, 2.5);
  EXPECT_NEAR(reach_mm({1, 0, 0}) + reach_mm({-1, 0, 0}), 56.0, 3.0);
  // A slimmer wrist belongs to a slimmer forearm.
  ArmMeasures usual;
  EXPECT_NEAR(slim.girth_mm[2] / usual.girth_mm[2], slim.girth_mm[8] / usual.girth_mm[8], 1e-12);
  EXPECT_EQ(slim.widthToDepth[0], usual.widthToDepth[0]);
}

const std::filesystem::path kStomachAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

nlohmann::json jsonOf(const char* file) {
  return nlohmann::json::parse(readFile(kStomachAssets / file));
}

Vec3 metres(const nlohmann::json& mm) {
  return 0.001 * Vec3{mm.at(0).get<double>(), mm.at(1).get<double>(), mm.at(2).get<double>()};
}

std::vector<Vec3> lineOf(const nlohmann::json& list) {
  std::vector<Vec3> line;
  for (const auto& point : list) {
    line.push_back(metres(point));
  }
  return line;
}

double lengthOf_mm(const std::vector<Vec3>& line) {
  double length_m = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k) {
    length_m += norm(line[k] - line[k - 1]);
  }
  return 1000.0 * length_m;
}

/// The stomach as its scene cuts it.
struct CutStomach {
  TriangleMesh mesh = importMesh(kStomachAssets / "organs/stomach.ply");
  nlohmann::json data = jsonOf("organs/stomach_markers.json");
  SectionLattice lattice{mesh, options()};

  static LatticeOptions options() {
    const nlohmann::json cut = jsonOf("scenes/stomach.json").at("lattice");
    return {.fixedEnd_m = metres(cut.at("fixed_end_mm")),
            .freeEnd_m = metres(cut.at("free_end_mm")),
            .fixedCut = 1000.0 * metres(cut.at("fixed_cut")),
            .ridgeZero = 1000.0 * metres(cut.at("ridge_zero")),
            .ridgeZeroFraction = cut.at("ridge_zero_fraction").get<double>(),
            .branchRoot_m = metres(cut.at("branch_root_mm")),
            .branchCut = 1000.0 * metres(cut.at("branch_cut"))};
  }
};

const CutStomach& stomach() {
  static const CutStomach cut;
  return cut;
}

double widthAt_mm(double share) {
  const SectionLattice& lattice = stomach().lattice;
  const std::vector<double> arcs{share * lattice.length_m()};
  const LatticeOutline outline = lattice.outlinesAt(arcs).front();
  double twice_m2 = 0.0;
  for (std::size_t k = 0; k < outline.points_m.size(); ++k) {
    const auto [x0, y0] = outline.points_m[k];
    const auto [x1, y1] = outline.points_m[(k + 1) % outline.points_m.size()];
    twice_m2 += x0 * y1 - x1 * y0;
  }
  return 2000.0 * std::sqrt(0.5 * twice_m2 / kPi);
}

TEST(StomachAnatomy, HasTheSizeOfAFedLivingStomach) {
  const MeshReport report = checkMesh(stomach().mesh);

  // MRI of fed adults: 0.36 to 1.10 l, largest diameter 65 to 102 mm.
  EXPECT_GT(report.volume_m3, 0.36e-3);
  EXPECT_LT(report.volume_m3, 1.10e-3);
  double widest_mm = 0.0;
  for (double share = 0.1; share < 0.95; share += 0.05) {
    widest_mm = std::max(widest_mm, widthAt_mm(share));
  }
  EXPECT_GT(widest_mm, 65.0);
  EXPECT_LT(widest_mm, 102.0);
  // 50 cadavers: 171 +- 20 mm (women), 190 +- 25 mm (men).
  const Vec3 pylorus = metres(stomach().data.at("fixed_end_mm"));
  double longest_m = 0.0;
  for (std::size_t v = 0; v < stomach().mesh.vertices_m.size(); ++v) {
    if (stomach().lattice.vertexParts()[v] == LatticePart::kFreeCap) {
      longest_m = std::max(longest_m, norm(stomach().mesh.vertices_m[v] - pylorus));
    }
  }
  EXPECT_NEAR(1000.0 * longest_m, 180.0, 25.0);
}

TEST(StomachAnatomy, HasCurvaturesBetweenFixedAndDistendedStomachs) {
  const std::vector<Vec3> lesser = lineOf(stomach().data.at("zero_line_mm"));
  std::vector<Vec3> greater = lineOf(stomach().data.at("greater_omentum_mm"));
  greater.push_back(metres(stomach().data.at("free_end_mm")));

  // 851 gastrectomies, fixed: lesser 163 +- 26 mm, greater 222 +- 31 mm; distended, the greater about 400.
  EXPECT_NEAR(lengthOf_mm(lesser), 163.0, 26.0);
  EXPECT_GT(lengthOf_mm(greater), 222.0);
  EXPECT_LT(lengthOf_mm(greater), 400.0);
}

TEST(StomachAnatomy, IsNarrowAtThePylorusAndWideInBodyAndBulb) {
  // Outer diameter of the pylorus 20 to 25 mm; BodyParts3D 23 mm.
  const double pylorus_mm = widthAt_mm(0.004);
  EXPECT_GT(pylorus_mm, 20.0);
  EXPECT_LT(pylorus_mm, 25.0);
  // BodyParts3D: equivalent diameters at shares of 195 mm from the fundus.
  EXPECT_NEAR(widthAt_mm(0.75), 87.0, 17.0);
  EXPECT_NEAR(widthAt_mm(0.50), 71.0, 12.0);
  EXPECT_NEAR(widthAt_mm(0.25), 51.0, 8.0);
  // The bulb, beyond the pylorus.
  double widest_m = 0.0;
  const Vec3 pylorus = metres(stomach().data.at("fixed_end_mm"));
  const Vec3 along = -1.0 * stomach().lattice.frameAt(0.0).tangent;
  for (std::size_t v = 0; v < stomach().mesh.vertices_m.size(); ++v) {
    const Vec3 from = stomach().mesh.vertices_m[v] - pylorus;
    if (stomach().lattice.vertexParts()[v] == LatticePart::kFixedCap && dot(from, along) > 0.006) {
      widest_m = std::max(widest_m, norm(from - dot(from, along) * along));
    }
  }
  EXPECT_GT(2000.0 * widest_m, pylorus_mm + 4.0);
}

TEST(StomachAnatomy, HasAnOesophagusThatMeetsTheFundusAtAnAcuteAngle) {
  const TriangleMesh& mesh = stomach().mesh;
  const Vec3 cardia = metres(stomach().data.at("cardia_mm"));
  const Vec3 up = normalized(metres(stomach().data.at("oesophagus")));
  const CollisionMesh surface(mesh);

  // The stub: 20 mm wide, 3 to 4 cm long, inside the surface on its axis and not beside it.
  EXPECT_LT(surface.closest(cardia + 0.030 * up).distance_m, -0.008);
  EXPECT_GT(surface.closest(cardia + 0.030 * up).distance_m, -0.0115);
  EXPECT_GT(surface.closest(cardia + 0.055 * up).distance_m, 0.005);
  EXPECT_LT(up.x, 0.0);  // it comes from the right, down to the left
  EXPECT_GT(up.z, 0.5);
  // The fundus rises above the cardia, and its wall towards the oesophagus leans away from it.
  double top_m = -1.0;
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    if (stomach().lattice.vertexParts()[v] == LatticePart::kFreeCap) {
      top_m = std::max(top_m, mesh.vertices_m[v].z);
    }
  }
  EXPECT_GT(top_m, cardia.z + 0.03);
  const auto angle =
      std::find_if(stomach().data.at("landmarks").begin(), stomach().data.at("landmarks").end(),
                   [](const auto& mark) { return mark.at("name") == "angle of His"; });
  ASSERT_NE(angle, stomach().data.at("landmarks").end());
  const Vec3 notch = metres(angle->at("position_mm"));
  const Vec3 fundus = metres(stomach().data.at("free_end_mm")) - notch;
  const double his_deg = degrees(std::acos(dot(normalized(fundus), up)));
  EXPECT_GT(his_deg, 20.0);
  EXPECT_LT(his_deg, 90.0);
}

TEST(StomachAnatomy, PlacesTenMarkersAndItsLandmarksOnTheSkinWhereTheyAreSaidToBe) {
  const CollisionMesh surface(stomach().mesh);
  ASSERT_EQ(stomach().data.at("markers").size(), 10U);
  const double length_mm = stomach().data.at("length_mm").get<double>();
  EXPECT_NEAR(1000.0 * stomach().lattice.length_m(), length_mm, 6.0);
  for (const char* list : {"markers", "landmarks"}) {
    for (const auto& mark : stomach().data.at(list)) {
      const Vec3 p = metres(mark.at("position_mm"));
      // Written in hundredths of a millimetre, from the body that the triangles were cut from.
      const SurfacePoint nearest = surface.closest(p);
      EXPECT_LT(std::abs(nearest.distance_m), 4e-4) << mark;
      const LatticeCoordinate& at =
          stomach().lattice.vertexCoordinates()[stomach().mesh.triangles[nearest.triangle].front()];
      EXPECT_NEAR(1000.0 * at.arc_m, mark.at("arc_mm").get<double>(), 22.0) << mark;
      const double away =
          std::remainder(at.angle_rad - radians(mark.at("angle_deg").get<double>()), 2.0 * kPi);
      EXPECT_LT(std::abs(degrees(away)), 30.0) << mark;
    }
  }
  // Front is towards -y.
  EXPECT_LT(metres(stomach().data.at("markers").at(5).at("position_mm")).y,
            metres(stomach().data.at("markers").at(6).at("position_mm")).y);
}

TEST(StomachAnatomy, HasOneMapOfItsWall) {
  const nlohmann::json& wall = stomach().data.at("wall_mm");
  // Pickhardt and Asher 2003: antrum 5.1 +- 1.6 mm over its last 46 mm, body 2.0 +- 0.4 mm.
  EXPECT_NEAR(wall.front().at(1).get<double>(), 5.1, 0.2);
  EXPECT_NEAR(wall.back().at(1).get<double>(), 2.0, 0.4);
  EXPECT_GT(wall.at(1).at(0).get<double>() * stomach().data.at("length_mm").get<double>(), 46.0);
  for (const char* scene : {"scenes/gastric-organo-axial.json", "scenes/gastric-mesentero-axial.json"}) {
    EXPECT_EQ(jsonOf(scene).at("patterns").at(0).at("detorsion").at("wall").at("thickness_mm"), wall)
        << scene;
  }
}

}  // namespace

namespace {

constexpr double kBarRadius_m = 0.02;
constexpr double kStubRadius_m = 0.008;

/// Along z, with a stub along +x at the middle.
TriangleMesh barWithStub() {
  const TriangleMesh mesh =
      testing::shapes::surfaceOf({-0.03, -0.03, -0.11}, {0.06, 0.03, 0.11}, 0.003, [](const Vec3& p) {
        const double bar = testing::shapes::bar(p, {0, 0, -0.08}, {0, 0, 0.08}, kBarRadius_m);
        const double stub = testing::shapes::bar(p, {0.01, 0, 0}, {0.045, 0, 0}, kStubRadius_m);
        return testing::shapes::joined(bar, stub, 0.003);
      });
  return requireOrgan(mesh, "bar with stub");
}

LatticeOptions withBranch() {
  return {.fixedEnd_m = {0, 0, -0.1},
          .freeEnd_m = {0, 0, 0.1},
          .ridgeZero = {1, 0, 0},
          .ridgeZeroFraction = 0.3,
          .branchRoot_m = {0.021, 0, 0},
          .branchCut = {1, 0, 0}};
}

bool onStub(const Vec3& p) {
  return p.x >= 0.021;
}

std::string refusalOfBranch(const Vec3& root_m, const Vec3& cut) {
  LatticeOptions options = withBranch();
  options.branchRoot_m = root_m;
  options.branchCut = cut;
  const std::optional<Error> error =
      testing::errorOf([&] { const SectionLattice lattice(barWithStub(), options); });
  EXPECT_TRUE(!error || error->code() == ErrorCode::kBadParameter);
  return error ? error->what() : "";
}

TEST(SideBranch, LeavesTheOrganClosedWithoutIt) {
  const TriangleMesh whole = barWithStub();

  const TrimmedOrgan trimmed(whole, {0.021, 0, 0}, {1, 0, 0});

  const MeshReport report = checkMesh(trimmed.mesh());
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_LT(report.boxMax_m.x, 0.022);
  const double stub_m3 = kPi * kStubRadius_m * kStubRadius_m * (0.045 - 0.021) +
                         2.0 / 3.0 * kPi * kStubRadius_m * kStubRadius_m * kStubRadius_m;
  EXPECT_NEAR(signedVolume_m3(whole) - report.volume_m3, stub_m3, 0.06 * stub_m3);
}

TEST(SideBranch, ChangesNoSection) {
  const SectionLattice lattice(barWithStub(), withBranch());

  ASSERT_NEAR(lattice.length_m(), 0.2, 0.006);
  for (int j = 3; j + 3 < lattice.sections(); ++j) {
    double farthest_m = 0.0;
    for (const Point2& p : lattice.outline_m(j)) {
      farthest_m = std::max(farthest_m, std::hypot(p[0], p[1]));
    }
    // The fillet at the root of the stub stays, two millimetres of it.
    EXPECT_LT(farthest_m, kBarRadius_m + 0.002) << j;
    const AxisFrame frame = lattice.frameAt(lattice.sectionArc_m(j));
    EXPECT_LT(std::hypot(frame.centre_m.x, frame.centre_m.y), 0.001) << j;
  }
}

TEST(SideBranch, StandsOnThePlacesOfItsRoot) {
  const TriangleMesh mesh = barWithStub();
  const SectionLattice lattice(mesh, withBranch());

  ASSERT_EQ(lattice.vertexCoordinates().size(), mesh.vertices_m.size());
  int branch = 0;
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    const Vec3& p = mesh.vertices_m[v];
    if (!onStub(p)) {
      continue;
    }
    ++branch;
    const LatticeCoordinate& at = lattice.vertexCoordinates()[v];
    EXPECT_EQ(lattice.vertexParts()[v], LatticePart::kSide);
    EXPECT_NEAR(at.arc_m, 0.5 * lattice.length_m() + p.z, 0.006);
    // Half the width of the root, seen from the axis.
    EXPECT_LT(std::abs(std::remainder(at.angle_rad, 2.0 * kPi)), 0.6);
    EXPECT_GE(at.angle_rad, 0.0);
    EXPECT_LT(at.angle_rad, 2.0 * kPi);
  }
  EXPECT_GT(branch, 100);
}

TEST(SideBranch, HasPointsOfTheWholeSurfaceOnlyAlsoAtItsRoot) {
  const TriangleMesh mesh = barWithStub();
  const SectionLattice lattice(mesh, withBranch());

  for (int k = 0; k < 24; ++k) {
    const LatticePoint point = lattice.surfacePoint({0.5 * lattice.length_m(), 2.0 * kPi * k / 24.0});

    ASSERT_LT(point.triangle, mesh.triangles.size());
    const TriangleMesh::Triangle& corners = mesh.triangles[point.triangle];
    Vec3 there;
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_GE(point.barycentric[c], -1e-9);
      there += point.barycentric[c] * mesh.vertices_m[corners[c]];
    }
    EXPECT_LT(norm(there - point.position_m), 1e-9) << k;
  }
}

TEST(SideBranch, IsRefusedWhereThereIsNone) {
  EXPECT_THAT(refusalOfBranch({0.2, 0, 0}, {1, 0, 0}), ::testing::HasSubstr("nothing of the organ"));
  EXPECT_THAT(refusalOfBranch({0, 0, 0.02}, {0, 0, 1}), ::testing::HasSubstr("more than a tenth"));
}

}  // namespace

}  // namespace torsio
