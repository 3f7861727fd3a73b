// SPDX-License-Identifier: GPL-3.0-or-later
// Patterns that are undone, as scene files state them: what is read, and what each refusal names.
#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_parameters.h"
#include "tests/support/copied_scene_files.h"

namespace torsio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

/// A copy of the sigmoid's scene file in which one thing can be changed.
class DetorsionFile : public testing::CopiedSceneFiles {
 protected:
  DetorsionFile()
      : CopiedSceneFiles({"scenes/sigmoid.json", "scenes/testis.json", "scenes/forearm.json",
                          "scenes/materials.json", "instruments/grasper.json"}),
        whole_(Json::parse(readFile(assets_ / "scenes/sigmoid.json"))) {}

  SceneDescription changed(const std::function<void(Json& pattern)>& edit) {
    Json json = whole_;
    edit(json["patterns"][0]);
    writeFileAtomically(assets_ / "scenes/sigmoid.json", json.dump());
    return readSceneFile(assets_, "sigmoid");
  }

  void expectRefusal(const std::string& field, const std::function<void(Json& pattern)>& edit) {
    try {
      static_cast<void>(changed(edit));
      ADD_FAILURE() << field << " was not refused";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kBadData) << field;
      EXPECT_THAT(error.what(), AllOf(HasSubstr("sigmoid.json"), HasSubstr("'" + field + "'"))) << field;
      EXPECT_FALSE(error.remedy().empty()) << field;
    }
  }

  std::string parameters(const std::function<void(Json& pattern)>& edit) {
    const SceneDescription scene = changed(edit);
    return parametersText(scene, scene.patterns[0].pattern, false, TissueModel::kTwist);
  }

  Json whole_;
};

TEST_F(DetorsionFile, IsReadInFullAndInSi) {
  const SceneDescription scene = changed([](Json&) {});

  ASSERT_TRUE(scene.patterns[0].pattern.detorsion);
  const Detorsion& read = *scene.patterns[0].pattern.detorsion;
  ASSERT_EQ(read.wall.thickness_m.size(), 1U);
  EXPECT_NEAR(read.wall.thickness_m[0][1], 0.002, 1e-12);
  EXPECT_NEAR(read.wall.pressure_Pa, 15.0 * 133.322387415, 1e-6);
  EXPECT_NEAR(read.wall.ventedPressure_Pa, 133.322387415, 1e-6);
  EXPECT_TRUE(read.wall.vent);
  ASSERT_EQ(read.spans.size(), 2U);
  EXPECT_EQ(read.spans[1].held, 0.94);
  EXPECT_EQ(read.spans[1].mobile, 0.63);
  EXPECT_NEAR(read.start.most_rad, kTurn, 1e-12);
  EXPECT_EQ(read.start.sign, 1);
  EXPECT_NEAR(read.start.since_s, 3.0 * 3600.0, 1e-9);
  EXPECT_NEAR(read.vessels.pedicle_m, 0.040, 1e-12);
  EXPECT_NEAR(read.vessels.lossTime_s, 6.0 * 3600.0, 1e-9);
  EXPECT_NEAR(read.base.relapseFrom_rad, radians(90.0), 1e-12);
  EXPECT_NEAR(read.limits.jawArea_m2, 20e-6, 1e-18);
  EXPECT_NEAR(read.limits.bruise_Pa, 330e3, 1e-6);
  EXPECT_NEAR(read.limits.residual_rad, radians(15.0), 1e-12);
  EXPECT_EQ(read.timeScale, 60.0);
  EXPECT_FALSE(read.validity.empty());
}

TEST_F(DetorsionFile, ReadsAWallAsAMapAndASolidCord) {
  const SceneDescription mapped = changed([](Json& p) {
    p["detorsion"]["wall"]["thickness_mm"] = Json::array({Json::array({0, 2}), Json::array({1, 5})});
  });
  const SceneDescription cord = readSceneFile(assets_, "testis");

  EXPECT_EQ(mapped.patterns[0].pattern.detorsion->wall.thickness_m.size(), 2U);
  EXPECT_NEAR(mapped.patterns[0].pattern.detorsion->wall.thickness_m[1][1], 0.005, 1e-12);
  EXPECT_TRUE(cord.patterns[0].pattern.detorsion->wall.thickness_m.empty());
  EXPECT_GT(cord.patterns[0].pattern.detorsion->cordStiffness_Nm_per_rad, 0.0);
}

