// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files with one thing wrong: the message names the file, the field and what to do.
// Patterns that are undone, as scene files state them: what is read, and what each refusal names.
#include "sim/scene/scene_file.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_parameters.h"
#include "tests/support/refusal.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

void expectFieldNamed(const Error& error, const std::string& file, const std::string& field) {
  testing::expectError(error, ErrorCode::kBadData, {file, "'" + field + "'"});
  EXPECT_FALSE(error.remedy().empty()) << field;
}

/// A copy of the shipped data files (not of the organs) in which one file can be changed.
class SceneFile : public testing::CopiedSceneFiles {
 protected:
  SceneFile()
      : CopiedSceneFiles({"scenes/forearm.json", "scenes/stomach.json", "scenes/materials.json",
                          "instruments/grasper.json"}) {}

  void change(const std::string& file, const std::function<void(Json&)>& edit) {
    Json json = Json::parse(readFile(assets_ / file));
    edit(json);
    writeFileAtomically(assets_ / file, json.dump());
  }

  Error refusal(const std::string& id = "stomach") {
    return testing::refusal([&] { return readSceneFile(assets_, id); });
  }

  void expectBadField(const std::function<void(Json&)>& edit, const std::string& field) {
    const std::string before = readFile(assets_ / "scenes/stomach.json");
    change("scenes/stomach.json", edit);
    expectFieldNamed(refusal(), "stomach.json", field);
    writeFileAtomically(assets_ / "scenes/stomach.json", before);
  }
};

TEST_F(SceneFile, IsReadInFull) {
  const SceneDescription scene = readSceneFile(assets_, "stomach");

  EXPECT_EQ(scene.id, "stomach");
  EXPECT_EQ(scene.organ, assets_ / "organs/stomach.ply");
  EXPECT_EQ(scene.lattice.mode, LatticeMode::kHarmonic);
  EXPECT_NEAR(scene.lattice.fixedEnd_m.x, -0.047, 1e-12);
  EXPECT_NEAR(scene.lattice.branchRoot_m.z, 0.0404, 1e-12);
  EXPECT_NEAR(norm(scene.lattice.branchCut), 1.0, 1e-12);
  EXPECT_LT(scene.lattice.branchCut.x, 0.0);
  EXPECT_EQ(scene.material.id, "stomach-filled");
  EXPECT_EQ(scene.instrument.id, "grasper");
  EXPECT_EQ(scene.patterns.size(), 4U);
  EXPECT_EQ(scene.patterns[0].elsewhere, AxisElsewhere::kEnds);
  EXPECT_EQ(scene.patterns[1].elsewhere, AxisElsewhere::kBend);
  ASSERT_EQ(scene.restraints.size(), 4U);
  const Restraint& cardia = scene.restraints[1];
  EXPECT_EQ(cardia.id, "cardia");
  EXPECT_NEAR(cardia.stiffness_N_per_m, 1000.0, 1e-9);
  EXPECT_NEAR(cardia.halfWidth_m, 0.011, 1e-12);
  ASSERT_TRUE(cardia.point_m);
  EXPECT_NEAR(cardia.point_m->z, 0.042, 1e-12);
  EXPECT_NEAR(scene.restraints[0].turn_Nm_per_rad, 0.010, 1e-12);
  for (const Restraint& restraint : scene.restraints) {
    EXPECT_FALSE(restraint.source.empty()) << restraint.id;
  }
}

