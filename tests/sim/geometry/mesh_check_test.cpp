// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_check.h"

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using testing::ellipsoid;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::together;
using testing::torus;

const Vec3 kOrganRadius_m{0.04, 0.05, 0.08};

// The message with which `mesh` is refused, or "accepted".
std::string organRefusal(const TriangleMesh& mesh, double unit_m = 0.001) {
  const std::optional<Error> error =
      testing::errorOf([&] { return requireOrgan(mesh, "organ.obj", unit_m); });
  if (!error) {
    return "accepted";
  }
  EXPECT_EQ(error->code(), ErrorCode::kBadMesh);
  EXPECT_EQ(error->where(), "organ.obj");
  EXPECT_THAT(std::string(error->what()), Not(HasSubstr("\n")));
  return error->what();
}

TEST(MeshReport, MeasuresASphere) {
  const TriangleMesh mesh = ellipsoid({0.05, 0.05, 0.05}, 128, 64);

  const MeshReport report = checkMesh(mesh);

  constexpr double kRadius_m = 0.05;
  constexpr double kFacetting =
      2e-3;  // 128 x 64 quads inscribed in the sphere: 1 - (2 pi / 128)^2 / 2 and less
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.components, 1U);
  EXPECT_EQ(report.euler, 2);
  EXPECT_EQ(report.genus(), 0);
  EXPECT_EQ(report.degenerateFaces + report.duplicateFaces + report.unusedVertices, 0U);
  EXPECT_NEAR(report.volume_m3 / (4.0 / 3.0 * kPi * kRadius_m * kRadius_m * kRadius_m), 1.0, 2 * kFacetting);
  EXPECT_NEAR(report.area_m2 / (4.0 * kPi * kRadius_m * kRadius_m), 1.0, kFacetting);
  EXPECT_NEAR(report.largestSide_m(), 2 * kRadius_m, 1e-12);
}

TEST(MeshReport, CountsTheHandleOfATorus) {
  const MeshReport report = checkMesh(torus(0.06, 0.02));

  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_EQ(report.euler, 0);
  EXPECT_EQ(report.genus(), 1);
}

TEST(MeshReport, CountsHolesAndTheirEdges) {
  TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  mesh.triangles.erase(mesh.triangles.begin() + 100);
  mesh.triangles.erase(mesh.triangles.begin() + 300);

  const MeshReport report = checkMesh(mesh);

  EXPECT_FALSE(report.closed());
  EXPECT_EQ(report.boundaryEdges, 6U);  // two triangles of three edges
  EXPECT_EQ(report.holes, 2U);
  EXPECT_EQ(report.genus(), -1);
}

TEST(MeshReport, FindsTheVertexWhereTwoPartsTouch) {
  // Given two ellipsoids that share nothing but one pole.
  TriangleMesh mesh = together(ellipsoid(kOrganRadius_m), ellipsoid(kOrganRadius_m), {0, 0, 0.16});
  const auto top = static_cast<std::uint32_t>(mesh.vertices_m.size() / 2 - 1);
  const auto bottom = static_cast<std::uint32_t>(mesh.vertices_m.size() - 2);
  for (TriangleMesh::Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      corner = corner == bottom ? top : corner;
    }
  }

  const MeshReport report = checkMesh(mesh);

  EXPECT_EQ(report.nonManifoldEdges, 0U);
  EXPECT_EQ(report.nonManifoldVertices, 1U);
  EXPECT_EQ(report.components, 1U);
  EXPECT_NEAR(report.firstNonManifold_m.z, 0.08, 1e-12);
  EXPECT_THAT(organRefusal(mesh), HasSubstr("M12 1 vertex where two parts only touch"));
}

TEST(MeshReport, StopsAtIndicesAndNumbersThatCannotBeUsed) {
  TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  mesh.triangles[7][1] = 1'000'000;
  EXPECT_EQ(checkMesh(mesh).badIndices, 1U);

  mesh = ellipsoid(kOrganRadius_m);
  mesh.vertices_m[5].y = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(checkMesh(mesh).nonFiniteVertices, 1U);
  EXPECT_EQ(checkMesh(mesh).firstBadVertex, 5U);
}

