// SPDX-License-Identifier: GPL-3.0-or-later
// Wrung tubes beyond the onset of their folds against CalculiX (tests/data/hollow): a program of other
// people, with solid elements, so that neither the folds nor their bending are put in.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wring_table.h"

namespace torsio {
namespace {

constexpr double kLocksNever = 1e9;  // J_m of a neo-Hookean wall
constexpr double kCalculixLength = 6.0;

struct CalculixRun {
  double thinness, pressure, waves, angle_deg, torque, lumen;
};

std::vector<CalculixRun> calculixRuns(const std::string& name) {
  std::ifstream file(std::string(TORSIO_TEST_DATA) + "/hollow/" + name);
  std::vector<CalculixRun> runs;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 't') {
      continue;
    }
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    CalculixRun run{};
    words >> run.thinness >> run.pressure >> run.waves >> run.angle_deg >> run.torque >> run.lumen;
    runs.push_back(run);
  }
  return runs;
}

struct WrungNumbers {
  double torque = 0.0;  // T / (2 pi G t R^2)
  double lumen = 1.0;   // least radius of the lumen over R
};

// The tube as the product computes it, with the folds that it expects.
WrungNumbers wrungNumbers(const CalculixRun& run) {
  TubeWall wall;
  wall.radius.assign(41, 1.0);
  wall.thickness.assign(41, run.thinness);
  wall.length = kCalculixLength;
  wall.gentLimit = kLocksNever;
  const int waves = foldWaves({run.thinness, kCalculixLength, run.pressure, kLocksNever});
  const WrungTube tube(wall, waves);
  WrungShape shape = tube.start();
  const int steps = static_cast<int>(run.angle_deg / 10.0) + 1;
  for (int k = 0; k <= steps; ++k) {
    tube.solve(radians(run.angle_deg * k / steps), run.pressure * run.thinness, shape);
  }
  const double packed = 2.0 * run.thinness;
  const double open = wrungState(tube.wall(), shape, waves).patency;
  return {shape.torque / (kTurn * run.thinness), std::sqrt(open * (1.0 - packed) + packed)};
}

// What the foreign program shows, and how far the product is from it, not what one would wish.
TEST(WrungCalculix, AnEmptyThinTubeHasTheTorqueWithinAQuarterAndALumenSlightlyTooWide) {
  for (const CalculixRun& run : calculixRuns("calculix_3d.csv")) {
    if (run.thinness > 0.05 || run.pressure > 0.0) {
      continue;
    }
    const WrungNumbers tube = wrungNumbers(run);

    EXPECT_GT(tube.torque / run.torque, 0.75) << run.angle_deg;
    EXPECT_LT(tube.torque / run.torque, 1.10) << run.angle_deg;
    EXPECT_GT(tube.lumen - run.lumen, 0.0) << run.angle_deg;
    EXPECT_LT(tube.lumen - run.lumen, 0.09) << run.angle_deg;
  }
}

TEST(WrungCalculix, AnEmptyThickTubeComesOutTooStiffByAThird) {
  int runs = 0;
  for (const CalculixRun& run : calculixRuns("calculix_3d.csv")) {
    if (run.thinness < 0.1 || run.pressure > 0.0) {
      continue;
    }
    const WrungNumbers tube = wrungNumbers(run);

    EXPECT_GT(tube.torque / run.torque, 0.99) << run.angle_deg;
    EXPECT_LT(tube.torque / run.torque, 1.33) << run.angle_deg;
    EXPECT_NEAR(tube.lumen, run.lumen, 0.04) << run.angle_deg;
    ++runs;
  }
  EXPECT_EQ(runs, 9);
}

TEST(WrungCalculix, ATubeUnderPressureHasTorqueAndLumenWithinATenth) {
  double sum = 0.0;
  int runs = 0;
  for (const CalculixRun& run : calculixRuns("calculix_3d.csv")) {
    if (run.pressure == 0.0) {
      continue;
    }
    const WrungNumbers tube = wrungNumbers(run);

    EXPECT_NEAR(tube.torque / run.torque, 1.0, 0.11)
        << run.thinness << ' ' << run.pressure << ' ' << run.angle_deg;
    EXPECT_NEAR(tube.lumen, run.lumen, 0.11) << run.thinness << ' ' << run.pressure << ' ' << run.angle_deg;
    sum += tube.torque / run.torque;
    ++runs;
  }
  EXPECT_EQ(runs, 21);
  EXPECT_NEAR(sum / runs, 0.97, 0.03);
}

}  // namespace
}  // namespace torsio
