// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/scene.h"

#include <cmath>
#include <filesystem>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_parameters.h"
#include "sim/tissue/rod/fold_check.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::filesystem::path kShippedAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

SceneRequest shipped(const std::string& id, const std::string& pattern = "") {
  return {.assets = kShippedAssets, .id = id, .pattern = pattern};
}

/// A request for a mesh of the user's, written to a file first.
SceneRequest usersMesh(const TriangleMesh& mesh, const std::string& name) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / (name + ".obj");
  writeObj(file, mesh);
  return {.assets = kShippedAssets, .organFile = file};
}

Error refusal(const SceneRequest& request) {
  return testing::refusal([&] { return loadScene(request); });
}

TEST(Scene, LoadsEveryShippedSceneWithEveryPattern) {
  for (const std::string& id : sceneIds(kShippedAssets)) {
    for (const std::string& pattern : patternIds(kShippedAssets, id)) {
      const Scene scene = loadScene(shipped(id, pattern));

      EXPECT_EQ(scene.id, id);
      EXPECT_EQ(scene.pattern.id, pattern);
      EXPECT_THAT(scene.provenance, HasSubstr("synthetic"));
      EXPECT_FALSE(scene.title.empty());
      EXPECT_GT(scene.pattern.source.size(), 40U) << "the angles need a source";
      EXPECT_EQ(scene.organHash, contentHash(scene.mesh));
      EXPECT_EQ(scene.model.lattice().vertexCoordinates().size(), scene.mesh.vertices_m.size());
      EXPECT_EQ(scene.patterns.size(), patternIds(kShippedAssets, id).size());
    }
  }
}

TEST(Scene, TwistsEveryPatternToItsTargetWithinItsTorque) {
  for (const std::string& id : sceneIds(kShippedAssets)) {
    for (const std::string& pattern : patternIds(kShippedAssets, id)) {
      const Scene scene = loadScene(shipped(id, pattern));
      if (scene.hollow) {
        continue;  // comes twisted, and its content widens it: hollow_view_test.cpp
      }
      const OrganState target = scene.stateAt(scene.pattern.targetAngle_rad);

      std::vector<Vec3> twisted(scene.mesh.vertices_m.size());
      scene.deform(target, twisted);
      const FoldReport fold = FoldCheck(scene.mesh, scene.lattice()).judge(twisted, [&](const Vec3& rest_m) {
        return scene.toDeformed_m(rest_m, target);
      });

      EXPECT_NEAR(target.twist.graspAngle_rad, scene.pattern.targetAngle_rad, 1e-9) << pattern;
      EXPECT_LT(std::abs(scene.torqueAt_Nm(scene.pattern.targetAngle_rad)), scene.pattern.torqueLimit_Nm)
          << pattern;
      EXPECT_FALSE(fold.folded()) << pattern << ": " << fold.reason().str();
      EXPECT_NEAR(fold.volumeRatio, 1.0, 0.005) << pattern;
      EXPECT_GE(fold.minDeterminant, 0.95) << pattern;
      scene.deform({}, twisted);
      EXPECT_EQ(twisted.front(), scene.mesh.vertices_m.front()) << pattern;
    }
  }
}

TEST(Scene, RecordingsFindTheOrganThatTheyWereMadeOn) {
  SceneRequest before = shipped("stomach", "partial");
  before.former = true;
  const Scene former = loadScene(before);
  const Scene now = loadScene(shipped("stomach", "partial"));
  ASSERT_TRUE(former.former);
  EXPECT_FALSE(now.former);
  // Of the version in which the stomach had no oesophagus.
  EXPECT_EQ(former.organHash, "3e0358cdb25a1ef8a1a63d42fd9a7291e81a9cd9cfd2cd7c5ed75f9a845975f1");
  EXPECT_NE(former.organHash, now.organHash);

  for (const Scene* recorded : {&former, &now}) {
    SceneRequest request = sceneRequestFor(recorded->parametersJson);
    request.assets = kShippedAssets;
    request.id = "stomach";

    const Scene found = loadScene(request);

    EXPECT_EQ(found.organHash, recorded->organHash);
    EXPECT_EQ(found.parameterHash, recorded->parameterHash);
    EXPECT_EQ(found.former, recorded->former);
    EXPECT_EQ(found.id, "stomach");
  }
}

