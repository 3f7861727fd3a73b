// SPDX-License-Identifier: GPL-3.0-or-later
// Formats and rules of an import through the process that reads: one shape in each format, one file a rule.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/file_io.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/organ_import.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/organ_like_shapes.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;

OrganImport importOfBytes(const std::string& name, const std::string& bytes) {
  OrganImportRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.file = std::filesystem::path(::testing::TempDir()) / ("rules-" + std::to_string(getpid()) + name);
  writeFileAtomically(request.file, bytes);
  OrganImport import = importOrgan(request);
  std::filesystem::remove(request.file);
  return import;
}

OrganImport importOfMesh(const TriangleMesh& mesh) {
  return importOfBytes(".ply", plyBytes(mesh));
}

const OrganFinding* foundIn(const OrganImport& import, const std::string& code) {
  const auto at = std::find_if(import.findings.begin(), import.findings.end(),
                               [&code](const OrganFinding& one) { return one.code == code; });
  return at == import.findings.end() ? nullptr : &*at;
}

/// The weight of a finding; it has its place and, unless it is a note, its remedy.
FindingWeight weightOf(const OrganImport& import, const std::string& code) {
  const OrganFinding* const one = foundIn(import, code);
  if (one == nullptr) {
    ADD_FAILURE() << "no " << code;
    return FindingWeight::kNote;
  }
  EXPECT_FALSE(one->what.empty()) << code;
  if (one->weight != FindingWeight::kNote) {
    EXPECT_FALSE(one->remedy.empty()) << code;
  }
  return one->weight;
}

