// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_thinning.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/geometry/mesh/flat_faces.h"
#include "sim/geometry/mesh/iso_surface.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

TEST(ThinnedMesh, KeepsTopologyVolumeAndShape) {
  const TriangleMesh fine = testing::ellipsoid({0.05, 0.04, 0.09}, 120, 120);

  const TriangleMesh coarse = thinned(fine, 4000);

  EXPECT_LE(coarse.triangles.size(), 4000U);
  EXPECT_GT(coarse.triangles.size(), 3900U);
  const MeshReport report = checkMesh(coarse);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_TRUE(report.oriented());
  EXPECT_EQ(report.genus(), 0);
  EXPECT_EQ(report.degenerateFaces, 0U);
  EXPECT_EQ(report.unusedVertices, 0U);
  EXPECT_NEAR(report.volume_m3 / checkMesh(fine).volume_m3, 1.0, 2e-3);
  EXPECT_TRUE(crossingTriangles(coarse).empty());
  for (const Vec3& v : coarse.vertices_m) {
    EXPECT_NEAR(v.x * v.x / 0.0025 + v.y * v.y / 0.0016 + v.z * v.z / 0.0081, 1.0, 0.01);  // 0.2 mm and less
  }
}

TEST(ThinnedMesh, KeepsFlatFacesFlatAndTrianglesEven) {
  const TriangleMesh fine = testing::prism(testing::circleOutline(0.03, 240), 0.2, 120);

  const TriangleMesh coarse = thinned(fine, 2000);

  double longest_m = 0.0;
  for (const TriangleMesh::Triangle& t : coarse.triangles) {
    const Vec3& a = coarse.vertices_m[t[0]];
    const Vec3& b = coarse.vertices_m[t[1]];
    const bool onSide = std::min(a.z, b.z) > 0.005 && std::max(a.z, b.z) < 0.195;  // its ends are fans
    longest_m = onSide ? std::max(longest_m, norm(b - a)) : longest_m;
  }
  EXPECT_LT(longest_m, 0.02);  // an even triangulation has edges of 7 mm
  const MeshReport report = checkMesh(coarse);
  EXPECT_NEAR(report.boxMin_m.z, 0.0, 2e-4);
  EXPECT_NEAR(report.boxMax_m.z, 0.2, 2e-4);
  EXPECT_NEAR(report.volume_m3 / checkMesh(fine).volume_m3, 1.0, 4e-3);
}

// The end of a fine tube is a fan of slivers that say little of its plane; its rim was lifted all the same.
TEST(ThinnedMesh, KeepsTheEndsOfAFineTubeFlat) {
  const TriangleMesh fine = testing::bentTube(0.03, 0.09, 2.2, 500, 100);
  const std::vector<FlatFace> before = findFlatFaces(fine, SurfaceTopology(fine));

  const TriangleMesh coarse = thinned(fine, 10'000);

  const std::vector<FlatFace> after = findFlatFaces(coarse, SurfaceTopology(coarse));
  ASSERT_EQ(before.size(), 2U);
  ASSERT_EQ(after.size(), 2U);
  for (std::size_t f = 0; f < 2; ++f) {
    EXPECT_NEAR(after[f].area_m2 / before[f].area_m2, 1.0, 2e-3);
    const bool swapped = norm(after[f].centroid_m - before[f].centroid_m) > 0.01;
    const FlatFace& same = before[swapped ? 1 - f : f];
    EXPECT_LT(norm(after[f].centroid_m - same.centroid_m), 1e-4);
    EXPECT_GT(dot(after[f].normal, same.normal), 0.99999);
  }
}

TEST(ThinnedMesh, LeavesASmallMeshAsItIs) {
  const TriangleMesh mesh = testing::ellipsoid({0.05, 0.05, 0.09});

  EXPECT_EQ(contentHash(thinned(mesh, 10'000)), contentHash(mesh));
}

TEST(ThinnedMesh, StopsWhereTheShapeAllowsNoMore) {
  const TriangleMesh ring = thinned(testing::torus(0.1, 0.03, 48, 24), 200);

  const MeshReport report = checkMesh(ring);
  EXPECT_EQ(report.genus(), 1);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
}

/// A ball of voxels that are all or nothing: stairs.
TriangleMesh stairs() {
  const SampleGrid grid{{-24.0, -24.0, -24.0}, 1.0, {49, 49, 49}};
  return isoSurface(grid, [](std::size_t z, std::span<double> layer) {
    for (std::size_t n = 0; n < layer.size(); ++n) {
      const auto at = [](std::size_t i) { return static_cast<double>(i) - 24.0; };
      layer[n] = norm(Vec3{at(n % 49), at(n / 49), at(z)}) < 20.0 ? -1.0 : 1.0;
    }
  });
}

double unevenness(const TriangleMesh& ball) {
  double sum = 0.0;
  for (const Vec3& v : ball.vertices_m) {
    sum += std::pow(norm(v) - 20.0, 2);
  }
  return std::sqrt(sum / static_cast<double>(ball.vertices_m.size()));
}

TEST(SmoothedMesh, LosesItsStairsAndNotItsVolume) {
  TriangleMesh ball = stairs();
  const double volume = signedVolume_m3(ball);
  const double before = unevenness(ball);

  smooth(ball, 20);

  EXPECT_NEAR(signedVolume_m3(ball) / volume, 1.0, 2e-3);
  EXPECT_LT(unevenness(ball), 0.7 * before);
  EXPECT_TRUE(checkMesh(ball).closed());
}

}  // namespace
}  // namespace torsio