TEST_F(SceneFile, SaysWhatTheModelIsBuiltWithBeyondItsFormulation) {
  change("scenes/forearm.json", [](Json& j) {
    j["model"] = {{"poynting", true},     {"restrained_ends", true}, {"taper", true},
                  {"shear_centre", true}, {"foundation", 0.5},       {"stiffening", 0.3},
                  {"drift", "constant"},  {"shear_modulus_pa", 5200}};
  });
  change("scenes/stomach.json", [](Json& j) {
    j["formulation"] = "paper";
    j["model"] = {{"interpolation", "components"}, {"beta", 30}, {"clamp_lift", true}};
  });

  const ModelChoice bar = readSceneFile(assets_, "forearm").model;
  const ModelChoice paper = readSceneFile(assets_, "stomach").model;

  EXPECT_EQ(bar, (ModelChoice{.drift = Drift::kConstant,
                              .poynting = true,
                              .restrainedEnds = true,
                              .taper = true,
                              .shearCentre = true,
                              .foundationLengths = 0.5,
                              .stiffeningStrain = 0.3,
                              .shearModulus_Pa = 5200.0}));
  EXPECT_EQ(paper,
            (ModelChoice{.interpolation = PaperInterpolation::kComponents, .beta = 30.0, .clampLift = true}));
}

TEST_F(SceneFile, RefusesAModelThatItsFormulationDoesNotKnow) {
  for (const char* field : {"interpolation", "beta", "clamp_lift"}) {
    expectBadField([field](Json& j) { j["model"][field] = 1; }, field);
  }
  for (const char* field :
       {"poynting", "restrained_ends", "taper", "shear_centre", "foundation", "stiffening"}) {
    expectBadField(
        [field](Json& j) {
          j["formulation"] = "paper";
          j["model"][field] = 1;
        },
        field);
  }
  expectBadField([](Json& j) { j["model"]["taper"] = "yes"; }, "taper");
  expectBadField([](Json& j) { j["model"]["foundation"] = 0.01; }, "foundation");
  expectBadField([](Json& j) { j["model"]["gamma"] = 1; }, "gamma");
  expectBadField(
      [](Json& j) {
        j["formulation"] = "paper";
        j["model"]["beta"] = 0;
      },
      "beta");
}

TEST_F(SceneFile, NamesAFieldThatItDoesNotKnow) {
  expectBadField([](Json& j) { j["colour"] = "pink"; }, "colour");
  expectBadField([](Json& j) { j["lattice"]["ridge"] = 12; }, "ridge");
  expectBadField([](Json& j) { j["patterns"][0]["angle"] = 12; }, "angle");
  expectBadField([](Json& j) { j["patterns"][0]["task"]["speed"] = 1; }, "speed");
}

TEST_F(SceneFile, NamesAFieldThatIsMissing) {
  for (const char* field :
       {"title", "provenance", "organ", "material", "instrument", "lattice", "patterns"}) {
    expectBadField([field](Json& j) { j.erase(field); }, field);
  }
  for (const char* field :
       {"id", "title", "grasp", "angle_deg", "tolerance_deg", "force_limit_n", "torque_limit_nm", "source"}) {
    expectBadField([field](Json& j) { j["patterns"][1].erase(field); }, field);
  }
  expectBadField([](Json& j) { j["patterns"][0]["task"].erase("axis_to_mm"); }, "axis_to_mm");
}

TEST_F(SceneFile, NamesAFieldOfTheWrongKind) {
  expectBadField([](Json& j) { j["title"] = 3; }, "title");
  expectBadField([](Json& j) { j["lattice"]["ridges"] = "many"; }, "ridges");
  expectBadField([](Json& j) { j["lattice"]["ridges"] = 12.5; }, "ridges");
  expectBadField([](Json& j) { j["lattice"]["fixed_end_mm"] = {1, 2}; }, "fixed_end_mm");
  expectBadField([](Json& j) { j["lattice"]["ridge_zero"] = {0, 0, 0}; }, "ridge_zero");
  expectBadField([](Json& j) { j["patterns"] = Json::array(); }, "patterns");
  expectBadField([](Json& j) { j["restraints"] = 1; }, "restraints");
  expectBadField([](Json& j) { j["restraints"][1].erase("source"); }, "source");
  expectBadField(
      [](Json& j) {
        j["patterns"][0]["task"]["measured"]["point_mm"] = {-47, 4, -68};
      },
      "point_mm");
}

