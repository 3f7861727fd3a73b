// SPDX-License-Identifier: GPL-3.0-or-later
// How far the answers of the law of the wall hold, in a state, over a scene and in a recording.
#include "sim/scene/hollow_validity.h"

#include <algorithm>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/scene/scene_parameters.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wrung_tube.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

using testing::twistedOrgan;

/// An empty tube of R 20 mm and t/R 0.05, folded.
WrungCase foldedTube(const std::vector<WallPlace>& places) {
  return {.places = places,
          .length_m = 0.12,
          .shearModulus_Pa = 5'000.0,
          .twist_rad = radians(60.0),
          .taut_rad = radians(10.0),
          .closing_rad = radians(105.0)};
}

TEST(WallValidity, AnEmptyFoldedTubeIsOffByAThirdAndOneUnderPressureByATenth) {
  const std::vector<WallPlace> places(5, {0.020, 0.001});
  WrungCase wrung = foldedTube(places);

  const WallValidity empty = wallValidity(wrung);
  wrung.pressure_Pa = 50.0;  // P 0.2
  const WallValidity filled = wallValidity(wrung);
  wrung.twist_rad = radians(-5.0);
  const WallValidity taut = wallValidity(wrung);

  EXPECT_TRUE(empty.beyond.empty() && filled.beyond.empty() && taut.beyond.empty());
  EXPECT_GT(empty.torqueError.value()[1], 0.3);
  EXPECT_LT(empty.torqueError.value()[0], -0.12);
  EXPECT_LT(filled.torqueError.value()[1], 0.12);
  EXPECT_GT(filled.torqueError.value()[0], -0.12);
  EXPECT_GT(taut.torqueError.value()[0], filled.torqueError.value()[0]);
}

TEST(WallValidity, FoldsHoldToALowerPressureAndAThinnerWallThanAWallWithoutThem) {
  const std::vector<WallPlace> thin(5, {0.020, 0.001});
  const std::vector<WallPlace> thick(5, {0.020, 0.005});
  WrungCase blown = foldedTube(thin);
  blown.pressure_Pa = 250.0;  // P 1
  WrungCase stout = foldedTube(thick);
  WrungCase packed = foldedTube(thin);
  packed.twist_rad = radians(106.0);

  EXPECT_NE(wallValidity(blown).beyond.str().find("folds are checked up to 0.5"), std::string::npos);
  EXPECT_NE(wallValidity(stout).beyond.str().find("checked up to 0.15"), std::string::npos);
  EXPECT_NE(wallValidity(packed).beyond.str().find("packed with wall"), std::string::npos);
  EXPECT_FALSE(wallValidity(packed).torqueError.has_value());
  blown.twist_rad = stout.twist_rad = radians(9.0);
  EXPECT_TRUE(wallValidity(blown).beyond.empty());
  EXPECT_TRUE(wallValidity(stout).beyond.empty());
}

TEST(WallValidity, PressureAndThicknessAreThoseOfTheWallAtNoPressure) {
  // Drawn at P 0.87, t/R 0.1: unloaded P 0.6, t/R 0.145, as in tests/data/hollow/calculix_pressed.csv.
  const std::vector<WallPlace> places(5, {0.0125, 0.00125});
  WrungCase wrung{.places = places,
                  .length_m = 0.11,
                  .shearModulus_Pa = 5'000.0,
                  .restPressure_Pa = 435.0,
                  .pressure_Pa = 435.0,
                  .twist_rad = radians(30.0),
                  .taut_rad = radians(10.0),
                  .closing_rad = radians(90.0)};
  EXPECT_NE(wallValidity(wrung).beyond.str().find("of 0.6"), std::string::npos) << wallValidity(wrung).beyond;
}

/// A tube of R 1 computed by CalculiX: tests/data/hollow/README.md.
struct SolidRun {
  double thinness, pressure, length, gentLimit, angle_deg, torque;
};