TEST(Scene, RecordingsOfASigmoidKeepTheFoldsThatTheyWereMadeWith) {
  SceneRequest before = shipped("sigmoid", "detorse");
  before.former = true;
  const Scene former = loadScene(before);
  const Scene now = loadScene(shipped("sigmoid", "detorse"));
  EXPECT_FALSE(former.hollow->detorsion().wall.foldsNeedRoom);
  EXPECT_TRUE(now.hollow->detorsion().wall.foldsNeedRoom);

  for (const Scene* recorded : {&former, &now}) {
    SceneRequest request = sceneRequestFor(recorded->parametersJson);
    request.assets = kShippedAssets;
    request.id = "sigmoid";

    const Scene found = loadScene(request);

    EXPECT_EQ(found.parameterHash, recorded->parameterHash);
    EXPECT_EQ(found.hollow->peakTorque_Nm(1000.0), recorded->hollow->peakTorque_Nm(1000.0));
  }
  EXPECT_NE(former.hollow->peakTorque_Nm(1000.0), now.hollow->peakTorque_Nm(1000.0));
}

TEST(Scene, HasAFormerStateOnlyAfterAChange) {
  for (const char* id :
       {"stomach", "gastric-organo-axial", "gastric-mesentero-axial", "intestine", "small-bowel-loop"}) {
    const std::vector<SceneDescription> former = readFormerScenes(kShippedAssets, id);
    ASSERT_FALSE(former.empty()) << id;
    EXPECT_EQ(former.front().id, id);
    EXPECT_NE(former.front().organ, readSceneFile(kShippedAssets, id).organ) << id;
  }
  EXPECT_TRUE(readFormerScenes(kShippedAssets, "forearm").empty());
}

TEST(Scene, HasTheFourGastricPatterns) {
  EXPECT_THAT(patternIds(kShippedAssets, "stomach"),
              ElementsAre("organo-axial", "mesentero-axial", "combined", "partial"));
  const Scene scene = loadScene(shipped("stomach"));

  // 180 degrees make a volvulus; the mesentero-axial one is usually incomplete.
  EXPECT_NEAR(std::abs(scene.patterns[0].targetAngle_rad), kPi, 1e-12);
  EXPECT_LT(std::abs(scene.patterns[1].targetAngle_rad), kPi);
  for (const std::size_t i : {0U, 1U, 2U}) {
    ASSERT_TRUE(scene.patterns[i].task) << scene.patterns[i].id;
    EXPECT_EQ(scene.patterns[i].task->axis, GripAxis::kLine) << scene.patterns[i].id;
    EXPECT_TRUE(scene.patterns[i].task->measured) << scene.patterns[i].id;
  }
  ASSERT_TRUE(scene.patterns[3].task);
  EXPECT_EQ(scene.patterns[3].task->axis, GripAxis::kOwn);
}

TEST(Scene, SwingsTheGreaterCurvatureForwardInAnOrganoAxialTwist) {
  const Scene scene = loadScene(shipped("stomach", "organo-axial"));
  const SectionLattice& lattice = scene.lattice();
  // Ridge 0 is the lesser curvature; half a turn from it lies the greater one.
  const Vec3 greater = lattice.surfacePoint({0.45 * lattice.length_m(), kPi}).position_m;

  const Vec3 half = scene.toDeformed_m(greater, scene.stateAt(0.5 * scene.pattern.targetAngle_rad));
  const Vec3 full = scene.toDeformed_m(greater, scene.stateAt(scene.pattern.targetAngle_rad));

  EXPECT_LT(half.y, greater.y - 0.02);  // y points to the back
  EXPECT_GT(full.z, greater.z + 0.02);
}

