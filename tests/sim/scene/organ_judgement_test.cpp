// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_judgement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/flat_faces.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_holes.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/surface_topology.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/scene_file.h"
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

bool refused(const OrganJudgement& judgement) {
  return std::any_of(judgement.findings.begin(), judgement.findings.end(),
                     [](const OrganFinding& one) { return one.weight == FindingWeight::kRefusal; });
}

TEST(OrganJudgement, RefusesABallBecauseItHasNoLength) {
  const OrganJudgement ball = judgementOf(testing::ballShape());

  EXPECT_TRUE(refusedBy(ball, "M20"));
  EXPECT_LT(ball.measures.elongation, 1.0);
  EXPECT_TRUE(refusedBy(ball, "M23")) << ball.measures.leastDeterminant60;
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

TEST(OrganJudgement, RefusesConesThatAreShortOrEndInATip) {
  EXPECT_TRUE(refusedBy(judgementOf(coneOf(0.02, 0.01, 0.0790)), "M20"));  // 1.98 widths
  EXPECT_FALSE(refused(judgementOf(coneOf(0.02, 0.01, 0.0830))));          // 2.08: a warning
  EXPECT_FALSE(judgementOf(coneOf(0.02, 0.01, 0.0830)).findings.empty());
  EXPECT_TRUE(judgementOf(coneOf(0.02, 0.01, 0.12)).findings.empty());    // a forearm tapers as much
  EXPECT_TRUE(refusedBy(judgementOf(coneOf(0.02, 0.0002, 0.2)), "M25"));  // all twist at its tip
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

TEST(OrganJudgement, AcceptsAnArchThatBendsNoMoreSharplyThanItIsWide) {
  // A banana, as a stomach is: two and a half radii of bend.
  EXPECT_FALSE(refused(judgementOf(archOf(0.02, 0.05, kPi))));
  // Just over its own radius: the inside has nowhere to go.
  EXPECT_TRUE(refused(judgementOf(archOf(0.02, 0.022, kPi))));
}

TEST(OrganJudgement, RefusesAHookedTool) {
  EXPECT_TRUE(refused(judgementOf(testing::hookedToolShape())));
}

TEST(OrganJudgement, RefusesSolidOrgansThatNobodyTwists) {
  const OrganJudgement liver = judgementOf(testing::liverShape());
  const OrganJudgement kidney = judgementOf(testing::kidneyShape());

  EXPECT_TRUE(refusedBy(liver, "M20")) << liver.measures.elongation;
  EXPECT_TRUE(refusedBy(kidney, "M22")) << kidney.measures.overlap;
}

TEST(OrganJudgement, FindsNothingAboutAGentlyBentTube) {
  const OrganJudgement tube = judgementOf(testing::tubeShape());

  EXPECT_TRUE(tube.findings.empty());
  EXPECT_GT(tube.measures.elongation, 3.5);
  EXPECT_GT(tube.measures.leastDeterminant60, 0.3);
  EXPECT_LT(tube.measures.leastDeterminant60, 1.0);
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
  double usual = 0.0;
  for (const auto& [points, rings] : {std::pair{60, 100}, {250, 400}, {400, 500}}) {
    const OrganJudgement tube = judgementOf(asInFile(testing::bentTube(0.03, kBend_m, kTurn, points, rings)));

    EXPECT_TRUE(tube.findings.empty()) << points << " points";
    EXPECT_NEAR(tube.measures.length_m, kBend_m * kTurn, 0.01 * kBend_m * kTurn) << points << " points";
    usual = usual == 0.0 ? tube.measures.leastDeterminant60 : usual;
    EXPECT_NEAR(tube.measures.leastDeterminant60, usual, 0.05) << points << " points";
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
      EXPECT_GT(organ.measures.leastDeterminant60, 0.35) << id;
      EXPECT_EQ(organ.measures.crossings60, 0U) << id;
    }
  }
}

TEST(OrganJudgement, RefusesNoShippedOrganAsItsSceneTakesIt) {
  for (const std::string& id : sceneIds(kJudgedAssets)) {
    const SceneDescription scene = readSceneFile(kJudgedAssets, id);

    OrganJudgement organ = judgeOrgan(importMesh(scene.organ), scene.lattice, wrungShare(kJudgedAssets, id));
    if (!twistsAsAWhole(kJudgedAssets, id)) {
      allowPartialTwist(organ);
    }

    EXPECT_EQ(organ.measures.crossingsAtRest, 0U) << id;
    for (const OrganFinding& one : organ.findings) {
      EXPECT_NE(one.weight, FindingWeight::kRefusal) << id << ": " << one.code << ' ' << one.what.str();
    }
    RecordProperty(id, std::to_string(organ.measures.leastDeterminant60));
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

TEST(OrganJudgement, OnlyWarnsOfALoopThatIsNotTwistedAsAWhole) {
  EXPECT_TRUE(twistsAsAWhole(kJudgedAssets, ""));
  EXPECT_TRUE(twistsAsAWhole(kJudgedAssets, "stomach"));
  EXPECT_FALSE(twistsAsAWhole(kJudgedAssets, "sigmoid"));
  OrganJudgement loop;
  loop.measures.length_m = 0.6;
  loop.findings = {{"M20", FindingWeight::kRefusal, std::string("short"), "", 1.0, ""},
                   {"M23", FindingWeight::kRefusal, std::string("folds"), "", -0.1, ""}};

  allowPartialTwist(loop);

  EXPECT_EQ(loop.findings[0].weight, FindingWeight::kRefusal);
  EXPECT_EQ(loop.findings[1].weight, FindingWeight::kWarning);
}

}  // namespace
}  // namespace torsio