std::vector<SolidRun> solidRuns() {
  constexpr double kNeverLocks = 1e9;
  std::vector<SolidRun> runs;
  for (const char* name : {"calculix_3d.csv", "calculix_pressed.csv"}) {
    std::ifstream file(std::string(TORSIO_TEST_DATA) + "/hollow/" + name);
    for (std::string line; std::getline(file, line);) {
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream words(line);
      std::vector<double> row;
      for (double number = 0.0; words >> number;) {
        row.push_back(number);
      }
      if (row.size() == 6) {
        runs.push_back({row[0], row[1], 6.0, kNeverLocks, row[3], row[4]});
      } else if (row.size() == 8) {
        runs.push_back({row[0], row[1], row[2], row[3] > 0.0 ? row[3] : kNeverLocks, row[5], row[6]});
      }
    }
  }
  return runs;
}

/// Turned as far as a run in steps of `step_deg`.
WrungShape turnedBy(const SolidRun& run, int waves, double step_deg) {
  TubeWall wall;
  wall.radius.assign(41, 1.0);
  wall.thickness.assign(41, run.thinness);
  wall.length = run.length;
  wall.gentLimit = run.gentLimit;
  wall.foldsNeedRoom = true;
  const WrungTube tube(wall, waves);
  WrungShape shape = tube.start();
  const int steps = static_cast<int>(run.angle_deg / step_deg) + 1;
  for (int k = 0; k <= steps; ++k) {
    tube.solve(radians(run.angle_deg * k / steps), run.pressure * run.thinness, shape);
  }
  return shape;
}

/// In steps short enough for where it snaps into its folds.
WrungShape turned(const SolidRun& run, int waves) {
  for (const double step_deg : {10.0, 7.0, 3.0}) {
    try {
      return turnedBy(run, waves, step_deg);
    } catch (const Error&) {
    }
  }
  return turnedBy(run, waves, 1.0);
}

// The range of the error is not a wish: no stored run of solid elements lies outside.
TEST(WallValidity, TheRangeOfTheTorqueHoldsForEveryTubeOfSolidElements) {
  constexpr double kShear_Pa = 5'000.0;
  constexpr double kRounding = 0.005;
  int checked = 0;
  int beyond = 0;
  for (const SolidRun& run : solidRuns()) {
    const int waves = foldWaves({run.thinness, run.length, run.pressure, run.gentLimit});
    const WrungShape shape = turned(run, waves);
    const std::vector<WallPlace> places(5, {0.020, 0.020 * run.thinness});
    const double turn_rad = radians(run.angle_deg);
    const WallValidity validity = wallValidity({.places = places,
                                                .length_m = 0.020 * run.length,
                                                .shearModulus_Pa = kShear_Pa,
                                                .gentLimit = run.gentLimit,
                                                .pressure_Pa = run.pressure * kShear_Pa * run.thinness,
                                                .twist_rad = turn_rad,
                                                .taut_rad = shape.folding < 0.0 ? kTurn : 0.0,
                                                .closing_rad = kTurn});
    if (!validity.torqueError) {
      ++beyond;
      continue;
    }
    ++checked;
    const double error = shape.torque / (kTurn * run.thinness) / run.torque - 1.0;
    EXPECT_GT(error, validity.torqueError->at(0) - kRounding)
        << run.thinness << ' ' << run.pressure << ' ' << run.angle_deg;
    EXPECT_LT(error, validity.torqueError->at(1) + kRounding)
        << run.thinness << ' ' << run.pressure << ' ' << run.angle_deg;
  }
  EXPECT_GE(checked, 80);
  EXPECT_LE(beyond, 8);  // folded under more than P 0.5, where solid elements fold later
}

// The spans of shipped scenes themselves, at the pressure with which they come.
TEST(WallValidity, ShippedSpansHaveTheTorqueOfSolidElementsAsFarAsTheyAreValid) {
  std::ifstream file(std::string(TORSIO_TEST_DATA) + "/hollow/calculix_spans.csv");
  int checked = 0;
  for (std::string line; std::getline(file, line);) {
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    std::string id;
    int span = 0;
    double angle_deg = 0.0;
    double torque_Nmm = 0.0;
    if (!(words >> id >> span >> angle_deg >> torque_Nmm)) {
      continue;
    }
    const HollowOrgan& organ = *twistedOrgan(id).hollow;
    const OrganState lies = organ.stateAt(radians(angle_deg));
    const WallValidity validity = wallValidity(organ, lies);
    if (!validity.torqueError) {
      continue;
    }
    const double torque_Nm = organ.tube(span)->torque_Nm(radians(angle_deg), lies.hollow.reading.pressure_Pa);
    const double error = torque_Nm / (1e-3 * torque_Nmm) - 1.0;
    EXPECT_GT(error, validity.torqueError->at(0)) << id << ' ' << angle_deg;
    EXPECT_LT(error, validity.torqueError->at(1)) << id << ' ' << angle_deg;
    ++checked;
  }
  EXPECT_GE(checked, 16);
}