TEST(MeshReport, OfAnEmptyMeshIsEmpty) {
  const MeshReport report = checkMesh({});

  EXPECT_FALSE(report.closed());
  EXPECT_EQ(report.components, 0U);
  EXPECT_EQ(report.genus(), -1);
}

TEST(RequireOrgan, LeavesAGoodMeshAsItIs) {
  const TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  MeshRepairs repairs;

  const TriangleMesh organ = requireOrgan(mesh, "organ.obj", 0.001, &repairs);

  EXPECT_EQ(organ.vertices_m, mesh.vertices_m);
  EXPECT_EQ(organ.triangles, mesh.triangles);
  EXPECT_FALSE(repairs.any());
  EXPECT_EQ(repairs.text(), "");
}

TEST(RequireOrgan, WeldsSeams) {
  // Given every triangle with corners of its own, as an STL file has them.
  const TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  TriangleMesh soup;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices_m.size());
    for (const std::uint32_t corner : t) {
      soup.vertices_m.push_back(mesh.vertices_m[corner]);
    }
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  MeshRepairs repairs;

  const TriangleMesh organ = requireOrgan(soup, "organ.stl", 0.001, &repairs);

  EXPECT_EQ(organ.vertices_m.size(), mesh.vertices_m.size());
  EXPECT_EQ(repairs.weldedVertices, soup.vertices_m.size() - mesh.vertices_m.size());
  EXPECT_DOUBLE_EQ(signedVolume_m3(organ), signedVolume_m3(mesh));
}

TEST(RequireOrgan, TurnsWhatIsInsideOutAndSingleFaces) {
  const TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  TriangleMesh wrong = mesh;
  for (TriangleMesh::Triangle& t : wrong.triangles) {
    std::swap(t[1], t[2]);
  }
  for (const std::size_t t : {3U, 50U, 51U}) {
    std::swap(wrong.triangles[t][1], wrong.triangles[t][2]);
  }
  MeshRepairs repairs;

  const TriangleMesh organ = requireOrgan(wrong, "organ.obj", 0.001, &repairs);

  EXPECT_GT(signedVolume_m3(organ), 0.0);
  EXPECT_TRUE(checkMesh(organ).oriented());
  EXPECT_EQ(repairs.turnedFaces, 3U);
  EXPECT_EQ(repairs.text(), "3 faces turned, turned inside out");
}

TEST(RequireOrgan, RemovesFacesWithoutAreaAndRepeatedFaces) {
  // Given a repeated face, a face with a repeated corner, and a sliver: an edge of face 200 split at its
  // middle on one side only, closed by a triangle without area.
  const TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  TriangleMesh wrong = mesh;
  const TriangleMesh::Triangle t = mesh.triangles[200];
  const auto middle = static_cast<std::uint32_t>(mesh.vertices_m.size());
  wrong.vertices_m.push_back(0.5 * (mesh.vertices_m[t[0]] + mesh.vertices_m[t[1]]));
  wrong.triangles[200] = {t[0], middle, t[2]};
  wrong.triangles.push_back({middle, t[1], t[2]});
  wrong.triangles.push_back({t[0], t[1], middle});
  wrong.triangles.push_back(mesh.triangles[10]);
  wrong.triangles.push_back({4, 4, 5});
  MeshRepairs repairs;

  const TriangleMesh organ = requireOrgan(wrong, "organ.obj", 0.001, &repairs);

  EXPECT_EQ(repairs.duplicateFaces, 1U);
  EXPECT_EQ(repairs.degenerateFaces, 2U);
  EXPECT_EQ(organ.triangles.size(), mesh.triangles.size() + 2);  // the edge is now split on both sides
  EXPECT_EQ(checkMesh(organ).degenerateFaces, 0U);
  EXPECT_NEAR(signedVolume_m3(organ), signedVolume_m3(mesh), 1e-12);
}

