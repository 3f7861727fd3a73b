// SPDX-License-Identifier: GPL-3.0-or-later
// A user's mesh on its way to an organ: read apart, repaired, judged, kept, and what becomes of its warnings.
#include "sim/scene/organ_import.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/scene.h"
#include "tests/support/organ_like_shapes.h"
#include "tests/support/other_program.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::filesystem::path kOwnAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

std::filesystem::path ownFile(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("own-" + name);
}

OrganImportRequest importOf(const TriangleMesh& mesh, const std::string& name) {
  OrganImportRequest request;
  request.assets = kOwnAssets;
  request.file = ownFile(name);
  writePly(request.file, mesh);
  return request;
}

TriangleMesh bar() {
  return testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
}

const OrganFinding* found(const OrganImport& import, const std::string& code) {
  const auto at = std::find_if(import.findings.begin(), import.findings.end(),
                               [&code](const OrganFinding& one) { return one.code == code; });
  return at == import.findings.end() ? nullptr : &*at;
}

Error refusalOfFile(const std::filesystem::path& file) {
  return testing::refusal([&] { return readOrganFile(file); });
}

/// Another program in the place of the one that reads meshes.
struct OtherReader : testing::OtherProgram {
  explicit OtherReader(const std::string& script)
      : OtherProgram("TORSIO_MESH_PROGRAM", ownFile("reader.sh"), script) {}
};

TEST(OrganFileName, CapitalsCountAsSmallLetters) {
  EXPECT_TRUE(isOrganFile("mine.organ"));
  EXPECT_TRUE(isOrganFile("MINE.ORGAN"));
  EXPECT_FALSE(isOrganFile("organ"));
  EXPECT_FALSE(isOrganFile("mine.organ.ply"));
}

TEST(OrganImport, AcceptsAGoodMeshAsItIs) {
  const OrganImport import = importOrgan(importOf(bar(), "bar.ply"));

  EXPECT_TRUE(import.accepted);
  EXPECT_TRUE(import.findings.empty());
  EXPECT_FALSE(import.repairs.any());
  EXPECT_NEAR(import.volume_ml.value(), 1e6 * testing::areaOf(testing::circleOutline(0.03, 36)) * 0.2, 0.1);
  ASSERT_EQ(import.patterns.size(), 2U);
  for (const PatternJudgement& pattern : import.patterns) {
    EXPECT_TRUE(pattern.accepted) << pattern.id;
    EXPECT_NEAR(pattern.leastDeterminant, 1.0, 1e-6) << pattern.id;
    EXPECT_NEAR(pattern.volumeRatio, 1.0, 0.005) << pattern.id;
    EXPECT_EQ(pattern.crossings, 0U) << pattern.id;
  }
  EXPECT_THAT(import.organ.patterns, ElementsAre("own-axis", "own-axis-back"));
  EXPECT_EQ(import.organ.source, "own-bar.ply");
  // The other process reads the same bits as this one.
  EXPECT_EQ(contentHash(import.organ.mesh), contentHash(importMesh(ownFile("bar.ply"))));
}

TEST(OrganImport, ReportsWhatItMends) {
  TriangleMesh mesh = bar();
  for (TriangleMesh::Triangle& t : mesh.triangles) {
    std::swap(t[1], t[2]);
  }
  mesh = testing::together(mesh, testing::prism(testing::circleOutline(0.02, 36), 0.15, 12), {0, 0, 0.02});

  const OrganImport import = importOrgan(importOf(mesh, "mended.ply"));

  EXPECT_TRUE(import.accepted);
  EXPECT_THAT(import.repairs.lines(), ElementsAre("turned inside out", "1 inner shell dropped"));
  ASSERT_NE(found(import, "M13"), nullptr);
  EXPECT_EQ(found(import, "M13")->weight, FindingWeight::kNote);
  ASSERT_NE(found(import, "M15"), nullptr);
  EXPECT_EQ(found(import, "M15")->weight, FindingWeight::kWarning);
  ASSERT_EQ(import.organ.warnings.size(), 1U);
  EXPECT_EQ(import.organ.warnings[0].code, "M15");
}

