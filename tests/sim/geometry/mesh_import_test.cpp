// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_import.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/random.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "tests/sim/geometry/shapes.h"
#include "tests/support/mesh_formats.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using testing::binaryStl;
using testing::ellipsoid;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::offText;

constexpr double kSinglePrecision_m = 1e-8;  // half a float step at 100 mm is 4e-9 m

class MeshImport : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("torsio_import_") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path file(const std::string& name, const std::string& bytes) const {
    writeFileAtomically(folder_ / name, bytes);
    return folder_ / name;
  }

  // The message with which the file is refused; its code goes to `code`.
  static std::string refusal(const fs::path& path, ErrorCode code, const MeshImportOptions& options = {}) {
    try {
      (void)importMesh(path, options);
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), code) << e.what();
      EXPECT_EQ(e.where(), path.string());
      EXPECT_FALSE(e.remedy().empty());
      EXPECT_THAT(std::string(e.what()), Not(HasSubstr("\n")));
      return e.happened();
    }
    return "accepted";
  }

  static void expectSame(const TriangleMesh& a, const TriangleMesh& b) {
    ASSERT_EQ(a.vertices_m.size(), b.vertices_m.size());
    ASSERT_EQ(a.triangles.size(), b.triangles.size());
    EXPECT_NEAR(signedVolume_m3(a), signedVolume_m3(b), 1e-9);
    double furthest_m = 0.0;
    for (std::size_t t = 0; t < a.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        furthest_m =
            std::max(furthest_m, norm(a.vertices_m[a.triangles[t][k]] - b.vertices_m[b.triangles[t][k]]));
      }
    }
    EXPECT_LT(furthest_m, kSinglePrecision_m);
  }

  const TriangleMesh organ_ = ellipsoid({0.04, 0.05, 0.08});
  fs::path folder_;
};

TEST_F(MeshImport, ReadsBackWhatTheExportersWrite) {
  const MeshExportOptions ascii{
      .format = PlyFormat::kAscii, .comments = {"first line", "second\nline"}, .colours = {}};

  expectSame(importMesh(file("a.ply", plyBytes(organ_))), organ_);
  expectSame(importMesh(file("b.PLY", plyBytes(organ_, ascii))), organ_);
  expectSame(importMesh(file("c.obj", objText(organ_))), organ_);
}

TEST_F(MeshImport, ReadsAPlyWhoseFirstNumberLooksLikeALineEnd) {
  // 0.08 is 0A D7 A3 3D: assimp dropped the first byte and read on shifted.
  TriangleMesh mesh = organ_;
  const double wanted_mm = static_cast<double>(0.08F);
  const double by_m = wanted_mm / 1000.0 - mesh.vertices_m.front().x;
  for (Vec3& v : mesh.vertices_m) {
    v.x += by_m;
  }
  const std::string bytes = plyBytes(mesh);
  ASSERT_EQ(bytes[bytes.find("end_header\n") + 11], '\n');

  expectSame(importMesh(file("a.ply", bytes)), mesh);

  std::string windows = bytes;
  for (std::size_t at = 0; (at = windows.find('\n', at)) < windows.find("end_header"); at += 2) {
    windows.replace(at, 1, "\r\n");
  }
  windows.replace(windows.find("end_header\n"), 11, "end_header\r\n");
  expectSame(importMesh(file("b.ply", windows)), mesh);
}

TEST_F(MeshImport, ReadsColouredPly) {
  const std::vector<std::array<std::uint8_t, 3>> red(organ_.vertices_m.size(), {200, 10, 10});
  for (const PlyFormat format : {PlyFormat::kBinary, PlyFormat::kAscii}) {
    const std::string bytes = plyBytes(organ_, {.format = format, .comments = {}, .colours = red});

    EXPECT_THAT(bytes, HasSubstr("property uchar red"));
    expectSame(importMesh(file("red.ply", bytes)), organ_);
  }
}

TEST_F(MeshImport, WeldsTheSoupOfAnStlFile) {
  MeshRepairs repairs;
  const TriangleMesh mesh = importMesh(file("organ.stl", binaryStl(organ_)), {}, &repairs);

  expectSame(mesh, organ_);
  EXPECT_FALSE(repairs.any()) << repairs.text();
}

