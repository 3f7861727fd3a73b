// SPDX-License-Identifier: GPL-3.0-or-later
// Formats and rules of an import through the process that reads: one shape in each format, one file a rule.
#include "sim/scene/organ_judgement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/file_io.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/flat_faces.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_holes.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/scene_file.h"
#include "tests/support/mesh_formats.h"
#include "tests/support/organ_like_shapes.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

const std::filesystem::path kJudgedAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

OrganJudgement judgementOf(const TriangleMesh& mesh) {
  return judgeOrgan(requireOrgan(mesh, "shape"), latticeFor({}));
}

bool refusedBy(const OrganJudgement& judgement, const std::string& code) {
  return std::any_of(judgement.findings.begin(), judgement.findings.end(), [&code](const OrganFinding& one) {
    return one.code == code && one.weight == FindingWeight::kRefusal && !one.what.empty() &&
           !one.where.empty() && !one.remedy.empty();
  });
}

bool warnedBy(const OrganJudgement& judgement, const std::string& code) {
  return std::any_of(judgement.findings.begin(), judgement.findings.end(), [&code](const OrganFinding& one) {
    return one.code == code && one.weight == FindingWeight::kWarning;
  });
}

bool refused(const OrganJudgement& judgement) {
  return std::any_of(judgement.findings.begin(), judgement.findings.end(),
                     [](const OrganFinding& one) { return one.weight == FindingWeight::kRefusal; });
}

TEST(OrganJudgement, RefusesABallBecauseItHasNoLength) {
  const OrganJudgement ball = judgementOf(testing::ballShape());

  EXPECT_TRUE(refusedBy(ball, "M20"));
  EXPECT_LT(ball.measures.elongation, 1.0);
}

TEST(OrganJudgement, RefusesWhatBranches) {
  EXPECT_TRUE(refusedBy(judgementOf(testing::branchingShape()), "M20"));
  EXPECT_TRUE(refused(judgementOf(testing::jawShape())));
}

TEST(OrganJudgement, RefusesASlabBecauseItIsFlat) {
  const OrganJudgement slab = judgementOf(testing::slabShape());

  EXPECT_TRUE(refusedBy(slab, "M18"));
  EXPECT_NEAR(slab.measures.flatness, 110.0 / 16.0, 0.2);
}

/// A round bar whose width goes from one end's to the other's.
TriangleMesh coneOf(double from_m, double to_m, double length_m) {
  constexpr std::uint32_t kAround = 36;
  constexpr std::uint32_t kRings = 24;
  TriangleMesh cone;
  for (std::uint32_t k = 0; k <= kRings; ++k) {
    const double share = static_cast<double>(k) / kRings;
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double turn = 2.0 * kPi * i / kAround;
      const double r_m = from_m + share * (to_m - from_m);
      cone.vertices_m.push_back({r_m * std::cos(turn), r_m * std::sin(turn), share * length_m});
    }
  }
  cone.vertices_m.push_back({0, 0, 0});
  cone.vertices_m.push_back({0, 0, length_m});
  constexpr std::uint32_t kFoot = (kRings + 1) * kAround;
  for (std::uint32_t i = 0; i < kAround; ++i) {
    const std::uint32_t next = (i + 1) % kAround;
    for (std::uint32_t k = 0; k < kRings; ++k) {
      const std::uint32_t a = k * kAround + i;
      const std::uint32_t b = k * kAround + next;
      cone.triangles.push_back({a, b, b + kAround});
      cone.triangles.push_back({a, b + kAround, a + kAround});
    }
    cone.triangles.push_back({kFoot, next, i});
    cone.triangles.push_back({kFoot + 1, kRings * kAround + i, kRings * kAround + next});
  }
  return cone;
}

TEST(OrganJudgement, RefusesAShortConeAndWarnsOfATip) {
  EXPECT_TRUE(refusedBy(judgementOf(coneOf(0.02, 0.01, 0.0690)), "M20"));  // 1.73 widths
  EXPECT_FALSE(refused(judgementOf(coneOf(0.02, 0.01, 0.0830))));          // 2.08: a warning
  EXPECT_FALSE(judgementOf(coneOf(0.02, 0.01, 0.0830)).findings.empty());
  EXPECT_TRUE(judgementOf(coneOf(0.02, 0.01, 0.12)).findings.empty());   // a forearm tapers as much
  EXPECT_TRUE(warnedBy(judgementOf(coneOf(0.02, 0.0002, 0.2)), "M25"));  // all twist at its tip
}

/// A round tube bent by a radius through an angle, with round ends.
TriangleMesh archOf(double radius_m, double bend_m, double turn_rad) {
  const double reach_m = bend_m + radius_m + 0.008;
  return testing::shapes::surfaceOf(
      {-reach_m, -reach_m, -radius_m - 0.008}, {reach_m, reach_m, radius_m + 0.008}, 0.004,
      [=](const Vec3& p) {
        const double at = std::clamp(std::atan2(p.y, p.x), -0.5 * turn_rad, 0.5 * turn_rad);
        return norm(p - Vec3{bend_m * std::cos(at), bend_m * std::sin(at), 0}) - radius_m;
      });
}

TEST(OrganJudgement, WarnsOfAnArchThatBendsMoreSharplyThanItIsWide) {
  // A banana, as a stomach is: two and a half radii of bend.
  EXPECT_FALSE(warnedBy(judgementOf(archOf(0.02, 0.05, kPi)), "M22"));
  // Just over its own radius: the inside has nowhere to go. Its patterns say whether that breaks it.
  EXPECT_TRUE(warnedBy(judgementOf(archOf(0.02, 0.022, kPi)), "M22"));
}

TEST(OrganJudgement, RefusesAHookedTool) {
  EXPECT_TRUE(refused(judgementOf(testing::hookedToolShape())));
}