TEST(OrganImport, RefusesWithCodePlaceAndRemedy) {
  TriangleMesh open = bar();
  open.triangles.resize(open.triangles.size() - 3);
  const OrganImport holed = importOrgan(importOf(open, "open.ply"));
  EXPECT_FALSE(holed.accepted);
  ASSERT_NE(found(holed, "M11"), nullptr);
  EXPECT_THAT(found(holed, "M11")->what.str(), HasSubstr("first at ("));
  EXPECT_FALSE(found(holed, "M11")->remedy.empty());
  EXPECT_TRUE(holed.patterns.empty());

  const OrganImport ball = importOrgan(importOf(testing::ballShape(), "ball.ply"));
  EXPECT_FALSE(ball.accepted);
  ASSERT_NE(found(ball, "M20"), nullptr);
  EXPECT_LT(found(ball, "M20")->value.value(), 1.0);
  EXPECT_TRUE(ball.organ.patterns.empty());

  OrganImportRequest metres = importOf(bar(), "metres.ply");
  metres.scale_m = 1.0;
  const OrganImport large = importOrgan(metres);
  EXPECT_FALSE(large.accepted);
  ASSERT_NE(found(large, "M09"), nullptr);
  EXPECT_THAT(found(large, "M09")->what.str(), HasSubstr("millimetres"));
}

TEST(OrganImport, ClosesHolesWhenAskedAndSaysSo) {
  TriangleMesh open = bar();
  const double whole_ml = 1e6 * signedVolume_m3(open);
  // Both flat ends, and one triangle of the side.
  std::erase_if(open.triangles, [&open](const TriangleMesh::Triangle& t) {
    const auto at = [&](std::size_t k, double z_m) { return std::abs(open.vertices_m[t[k]].z - z_m) < 1e-9; };
    return (at(0, 0.0) && at(1, 0.0) && at(2, 0.0)) || (at(0, 0.2) && at(1, 0.2) && at(2, 0.2));
  });
  open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(open.triangles.size() / 2));
  OrganImportRequest request = importOf(open, "holes.ply");
  EXPECT_FALSE(importOrgan(request).accepted);
  request.closeHoles = true;

  const OrganImport import = importOrgan(request);

  EXPECT_TRUE(import.accepted);
  ASSERT_NE(found(import, "M11"), nullptr);
  EXPECT_EQ(found(import, "M11")->value, 3.0);
  EXPECT_EQ(found(import, "M11")->weight, FindingWeight::kWarning);
  EXPECT_NEAR(import.volume_ml.value(), whole_ml, 0.01 * whole_ml);
}

// As in a mesh that lost triangles here and there.
TEST(OrganImport, ClosesHolesThatMeetInAVertex) {
  TriangleMesh open = bar();
  const TriangleMesh::Triangle first = open.triangles[open.triangles.size() / 2];
  const auto shared = [&first](const TriangleMesh::Triangle& t) {
    return std::count_if(t.begin(), t.end(), [&first](std::uint32_t v) {
      return std::find(first.begin(), first.end(), v) != first.end();
    });
  };
  const auto second = std::find_if(open.triangles.begin(), open.triangles.end(),
                                   [&](const TriangleMesh::Triangle& t) { return shared(t) == 1; });
  ASSERT_NE(second, open.triangles.end());
  open.triangles.erase(second);
  open.triangles.erase(std::find(open.triangles.begin(), open.triangles.end(), first));
  OrganImportRequest request = importOf(open, "meeting.ply");
  const OrganImport refused = importOrgan(request);
  ASSERT_NE(found(refused, "M11"), nullptr);
  EXPECT_THAT(found(refused, "M11")->remedy.str(), HasSubstr("--close-holes"));
  request.closeHoles = true;

  const OrganImport import = importOrgan(request);

  EXPECT_TRUE(import.accepted);
  ASSERT_NE(found(import, "M11"), nullptr);
  EXPECT_EQ(found(import, "M11")->value, 2.0);
}

// As exporters leave it that lost track of a face's side where the surface breaks off.
TEST(OrganImport, ClosesAHoleWithATurnedFaceAtItsRim) {
  TriangleMesh open = bar();
  const TriangleMesh::Triangle lost = open.triangles[open.triangles.size() / 2];
  open.triangles.erase(open.triangles.begin() + static_cast<std::ptrdiff_t>(open.triangles.size() / 2));
  const auto beside = std::find_if(open.triangles.begin(), open.triangles.end(), [&lost](const auto& t) {
    return std::count_if(t.begin(), t.end(), [&lost](std::uint32_t v) {
             return std::find(lost.begin(), lost.end(), v) != lost.end();
           }) == 2;
  });
  ASSERT_NE(beside, open.triangles.end());
  std::swap((*beside)[0], (*beside)[1]);
  OrganImportRequest request = importOf(open, "turned_rim.ply");
  request.closeHoles = true;

  const OrganImport import = importOrgan(request);

  EXPECT_TRUE(import.accepted);
  ASSERT_NE(found(import, "M11"), nullptr);
  EXPECT_EQ(found(import, "M11")->value, 1.0);
  EXPECT_EQ(import.repairs.turnedFaces, 1U);
  EXPECT_FALSE(import.repairs.insideOut);
}