TEST(Scene, HoldsTheCardiaOfTheStomachInEveryTask) {
  const Vec3 cardia_m{0.021, 0.018, 0.042};
  for (const std::string& pattern : patternIds(kShippedAssets, "stomach")) {
    const Scene scene = loadScene(shipped("stomach", pattern));

    const Vec3 moved_m = scene.toDeformed_m(cardia_m, scene.stateAt(scene.pattern.targetAngle_rad));

    EXPECT_LT(norm(moved_m - cardia_m), 0.006) << pattern;
  }
}

TEST(Scene, TasksAreDoneWithRestraintsHalfAndTwiceAsStiff) {
  // Nearly all stiffnesses are assumed: what the tasks ask for may not hang on them.
  const std::filesystem::path assets = std::filesystem::path(::testing::TempDir()) / "restraints";
  for (const double factor : {0.5, 2.0}) {
    std::filesystem::remove_all(assets);
    std::filesystem::copy(kShippedAssets, assets, std::filesystem::copy_options::recursive);
    auto json = nlohmann::json::parse(readFile(kShippedAssets / "scenes" / "stomach.json"));
    for (auto& restraint : json["restraints"]) {
      for (const char* name : {"stiffness_n_per_mm", "turn_nmm_per_rad"}) {
        if (restraint.contains(name)) {
          restraint[name] = factor * restraint[name].get<double>();
        }
      }
    }
    writeFileAtomically(assets / "scenes" / "stomach.json", json.dump());
    for (const std::string& pattern : patternIds(assets, "stomach")) {
      SCOPED_TRACE(pattern + " x " + std::to_string(factor));
      SceneRequest request = shipped("stomach", pattern);
      request.assets = assets;
      const Scene scene = loadScene(request);
      const OrganState target = scene.stateAt(scene.pattern.targetAngle_rad);

      const Vec3 moved_m = scene.toDeformed_m({0.021, 0.018, 0.042}, target);

      EXPECT_NEAR(target.twist.graspAngle_rad, scene.pattern.targetAngle_rad, 1e-9);
      EXPECT_LT(std::abs(scene.torqueAt_Nm(scene.pattern.targetAngle_rad)), scene.pattern.torqueLimit_Nm);
      EXPECT_LT(scene.rod->skin().sharpestBend(scene.rod->skin().curveOf(target.pose)), kFoldingBend);
      EXPECT_LT(norm(moved_m - Vec3{0.021, 0.018, 0.042}), 0.0075);
    }
  }
  std::filesystem::remove_all(assets);
}

TEST(Scene, SmallTurnsAreTurnsToo) {
  for (const char* organ : {"stomach", "intestine"}) {
    for (const std::string& pattern : patternIds(kShippedAssets, organ)) {
      const Scene scene = loadScene(shipped(organ, pattern));
      for (const double angle_deg : {1e-4, 0.01, 0.5, -1e-4, -0.01, -0.5}) {
        SCOPED_TRACE(pattern + " " + std::to_string(angle_deg));
        const TaskPoint point = scene.rod->pointAt(radians(angle_deg));
        EXPECT_NEAR(point.angle_rad, radians(angle_deg), 1e-9);
        EXPECT_GT(point.torque_Nm * angle_deg, 0.0);
      }
    }
  }
}

TEST(Scene, GripPlaceChangesTheTwistOfTheStomach) {
  const Scene scene = loadScene(shipped("stomach", "partial"));

  const TaskPoint near = scene.rod->follow(0.2, radians(60.0)).back();
  const TaskPoint far = scene.rod->follow(0.6, radians(60.0)).back();

  EXPECT_GT(std::abs(far.torque_Nm / near.torque_Nm - 1.0), 0.05);
  EXPECT_GT(norm(far.pose.nodes[20].position_m - near.pose.nodes[20].position_m), 0.002);
}

TEST(Scene, TurnsTheArmBothWays) {
  const Scene scene = loadScene(shipped("forearm"));

  ASSERT_EQ(scene.patterns.size(), 2U);
  EXPECT_EQ(scene.patterns[0].id, "pronation");
  EXPECT_EQ(scene.patterns[1].id, "supination");
  EXPECT_LT(scene.patterns[0].targetAngle_rad, 0.0);
  EXPECT_EQ(scene.patterns[0].targetAngle_rad, -scene.patterns[1].targetAngle_rad);
  EXPECT_TRUE(scene.lattice().straight());
  // From the elbow's cut to the crease of the wrist; the hand follows.
  EXPECT_NEAR(scene.lattice().length_m(), 0.262, 0.005);
}