TEST(RequireOrgan, DropsDebrisAndInnerShells) {
  // Given an organ with its inner wall and a crumb beside it.
  const TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  const TriangleMesh inner = ellipsoid({0.036, 0.045, 0.072});
  const TriangleMesh crumb = ellipsoid({0.002, 0.002, 0.002}, 8, 6);
  MeshRepairs repairs;

  const TriangleMesh organ = requireOrgan(together(together(crumb, inner, {0.2, 0, 0}), mesh, {0.2, 0, 0}),
                                          "organ.obj", 0.001, &repairs);

  EXPECT_EQ(organ.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(repairs.droppedShells, 1U);
  EXPECT_EQ(repairs.droppedComponents, 1U);
  EXPECT_EQ(repairs.text(), "1 small piece dropped, 1 inner shell dropped");
}

TEST(RequireOrgan, RefusesTwoOrgans) {
  const TriangleMesh mesh = ellipsoid(kOrganRadius_m);

  EXPECT_THAT(organRefusal(together(mesh, mesh, {0.2, 0, 0})),
              HasSubstr("organ.obj: M14 separate pieces hold 50 % of the surface"));
}

TEST(RequireOrgan, RefusesAnOpenSurfaceAndSaysWhere) {
  TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  std::erase_if(mesh.triangles, [&mesh](const TriangleMesh::Triangle& t) {
    return mesh.vertices_m[t[0]].z > 0.07;  // the top is cut off
  });

  EXPECT_THAT(organRefusal(mesh),
              HasSubstr("M11 the surface is open: 24 boundary edges in 1 hole, first at ("));
}

TEST(RequireOrgan, RefusesAnEdgeWithThreeFaces) {
  TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  mesh.vertices_m.push_back({0.09, 0.0, 0.0});
  const TriangleMesh::Triangle t = mesh.triangles[60];
  mesh.triangles.push_back({t[0], t[1], static_cast<std::uint32_t>(mesh.vertices_m.size() - 1)});

  EXPECT_THAT(organRefusal(mesh), HasSubstr("M12 1 edge shared by more than two faces"));
}

TEST(RequireOrgan, RefusesARing) {
  EXPECT_THAT(organRefusal(torus(0.06, 0.02)), HasSubstr("M16 the surface has 1 handle"));
}

TEST(RequireOrgan, RefusesAOneSidedSurface) {
  // The projective plane on six vertices, each face cut into 6^2 so that only its one-sidedness is wrong.
  // Source: the standard minimal triangulation (the icosahedron with opposite points identified).
  TriangleMesh mesh;
  for (int i = 0; i < 6; ++i) {
    mesh.vertices_m.push_back({0.05 * std::cos(i * 1.1), 0.05 * std::sin(i * 1.1), 0.02 * i * std::cos(i)});
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1},
                    {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}};

  EXPECT_THAT(organRefusal(mesh), HasSubstr("M13 the surface is one-sided"));
}

TEST(RequireOrgan, RefusesAFlatSurface) {
  EXPECT_THAT(organRefusal(ellipsoid({0.08, 0.0002, 0.08})),
              HasSubstr("M18 the surface is flat: mean thickness 0."));
}

TEST(RequireOrgan, RefusesACoarseSurface) {
  EXPECT_THAT(organRefusal(ellipsoid(kOrganRadius_m, 10, 10)), HasSubstr("M19 too coarse: 180 triangles"));
}

TEST(RequireOrgan, RefusesAnEmptyMeshABadIndexAndABadNumber) {
  EXPECT_THAT(organRefusal({}), HasSubstr("M06 no triangles"));

  TriangleMesh mesh = ellipsoid(kOrganRadius_m);
  mesh.triangles[7][1] = 1'000'000;
  EXPECT_THAT(organRefusal(mesh), HasSubstr("M08 face 7 uses vertex 1000000 of 362"));

  mesh = ellipsoid(kOrganRadius_m);
  mesh.vertices_m[5].y = std::numeric_limits<double>::infinity();
  EXPECT_THAT(organRefusal(mesh), HasSubstr("M07 vertex 5 is not a finite number"));

  mesh = ellipsoid(kOrganRadius_m);
  for (Vec3& v : mesh.vertices_m) {
    v.x += 1000.0;
  }
  EXPECT_THAT(organRefusal(mesh), HasSubstr("M07 vertex 0 is at ("));
}