void addPiece(TriangleMesh& whole, const TriangleMesh& piece, const Vec3& at_m) {
  const auto first = static_cast<std::uint32_t>(whole.vertices_m.size());
  for (const Vec3& v : piece.vertices_m) {
    whole.vertices_m.push_back(v + at_m);
  }
  for (const TriangleMesh::Triangle& t : piece.triangles) {
    whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
}

TriangleMesh plainBar() {
  return testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
}

TEST(OrganRules, OneShapeIsAcceptedInEveryFormat) {
  const TriangleMesh bar = plainBar();
  for (const auto& [ending, bytes] : testing::everyFormat(bar)) {
    const OrganImport import = importOfBytes(ending, bytes);

    EXPECT_TRUE(import.accepted) << ending << ' '
                                 << (import.findings.empty() ? "" : import.findings[0].what.str());
    EXPECT_EQ(import.organ.mesh.triangles.size(), bar.triangles.size()) << ending;
    EXPECT_NEAR(import.volume_ml.value_or(0.0), 1e6 * signedVolume_m3(bar), 0.5) << ending;
  }
}

TEST(OrganRules, M03RefusesTooLargeAFileAndTooManyTriangles) {
  OrganImportRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.file =
      std::filesystem::path(::testing::TempDir()) / ("rules-large-" + std::to_string(getpid()) + ".stl");
  writeFileAtomically(request.file, "x");
  std::filesystem::resize_file(request.file, 500'000'001);  // holes: no bytes on the disk
  EXPECT_EQ(weightOf(importOrgan(request), "M03"), FindingWeight::kRefusal);
  std::filesystem::remove(request.file);

  const OrganImport many = importOfMesh(testing::prism(testing::circleOutline(0.03, 500), 0.2, 2001));
  EXPECT_EQ(weightOf(many, "M03"), FindingWeight::kRefusal);
  EXPECT_FALSE(many.accepted);
}

TEST(OrganRules, M10TellsOfFacesThatWereRemoved) {
  TriangleMesh mesh = plainBar();
  mesh.triangles.push_back(mesh.triangles[5]);
  mesh.triangles.push_back({1, 1, 2});

  const OrganImport import = importOfMesh(mesh);

  EXPECT_TRUE(import.accepted);
  EXPECT_EQ(weightOf(import, "M10"), FindingWeight::kNote);
  EXPECT_EQ(foundIn(import, "M10")->value, 2.0);
}

TEST(OrganRules, M14LeavesDebrisOutAndRefusesTwoOrgans) {
  TriangleMesh debris = plainBar();
  addPiece(debris, testing::prism(testing::circleOutline(0.003, 12), 0.004, 2), {0.1, 0, 0});
  const OrganImport kept = importOfMesh(debris);
  EXPECT_TRUE(kept.accepted);
  EXPECT_EQ(weightOf(kept, "M14"), FindingWeight::kNote);
  EXPECT_EQ(kept.organ.mesh.triangles.size(), plainBar().triangles.size());

  TriangleMesh two = plainBar();
  addPiece(two, plainBar(), {0.1, 0, 0});
  const OrganImport refused = importOfMesh(two);
  EXPECT_FALSE(refused.accepted);
  EXPECT_EQ(weightOf(refused, "M14"), FindingWeight::kRefusal);
}

/// A ring that is not closed: its ends lie `aside_m` beside each other.
TriangleMesh openRing(double turn_rad, double aside_m) {
  constexpr double kBend_m = 0.07;
  return testing::sweep(testing::circleOutline(0.02, 60), 200, [=](double t) {
    const SinCos a = portableSinCos(t * turn_rad);
    return testing::SweepFrame{
        {kBend_m * a.cos, aside_m * t, kBend_m * a.sin}, {a.cos, 0, a.sin}, {0, 1, 0}, 1.0};
  });
}

TEST(OrganRules, M17RefusesASurfaceThatCrossesItself) {
  const OrganImport crossing = importOfMesh(openRing(2.0 * kPi + 0.2, 0.015));
  EXPECT_EQ(weightOf(crossing, "M17"), FindingWeight::kRefusal);
  EXPECT_GT(crossing.measures.crossingsAtRest, 24U);

  EXPECT_EQ(foundIn(importOfMesh(openRing(2.0 * kPi - 1.0, 0.015)), "M17"), nullptr);
}

TEST(OrganRules, M21TellsOfTexturesThatAreLeftOut) {
  const std::string pixel =
      "data:image/png;base64," + testing::formats::base64(std::string("\x89PNG\r\n\x1a\n and no more", 20));
  const std::string textured = R"("materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],)"
                               R"("textures":[{"source":0}],"images":[{"uri":")" +
                               pixel + R"("}],)";

  const OrganImport import = importOfBytes(".gltf", testing::gltfText(plainBar(), textured));

  EXPECT_TRUE(import.accepted);
  EXPECT_EQ(weightOf(import, "M21"), FindingWeight::kNote);
}

TEST(OrganRules, M24RefusesWhatCrossesItselfWhenItIsTwisted) {
  const OrganImport slab = importOfMesh(testing::slabShape());

  EXPECT_EQ(weightOf(slab, "M24"), FindingWeight::kRefusal);
  EXPECT_EQ(foundIn(slab, "M17"), nullptr);  // not at rest
}

/// A bar with a neck of `share` of its radius at half its length.
TriangleMesh necked(double share) {
  return testing::sweep(testing::circleOutline(0.03, 48), 80, [share](double t) {
    const double away = std::min(1.0, std::abs(t - 0.5) / 0.2);
    return testing::SweepFrame{{0, 0, 0.25 * t}, {1, 0, 0}, {0, 1, 0}, share + (1.0 - share) * away};
  });
}

TEST(OrganRules, M25WarnsOfANeckAndRefusesAThinOne) {
  EXPECT_EQ(foundIn(importOfMesh(necked(0.5)), "M25"), nullptr);
  const OrganImport warned = importOfMesh(necked(0.29));
  EXPECT_EQ(weightOf(warned, "M25"), FindingWeight::kWarning);
  EXPECT_EQ(weightOf(importOfMesh(necked(0.2)), "M25"), FindingWeight::kRefusal);
}

}  // namespace
}  // namespace torsio
