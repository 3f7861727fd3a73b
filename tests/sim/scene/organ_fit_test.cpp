// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_fit.h"

#include <algorithm>
#include <string>
#include <utility>

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

void expectWhole(const FittedOrgan& organ) {
  ASSERT_FALSE(organ.patterns.empty());
  for (const PatternJudgement& pattern : organ.patterns) {
    EXPECT_TRUE(pattern.accepted) << pattern.id << ": " << pattern.reason;
    EXPECT_GT(pattern.leastDeterminant, 0.2) << pattern.id;
  }
}

OrganFile organOf(TriangleMesh mesh, const OrganEnds& ends, const std::string& anatomy) {
  OrganFile organ;
  organ.mesh = std::move(mesh);
  organ.ends = ends;
  organ.anatomy = anatomy;
  return organ;
}

OrganEnds endsOf(const SceneDescription& scene) {
  OrganEnds ends;
  ends.fixedEnd_m = scene.lattice.fixedEnd_m;
  ends.freeEnd_m = scene.lattice.freeEnd_m;
  return ends;
}

TEST(OrganFit, JudgesAMidgutOnItsStalk) {
  const SceneDescription scene =
      readFormerScenes(kFitAssets, "midgut").front();  // without the limb beside it
  const TriangleMesh mesh = importMesh(scene.organ);

  // With its ends named, and as a mesh of which nothing is known but what it is.
  for (const OrganEnds& ends : {endsOf(scene), OrganEnds{}}) {
    const FittedOrgan organ = fitOrgan(organOf(mesh, ends, "midgut"), kFitAssets);

    EXPECT_FALSE(isRefused(organ)) << saidOf(organ);
    EXPECT_GT(organ.judgement.measures.elongation, 2.2) << saidOf(organ);
    EXPECT_LT(organ.judgement.measures.stalkWidth, 0.4);
    expectWhole(organ);
    // The root of the stalk is held, behind the pack.
    EXPECT_GT(organ.ends.fixedEnd_m.value().y, 0.05);
  }
}

TEST(OrganFit, RefusesAsMidgutWhatHangsOnNoStalk) {
  for (const TriangleMesh& mesh : {testing::ballShape(), testing::kidneyShape(), testing::tubeShape()}) {
    const FittedOrgan organ = fitOrgan(organOf(requireOrgan(mesh, "shape"), {}, "midgut"), kFitAssets);

    EXPECT_TRUE(isRefused(organ, "M20")) << saidOf(organ);
  }
}

TEST(OrganFit, TakesAStomachNamedAtPylorusAndFundusWithoutItsOesophagus) {
  const SceneDescription scene = readSceneFile(kFitAssets, "stomach");
  const TriangleMesh mesh = importMesh(scene.organ);
  OrganEnds cut = endsOf(scene);
  cut.fixedCut = scene.lattice.fixedCut;
  for (const OrganEnds& ends : {cut, endsOf(scene)}) {
    const FittedOrgan organ = fitOrgan(organOf(mesh, ends, "stomach"), kFitAssets);

    EXPECT_FALSE(isRefused(organ)) << saidOf(organ);
    // Where the scene cuts it off, within a radius of the oesophagus.
    EXPECT_LT(norm(organ.ends.branchRoot_m - scene.lattice.branchRoot_m), 0.01);
    EXPECT_GT(dot(organ.ends.branchCut, normalized(scene.lattice.branchCut)), 0.9);
    EXPECT_TRUE(std::any_of(
        organ.judgement.findings.begin(), organ.judgement.findings.end(),
        [](const OrganFinding& one) { return one.code == "M20" && one.weight == FindingWeight::kWarning; }))
        << saidOf(organ);
    expectWhole(organ);
  }
}

TEST(OrganFit, TakesPlanesWhereTheAxisBendsTowardsAJaggedCut) {
  const Arm arm = makeArm({}, 0.43);  // a hundred thousand triangles
  OrganEnds ends;
  ends.fixedEnd_m = arm.fixedEnd_m;
  ends.freeEnd_m = arm.wrist_m;
  ends.freeCut = {0, 0, 1};

  const FittedOrgan organ = fitOrgan(organOf(requireOrgan(arm.surface, "arm"), ends, "forearm"), kFitAssets);

  EXPECT_TRUE(organ.judgement.findings.empty()) << saidOf(organ);
  EXPECT_TRUE(organ.ends.straight);
  expectWhole(organ);
}

}  // namespace
}  // namespace torsio