TEST_F(MeshImport, ReadsOff) {
  const TriangleMesh mesh = importMesh(file("organ.off", offText(organ_)));

  EXPECT_EQ(mesh.triangles.size(), organ_.triangles.size());
  EXPECT_NEAR(signedVolume_m3(mesh), signedVolume_m3(organ_), 1e-9);
}

TEST_F(MeshImport, CutsPolygonsIntoTriangles) {
  // A cube of quads: 100 mm, 1 litre.
  const fs::path cube =
      file("cube.obj",
           "v 0 0 0\nv 100 0 0\nv 100 100 0\nv 0 100 0\nv 0 0 100\nv 100 0 100\nv 100 100 100\n"
           "v 0 100 100\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");

  const TriangleMesh mesh = importMesh(cube, {.scale_m = 0.001, .organ = false});

  EXPECT_EQ(mesh.vertices_m.size(), 8U);
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_NEAR(signedVolume_m3(mesh), 1e-3, 1e-12);
  EXPECT_THAT(refusal(cube, ErrorCode::kBadMesh), HasSubstr("M19 too coarse: 12 triangles"));
}

TEST_F(MeshImport, AppliesNodeTransformsAndTurnsMirroredParts) {
  // A COLLADA file with one tetrahedron (10 units) in a node mirrored in x and moved.
  const fs::path mirrored = file(
      "node.dae",
      R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="metre" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">
0 0 0 10 0 0 0 10 0 0 0 10</float_array><technique_common><accessor source="#a" count="4" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor>
</technique_common></source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 1 2 3 2 0 3</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node id="n">
<matrix>-1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)");

  const TriangleMesh mesh = importMesh(mirrored, {.scale_m = 0.001, .organ = false});

  const MeshReport report = checkMesh(mesh);
  EXPECT_NEAR(report.volume_m3, 1e-6 / 6.0, 1e-12);  // 10 mm: a sixth of a cubic centimetre, not negative
  EXPECT_NEAR(report.boxMin_m.x, -0.005, 1e-9);      // 5 - 10
  EXPECT_NEAR(report.boxMax_m.x, 0.005, 1e-9);
}

TEST_F(MeshImport, RefusesWhatIsNoFile) {
  EXPECT_THAT(refusal(folder_ / "none.obj", ErrorCode::kFileMissing), HasSubstr("M01 no such file"));
  EXPECT_THAT(refusal(folder_, ErrorCode::kFileUnreadable), HasSubstr("M01 not a file"));
  EXPECT_THAT(refusal(file("empty.ply", ""), ErrorCode::kFileUnreadable), HasSubstr("M01 the file is empty"));
}

TEST_F(MeshImport, RefusesUnknownExtensionsAndOtherContent) {
  const std::string garbage = "This is a letter, not a mesh.\nKind regards\n";
  for (const char* name : {"scan.3mf", "scan.md2", "scan", "scan.ply.gz"}) {
    EXPECT_THAT(refusal(file(name, garbage), ErrorCode::kFileUnreadable),
                HasSubstr("M02 files with the extension"));
  }
  for (const char* name : {"a.ply", "a.off", "a.stl", "a.glb", "a.gltf", "a.dae"}) {
    EXPECT_THAT(refusal(file(name, garbage), ErrorCode::kFileUnreadable), HasSubstr("M02 not a ")) << name;
  }
  EXPECT_THAT(refusal(file("a.obj", garbage), ErrorCode::kFileUnreadable),
              HasSubstr("M02 not a file of the format OBJ"));
  EXPECT_THAT(refusal(file("b.obj", std::string("v\0 \0001", 5)), ErrorCode::kFileUnreadable),
              HasSubstr("M02 not a file of the format OBJ: it is not UTF-8 text"));
  EXPECT_THAT(refusal(file("c.stl", plyBytes(organ_)), ErrorCode::kFileUnreadable), HasSubstr("M0"));
}