struct ShippedValidity {
  const char* scene;
  double validTo_deg;
};

class ShippedWall : public ::testing::TestWithParam<ShippedValidity> {};

// assets/scenes/README.md: the stomach that turns across and the sigmoid come folded under their gas, or
// shut.
TEST_P(ShippedWall, IsValidUpToTheTurnThatTheDocumentsSay) {
  const HollowOrgan& organ = *twistedOrgan(GetParam().scene).hollow;

  const ValidTurn valid = validTurn(organ);

  EXPECT_NEAR(degrees(valid.to_rad), GetParam().validTo_deg, 1.5);
  const InitialTwist& start = organ.detorsion().start;
  const Text asItComes = wallValidity(organ, organ.stateAt(start.sign * start.most_rad)).beyond;
  EXPECT_EQ(asItComes.empty(), valid.to_rad >= start.most_rad);
  EXPECT_NE(validityText(organ).str().find("solid elements"), std::string::npos);
}

// The swing of the stomach ends some 15 degrees beyond its largest start.
INSTANTIATE_TEST_SUITE_P(Scenes, ShippedWall,
                         ::testing::Values(ShippedValidity{"small-bowel-loop", 222.0},
                                           ShippedValidity{"gastric-organo-axial", 227.0},
                                           ShippedValidity{"gastric-mesentero-axial", 118.0},
                                           ShippedValidity{"sigmoid", 104.0}));

TEST(WallValidity, OfACordHasNoLimit) {
  const HollowOrgan& testis = *twistedOrgan("testis").hollow;

  EXPECT_GT(validTurn(testis).to_rad, 1e6);
  EXPECT_TRUE(validTurn(testis).beyond.empty());
  EXPECT_TRUE(validityText(testis).empty());
  EXPECT_FALSE(wallValidity(testis, testis.stateAt(1.0)).torqueError.has_value());
}

std::string hashOf(const std::string& parameters) {
  Digest digest;
  digest.update(parameters);
  return digest.hex();
}

TEST(RecordedValidity, StandsBesideTheParametersButNotInTheirHash) {
  const Scene& scene = twistedOrgan("sigmoid");

  const std::optional<RecordedValidity> recorded = recordedValidity(scene.parametersJson);
  const std::string before = withoutValidity(scene.parametersJson);

  ASSERT_TRUE(recorded.has_value());
  EXPECT_EQ(recorded->validTo_rad, validTurn(*scene.hollow).to_rad);
  EXPECT_EQ(recorded->beyond, validTurn(*scene.hollow).beyond.str());
  EXPECT_FALSE(recordedValidity(before).has_value());
  EXPECT_EQ(hashOf(before), scene.parameterHash);
  EXPECT_EQ(withoutValidity(before), before);
  EXPECT_EQ(withoutValidity("no JSON"), "no JSON");
}

TEST(RecordedValidity, ARecordingFromBeforeItWasStoredFindsItsScene) {
  const Scene& scene = twistedOrgan("testis");
  const Scene& loop = twistedOrgan("small-bowel-loop");
  for (const std::string& parameters : {scene.parametersJson, withoutValidity(loop.parametersJson)}) {
    const bool cord = parameters == scene.parametersJson;
    SceneRequest request = sceneRequestFor(parameters);
    request.assets = testing::shippedRequest().assets;
    request.id = cord ? "testis" : "small-bowel-loop";

    EXPECT_EQ(loadScene(request).parameterHash, (cord ? scene : loop).parameterHash);
    EXPECT_FALSE(recordedValidity(parameters).has_value());
  }
}

}  // namespace
}  // namespace torsio
