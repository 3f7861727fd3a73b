// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/triangle_mesh.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/flat_faces.h"
#include "sim/geometry/mesh/iso_surface.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

using testing::ellipsoid;

// The corner of a cube of side 10 mm: one sixth of a cubic centimetre.
TriangleMesh cornerTetrahedron() {
  TriangleMesh mesh{.vertices_m = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}},
                    .triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
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

using ::testing::HasSubstr;

TriangleMesh oneTriangle() {
  TriangleMesh mesh{.vertices_m = {{0, 0, 0}, {0.0015, 0, 0}, {0, -0.002, 0.1}}, .triangles = {{0, 1, 2}}};
  return mesh;
}

TEST(MeshExport, WritesPlyTextInMillimetres) {
  const std::string text =
      plyBytes(oneTriangle(), {.format = PlyFormat::kAscii, .comments = {"one\ntwo"}, .colours = {}});

  EXPECT_EQ(
      text,
      "ply\nformat ascii 1.0\ncomment one two\ncomment unit millimetre, axes LPS (x left, y back, z up)\n"
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1.5 0 0\n0 -2 100\n3 0 1 2\n");
}

TEST(MeshExport, WritesLittleEndianBinaryPly) {
  const std::string bytes = plyBytes(oneTriangle());

  const std::size_t body = bytes.find("end_header\n") + 11;
  EXPECT_EQ(bytes.size() - body, 3 * 12 + 13U);  // three vertices of 12 bytes, a face of 1 + 12
  EXPECT_EQ(bytes.substr(body + 12, 4), std::string("\0\0\xC0\x3F", 4));  // 1.5f, IEEE 754
  EXPECT_EQ(bytes.substr(body + 36), std::string("\3\0\0\0\0\1\0\0\0\2\0\0\0", 13));
}

TEST(MeshExport, WritesColoursWithEachVertex) {
  const std::vector<std::array<std::uint8_t, 3>> colours{{1, 2, 3}, {4, 5, 6}, {255, 0, 9}};

  const std::string text =
      plyBytes(oneTriangle(), {.format = PlyFormat::kAscii, .comments = {}, .colours = colours});

  EXPECT_THAT(text, HasSubstr("property uchar blue\n"));
  EXPECT_THAT(text, HasSubstr("\n0 0 0 1 2 3\n1.5 0 0 4 5 6\n0 -2 100 255 0 9\n3 0 1 2\n"));
  EXPECT_THROW(
      (void)plyBytes(oneTriangle(),
                     {.format = PlyFormat::kAscii, .comments = {}, .colours = std::span(colours).first(2)}),
      ContractError);
}

TEST(MeshExport, WritesNormalsAndTextureCoordinatesWithEachVertex) {
  const std::vector<std::array<float, 2>> texture{{0.0F, 0.25F}, {0.5F, 0.0F}, {1.0F, 0.75F}};
  MeshExportOptions options;
  options.format = PlyFormat::kAscii;
  options.normals = true;
  options.texture = texture;
  TriangleMesh flat{.vertices_m = {{0, 0, 0}, {0.001, 0, 0}, {0, 0.002, 0}}, .triangles = {{0, 1, 2}}};

  const std::string text = plyBytes(flat, options);

  EXPECT_THAT(text, HasSubstr("property float nz\nproperty float s\nproperty float t\nelement face"));
  EXPECT_THAT(text, HasSubstr("\n0 0 0 0 0 1 0 0.25\n1 0 0 0 0 1 0.5 0\n0 2 0 0 0 1 1 0.75\n3 0 1 2\n"));
  options.texture = std::span(texture).first(2);
  EXPECT_THROW((void)plyBytes(flat, options), ContractError);
}

TEST(MeshExport, WritesObjWithIndicesFromOne) {
  EXPECT_EQ(objText(oneTriangle()),
            "# unit millimetre, axes LPS (x left, y back, z up)\nv 0 0 0\nv 1.5 0 0\nv 0 -2 100\nf 1 2 3\n");
}

TEST(MeshExport, WritesWholeFilesOrNone) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "torsio_export";
  std::filesystem::remove_all(folder);
  ensureFolder(folder);

  writePly(folder / "a.ply", oneTriangle());
  writeObj(folder / "a.obj", oneTriangle());

  EXPECT_EQ(readFile(folder / "a.ply"), plyBytes(oneTriangle()));
  EXPECT_EQ(readFile(folder / "a.obj"), objText(oneTriangle()));
  EXPECT_THROW(writePly(folder / "none" / "a.ply", oneTriangle()), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
  std::filesystem::remove_all(folder);
}

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
