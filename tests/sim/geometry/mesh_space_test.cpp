// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh file says of its coordinates, and text STL as programs write it.
#include "sim/geometry/mesh/mesh_space.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using testing::binaryStl;
using testing::ellipsoid;

constexpr double kFloatStep_m = 1e-7;

class MeshSpaceOfFile : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("torsio_space_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const std::string& bytes) const {
    writeFileAtomically(folder_ / name, bytes);
    return folder_ / name;
  }

  static void expectSame(const TriangleMesh& a, const TriangleMesh& b) {
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    EXPECT_NEAR(signedVolume_m3(a), signedVolume_m3(b), 1e-9);
    EXPECT_LT(norm(boxOf(a.vertices_m).low - boxOf(b.vertices_m).low), kFloatStep_m);
    EXPECT_LT(norm(boxOf(a.vertices_m).high - boxOf(b.vertices_m).high), kFloatStep_m);
  }

  const TriangleMesh organ_ = ellipsoid({0.04, 0.05, 0.08});
  fs::path folder_;
};

std::string textStl(const TriangleMesh& mesh, const std::string& name = "organ") {
  std::string text = "solid " + name + "\n";
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    text += " facet normal 0 0 1\n  outer loop\n";
    for (const std::uint32_t corner : t) {
      const Vec3& v = mesh.vertices_m[corner];
      text += "   vertex " + std::to_string(1000.0 * v.x) + ' ' + std::to_string(1000.0 * v.y) + ' ' +
              std::to_string(1000.0 * v.z) + '\n';
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid " + name + '\n';
}

TEST_F(MeshSpaceOfFile, ReadsEveryTextStl) {
  const std::string plain = textStl(organ_);
  std::string large = plain;
  std::transform(large.begin(), large.end(), large.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  std::string oneLine = plain;
  std::replace(oneLine.begin(), oneLine.end(), '\n', ' ');
  for (const auto& [name, text] : {std::pair<const char*, std::string>{"plain", plain},
                                   {"empty solid first", "solid none\nendsolid none\n" + plain},
                                   {"leading blanks", " \n\t " + plain},
                                   {"byte order mark", "\xEF\xBB\xBF" + plain},
                                   {"capitals", large},
                                   {"one line", oneLine},
                                   {"a name that is not ASCII", textStl(organ_, "\xE8\x83\x83")}}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = importMesh(file("organ.stl", text));
    EXPECT_EQ(mesh.triangles.size(), organ_.triangles.size());
    EXPECT_NEAR(signedVolume_m3(mesh), signedVolume_m3(organ_), 1e-9);
  }
  const fs::path none = file("none.stl", "solid none\nendsolid none\n");
  testing::expectError(testing::refusal([&] { return importMesh(none); }), ErrorCode::kBadMesh, {"M06"});
}

TEST_F(MeshSpaceOfFile, TakesAFilesOwnNumbersWhateverItsUnit) {
  const std::string centimetres = testing::daeText(organ_);
  for (const char* unit : {"0.001", "0.01", "1", "0.0254"}) {
    std::string text = centimetres;
    text.replace(text.find("0.001"), 5, unit);
    const fs::path path = file("organ.dae", text);
    expectSame(importMesh(path), organ_);
    EXPECT_EQ(meshSpaceOf(path).unit_m, std::stod(unit));
  }
}

TEST_F(MeshSpaceOfFile, TakesTheUnitThatAFileStates) {
  const fs::path dae = file("a.dae", testing::daeText(organ_));
  const fs::path glb = file("b.GLB", testing::glbBytes(organ_));
  const fs::path ply = file("c.ply", plyBytes(organ_));
  EXPECT_EQ(meshUnit_m(dae, {}), 1e-3);
  EXPECT_EQ(meshUnit_m(dae, 1e-3), 1e-3);
  EXPECT_EQ(meshUnit_m(glb, {}), 1.0);
  EXPECT_EQ(meshUnit_m(ply, {}), 1e-3);
  EXPECT_EQ(meshUnit_m(ply, 1e-2), 1e-2);
  EXPECT_EQ(meshUnit_m(folder_ / "nowhere.dae", 1e-2), 1e-2);
  for (const auto& [path, given_m] : {std::pair(dae, 1e-2), {glb, 1e-3}}) {
    const Error refused =
        testing::refusal([&path = path, given_m = given_m] { return meshUnit_m(path, given_m); });
    testing::expectError(refused, ErrorCode::kBadParameter, {"the file says that one of its units is"});
    EXPECT_EQ(refused.where(), path.string());
  }
  std::string bare = testing::daeText(organ_);
  bare.replace(bare.find("<unit"), bare.find("<up_axis") - bare.find("<unit"), "");
  const fs::path none = file("d.dae", bare);
  EXPECT_FALSE(meshSpaceOf(none).unit_m.has_value());
  expectSame(importMesh(none), organ_);
}

TEST_F(MeshSpaceOfFile, TurnsWhat3DSlicerWroteInRas) {
  TriangleMesh ras = organ_;
  for (Vec3& v : ras.vertices_m) {
    v = {-v.x - 0.03, -v.y + 0.01, v.z + 0.2};
  }
  TriangleMesh lps = organ_;
  for (Vec3& v : lps.vertices_m) {
    v = {v.x + 0.03, v.y - 0.01, v.z + 0.2};
  }
  for (const std::string said : {"3D Slicer output. SPACE=RAS", "3D Slicer output. SPACE=LPS"}) {
    const TriangleMesh& wanted = said.ends_with("RAS") ? lps : ras;
    std::string stl = binaryStl(ras);
    stl.replace(0, said.size(), said);
    const MeshExportOptions words{.format = PlyFormat::kBinary, .comments = {said}, .colours = {}};
    for (const fs::path& path : {file("a.stl", stl), file("b.ply", plyBytes(ras, words)),
                                 file("c.obj", "# " + said + '\n' + objText(ras))}) {
      const TriangleMesh read = importMesh(path);
      EXPECT_LT(norm(boxOf(read.vertices_m).low - boxOf(wanted.vertices_m).low), kFloatStep_m) << path;
      EXPECT_NEAR(signedVolume_m3(read), signedVolume_m3(wanted), 1e-9);
      EXPECT_EQ(meshSpaceOf(path).unit_m, 1e-3);
    }
  }
}

}  // namespace
}  // namespace torsio