TEST(OrganImport, ComparesTheVolumeWithThatOfItsAnatomy) {
  OrganImportRequest request =
      importOf(testing::prism(testing::circleOutline(0.008, 36), 0.1, 24), "thin.ply");
  EXPECT_TRUE(importOrgan(request).accepted);
  request.anatomy = "stomach";

  const OrganImport import = importOrgan(request);

  EXPECT_FALSE(import.accepted);
  ASSERT_NE(found(import, "M09"), nullptr);
  EXPECT_NEAR(found(import, "M09")->value.value(), 20.0, 0.3);
}

TEST(OrganImport, RefusesAnInvalidRequest) {
  OrganImportRequest request = importOf(bar(), "request.ply");
  const auto codeOf = [](const OrganImportRequest& one) {
    return testing::refusalCode([&] { return importOrgan(one); });
  };
  OrganImportRequest wrong = request;
  wrong.file = "/nowhere/organ.ply";
  EXPECT_EQ(codeOf(wrong), ErrorCode::kFileMissing);
  wrong = request;
  wrong.anatomy = "liver";
  EXPECT_EQ(codeOf(wrong), ErrorCode::kBadParameter);
  wrong = request;
  wrong.wall_m = 0.2;
  EXPECT_EQ(codeOf(wrong), ErrorCode::kBadParameter);
  wrong = request;
  wrong.ends.freeEnd_m = Vec3{0, 0, 0.2};
  EXPECT_EQ(codeOf(wrong), ErrorCode::kUsage);
}

TEST(OrganImport, SurvivesACrashOfTheImporter) {
  const OrganImportRequest request = importOf(bar(), "fatal.ply");
  {
    const OtherReader crashing("kill -SEGV $$");
    const OrganImport import = importOrgan(request);
    EXPECT_FALSE(import.accepted);
    ASSERT_NE(found(import, "M05"), nullptr);
    EXPECT_THAT(found(import, "M05")->what.str(), HasSubstr("crashed"));
  }
  {
    const OtherReader hanging("exec sleep 600");
    OrganImportRequest impatient = request;
    impatient.reading.wall_s = 1;
    const OrganImport import = importOrgan(impatient);
    ASSERT_NE(found(import, "M05"), nullptr);
    EXPECT_THAT(found(import, "M05")->what.str(), HasSubstr("within 1 s"));
  }
  {
    const OtherReader talking("head -c 100 /dev/zero >&3");
    const OrganImport import = importOrgan(request);
    ASSERT_NE(found(import, "M05"), nullptr);
    EXPECT_THAT(found(import, "M05")->what.str(), HasSubstr("no answer"));
  }
}

TEST(OrganImport, KeepsToItsMemoryLimit) {
  OrganImportRequest request =
      importOf(testing::prism(testing::circleOutline(0.03, 400), 0.2, 300), "large.ply");
  request.reading.memory_MB = 10;

  const OrganImport import = importOrgan(request);

  EXPECT_FALSE(import.accepted);
  EXPECT_NE(found(import, "M05"), nullptr);
}

TEST(OrganFile, IsReadAsItWasWritten) {
  OrganFile organ;
  organ.mesh = bar();
  organ.ends = {Vec3{0, 0, 0}, Vec3{0, 0, 0.2}, {}, {0, 0, 1}};
  organ.ends.capRadius_m = 0.006;
  organ.ends.straight = true;
  organ.ends.branchRoot_m = {0.03, 0, 0.1};
  organ.ends.branchCut = {1, 0, 0};
  organ.anatomy = "stomach";
  organ.wall_m = 0.003;
  organ.source = "bar.ply";
  organ.patterns = {"partial", "combined"};
  organ.warnings = {{"M23", Text::tr("the organ file is cut short")}};
  writeOrganFile(ownFile("bar.organ"), organ);

  const OrganFile read = readOrganFile(ownFile("bar.organ"));

  EXPECT_EQ(contentHash(read.mesh), contentHash(organ.mesh));
  EXPECT_EQ(read.ends.freeEnd_m, organ.ends.freeEnd_m);
  EXPECT_EQ(read.ends.freeCut, organ.ends.freeCut);
  EXPECT_EQ(read.ends.capRadius_m, 0.006);
  EXPECT_TRUE(read.ends.straight);
  EXPECT_EQ(read.ends.branchRoot_m, organ.ends.branchRoot_m);
  EXPECT_EQ(read.ends.branchCut, organ.ends.branchCut);
  EXPECT_EQ(read.anatomy, "stomach");
  EXPECT_EQ(read.wall_m, 0.003);
  EXPECT_EQ(read.source, "bar.ply");
  EXPECT_EQ(read.patterns, organ.patterns);
  EXPECT_EQ(read.warnings, organ.warnings);
}