TEST_F(SceneFile, NamesAValueOutOfRangeWithTheRange) {
  expectBadField([](Json& j) { j["lattice"]["ridges"] = 2; }, "ridges");
  expectBadField([](Json& j) { j["lattice"]["sections"] = 361; }, "sections");
  expectBadField([](Json& j) { j["patterns"][0]["grasp"] = 1.5; }, "grasp");
  expectBadField([](Json& j) { j["patterns"][0]["angle_deg"] = 1e9; }, "angle_deg");
  change("scenes/stomach.json", [](Json& j) { j["lattice"]["sections"] = 1; });
  EXPECT_THAT(refusal().what(), HasSubstr("from 2 to 360, not 1"));
}

TEST_F(SceneFile, ListsTheChoicesOfAWord) {
  change("scenes/stomach.json", [](Json& j) { j["lattice"]["mode"] = "magic"; });
  EXPECT_THAT(refusal().what(), AllOf(HasSubstr("'magic'"), HasSubstr("harmonic, straight-axis, automatic")));
}

TEST_F(SceneFile, ListsTheMaterialsWhenOneIsUnknown) {
  change("scenes/stomach.json", [](Json& j) { j["material"] = "steel"; });
  const Error error = refusal();
  EXPECT_EQ(error.code(), ErrorCode::kBadData);
  EXPECT_THAT(error.what(),
              AllOf(HasSubstr("stomach.json"), HasSubstr("'steel'"), HasSubstr("stomach-filled")));
}

TEST_F(SceneFile, RefusesAnInstrumentThatIsNotThere) {
  change("scenes/stomach.json", [](Json& j) { j["instrument"] = "spoon"; });
  EXPECT_EQ(refusal().code(), ErrorCode::kFileMissing);
  EXPECT_THAT(refusal().what(), HasSubstr("spoon.json"));
}

TEST_F(SceneFile, RefusesAPatternIdThatIsUsedTwice) {
  change("scenes/stomach.json", [](Json& j) { j["patterns"][1]["id"] = "organo-axial"; });
  EXPECT_EQ(refusal().code(), ErrorCode::kBadData);
  EXPECT_THAT(refusal().what(), HasSubstr("'organo-axial' is used twice"));
}

TEST_F(SceneFile, RefusesALineOfNoLength) {
  expectBadField([](Json& j) { j["patterns"][0]["task"]["axis_to_mm"] = {-47, 4, -68}; }, "axis_to_mm");
}

TEST_F(SceneFile, RefusesOnePointForSeveralSprings) {
  expectBadField([](Json& j) { j["restraints"][2]["point_mm"] = {1, 2, 3}; }, "point_mm");
}

TEST_F(SceneFile, SaysWhereTheTextIsNoJson) {
  writeFileAtomically(assets_ / "scenes/stomach.json", "{ \"title\": ");
  EXPECT_EQ(refusal().code(), ErrorCode::kBadData);
  EXPECT_THAT(refusal().what(), AllOf(HasSubstr("stomach.json"), HasSubstr("is not JSON")));
  writeFileAtomically(assets_ / "scenes/stomach.json", "[1, 2]");
  EXPECT_EQ(refusal().code(), ErrorCode::kBadData);
}

TEST_F(SceneFile, ChecksMaterialsAsStrictly) {
  change("scenes/materials.json", [](Json& j) { j[0]["shear_modulus_pa"] = 1e6; });
  EXPECT_THAT(refusal("forearm").what(), AllOf(HasSubstr("material 1"), HasSubstr("'shear_modulus_pa'")));
  change("scenes/materials.json", [](Json& j) { j[0] = {{"id", "x"}}; });
  EXPECT_THAT(refusal("forearm").what(), AllOf(HasSubstr("material 1"), HasSubstr("'title'")));
  writeFileAtomically(assets_ / "scenes/materials.json", "{}");
  EXPECT_THAT(refusal("forearm").what(), HasSubstr("must be a list"));
}

TEST_F(SceneFile, RefusesAFolderWithoutScenes) {
  EXPECT_EQ(testing::refusal([&] { return sceneIds(assets_ / "nowhere"); }).code(), ErrorCode::kFileMissing);
}

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
    expectFieldNamed(testing::refusal([&] { return changed(edit); }), "sigmoid.json", field);
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
