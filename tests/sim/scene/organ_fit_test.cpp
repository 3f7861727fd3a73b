// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_fit.h"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "sim/anatomy/forearm.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/scene_file.h"
#include "tests/support/organ_like_shapes.h"

namespace torsio {
namespace {

const std::filesystem::path kFitAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

std::string saidOf(const FittedOrgan& organ) {
  std::string said;
  for (const OrganFinding& one : organ.judgement.findings) {
    said += (one.weight == FindingWeight::kRefusal ? "refusal " : "told ") + one.code + ' ' + one.what.str() +
            '\n';
  }
  return said;
}

bool isRefused(const FittedOrgan& organ, const std::string& code = "") {
  return std::any_of(organ.judgement.findings.begin(), organ.judgement.findings.end(),
                     [&code](const OrganFinding& one) {
                       return one.weight == FindingWeight::kRefusal && (code.empty() || one.code == code);
                     });
}

OrganEnds endsOf(const SceneDescription& scene) {
  OrganEnds ends;
  ends.fixedEnd_m = scene.lattice.fixedEnd_m;
  ends.freeEnd_m = scene.lattice.freeEnd_m;
  return ends;
}

TEST(OrganFit, JudgesAMidgutOnItsStalk) {
  const SceneDescription scene = readSceneFile(kFitAssets, "midgut");
  const TriangleMesh mesh = importMesh(scene.organ);

  // With its ends named, and as a mesh of which nothing is known but what it is.
  for (const OrganEnds& ends : {endsOf(scene), OrganEnds{}}) {
    const FittedOrgan organ = fitOrgan(mesh, ends, kFitAssets, "midgut");

    EXPECT_FALSE(isRefused(organ)) << saidOf(organ);
    EXPECT_GT(organ.judgement.measures.elongation, 2.2) << saidOf(organ);
    EXPECT_LT(organ.judgement.measures.stalkWidth, 0.4);
    EXPECT_GT(organ.judgement.measures.leastDeterminant60, 0.2);
    EXPECT_EQ(organ.judgement.measures.crossings60, 0U);
    // The root of the stalk is held, behind the pack.
    EXPECT_GT(organ.ends.fixedEnd_m.value().y, 0.05);
  }
}

TEST(OrganFit, RefusesAsMidgutWhatHangsOnNoStalk) {
  for (const TriangleMesh& mesh : {testing::ballShape(), testing::kidneyShape(), testing::tubeShape()}) {
    const FittedOrgan organ = fitOrgan(requireOrgan(mesh, "shape"), {}, kFitAssets, "midgut");

    EXPECT_TRUE(isRefused(organ, "M20")) << saidOf(organ);
  }
}

TEST(OrganFit, TakesAStomachNamedAtPylorusAndFundusWithoutItsOesophagus) {
  const SceneDescription scene = readSceneFile(kFitAssets, "stomach");
  const TriangleMesh mesh = importMesh(scene.organ);
  OrganEnds cut = endsOf(scene);
  cut.fixedCut = scene.lattice.fixedCut;
  for (const OrganEnds& ends : {cut, endsOf(scene)}) {
    const FittedOrgan organ = fitOrgan(mesh, ends, kFitAssets, "stomach");

    EXPECT_FALSE(isRefused(organ)) << saidOf(organ);
    // Where the scene cuts it off, within a radius of the oesophagus.
    EXPECT_LT(norm(organ.ends.branchRoot_m - scene.lattice.branchRoot_m), 0.01);
    EXPECT_GT(dot(organ.ends.branchCut, normalized(scene.lattice.branchCut)), 0.9);
    EXPECT_TRUE(std::any_of(
        organ.judgement.findings.begin(), organ.judgement.findings.end(),
        [](const OrganFinding& one) { return one.code == "M20" && one.weight == FindingWeight::kWarning; }))
        << saidOf(organ);
    EXPECT_GT(organ.judgement.measures.leastDeterminant60, 0.2);
    // Uncut at the pylorus a few at the bulb are left, of which M24 warns.
    EXPECT_LT(organ.judgement.measures.crossings60, ends.fixedCut == Vec3{} ? 10U : 1U) << saidOf(organ);
  }
}

TEST(OrganFit, TakesPlanesWhereTheAxisBendsTowardsAJaggedCut) {
  const Arm arm = makeArm({}, 0.43);  // a hundred thousand triangles
  OrganEnds ends;
  ends.fixedEnd_m = arm.fixedEnd_m;
  ends.freeEnd_m = arm.wrist_m;
  ends.freeCut = {0, 0, 1};

  const FittedOrgan organ = fitOrgan(requireOrgan(arm.surface, "arm"), ends, kFitAssets, "forearm");

  EXPECT_TRUE(organ.judgement.findings.empty()) << saidOf(organ);
  EXPECT_TRUE(organ.ends.straight);
  EXPECT_GT(organ.judgement.measures.leastDeterminant60, 0.9);  // 0.13 on the axis that is found
  EXPECT_EQ(organ.judgement.measures.crossings60, 0U);
}

}  // namespace
}  // namespace torsio
