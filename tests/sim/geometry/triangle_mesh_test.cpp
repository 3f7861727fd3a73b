// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/triangle_mesh.h"

#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
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

using ::testing::HasSubstr;

TriangleMesh oneTriangle() {
  TriangleMesh mesh;
  mesh.vertices_m = {{0, 0, 0}, {0.0015, 0, 0}, {0, -0.002, 0.1}};
  mesh.triangles = {{0, 1, 2}};
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
  TriangleMesh flat;
  flat.vertices_m = {{0, 0, 0}, {0.001, 0, 0}, {0, 0.002, 0}};
  flat.triangles = {{0, 1, 2}};

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

}  // namespace
}  // namespace torsio
