// SPDX-License-Identifier: GPL-3.0-or-later
// Scene files with one thing wrong: the message names the file, the field and what to do.
#include "sim/scene/scene_file.h"

#include <functional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/support/copied_scene_files.h"

namespace torsio {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using Json = nlohmann::json;

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
    try {
      static_cast<void>(readSceneFile(assets_, id));
    } catch (const Error& error) {
      return error;
    }
    ADD_FAILURE() << "nothing was refused";
    return {ErrorCode::kInternal, "", "", ""};
  }

  void expectBadField(const std::function<void(Json&)>& edit, const std::string& field) {
    const std::string before = readFile(assets_ / "scenes/stomach.json");
    change("scenes/stomach.json", edit);
    const Error error = refusal();
    EXPECT_EQ(error.code(), ErrorCode::kBadData) << field;
    EXPECT_THAT(error.what(), AllOf(HasSubstr("stomach.json"), HasSubstr("'" + field + "'"))) << field;
    EXPECT_FALSE(error.remedy().empty()) << field;
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
  EXPECT_THAT(refusal().what(), AllOf(HasSubstr("stomach.json"), HasSubstr("not valid JSON")));
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
  try {
    static_cast<void>(sceneIds(assets_ / "nowhere"));
    FAIL() << "nothing was refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kFileMissing);
  }
}

}  // namespace
}  // namespace torsio