TEST(OrganJudgement, RefusesALiverAndWarnsOfAKidney) {
  const OrganJudgement liver = judgementOf(testing::liverShape());
  const OrganJudgement kidney = judgementOf(testing::kidneyShape());

  EXPECT_TRUE(refusedBy(liver, "M20")) << liver.measures.elongation;
  EXPECT_TRUE(warnedBy(kidney, "M22")) << kidney.measures.overlap;
}

TEST(OrganJudgement, FindsNothingAboutAGentlyBentTube) {
  const OrganJudgement tube = judgementOf(testing::tubeShape());

  EXPECT_TRUE(tube.findings.empty());
  EXPECT_GT(tube.measures.elongation, 3.5);
}

/// What a PLY file keeps of a mesh: single precision, in millimetres.
TriangleMesh asInFile(TriangleMesh mesh) {
  for (Vec3& v : mesh.vertices_m) {
    for (double* x : {&v.x, &v.y, &v.z}) {
      *x = static_cast<double>(static_cast<float>(1000.0 * *x)) / 1000.0;
    }
  }
  return mesh;
}

/// The tube with each end as a fan about its middle.
TriangleMesh withFans(TriangleMesh tube) {
  const SurfaceTopology topology(tube);
  std::vector<std::uint8_t> end(tube.triangles.size(), 0);
  for (const FlatFace& face : findFlatFaces(tube, topology)) {
    for (const std::uint32_t t : face.triangles) {
      end[t] = 1;
    }
  }
  std::vector<TriangleMesh::Triangle> side;
  for (std::size_t t = 0; t < end.size(); ++t) {
    if (end[t] == 0) {
      side.push_back(tube.triangles[t]);
    }
  }
  tube.triangles = side;
  EXPECT_EQ(closeHoles(tube).count, 2U);
  return tube;
}

TEST(OrganJudgement, FindsTheEndsOfATubeInAnyMeshing) {
  for (const auto& [points, rings] : {std::pair{60, 100}, {100, 200}, {200, 240}}) {
    const OrganJudgement tube =
        judgementOf(asInFile(withFans(testing::bentTube(0.03, 0.09, 2.2, points, rings))));

    EXPECT_TRUE(tube.findings.empty()) << points << " points";
    EXPECT_NEAR(tube.measures.length_m, 0.198, 0.00198) << points << " points";
  }
}

TEST(OrganJudgement, JudgesAShapeAlikeAtAnyResolution) {
  constexpr double kBend_m = 0.09;
  constexpr double kTurn = 2.2;
  for (const auto& [points, rings] : {std::pair{60, 100}, {250, 400}, {400, 500}}) {
    const OrganJudgement tube = judgementOf(asInFile(testing::bentTube(0.03, kBend_m, kTurn, points, rings)));

    EXPECT_TRUE(tube.findings.empty()) << points << " points";
    EXPECT_NEAR(tube.measures.length_m, kBend_m * kTurn, 0.01 * kBend_m * kTurn) << points << " points";
  }
}

TEST(OrganJudgement, FindsNothingAboutTheShippedOrgansThatTwistAsAWhole) {
  for (const char* id : {"stomach", "intestine"}) {
    const SceneDescription scene = readSceneFile(kJudgedAssets, id);
    const TriangleMesh mesh = importMesh(scene.organ);

    // As the scene cuts it, and as a mesh of which nothing is known.
    for (const LatticeOptions& options : {scene.lattice, latticeFor({})}) {
      const OrganJudgement organ = judgeOrgan(mesh, options);

      EXPECT_TRUE(organ.findings.empty()) << id;
    }
  }
}

TEST(OrganJudgement, RefusesNoShippedOrganAsItsSceneTakesIt) {
  for (const std::string& id : sceneIds(kJudgedAssets)) {
    const SceneDescription scene = readSceneFile(kJudgedAssets, id);

    const OrganJudgement organ =
        judgeOrgan(importMesh(scene.organ), scene.lattice, wrungShare(kJudgedAssets, id));

    EXPECT_EQ(organ.measures.crossingsAtRest, 0U) << id;
    for (const OrganFinding& one : organ.findings) {
      EXPECT_NE(one.weight, FindingWeight::kRefusal) << id << ": " << one.code << ' ' << one.what.str();
    }
  }
}

TEST(OrganJudgement, LetsAHandBeyondACutFollow) {
  const SceneDescription forearm = readSceneFile(kJudgedAssets, "forearm");
  const TriangleMesh mesh = importMesh(forearm.organ);
  OrganEnds ends;
  ends.fixedEnd_m = forearm.lattice.fixedEnd_m;
  ends.freeEnd_m = forearm.lattice.freeEnd_m;
  ends.freeCut = forearm.lattice.freeCut;

  const OrganJudgement cut = judgeOrgan(mesh, latticeFor(ends));

  EXPECT_FALSE(refused(cut));
  EXPECT_LT(cut.measures.beyond, 0.1);
}

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

/// A bar with a neck of `share` of its radius at half its length.
TriangleMesh necked(double share) {
  return testing::sweep(testing::circleOutline(0.03, 48), 80, [share](double t) {
    const double away = std::min(1.0, std::abs(t - 0.5) / 0.2);
    return testing::SweepFrame{{0, 0, 0.25 * t}, {1, 0, 0}, {0, 1, 0}, share + (1.0 - share) * away};
  });
}

TEST(OrganRules, M25WarnsOfANeck) {
  EXPECT_EQ(foundIn(importOfMesh(necked(0.5)), "M25"), nullptr);
  const OrganImport warned = importOfMesh(necked(0.29));
  EXPECT_EQ(weightOf(warned, "M25"), FindingWeight::kWarning);
}

}  // namespace
}  // namespace torsio