TEST(OrganFile, ReportsDamageChangesAndOtherFiles) {
  OrganFile organ;
  organ.mesh = bar();
  const std::filesystem::path file = ownFile("damaged.organ");
  writeOrganFile(file, organ);
  const std::string whole = readFile(file);
  for (const std::size_t at : {std::size_t{20}, whole.size() / 2, whole.size() - 100, whole.size() - 1}) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    writeFileAtomically(file, changed);
    EXPECT_EQ(refusalOfFile(file).code(), ErrorCode::kFileUnreadable) << at;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, std::size_t{200}, whole.size() - 1}) {
    writeFileAtomically(file, whole.substr(0, size));
    EXPECT_EQ(refusalOfFile(file).code(), ErrorCode::kFileUnreadable) << size;
  }
  std::string later = whole;
  later[13] = '7';
  writeFileAtomically(file, later);
  EXPECT_THAT(refusalOfFile(file).what(), HasSubstr("later version"));
}

TEST(UsersOrganOffers, OnlyTwistsAboutItsOwnAxisWhereNothingIsKnownOfIt) {
  SceneRequest request{.assets = kOwnAssets, .organFile = importOf(bar(), "patterns.ply").file};

  const Scene scene = loadScene(request);

  EXPECT_EQ(scene.id, kOwnOrganScene);
  EXPECT_EQ(scene.pattern.id, "own-axis");
  ASSERT_EQ(scene.patterns.size(), 2U);
  EXPECT_EQ(scene.patterns[1].id, "own-axis-back");
  EXPECT_TRUE(scene.organWarnings.empty());
}

TEST(UsersOrganOffers, ThePatternsOfItsAnatomyAndNoOthers) {
  OrganImportRequest known = importOf(testing::jTube(0.02, 0.12, 0.05, 36, 60), "anatomy.ply");
  known.anatomy = "stomach";
  known.wall_m = 0.003;
  const OrganImport import = importOrgan(known);
  ASSERT_TRUE(import.accepted);
  SceneRequest request{.assets = kOwnAssets, .organFile = ownFile("anatomy.organ")};
  writeOrganFile(*request.organFile, import.organ);

  const Scene scene = loadScene(request);

  EXPECT_EQ(scene.id, "stomach");
  EXPECT_EQ(scene.pattern.id, "organo-axial");
  EXPECT_EQ(scene.wall_m, 0.003);
  request.pattern = "pronation";
  const Error error = testing::refusal([&] { return loadScene(request); });
  EXPECT_EQ(error.code(), ErrorCode::kBadParameter);
  EXPECT_THAT(error.remedy(), HasSubstr("organo-axial, mesentero-axial"));
}

TEST(UsersOrganOffers, NothingWhereTheMeshIsRefused) {
  SceneRequest request{.assets = kOwnAssets, .organFile = importOf(testing::ballShape(), "refused.ply").file};
  const Error error = testing::refusal([&] { return loadScene(request); });
  EXPECT_EQ(error.code(), ErrorCode::kBadMesh);
  EXPECT_THAT(error.what(), HasSubstr("M20"));
}

TEST(UsersOrganWarnings, StayWithTheRecording) {
  SceneRequest request{
      .assets = kOwnAssets,
      .organFile = importOf(testing::prism(testing::circleOutline(0.05, 48), 0.2, 24), "short.ply").file};
  const Scene scene = loadScene(request);
  ASSERT_EQ(scene.organWarnings.size(), 1U);
  EXPECT_EQ(scene.organWarnings[0].code, "M20");

  EXPECT_EQ(recordedOrganWarnings(scene.parametersJson), scene.organWarnings);
  SceneRequest again = sceneRequestFor(scene.parametersJson);
  again.assets = kOwnAssets;
  again.organFile = request.organFile;
  const Scene rebuilt = loadScene(again);
  EXPECT_EQ(rebuilt.parameterHash, scene.parameterHash);
  EXPECT_EQ(rebuilt.organWarnings, scene.organWarnings);
}

TEST(UsersOrganWarnings, AreNotAskedForWhereARecordingHadNone) {
  // Recorded before organs were judged: the ball is taken as it was.
  SceneRequest request{
      .assets = kOwnAssets,
      .organFile = importOf(testing::prism(testing::circleOutline(0.05, 48), 0.2, 24), "older.ply").file,
      .pattern = "pronation",
      .asRecorded = true};

  const Scene scene = loadScene(request);

  EXPECT_EQ(scene.id, "forearm");
  EXPECT_TRUE(scene.organWarnings.empty());
  EXPECT_EQ(scene.parametersJson.find("organ_warnings"), std::string::npos);
}

}  // namespace
}  // namespace torsio
