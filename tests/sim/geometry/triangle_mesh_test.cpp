// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/triangle_mesh.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/sim/geometry/shapes.h"

namespace torsio {
namespace {

using testing::ellipsoid;

// The corner of a cube of side 10 mm: one sixth of a cubic centimetre.
TriangleMesh cornerTetrahedron() {
  TriangleMesh mesh;
  mesh.vertices_m = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return mesh;
}

TEST(TriangleMesh, EnclosesTheVolumeOfATetrahedron) {
  TriangleMesh mesh = cornerTetrahedron();
  EXPECT_NEAR(signedVolume_m3(mesh), 1e-6 / 6.0, 1e-20);

  for (Vec3& v : mesh.vertices_m) {
    v += Vec3{50.0, -20.0, 7.0};
  }
  EXPECT_NEAR(signedVolume_m3(mesh), 1e-6 / 6.0, 1e-17);  // digits lost: 50 m against 10 mm

  for (TriangleMesh::Triangle& t : mesh.triangles) {
    std::swap(t[0], t[1]);
  }
  EXPECT_NEAR(signedVolume_m3(mesh), -1e-6 / 6.0, 1e-17);
  EXPECT_EQ(signedVolume_m3({}), 0.0);
}

TEST(TriangleMesh, HasNormalsThatPointOutwards) {
  const TriangleMesh mesh = ellipsoid({0.05, 0.05, 0.05}, 64, 32);

  const std::vector<Vec3> normals = vertexNormals(mesh);

  constexpr double kFacetting = 0.02;  // area-weighted facets of 64 x 32; worst beside the poles
  for (std::size_t i = 0; i < normals.size(); ++i) {
    ASSERT_NEAR(norm(normals[i]), 1.0, 1e-12);
    ASSERT_LT(norm(normals[i] - normalized(mesh.vertices_m[i])), kFacetting);
  }
}

TEST(TriangleMesh, HashesEveryBit) {
  const TriangleMesh mesh = cornerTetrahedron();
  const std::string hash = contentHash(mesh);
  EXPECT_EQ(hash.size(), 64U);  // 256 bits
  EXPECT_EQ(contentHash(mesh), hash);

  TriangleMesh moved = mesh;
  moved.vertices_m[2].y = std::nextafter(moved.vertices_m[2].y, 1.0);
  EXPECT_NE(contentHash(moved), hash);

  TriangleMesh turned = mesh;
  std::swap(turned.triangles[1], turned.triangles[2]);
  EXPECT_NE(contentHash(turned), hash);
}

}  // namespace
}  // namespace torsio