TEST(Scene, SaysWhatDecidesItsAnswersInOneStableText) {
  const Scene scene = loadScene(shipped("forearm"));

  // Fields of assets/scenes/forearm.json and materials.json, in the order of scene_parameters.cpp.
  EXPECT_EQ(scene.parametersJson,
            R"({"format":1,"formulation":"saint-venant","ridges":36,"sections":25,"organ":"scene",)"
            R"("organ_unit_m":0.001,"lattice":{"mode":"straight-axis","spacing":"angle",)"
            R"("fixed_end_m":[0.0,0.0,0.0],"free_end_m":[0.0,0.0,0.262],"fixed_cut":[0.0,0.0,0.0],)"
            R"("free_cut":[0.0,0.0,1.0],"cap_radius_m":0.0,"ridge_zero":[1.0,0.0,0.0],)"
            R"("ridge_zero_fraction":0.0},"material":{"id":"forearm-soft-tissue",)"
            R"("shear_modulus_pa":4000.0},"instrument":{"id":"grasper","tip_radius_m":0.0025,)"
            R"("grip_reach_m":0.004},"pattern":{"id":"pronation","ends":"clamped-free",)"
            R"("force_limit_n":3.3,"torque_limit_nm":0.3}})");
  EXPECT_EQ(scene.parameterHash.size(), 64U);
  EXPECT_EQ(scene.parameterHash, loadScene(shipped("forearm")).parameterHash);
}

TEST(Scene, EveryOptionChangesTheParameterHash) {
  std::set<std::string> hashes;
  SceneRequest request = shipped("forearm");
  hashes.insert(loadScene(request).parameterHash);
  request.ridges = 12;
  hashes.insert(loadScene(request).parameterHash);
  request.sections = 9;
  hashes.insert(loadScene(request).parameterHash);
  request.formulation = Formulation::kPaper;
  hashes.insert(loadScene(request).parameterHash);
  request.material = "stomach-filled";
  hashes.insert(loadScene(request).parameterHash);
  request.latticeMode = LatticeMode::kHarmonic;
  hashes.insert(loadScene(request).parameterHash);
  request.pattern = "supination";
  hashes.insert(loadScene(request).parameterHash);

  EXPECT_EQ(hashes.size(), 7U);
}

TEST(Scene, EverythingOfTheInstrumentDecidesTheParameters) {
  SceneDescription description = readSceneFile(kShippedAssets, "forearm");
  const TwistPattern pattern = description.patterns.at(0).pattern;
  const auto textWith = [&](auto&& edit) {
    SceneDescription changed = description;
    edit(changed.instrument);
    return parametersText(changed, pattern, false, TissueModel::kTwist);
  };
  const std::string usual = parametersText(description, pattern, false, TissueModel::kTwist);

  const std::string longer = textWith([](Instrument& i) { i.shaftLength_m = 0.33; });
  const std::set<std::string> texts{usual, longer, textWith([](Instrument& i) { i.tipRadius_m = 0.003; }),
                                    textWith([](Instrument& i) { i.gripReach_m = 0.005; })};

  EXPECT_EQ(texts.size(), 4U);
  EXPECT_THAT(longer, HasSubstr(R"("grip_reach_m":0.004,"shaft_length_m":0.33})"));
  // The usual length goes unsaid: the hashes of older trials stay true.
  EXPECT_THAT(usual, ::testing::Not(HasSubstr("shaft_length_m")));
  EXPECT_EQ(sceneRequestFor(longer).pattern, pattern.id);
  EXPECT_EQ(sceneRequestFor(longer).tissue, TissueModel::kTwist);
  const std::string elements = parametersText(description, pattern, false, TissueModel::kFiniteElements);
  EXPECT_NE(elements, usual);
  EXPECT_EQ(sceneRequestFor(elements).tissue, TissueModel::kFiniteElements);
}

