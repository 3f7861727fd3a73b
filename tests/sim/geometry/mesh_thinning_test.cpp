// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_thinning.h"

#include <gtest/gtest.h>

#include "sim/geometry/mesh/mesh_check.h"
#include "tests/sim/geometry/shapes.h"

namespace torsio {
namespace {

TEST(ThinnedMesh, KeepsTopologyVolumeAndPlaces) {
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
  EXPECT_NEAR(report.volume_m3 / checkMesh(fine).volume_m3, 1.0, 0.01);
  for (const Vec3& v : coarse.vertices_m) {
    EXPECT_NEAR(v.x * v.x / 0.0025 + v.y * v.y / 0.0016 + v.z * v.z / 0.0081, 1.0, 1e-9);
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

}  // namespace
}  // namespace torsio
