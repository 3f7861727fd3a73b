// SPDX-License-Identifier: GPL-3.0-or-later
// The exercise on the organs that are shipped: every pattern can be gripped, twisted and let go.
// A tick takes no memory and no lock in any phase of an exercise, with every link joined.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/file_io.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/record/trial.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/servo/hand_task.h"
#include "sim/servo/replay_trial.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/sim/servo/recorded_trial.h"
#include "tests/support/allocation_count.h"
#include "tests/support/lock_count.h"
#include "tests/support/shipped_scene.h"

namespace torsio {

namespace {

const std::filesystem::path kAssets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";

Scene shipped(const std::string& id, const std::string& pattern = "") {
  return testing::shippedScene(id, pattern);
}

ScriptedHandOptions skilledHand(const Scene& scene) {
  return {.seed = 1,
          .task = handTask(scene),
          .profile = {.initialSkill = 0.9, .finalSkill = 0.9},
          .duration_s = 1.0};  // one twist
}

TEST(ShippedScenes, LetASkilledHandDoEveryPattern) {
  for (const std::string& id : sceneIds(kAssets)) {
    const Scene first = shipped(id);
    for (const TwistPattern& pattern : first.patterns) {
      SCOPED_TRACE(id + ", " + pattern.id);
      const Scene scene = shipped(id, pattern.id);
      if (scene.hollow) {
        continue;  // came twisted: the next test
      }
      ScriptedHandOptions options = skilledHand(scene);
      options.duration_s = ScriptedHand(options).span_s(0)[1];
      ScriptedHand hand(options);
      ServoLoop loop({.device = &hand, .scene = &scene}, {});

      std::uint32_t events = 0;
      double angle_rad = 0.0;
      double torque_Nm = 0.0;
      for (std::int64_t time_us = 0; time_us < static_cast<std::int64_t>(options.duration_s * 1e6);
           time_us += 1000) {
        loop.tick(time_us);
        events |= loop.lastEvents();
        const TwistResponse& response = loop.lastSample().response;
        if (std::abs(response.angle_rad) > std::abs(angle_rad)) {
          angle_rad = response.angle_rad;
        }
        torque_Nm = std::max(torque_Nm, std::abs(response.torque_Nm));
      }

      EXPECT_TRUE(events & kEventGripped);
      EXPECT_TRUE(events & kEventReleased);
      EXPECT_TRUE(events & kEventReturned);
      EXPECT_FALSE(events & kEventSlipped);
      // A hand of skill 0.9 misses by less than 6 degrees and overshoots by less than 6 %; the way of the tip
      // round a bent organ differs from the plan's circle by the grip's own deviation.
      EXPECT_NEAR(angle_rad, pattern.targetAngle_rad, 0.1 * std::abs(pattern.targetAngle_rad) + radians(6.0));
      EXPECT_GT(torque_Nm, 0.001);
      EXPECT_EQ(loop.lastSample().phase, ExercisePhase::kTracking);
    }
  }
}

TEST(ShippedScenes, LetASkilledHandUndoEveryOrganThatCameTwisted) {
  std::size_t undone = 0;
  for (const std::string& id : sceneIds(kAssets)) {
    for (const std::string& pattern : patternIds(kAssets, id)) {
      SCOPED_TRACE(id + ", " + pattern);
      const Scene scene = shipped(id, pattern);
      if (!scene.hollow) {
        continue;
      }
      const DetorsionLimits& limits = scene.hollow->detorsion().limits;
      ScriptedHandOptions options = skilledHand(scene);
      const double ends_s = undone_s(*scene.hollow, ScriptedHand(options));
      options.duration_s = ends_s;
      ScriptedHand hand(options);
      ServoLoop loop({.device = &hand, .scene = &scene}, {.seed = detorsionSeed({})});

      std::uint32_t events = 0;
      for (std::int64_t time_us = 0; time_us < static_cast<std::int64_t>(ends_s * 1e6); time_us += 1000) {
        loop.tick(time_us);
        events |= loop.lastEvents();
      }

      const HollowReading& reading = loop.lastSample().hollow;
      EXPECT_TRUE(events & kEventGripped);
      EXPECT_TRUE(events & kEventReleased);
      EXPECT_FALSE(events & (kEventBruised | kEventTorn));
      EXPECT_LE(std::abs(loop.lastSample().response.angle_rad), limits.residual_rad);
      EXPECT_GE(reading.patency, limits.patency);
      EXPECT_GE(reading.flow, limits.flow);
      EXPECT_LT(reading.dose, 1.0);
      ++undone;
    }
  }
  EXPECT_EQ(undone, 6U);
}

// A stomach that is turned by 210 degrees lies wholly behind the line that it swings about.
TEST(ShippedScenes, TheHandReachesForTheOrganHoweverFarItCameTwisted) {
  constexpr double kBetweenVertices_m = 0.005;
  constexpr std::uint64_t kStarts = 24;
  for (const std::string& id : sceneIds(kAssets)) {
    if (patternIds(kAssets, id) != std::vector<std::string>{"detorse"}) {
      continue;
    }
    const Scene& scene = testing::twistedOrgan(id);
    std::set<double> known_rad;
    for (std::uint64_t seed = 1; seed <= kStarts; ++seed) {
      const OrganState lies = scene.hollow->start(seed);
      if (!known_rad.insert(lies.twist.graspAngle_rad).second) {
        continue;
      }
      const Vec3 reached_m = detorseTask(scene, seed).turns.front().graspPoint_m;
      double away_m = 1.0;
      for (const Vec3& vertex_m : testing::smoothAt(scene, lies)) {
        away_m = std::min(away_m, norm(vertex_m - reached_m));
      }
      EXPECT_LT(away_m, kBetweenVertices_m) << id << " " << degrees(lies.twist.graspAngle_rad);
    }
    EXPECT_GE(known_rad.size(), 2U) << id;
  }
}

TEST(ShippedScenes, ReplayBitForBitWithAModelThatWasBuiltAnew) {
  Trial trial;
  {
    const Scene scene = shipped("forearm");
    ScriptedHandOptions options = skilledHand(scene);
    options.duration_s = 12.0;
    ScriptedHand hand(options);
    ServoLoop loop({.device = &hand, .scene = &scene}, {});
    trial = recordedTrial(loop, headerOf(scene, hand), 12);
  }

  const Scene again = shipped("forearm");

  EXPECT_TRUE(replayTrial(again, trial).identical());
}

TEST(TickCost, TakesNoMemoryAndNoLockThroughAWholeExercise) {
  const Scene scene = barScene();
  ScriptedHand hand({.seed = 3, .task = handTask(scene), .profile = handProfile(3), .duration_s = 10.0});
  SpscRing<Sample> ring(20'000);
  SpscRing<ServoCommand> wishes(4);
  SpscRing<ExerciseMoment> events(64);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand,
                  .scene = &scene,
                  .recording = &ring,
                  .live = &live,
                  .commands = &wishes,
                  .events = &events},
                 {});
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kSetTarget, 1.0}));
  std::set<ExercisePhase> phases;

  std::int64_t taken = 0;
  std::int64_t locked = 0;
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t allocations = testing::allocationCount();
    const std::int64_t locks = testing::lockCount();
    loop.tick(1000LL * i);
    taken += testing::allocationCount() - allocations;
    locked += testing::lockCount() - locks;
    phases.insert(loop.lastSample().phase);
  }

  EXPECT_EQ(taken, 0);
  EXPECT_EQ(locked, 0);
  EXPECT_EQ(phases.size(), 4U);
}