struct UnitCase {
  double fileSize;  // largest side of the organ in file units
  double unit_m;    // what the user said
  const char* answer;
};

class RequireOrganUnit : public ::testing::TestWithParam<UnitCase> {};

TEST_P(RequireOrganUnit, GuessesTheRightUnit) {
  const UnitCase& c = GetParam();
  const double side_m = c.fileSize * c.unit_m;
  const TriangleMesh mesh = ellipsoid({0.25 * side_m, 0.25 * side_m, 0.5 * side_m});

  EXPECT_THAT(organRefusal(mesh, c.unit_m), HasSubstr(c.answer));
}

INSTANTIATE_TEST_SUITE_P(
    Units, RequireOrganUnit,
    ::testing::Values(
        UnitCase{0.19, 0.001,
                 "organ.obj: M09 largest side 0.19 mm: the file seems to be in metres. Add --organ-unit m"},
        UnitCase{19.0, 0.001, "19 mm: the file seems to be in centimetres. Add --organ-unit cm"},
        UnitCase{190.0, 0.001, "accepted"},
        UnitCase{190000.0, 0.001, "the file seems to be in micrometres. Add --organ-unit um"},
        UnitCase{190.0, 1.0, "the file seems to be in millimetres. Add --organ-unit mm"},
        UnitCase{0.0002, 0.001,
                 "M09 largest side 0.0002 mm is not that of an organ (30 to 2000 mm). Scale the mesh"}));

TriangleMesh triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {{a, b, c}, {{0, 1, 2}}};
}

TEST(CrossingTriangles, ATriangleThroughAnotherIsOnePair) {
  const TriangleMesh flat = triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  EXPECT_EQ(crossingTriangles(together(flat, triangle({0.2, 0.2, -1}, {0.2, 0.2, 1}, {5, 5, 1}))),
            (std::vector<TrianglePair>{{0, 1}}));
  EXPECT_TRUE(crossingTriangles(together(flat, triangle({2, 2, -1}, {2, 2, 1}, {5, 5, 1}))).empty());
  EXPECT_TRUE(crossingTriangles(together(flat, triangle({0.2, 0.2, 0}, {0.2, 0.2, 1}, {5, 5, 1}))).empty())
      << "touching is not cutting";
}

TEST(CrossingTriangles, NeighboursOnASurfaceAreNotCompared) {
  // Two triangles that share corner 0; the edge of the second runs through the first.
  const TriangleMesh fan{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, -1}, {0.3, 0.3, 1}},
                         {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_TRUE(crossingTriangles(fan).empty());
}

TEST(CrossingTriangles, AClosedSurfaceAtRestHasNone) {
  EXPECT_TRUE(crossingTriangles(testing::capsule(0.02, 0.2, 48, 40)).empty());
  EXPECT_TRUE(crossingTriangles(testing::jTube(0.02, 0.1, 0.05, 32, 60)).empty());
  EXPECT_TRUE(crossingTriangles({}).empty());
}

TEST(CrossingTriangles, AreThoseThatEveryPairByItselfGives) {
  const TriangleMesh bar = testing::capsule(0.02, 0.1, 16, 12);
  const TriangleMesh both =
      together(bar, testing::shifted(testing::turned(bar, {1, 0, 0}, 1.1), {0.007, 0.03, 0.04}));
  std::vector<TrianglePair> expected;
  for (std::uint32_t i = 0; i < both.triangles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < both.triangles.size(); ++j) {
      if (!crossingTriangles({both.vertices_m, {both.triangles[i], both.triangles[j]}}).empty()) {
        expected.emplace_back(i, j);
      }
    }
  }

  EXPECT_EQ(crossingTriangles(both), expected);
  EXPECT_GT(expected.size(), 20U);
}

}  // namespace
}  // namespace torsio
