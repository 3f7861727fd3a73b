// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/pattern_judgement.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/organ_fit.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/rod_organ.h"
#include "tests/support/organ_like_shapes.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::filesystem::path kPatternAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

OrganFile drawnOrgan(const TriangleMesh& mesh, const std::string& anatomy = "") {
  OrganFile organ;
  organ.mesh = requireOrgan(mesh, "drawn");
  organ.anatomy = anatomy;
  return organ;
}

const OrganFinding* refusalOf(const FittedOrgan& fitted) {
  const auto at = std::find_if(fitted.judgement.findings.begin(), fitted.judgement.findings.end(),
                               [](const OrganFinding& one) { return one.weight == FindingWeight::kRefusal; });
  return at == fitted.judgement.findings.end() ? nullptr : &*at;
}

/// A straight tube of 30 mm with a bump of 9.6 ml on one side.
TriangleMesh bumpedTube() {
  return testing::shapes::surfaceOf({-0.03, -0.03, -0.02}, {0.045, 0.03, 0.22}, 0.003, [](const Vec3& p) {
    const double tube = std::max(std::hypot(p.x, p.y) - 0.015, std::abs(p.z - 0.1) - 0.1);
    return testing::shapes::joined(tube, norm(p - Vec3{0.018, 0, 0.1}) - 0.0165, 0.004);
  });
}

/// A tube bent by one and a half of its radii through half a turn, each end a fan about its middle.
TriangleMesh fannedArch() {
  constexpr std::uint32_t kPoints = 40;
  constexpr std::uint32_t kRings = 60;
  constexpr double kBend_m = 0.03;
  TriangleMesh arch = testing::bentTube(0.02, kBend_m, kPi, kPoints, kRings);
  std::erase_if(arch.triangles, [](const TriangleMesh::Triangle& t) {
    const auto in = [&t](std::uint32_t ring) {
      return std::all_of(t.begin(), t.end(), [ring](std::uint32_t v) { return v / kPoints == ring; });
    };
    return in(0) || in(kRings);
  });
  arch.vertices_m.push_back({0, 0, 0});
  arch.vertices_m.push_back({2.0 * kBend_m, 0, 0});
  constexpr std::uint32_t kFoot = (kRings + 1) * kPoints;
  for (std::uint32_t i = 0; i < kPoints; ++i) {
    const std::uint32_t next = (i + 1) % kPoints;
    arch.triangles.push_back({kFoot, next, i});
    arch.triangles.push_back({kFoot + 1, kRings * kPoints + i, kRings * kPoints + next});
  }
  return arch;
}

/// A tube bent by one and a half of its radii.
TriangleMesh tightArch() {
  return testing::bentTube(0.03, 0.045, 2.6, 40, 60);
}

TEST(PatternJudgement, AcceptsEveryPatternOfEveryShippedScene) {
  for (const std::string& id : sceneIds(kPatternAssets)) {
    for (const std::string& pattern : patternIds(kPatternAssets, id)) {
      const PatternJudgement judgement = judgePattern(testing::shippedScene(id, pattern));

      EXPECT_TRUE(judgement.accepted) << id << ", " << pattern << ": " << judgement.reason;
      EXPECT_EQ(judgement.wholeShare, 1.0) << id << ", " << pattern;
      EXPECT_FALSE(judgement.brokenAt_rad) << id << ", " << pattern;
    }
  }
}

TEST(PatternJudgement, AcceptsATubeWithABumpOnOneSide) {
  const FittedOrgan fitted = fitOrgan(drawnOrgan(bumpedTube()), kPatternAssets);

  ASSERT_EQ(refusalOf(fitted), nullptr) << refusalOf(fitted)->what;
  EXPECT_THAT(acceptedAmong(fitted.patterns), ElementsAre("own-axis", "own-axis-back"));
  for (const PatternJudgement& pattern : fitted.patterns) {
    EXPECT_NEAR(pattern.leastDeterminant, 1.0, 0.05) << pattern.id;
    EXPECT_EQ(pattern.crossings, 0U) << pattern.id;
  }
}

TEST(PatternJudgement, RefusesAPatternWithItsReasonAndTheAngleAtWhichItBreaks) {
  // Half a turn of its middle leaves the inside of its bend no room.
  const FittedOrgan fitted = fitOrgan(drawnOrgan(tightArch(), "intestine"), kPatternAssets);

  ASSERT_NE(refusalOf(fitted), nullptr);
  EXPECT_THAT(refusalOf(fitted)->what.str(), HasSubstr("no pattern leaves the organ whole; loop"));
  EXPECT_FALSE(refusalOf(fitted)->remedy.empty());
  ASSERT_EQ(fitted.patterns.size(), 1U);
  EXPECT_FALSE(fitted.patterns[0].accepted);
  ASSERT_TRUE(fitted.patterns[0].brokenAt_rad);
  EXPECT_GT(*fitted.patterns[0].brokenAt_rad, 0.0);
  EXPECT_LT(*fitted.patterns[0].brokenAt_rad, kPi);
  EXPECT_THAT(refusalOf(fitted)->what.str(), HasSubstr(" degrees"));
}