TEST_F(MeshImport, RefusesHugeDeclaredCounts) {
  const std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\nabc";
  EXPECT_THAT(refusal(file("huge.ply", ply), ErrorCode::kFileUnreadable),
              HasSubstr("M04 the header promises 2000000000 of element vertex"));
  EXPECT_THAT(refusal(file("huge.off", "OFF\n999999999999999999999 4000000000 0\n0 0 0\n"),
                      ErrorCode::kFileUnreadable),
              HasSubstr("M04 the header promises"));
  std::string stl = binaryStl(organ_);
  stl.resize(stl.size() / 2);
  EXPECT_THAT(refusal(file("cut.stl", stl), ErrorCode::kFileUnreadable),
              HasSubstr("M04 the header promises 720 facets"));
  std::string cut = plyBytes(organ_);
  cut.resize(cut.size() - 20);
  EXPECT_THAT(refusal(file("cut.ply", cut), ErrorCode::kFileUnreadable), HasSubstr("of element face"));
}

/// What a glTF file promises must be in it before the importer reserves memory for it.
TEST_F(MeshImport, RefusesAGlbThatPromisesMoreThanItHolds) {
  const std::string sound = testing::glbBytes(organ_);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string bytes = sound;
    const std::size_t at = bytes.find(from);
    EXPECT_NE(at, std::string::npos) << from << " is not in " << bytes.substr(20, 900);
    const std::size_t digits = bytes.find_first_not_of("0123456789", at + from.size());
    std::string number = to;
    number.resize(std::max(to.size(), digits - at - from.size()), ' ');
    const std::size_t grown = number.size() - (digits - at - from.size());
    bytes.replace(at + from.size(), digits - at - from.size(), number);
    // The chunk and the file grow by as much.
    for (const std::size_t field : {8UL, 12UL}) {
      std::uint32_t length = 0;
      std::memcpy(&length, bytes.data() + field, 4);
      length += static_cast<std::uint32_t>(grown);
      std::memcpy(bytes.data() + field, &length, 4);
    }
    return bytes;
  };
  for (const char* field : {"\"count\":", "\"byteLength\":", "\"byteOffset\":", "\"byteStride\":"}) {
    if (sound.find(field) == std::string::npos) {
      continue;
    }
    EXPECT_THAT(refusal(file("big.glb", changed(field, "800000000")), ErrorCode::kFileUnreadable),
                HasSubstr("it promises more than the file holds"))
        << field;
    EXPECT_THAT(refusal(file("none.glb", changed(field, "-1")), ErrorCode::kFileUnreadable),
                HasSubstr("it promises more than the file holds"))
        << field;
  }
  std::string other = sound;
  other[4] = 1;
  EXPECT_THAT(refusal(file("old.glb", other), ErrorCode::kFileUnreadable), HasSubstr("not of version 2"));
}

TEST_F(MeshImport, RefusesNumbersThatAreNone) {
  std::string text = objText(organ_);
  text.replace(text.find("\nv ") + 3, 1, "nan ");
  EXPECT_THAT(refusal(file("nan.obj", text), ErrorCode::kBadMesh), HasSubstr("is not a finite number"));

  std::string off = offText(organ_);
  off.replace(off.find("0\n", 4) + 2, 1, "inf ");
  EXPECT_THAT(refusal(file("inf.off", off), ErrorCode::kBadMesh), HasSubstr("M07"));

  std::string ply = plyBytes(organ_);
  const std::size_t body = ply.find("end_header\n") + 11;
  ply.replace(body + 36, 4, std::string("\0\0\xC0\x7F", 4));  // NaN as the x of vertex 3
  EXPECT_THAT(refusal(file("nan.ply", ply), ErrorCode::kBadMesh), HasSubstr("is not a finite number"));
}