TEST_F(DetorsionFile, RefusesAGoalWithoutItsNumbersAndNumbersWithoutAGoal) {
  expectRefusal("detorsion", [](Json& p) { p.erase("detorsion"); });
  expectRefusal("detorsion", [](Json& p) { p.erase("goal"); });
  expectRefusal("goal", [](Json& p) { p["goal"] = "untwist"; });
  expectRefusal("angle_deg", [](Json& p) { p["angle_deg"] = 90; });
  expectRefusal("task", [](Json& p) { p["task"] = {{"axis", "own"}}; });
}

TEST_F(DetorsionFile, RefusesWhatNoOrganHasNamingTheField) {
  const auto in = [](const char* part, const char* field, const Json& value) {
    return [=](Json& p) { p["detorsion"][part][field] = value; };
  };
  expectRefusal("thickness_mm", in("wall", "thickness_mm", 0));
  expectRefusal("thickness_mm", in("wall", "thickness_mm", "thin"));
  expectRefusal("thickness_mm", in("wall", "thickness_mm", Json::parse("[[0.5, 2], [0.5, 3]]")));
  expectRefusal("thickness_mm", in("wall", "thickness_mm", Json::parse("[[0, -2]]")));
  expectRefusal("gent_limit", in("wall", "gent_limit", 0));
  expectRefusal("pressure_mmhg", in("wall", "pressure_mmhg", -1));
  expectRefusal("vented_pressure_mmhg", in("wall", "vented_pressure_mmhg", 20));
  expectRefusal("vent", in("wall", "vent", 1));
  expectRefusal("most_deg", in("initial_twist", "most_deg", 90));
  expectRefusal("direction", in("initial_twist", "direction", "left"));
  expectRefusal("opposite_share", in("initial_twist", "opposite_share", 1.5));
  expectRefusal("venous_mmhg", in("pedicle", "venous_mmhg", 90));
  expectRefusal("loss_time_h", in("pedicle", "loss_time_h", 0));
  expectRefusal("relapse_time_s", in("base", "relapse_time_s", 0));
  expectRefusal("tear_kpa", in("limits", "tear_kpa", 100));
  expectRefusal("jaw_area_mm2", in("limits", "jaw_area_mm2", 0));
  expectRefusal("source", [](Json& p) { p["detorsion"]["limits"].erase("source"); });
  expectRefusal("viscosity", in("wall", "viscosity", 1));
  expectRefusal("time_scale", [](Json& p) { p["detorsion"]["time_scale"] = 0; });
  expectRefusal("validity", [](Json& p) { p["detorsion"].erase("validity"); });
  expectRefusal("wall", [](Json& p) { p["detorsion"]["cord_stiffness_nmm_per_rad"] = 3; });
  expectRefusal("wall", [](Json& p) { p["detorsion"].erase("wall"); });
}

TEST_F(DetorsionFile, ReadsTheStagesInWhichAnOrganIsToBeUndone) {
  const TurnStages none = readSceneFile(assets_, "sigmoid").patterns[0].pattern.detorsion->stages;
  const TurnStages testis = readSceneFile(assets_, "testis").patterns[0].pattern.detorsion->stages;
  const auto with = [](const Json& stages) {
    return [stages](Json& p) { p["detorsion"]["stages"] = stages; };
  };

  EXPECT_FALSE(none.asked());
  EXPECT_EQ(testis, (TurnStages{radians(360.0), 300.0}));
  expectRefusal("rest_min", with({{"turn_deg", 360}, {"rest_min", 0}, {"source", "x"}}));
  expectRefusal("turn_deg", with({{"turn_deg", 1}, {"rest_min", 5}, {"source", "x"}}));
  expectRefusal("source", with({{"turn_deg", 360}, {"rest_min", 5}}));
}