TEST(Scene, IsRebuiltFromItsParameters) {
  for (const std::string id : {"forearm", "stomach"}) {
    SceneRequest request = shipped(id);
    request.ridges = 18;
    request.sections = 13;
    request.formulation = Formulation::kPaper;
    request.material = "intestine-filled";
    const Scene scene = loadScene(request);

    SceneRequest again = sceneRequestFor(scene.parametersJson);
    again.assets = kShippedAssets;
    again.id = scene.id;

    EXPECT_EQ(loadScene(again).parameterHash, scene.parameterHash);
  }
}

TEST(Scene, IsRebuiltFromItsParametersAndTheUsersMesh) {
  const TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
  SceneRequest request = usersMesh(bar, "rebuilt");
  request.fixedEnd_m = Vec3{0, 0, 0.2};
  request.freeEnd_m = Vec3{0, 0, 0};
  const Scene scene = loadScene(request);

  SceneRequest again = sceneRequestFor(scene.parametersJson);
  again.assets = kShippedAssets;
  again.id = scene.id;
  again.organFile = request.organFile;
  const Scene rebuilt = loadScene(again);

  EXPECT_EQ(rebuilt.parameterHash, scene.parameterHash);
  EXPECT_EQ(rebuilt.organHash, scene.organHash);
  EXPECT_LT(rebuilt.lattice().frameAt(0.0).tangent.z, -0.999);
}

TEST(Scene, RefusesParametersThatItDidNotWrite) {
  for (const char* text : {"", "{}", "not json", R"({"formulation":"paper","ridges":"many"})"}) {
    EXPECT_EQ(testing::refusal([&] { return sceneRequestFor(text); }).code(), ErrorCode::kBadData) << text;
  }
}

TEST(Scene, NamesTheScenesThereAreWhenAskedForAnother) {
  testing::expectError(refusal(shipped("liver")), ErrorCode::kFileMissing,
                       {"'liver'", "forearm, gastric-mesentero-axial, gastric-organo-axial, intestine"});
}

TEST(Scene, NamesThePatternsThereAreWhenAskedForAnother) {
  testing::expectError(refusal(shipped("forearm", "flexion")), ErrorCode::kBadParameter,
                       {"'flexion'", "pronation, supination"});
}

TEST(Scene, NamesTheMaterialsThereAreWhenAskedForAnother) {
  SceneRequest request = shipped("forearm");
  request.material = "steel";

  testing::expectError(refusal(request), ErrorCode::kBadParameter,
                       {"'steel'", "forearm-soft-tissue, stomach-filled, intestine-filled"});
}

TEST(Scene, RefusesCountsThatTheLatticeCannotHave) {
  SceneRequest request = shipped("forearm");
  request.ridges = 2;
  EXPECT_EQ(refusal(request).code(), ErrorCode::kBadParameter);
  EXPECT_THAT(refusal(request).what(), HasSubstr("cannot bound an area"));
  request.ridges = 12;
  request.sections = 1000;
  EXPECT_EQ(refusal(request).code(), ErrorCode::kBadParameter);
}

TEST(UsersOrgan, ReplacesTheSceneAndIsCutByPlanesWhenItIsABar) {
  const TriangleMesh bar = testing::prism(testing::ellipseOutline(0.03, 0.02, 48), 0.2, 20);

  const Scene scene = loadScene(usersMesh(bar, "bar"));

  EXPECT_TRUE(scene.lattice().straight());
  // Wavefront text keeps the micrometre's tenth.
  EXPECT_NEAR(scene.lattice().length_m(), 0.2, 1e-6);
  EXPECT_THAT(scene.provenance, HasSubstr("bar.obj"));
  EXPECT_EQ(scene.pattern.id, "own-axis");
  EXPECT_THAT(scene.parametersJson, HasSubstr(R"("organ":"file")"));
}