TEST_F(MeshImport, RefusesOpenNonManifoldAndWrongUnits) {
  TriangleMesh open = organ_;
  open.triangles.pop_back();
  EXPECT_THAT(refusal(file("open.obj", objText(open)), ErrorCode::kBadMesh),
              HasSubstr("M11 the surface is open"));

  TriangleMesh fin = organ_;
  fin.vertices_m.push_back({0.2, 0.0, 0.0});
  fin.triangles.push_back({10, 11, static_cast<std::uint32_t>(fin.vertices_m.size() - 1)});
  EXPECT_THAT(refusal(file("fin.obj", objText(fin)), ErrorCode::kBadMesh), HasSubstr("M12"));

  TriangleMesh metres = organ_;
  for (Vec3& v : metres.vertices_m) {
    v *= 0.001;  // the writer multiplies by 1000: the file holds metres
  }
  const fs::path inMetres = file("metres.obj", objText(metres));
  EXPECT_THAT(refusal(inMetres, ErrorCode::kBadMesh), HasSubstr("the file seems to be in metres"));
  EXPECT_EQ(importMesh(inMetres, {.scale_m = lengthUnit_m("m"), .organ = true}).triangles.size(),
            organ_.triangles.size());
}

TEST_F(MeshImport, RefusesPointsWithoutFaces) {
  EXPECT_THAT(refusal(file("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), ErrorCode::kBadMesh),
              HasSubstr("M0"));
  EXPECT_THAT(refusal(file("lines.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n"), ErrorCode::kBadMesh),
              HasSubstr("M06"));
  const std::string points =
      "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
      "z\nend_header\n0 0 0\n";
  EXPECT_THAT(refusal(file("points.ply", points), ErrorCode::kBadMesh), HasSubstr("M06"));
}

TEST_F(MeshImport, RefusesFaceIndicesOutOfRange) {
  std::string off = offText(organ_);
  off.replace(off.rfind("\n3 ") + 3, 1, "99999");
  EXPECT_THAT(refusal(file("index.off", off), ErrorCode::kBadMesh), HasSubstr("M08 line"));

  std::string obj = objText(organ_);
  obj.replace(obj.rfind("\nf ") + 3, 1, "99999");
  EXPECT_THAT(refusal(file("index.obj", obj), ErrorCode::kFileUnreadable), HasSubstr("M05"));

  std::string ply = plyBytes(organ_, {.format = PlyFormat::kAscii, .comments = {}, .colours = {}});
  ply.replace(ply.rfind("\n3 ") + 3, 1, "99999");
  EXPECT_THAT(refusal(file("index.ply", ply), ErrorCode::kBadMesh), HasSubstr("M08"));
}

TEST_F(MeshImport, ReadsWindowsLineEndsAndComments) {
  const auto withReturns = [](const std::string& text) {
    std::string out;
    for (const char c : text) {
      out += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    return out;
  };
  std::string off = withReturns(offText(organ_));
  off.insert(off.find('\n') + 1, "# counts follow\r\n\r\n");
  expectSame(importMesh(file("w.obj", withReturns(objText(organ_)))), organ_);
  expectSame(
      importMesh(file("w.ply", withReturns(plyBytes(
                                   organ_, {.format = PlyFormat::kAscii, .comments = {}, .colours = {}})))),
      organ_);
  EXPECT_EQ(importMesh(file("w.off", off)).triangles.size(), organ_.triangles.size());
}

TEST_F(MeshImport, ReadsBigEndianPly) {
  std::string bytes = plyBytes(organ_);
  bytes.replace(bytes.find("little"), 6, "big");
  std::size_t at = bytes.find("end_header\n") + 11;
  const auto swap4 = [&bytes, &at] {
    std::reverse(bytes.begin() + static_cast<std::ptrdiff_t>(at),
                 bytes.begin() + static_cast<std::ptrdiff_t>(at + 4));
    at += 4;
  };
  for (std::size_t i = 0; i < 3 * organ_.vertices_m.size(); ++i) {
    swap4();
  }
  for (std::size_t i = 0; i < organ_.triangles.size(); ++i) {
    ++at;  // the length of the list
    for (int k = 0; k < 3; ++k) {
      swap4();
    }
  }

  expectSame(importMesh(file("big.ply", bytes)), organ_);
}

TEST_F(MeshImport, RefusesBrokenRows) {
  const MeshExportOptions ascii{.format = PlyFormat::kAscii, .comments = {}, .colours = {}};
  const std::string ply = plyBytes(organ_, ascii);
  std::string missing = ply;
  missing.erase(missing.find_last_of(' '));  // the last index
  EXPECT_THAT(refusal(file("missing.ply", missing), ErrorCode::kFileUnreadable),
              HasSubstr("values are missing"));
  std::string more = ply;
  more.insert(more.size() - 1, " 7");
  EXPECT_THAT(refusal(file("more.ply", more), ErrorCode::kFileUnreadable),
              HasSubstr("more values than declared"));
  std::string word = ply;
  word.replace(word.find("end_header\n") + 11, 1, "x");
  EXPECT_THAT(refusal(file("word.ply", word), ErrorCode::kFileUnreadable),
              HasSubstr("a value is not a number"));
  std::string list = plyBytes(organ_);
  list[list.size() - 13] = '\xff';  // the last face claims 255 corners
  EXPECT_THAT(refusal(file("list.ply", list), ErrorCode::kFileUnreadable), HasSubstr("the file ends early"));
  std::string index = plyBytes(organ_);
  index[index.size() - 1] = '\x80';  // a negative index
  EXPECT_THAT(refusal(file("index.ply", index), ErrorCode::kBadMesh),
              HasSubstr("M08 face 719 uses vertex -"));
  std::string off = offText(organ_);
  off.resize(off.size() - 30);
  EXPECT_THAT(refusal(file("cut.off", off), ErrorCode::kFileUnreadable), HasSubstr("M0"));
}

TEST_F(MeshImport, SurvivesDamagedFiles) {
  // assimp 5.2 alone crashes on some damaged PLY and OFF files.
  const TriangleMesh small = ellipsoid({0.04, 0.05, 0.08}, 12, 10);
  const MeshExportOptions ascii{.format = PlyFormat::kAscii, .comments = {}, .colours = {}};
  const std::vector<std::pair<std::string, std::string>> seeds{{"a.ply", plyBytes(small)},
                                                               {"b.ply", plyBytes(small, ascii)},
                                                               {"c.off", offText(small)},
                                                               {"d.obj", objText(small)},
                                                               {"e.stl", binaryStl(small)}};
  constexpr int kVariants = 60;
  Random random(11);
  for (const auto& [name, seed] : seeds) {
    int refused = 0;
    for (int i = 0; i < kVariants; ++i) {
      std::string bytes = seed;
      const std::size_t at = random.bounded(bytes.size());
      if (i % 3 == 0) {
        bytes.resize(at);
      }
      if (i % 3 == 1) {
        bytes.erase(at, 1 + random.bounded(20));
      }
      for (int k = 0; i % 3 == 2 && k < 5; ++k) {
        bytes[random.bounded(bytes.size())] = static_cast<char>(random.bounded(256));
      }
      try {
        const TriangleMesh mesh = importMesh(file(name, bytes));
        EXPECT_EQ(checkMesh(mesh).genus(), 0);
      } catch (const Error&) {
        ++refused;
      }
    }
    EXPECT_GT(refused, kVariants / 2) << name;
  }
}

TEST_F(MeshImport, OpensNoFileOutsideTheFolder) {
  // Given a glTF file whose buffer is a file one folder up.
  writeFileAtomically(folder_ / "secret.bin", std::string(36, '\0'));
  fs::create_directories(folder_ / "inner");
  const fs::path gltf =
      file("inner/a.gltf",
           R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"buffers":[{"uri":"../secret.bin","byteLength":36}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,0]}]})");

  EXPECT_THAT(refusal(gltf, ErrorCode::kFileUnreadable, {.scale_m = 1.0, .organ = false}),
              HasSubstr("M05 the importer failed on this file"));
}

TEST_F(MeshImport, RefusesAScaleThatIsNone) {
  const fs::path good = file("organ.obj", objText(organ_));
  for (const double scale_m : {0.0, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THAT(refusal(good, ErrorCode::kBadParameter, {.scale_m = scale_m, .organ = true}),
                HasSubstr("the file unit must lie between"));
  }
  EXPECT_THROW((void)lengthUnit_m("furlong"), Error);
  EXPECT_EQ(lengthUnit_m("mm"), 0.001);
}

}  // namespace
}  // namespace torsio