TEST(TickCost, TakesNoMemoryAndNoLockWhileAnOrganIsUndone) {
  const Scene scene = hollowScene(twistedTube());
  ScriptedHandOptions options{
      .seed = 3, .task = handTask(scene), .profile = {.initialSkill = 0.9, .finalSkill = 0.9}};
  options.duration_s = undone_s(*scene.hollow, ScriptedHand(options));
  ScriptedHand hand(options);
  SpscRing<Sample> ring(100'000);
  SpscRing<ServoCommand> wishes(4);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand, .scene = &scene, .recording = &ring, .live = &live, .commands = &wishes},
                 {});
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kVent, 1.0}));
  ASSERT_TRUE(wishes.push({ServoCommand::Kind::kCheckFlow, 3.0}));
  std::set<ExercisePhase> phases;

  const std::int64_t allocations = testing::allocationCount();
  const std::int64_t locks = testing::lockCount();
  for (int i = 0; i < static_cast<int>(options.duration_s * 1000.0); ++i) {
    loop.tick(1000LL * i);
    phases.insert(loop.lastSample().phase);
  }
  const std::int64_t ofTheSet = static_cast<std::int64_t>(phases.size());

  EXPECT_EQ(testing::allocationCount() - allocations, ofTheSet);  // a node for each phase
  EXPECT_EQ(testing::lockCount() - locks, 0);
  EXPECT_EQ(phases.size(), 4U);
}

TEST(TickCost, DetectsALock) {
  if (!testing::lockCountWorks()) {
    GTEST_SKIP() << "locks are not counted here";
  }
  std::mutex mutex;
  const std::int64_t before = testing::lockCount();
  { const std::lock_guard<std::mutex> guard(mutex); }
  EXPECT_EQ(testing::lockCount() - before, 1);
}

TEST(TickCost, ReportsEveryEventWithItsTime) {
  const Scene scene = barScene();
  ScriptedHand hand({.seed = 3, .task = handTask(scene), .profile = handProfile(3), .duration_s = 10.0});
  SpscRing<ExerciseMoment> events(64);
  LatestValue<LiveState> live;
  ServoLoop loop({.device = &hand, .scene = &scene, .live = &live, .events = &events}, {});
  for (int i = 0; i < 10'000; ++i) {
    loop.tick(1000LL * i);
  }

  std::uint32_t seen = kEventNone;
  std::int64_t touched_us = -1;
  std::int64_t gripped_us = -1;
  std::int64_t released_us = -1;
  std::int64_t last_us = 0;
  ExerciseMoment moment;
  while (events.pop(moment)) {
    EXPECT_GE(moment.time_us, last_us);
    EXPECT_EQ(moment.time_us, 1000 * moment.tick);
    last_us = moment.time_us;
    seen |= moment.events;
    if ((moment.events & kEventTouched) != 0) {
      touched_us = moment.time_us;
    }
    if ((moment.events & kEventGripped) != 0) {
      gripped_us = moment.time_us;
    }
    if ((moment.events & kEventReleased) != 0) {
      released_us = moment.time_us;
    }
  }

  EXPECT_EQ(seen & (kEventTouched | kEventGripped | kEventReleased),
            kEventTouched | kEventGripped | kEventReleased);
  EXPECT_LT(gripped_us, released_us);
  const ExerciseTimes& times = live.latest().times;
  EXPECT_EQ(times.touched_us, touched_us);
  EXPECT_EQ(times.gripped_us, gripped_us);
  EXPECT_EQ(times.released_us, released_us);
  EXPECT_EQ(times.slipped_us, -1);
  EXPECT_EQ(times, loop.times());
}

}  // namespace

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