TEST(PatternJudgement, RefusesWhatTheWallCannotBalance) {
  // A loop's limbs are wrung; those of a short tube are as wide as long.
  OrganFile tube = drawnOrgan(testing::bentTube(0.03, 0.05, 2.5, 40, 60), "sigmoid");

  const FittedOrgan fitted = fitOrgan(tube, kPatternAssets);

  ASSERT_NE(refusalOf(fitted), nullptr);  // its anatomy makes no warning of it
  EXPECT_TRUE(acceptedAmong(fitted.patterns).empty());
}

TEST(PatternJudgement, LeavesOutThePatternsThatBreakAndOffersTheOthersOnly) {
  OrganImportRequest request;
  request.assets = kPatternAssets;
  request.file = std::filesystem::path(::testing::TempDir()) / "some-patterns.ply";
  writePly(request.file, fannedArch());
  request.anatomy = "stomach";

  const OrganImport import = importOrgan(request);

  ASSERT_TRUE(import.accepted);
  ASSERT_EQ(import.patterns.size(), 4U);
  ASSERT_FALSE(import.organ.patterns.empty());
  ASSERT_LT(import.organ.patterns.size(), 4U);
  const auto left = std::find_if(import.patterns.begin(), import.patterns.end(),
                                 [](const PatternJudgement& one) { return !one.accepted; });
  EXPECT_FALSE(left->reason.empty());
  EXPECT_TRUE(std::any_of(import.findings.begin(), import.findings.end(), [&left](const OrganFinding& one) {
    return one.weight == FindingWeight::kNote && one.what.str().find(left->id) != std::string::npos;
  }));

  SceneRequest opened{.assets = kPatternAssets, .organFile = request.file};
  opened.organFile->replace_extension(".organ");
  writeOrganFile(*opened.organFile, import.organ);
  const Scene scene = loadScene(opened);
  std::vector<std::string> offered;
  for (const TwistPattern& pattern : scene.patterns) {
    offered.push_back(pattern.id);
  }
  EXPECT_EQ(offered, import.organ.patterns);
  opened.pattern = left->id;
  const Error refused = testing::refusal([&opened] { return loadScene(opened); });
  EXPECT_EQ(refused.code(), ErrorCode::kBadParameter);
  EXPECT_THAT(refused.remedy(), HasSubstr(import.organ.patterns.front()));
  // As a mesh it is refused with the reason.
  opened.organFile = request.file;
  EXPECT_THAT(testing::refusal([&opened] { return loadScene(opened); }).what(), HasSubstr(left->id));
  opened.tellOnly = true;
  EXPECT_EQ(loadScene(opened).pattern.id, left->id);
}

TEST(PatternJudgement, CutsAcrossTheEndsWhereThatHelpsAndSaysHow) {
  OrganImportRequest request;
  request.assets = kPatternAssets;
  request.file = std::filesystem::path(::testing::TempDir()) / "cut-ends.ply";
  writePly(request.file, fannedArch());
  request.anatomy = "stomach";

  const OrganImport found = importOrgan(request);

  const auto told = std::find_if(found.findings.begin(), found.findings.end(),
                                 [](const OrganFinding& one) { return one.code == "M28"; });
  ASSERT_NE(told, found.findings.end());
  EXPECT_THAT(told->remedy.str(), HasSubstr("torsio organ import '" + request.file.string() +
                                            "' --anatomy stomach --fixed-end "));
  EXPECT_THAT(told->remedy.str(), HasSubstr(" --free-cut "));
  EXPECT_NE(found.organ.ends.fixedCut, Vec3{});
  // Asked for by hand it is the same.
  request.ends = found.organ.ends;
  const OrganImport named = importOrgan(request);
  EXPECT_TRUE(named.accepted);
  EXPECT_EQ(named.organ.patterns, found.organ.patterns);
}

TEST(PatternJudgement, KeepsARecordingFromBeforeOwnOrgansWereRods) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "former-tube.ply";
  writePly(file, testing::bentTube(0.03, 0.12, 1.5, 36, 40));
  const SceneRequest now{.assets = kPatternAssets, .organFile = file};
  const Scene scene = loadScene(now);
  ASSERT_NE(scene.rod, nullptr);
  // What such a recording remembers: no task, no restraints.
  std::string before = scene.parametersJson;
  const std::size_t task = before.find(R"(,"grasp":)");
  ASSERT_NE(task, std::string::npos);
  before = before.substr(0, task) + '}';
  SceneRequest replay = sceneRequestFor(before);
  replay.assets = kPatternAssets;
  replay.organFile = file;

  const Scene former = loadScene(replay);

  EXPECT_TRUE(former.former);
  EXPECT_EQ(former.rod, nullptr);
  EXPECT_EQ(former.parametersJson, before);
}

TEST(PatternJudgement, FindsNoCrossingInAFlatEndThatIsTurnedAsAWhole) {
  const TriangleMesh bar = testing::prism(testing::ellipseOutline(0.03, 0.02, 40), 0.2, 60);
  for (int step = 1; step <= 60; ++step) {
    const TriangleMesh turned = testing::turned(bar, {0, 0, 1}, radians(static_cast<double>(step)));
    EXPECT_TRUE(crossingTriangles(turned).empty()) << step;
  }
}

}  // namespace
}  // namespace torsio