TEST(UsersOrgan, IsCutByItsFieldWhenItIsBent) {
  const Scene scene = loadScene(usersMesh(testing::bentTube(0.02, 0.06, kPi / 2, 40, 60), "bent"));

  EXPECT_FALSE(scene.lattice().straight());
  EXPECT_NEAR(scene.lattice().length_m(), 0.06 * kPi / 2, 1e-4);
}

TEST(UsersOrgan, IsReadInItsUnit) {
  TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
  for (Vec3& p : bar.vertices_m) {
    p *= 0.1;  // written in millimetres: now in centimetres
  }
  SceneRequest request = usersMesh(bar, "centimetres");
  request.organScale_m = 0.01;

  EXPECT_NEAR(loadScene(request).lattice().length_m(), 0.2, 1e-5);
}

TEST(UsersOrgan, TakesPatternsOfEveryScene) {
  SceneRequest request = usersMesh(testing::jTube(0.02, 0.12, 0.05, 36, 60), "j");
  request.pattern = "combined";

  const Scene scene = loadScene(request);

  EXPECT_EQ(scene.id, "stomach");
  EXPECT_EQ(scene.pattern.id, "combined");
  request.pattern = "somersault";
  testing::expectError(refusal(request), ErrorCode::kBadParameter, {"pronation", "mesentero-axial"});
}

TEST(UsersOrgan, HasItsOwnAxes) {
  SceneRequest request = usersMesh(testing::jTube(0.02, 0.12, 0.05, 36, 60), "axes");
  request.pattern = "organo-axial";

  const Scene scene = loadScene(request);

  const SectionLattice& lattice = scene.lattice();
  const TurnTask& longAxis = scene.patterns[0].task.value();
  EXPECT_LT(norm(longAxis.axisFrom_m - lattice.frameAt(0.0).centre_m), 1e-12);
  EXPECT_LT(norm(longAxis.axisTo_m - lattice.frameAt(lattice.length_m()).centre_m), 1e-12);
  // The short one lies in the plane of the bend, from the inside to the outside, across a 40 mm tube.
  const TurnTask& shortAxis = scene.patterns[1].task.value();
  const Vec3 across = shortAxis.axisTo_m - shortAxis.axisFrom_m;
  EXPECT_NEAR(norm(across), 0.04, 0.002);
  EXPECT_NEAR(across.y, 0.0, 0.001);
  const Vec3 middle = lattice.frameAt(0.5 * lattice.length_m()).centre_m;
  const Vec3 chord = 0.5 * (longAxis.axisFrom_m + longAxis.axisTo_m);
  EXPECT_LT(dot(across, chord - middle), 0.0);
}

TEST(UsersOrgan, NeedsBothEndsOrNone) {
  SceneRequest request = usersMesh(testing::prism(testing::circleOutline(0.03, 36), 0.2, 12), "ends");
  request.freeEnd_m = Vec3{0, 0, 0.2};

  EXPECT_EQ(refusal(request).code(), ErrorCode::kUsage);
}

TEST(UsersOrgan, IsRefusedWhenItIsMissingOrOpen) {
  SceneRequest request = shipped("forearm");
  request.organFile = "/nowhere/organ.obj";
  EXPECT_EQ(refusal(request).code(), ErrorCode::kFileMissing);

  TriangleMesh open = testing::prism(testing::circleOutline(0.03, 36), 0.2, 12);
  open.triangles.resize(open.triangles.size() - 3);
  EXPECT_EQ(refusal(usersMesh(open, "open")).code(), ErrorCode::kBadMesh);
}

TEST(Materials, HaveAModulusInsideTheirPublishedRangeAndASource) {
  const std::vector<Material> materials = readMaterials(kShippedAssets);

  EXPECT_GE(materials.size(), 3U);
  for (const Material& material : materials) {
    EXPECT_GE(material.shearModulus_Pa, material.lowest_Pa) << material.id;
    EXPECT_LE(material.shearModulus_Pa, material.highest_Pa) << material.id;
    EXPECT_GT(material.source.size(), 40U) << material.id;
    EXPECT_FALSE(material.title.empty()) << material.id;
  }
}

}  // namespace
}  // namespace torsio
