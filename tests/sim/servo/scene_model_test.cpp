// SPDX-License-Identifier: GPL-3.0-or-later
// A scene that says what its model is built with: other answers, another hash, and recordings that replay.
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/file_io.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/trial.h"
#include "sim/scene/scene.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/recorded_trial.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// A copy of the assets of the forearm and the stomach, whose scenes can be changed.
class SceneModel : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    const fs::path shipped = fs::path(TORSIO_SOURCE_DIR) / "assets";
    assets_ = fs::path(::testing::TempDir()) / (std::string("scene_model_") + test->name());
    fs::remove_all(assets_);
    for (const char* folder : {"scenes", "instruments", "organs"}) {
      fs::create_directories(assets_ / folder);
    }
    for (const char* name : {"scenes/forearm.json", "scenes/stomach.json", "scenes/materials.json",
                             "instruments/grasper.json", "organs/forearm.ply", "organs/stomach.ply"}) {
      fs::copy_file(shipped / name, assets_ / name);
    }
  }
  void TearDown() override { fs::remove_all(assets_); }

  void setModel(const std::string& id, const std::string& formulation, const Json& model) const {
    const fs::path file = assets_ / "scenes" / (id + ".json");
    Json json = Json::parse(readFile(file));
    json["formulation"] = formulation;
    json["model"] = model;
    writeFileAtomically(file, json.dump());
  }

  [[nodiscard]] SceneRequest request(const std::string& id) const { return {.assets = assets_, .id = id}; }

  fs::path assets_;
};

Trial recorded(const Scene& scene) {
  ScriptedHandOptions options{.seed = 3,
                              .task = handTask(scene),
                              .profile = {.initialSkill = 0.6, .finalSkill = 0.6},
                              .duration_s = 6.0};
  ScriptedHand hand(options);
  ServoLoop loop({.device = &hand, .scene = &scene}, {});
  return recordedTrial(loop, headerOf(scene, hand), 6);
}

TEST_F(SceneModel, AnswersAsTheSameModelOfAnEngineerDoes) {
  const Scene plain = loadScene(request("forearm"));
  SceneRequest chosen = request("forearm");
  chosen.model = {.taper = true, .stiffeningStrain = 0.3, .shearModulus_Pa = 5200.0};
  const Scene engineers = loadScene(chosen);
  setModel("forearm", "saint-venant", {{"taper", true}, {"stiffening", 0.3}, {"shear_modulus_pa", 5200}});

  const Scene scene = loadScene(request("forearm"));

  const double target_rad = scene.pattern.targetAngle_rad;
  EXPECT_EQ(scene.torqueAt_Nm(target_rad), engineers.torqueAt_Nm(target_rad));
  EXPECT_GT(std::abs(scene.torqueAt_Nm(target_rad)), 1.2 * std::abs(plain.torqueAt_Nm(target_rad)));
  EXPECT_EQ(scene.modelChoice, engineers.modelChoice);
  EXPECT_NE(scene.parameterHash, plain.parameterHash);
  EXPECT_NE(scene.parameterHash, engineers.parameterHash) << "nothing may be recorded of the engineer's";
  EXPECT_NE(scene.parametersJson.find(
                R"("model":{"taper":true,"stiffening":0.3,"shear_modulus_pa":5200.0},"instrument")"),
            std::string::npos)
      << scene.parametersJson;
}

TEST_F(SceneModel, EveryPartOfItChangesTheParameterHash) {
  std::set<std::string> hashes{loadScene(request("forearm")).parameterHash};
  const std::vector<Json> ofSaintVenant{{{"poynting", true}},    {{"restrained_ends", true}},
                                        {{"taper", true}},       {{"shear_centre", true}},
                                        {{"foundation", 0.5}},   {{"stiffening", 0.3}},
                                        {{"drift", "constant"}}, {{"shear_modulus_pa", 5200}}};
  const std::vector<Json> ofPaper{
      Json::object(), {{"interpolation", "components"}}, {{"beta", 30}}, {{"clamp_lift", true}}};

  for (const Json& model : ofSaintVenant) {
    setModel("forearm", "saint-venant", model);
    hashes.insert(loadScene(request("forearm")).parameterHash);
  }
  for (const Json& model : ofPaper) {
    setModel("forearm", "paper", model);
    hashes.insert(loadScene(request("forearm")).parameterHash);
  }

  EXPECT_EQ(hashes.size(), 1 + ofSaintVenant.size() + ofPaper.size());
}

TEST_F(SceneModel, ARecordingOfItReplaysBitForBitFromItsParameters) {
  setModel("forearm", "saint-venant", {{"taper", true}, {"stiffening", 0.3}, {"restrained_ends", true}});
  const Trial trial = recorded(loadScene(request("forearm")));
  SceneRequest again = sceneRequestFor(trial.header.parametersJson);
  again.assets = assets_;
  again.id = trial.header.sceneId;

  const ReplayReport report = replayTrial(loadScene(again), trial);

  EXPECT_EQ(report.samples, 6'000);
  EXPECT_TRUE(report.identical()) << (report.first ? report.first->field : "");
}

TEST_F(SceneModel, LeavesACurvedOrganToTheTwistModelButForItsModulus) {
  setModel("stomach", "saint-venant", {{"shear_modulus_pa", 3500}});
  const Scene firmer = loadScene(request("stomach"));
  setModel("stomach", "saint-venant", {{"foundation", 0.5}});
  const Scene bar = loadScene(request("stomach"));

  EXPECT_NE(firmer.rod, nullptr);
  EXPECT_EQ(firmer.model.material().shearModulus_Pa, 3500.0);
  EXPECT_EQ(bar.rod, nullptr);
}

TEST_F(SceneModel, GivesWayToAnotherFormulationAndAnotherTissue) {
  setModel("forearm", "saint-venant", {{"taper", true}, {"drift", "constant"}, {"shear_modulus_pa", 5200}});
  SceneRequest printed = request("forearm");
  printed.formulation = Formulation::kPaper;
  SceneRequest stomach = request("forearm");
  stomach.material = "stomach-filled";

  EXPECT_EQ(loadScene(printed).modelChoice,
            (ModelChoice{.drift = Drift::kConstant, .shearModulus_Pa = 5200.0}));
  const Scene other = loadScene(stomach);
  EXPECT_FALSE(other.modelChoice.shearModulus_Pa);
  EXPECT_TRUE(other.modelChoice.taper);
}

}  // namespace
}  // namespace torsio