TEST_F(DetorsionFile, RefusesSpansThatLeaveNoMobilePart) {
  for (const char* spans :
       {"[]", "[[0.2, 0.21]]", "[[0, 1.2]]", "[[0, 0.6], [1, 0.5]]", "[[0, 0.3], [0.4, 0.7]]",
        "[[0, 0.1], [0.3, 0.2], [1, 0.9]]", "[0, 0.4]", "[[0]]"}) {
    expectRefusal("spans", [&](Json& p) { p["detorsion"]["spans"] = Json::parse(spans); });
  }
}

TEST_F(DetorsionFile, PutsEveryNumberIntoTheParametersAndNoneIntoThoseOfOthers) {
  const std::string before = parameters([](Json&) {});
  const auto number = [](const char* part, const char* field, double value) {
    return [=](Json& p) { p["detorsion"][part][field] = value; };
  };

  for (const auto& [part, field] : {std::pair{"wall", "thickness_mm"},
                                    {"wall", "gent_limit"},
                                    {"wall", "rest_pressure_mmhg"},
                                    {"wall", "pressure_mmhg"},
                                    {"wall", "vented_pressure_mmhg"},
                                    {"initial_twist", "least_deg"},
                                    {"initial_twist", "most_deg"},
                                    {"initial_twist", "step_deg"},
                                    {"initial_twist", "opposite_share"},
                                    {"initial_twist", "since_h"},
                                    {"pedicle", "arterial_mmhg"},
                                    {"pedicle", "venous_mmhg"},
                                    {"pedicle", "shut_at_turn_mmhg"},
                                    {"pedicle", "shut_power"},
                                    {"pedicle", "pedicle_mm"},
                                    {"pedicle", "pedicle_reference_mm"},
                                    {"pedicle", "pedicle_share"},
                                    {"pedicle", "lumen_threshold_mmhg"},
                                    {"pedicle", "lumen_floor"},
                                    {"pedicle", "flow_time_s"},
                                    {"pedicle", "loss_time_h"},
                                    {"pedicle", "enough_flow"},
                                    {"base", "stick_share"},
                                    {"base", "relapse_share"},
                                    {"base", "relapse_from_deg"},
                                    {"base", "relapse_time_s"},
                                    {"limits", "jaw_area_mm2"},
                                    {"limits", "jaw_force_n"},
                                    {"limits", "bruise_kpa"},
                                    {"limits", "bruise_s"},
                                    {"limits", "tear_kpa"},
                                    {"limits", "pull_n"},
                                    {"limits", "residual_deg"},
                                    {"limits", "patency"},
                                    {"limits", "flow"},
                                    {"limits", "hands_off_s"}}) {
    const double was = whole_["patterns"][0]["detorsion"][part][field].get<double>();
    EXPECT_NE(parameters(number(part, field, 0.99 * was + (was == 0.0 ? 0.1 : 0.0))), before)
        << part << " " << field;
  }
  EXPECT_NE(parameters([](Json& p) { p["detorsion"]["spans"][0][1] = 0.36; }), before);
  EXPECT_NE(parameters([](Json& p) { p["detorsion"]["time_scale"] = 59; }), before);
  EXPECT_NE(parameters([](Json& p) { p["detorsion"]["wall"]["sealed"] = true; }),
            parameters([](Json& p) { p["detorsion"]["wall"]["sealed"] = false; }));
  EXPECT_NE(parameters([](Json& p) { p["detorsion"]["wall"]["vent"] = false; }), before);
  EXPECT_NE(parameters([](Json& p) { p["detorsion"]["initial_twist"]["direction"] = "clockwise"; }), before);
  EXPECT_EQ(parameters([](Json& p) { p["detorsion"]["validity"] = "other words"; }), before);
  const SceneDescription forearm = readSceneFile(assets_, "forearm");
  const std::string plain = parametersText(forearm, forearm.patterns[0].pattern, false, TissueModel::kTwist);
  EXPECT_EQ(plain.find("goal"), std::string::npos);
  EXPECT_EQ(plain.find("detorsion"), std::string::npos);
}

}  // namespace
}  // namespace torsio
