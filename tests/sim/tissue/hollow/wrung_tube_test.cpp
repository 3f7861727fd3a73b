// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/wrung_tube.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/base/angle.h"
#include "sim/base/error.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wring_table.h"

namespace torsio {
namespace {

constexpr double kNeoHookean = 1e9;

TubeWall uniform(double thinness, double slenderness, double gentLimit, int nodes = 41) {
  TubeWall wall;
  wall.radius.assign(static_cast<std::size_t>(nodes), 1.0);
  wall.thickness.assign(static_cast<std::size_t>(nodes), thinness);
  wall.length = slenderness;
  wall.gentLimit = gentLimit;
  return wall;
}

/// T / (2 pi G t R^2).
double scaled(const WrungShape& shape, double thinness) {
  return shape.torque / (kTurn * thinness);
}

/// Turned in steps of at most 10 degrees.
WrungShape turned(const WrungTube& tube, double angle_deg, double pressure) {
  WrungShape shape = tube.start();
  const int steps = static_cast<int>(angle_deg / 10.0) + 1;
  for (int k = 0; k <= steps; ++k) {
    tube.solve(radians(angle_deg * k / steps), pressure, shape);
  }
  return shape;
}

struct MembraneRun {
  double thinness, pressure, gentLimit, waves, angle_deg, torque, lumen;
};

std::vector<MembraneRun> membraneRuns() {
  std::ifstream file(std::string(TORSIO_TEST_DATA) + "/hollow/membrane_3d.csv");
  std::vector<MembraneRun> runs;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 't') {
      continue;
    }
    std::replace(line.begin(), line.end(), ',', ' ');
    std::istringstream words(line);
    MembraneRun run{};
    words >> run.thinness >> run.pressure >> run.gentLimit >> run.waves >> run.angle_deg >> run.torque >>
        run.lumen;
    run.gentLimit = run.gentLimit > 0.0 ? run.gentLimit : kNeoHookean;
    runs.push_back(run);
  }
  return runs;
}

TEST(WrungTube, HasTheTorqueOfHeldOutRunsInThreeDimensions) {
  const std::vector<MembraneRun> runs = membraneRuns();
  ASSERT_EQ(runs.size(), 28U);
  double sum = 0.0;
  for (const MembraneRun& run : runs) {
    const WrungTube tube(uniform(run.thinness, 6.0, run.gentLimit), static_cast<int>(run.waves));

    const WrungShape shape = turned(tube, run.angle_deg, run.pressure * run.thinness);

    const double ratio = scaled(shape, run.thinness) / run.torque;
    EXPECT_GT(ratio, 0.85) << run.thinness << ' ' << run.pressure << ' ' << run.angle_deg;
    EXPECT_LT(ratio, 1.2) << run.thinness << ' ' << run.pressure << ' ' << run.angle_deg;
    EXPECT_LT(shape.residual, 1e-9);
    sum += ratio;
  }
  EXPECT_NEAR(sum / static_cast<double>(runs.size()), 1.0, 0.03);
}

TEST(WrungTube, BelowTheOnsetCarriesTheTorqueOfATautTube) {
  // P = 0.2, L / R 40: the clamped ends, which the long tube does not know, are a small part of it.
  const double pressure = 0.2;
  const double omega = 0.1;
  TubeWall wall = uniform(0.05, 40.0, 1.0, 81);
  const TautTube taut = tautTube(pressure, 1.0, omega);
  wall.ends = {taut.stretch, taut.stretch};
  const WrungTube tube(wall, 4);
  WrungShape shape = tube.start();

  for (int k = 0; k <= 8; ++k) {
    tube.solve(40.0 * omega * k / 8, pressure * 0.05, shape);
  }

  EXPECT_NEAR(scaled(shape, 0.05) / taut.torque, 1.0, 1e-3);
  EXPECT_LT(shape.folding, 0.0);
}

TEST(WrungTube, TorqueIsTheSlopeOfTheEnergy) {
  // Trapezoids of 5 degrees, 0 to 150, through onset and neck.
  for (const double pressure : {0.2, 0.5}) {
    const WrungTube tube(uniform(0.05, 6.0, 1.0), 5);
    WrungShape shape = tube.start();
    tube.solve(0.0, pressure * 0.05, shape);
    const double before = shape.energy;
    double work = 0.0;
    double torque = shape.torque;
    for (int degree = 5; degree <= 150; degree += 5) {
      tube.solve(radians(degree), pressure * 0.05, shape);
      work += radians(5.0) * 0.5 * (torque + shape.torque);
      torque = shape.torque;
    }

    EXPECT_NEAR(work / (shape.energy - before), 1.0, 3e-3) << pressure;
  }
}

TEST(WrungTube, GoesBackTheWayItCame) {
  for (const double pressure : {0.2, 0.5}) {
    const WrungTube tube(uniform(0.05, 6.0, 1.0), 5);
    WrungShape shape = tube.start();
    std::vector<double> up;
    double peak = 0.0;
    for (int degree = 0; degree <= 200; degree += 10) {
      tube.solve(radians(degree), pressure * 0.05, shape);
      up.push_back(shape.torque);
      peak = std::max(peak, shape.torque);
    }
    for (int degree = 200; degree >= 0; degree -= 10) {
      tube.solve(radians(degree), pressure * 0.05, shape);
      EXPECT_NEAR(shape.torque, up.back(), 0.015 * peak) << pressure << ' ' << degree;
      up.pop_back();
    }
  }
}

TEST(WrungTube, KeepsTheNeckOnTheSideOfTheTurnedEnd) {
  for (const int nodes : {41, 61}) {
    for (const double pressure : {0.2, 0.5}) {
      const WrungTube tube(uniform(0.05, 6.0, 1.0, nodes), 5);

      const WrungShape shape = turned(tube, 135.0, pressure * 0.05);

      EXPECT_GT(wrungState(tube.wall(), shape, 5).waistPlace, 0.5) << nodes << ' ' << pressure;
    }
  }
}

TEST(WrungTube, HardlyDependsOnTheMesh) {
  const WrungTube coarse(uniform(0.05, 6.0, 1.0, 41), 5);
  const WrungTube fine(uniform(0.05, 6.0, 1.0, 121), 5);
  for (const double angle_deg : {60.0, 105.0, 135.0}) {
    const double few = turned(coarse, angle_deg, 0.2 * 0.05).torque;
    const double many = turned(fine, angle_deg, 0.2 * 0.05).torque;
    EXPECT_NEAR(few / many, 1.0, 0.02) << angle_deg;
  }
}

TEST(WrungTube, ComesShorterWhereItsEndsAreFree) {
  // A prototype in another language with the same pull: z 6.0399 at rest, 5.7229 at 60 degrees.
  TubeWall wall = uniform(0.05, 6.0, kNeoHookean);
  wall.freeLength = true;
  wall.pull = 0.02 * kTurn * 0.05;
  const WrungTube tube(wall, 3);
  WrungShape rest = tube.start();
  tube.solve(0.0, 0.0, rest);

  const WrungShape shape = turned(tube, 60.0, 0.0);

  EXPECT_NEAR(rest.nodes.back().z - shape.nodes.back().z, 0.3170, 0.001);
  EXPECT_LT(shape.torque, turned(WrungTube(uniform(0.05, 6.0, kNeoHookean), 3), 60.0, 0.0).torque);
}

TEST(WrungTube, RefusesAWallWithoutThickness) {
  TubeWall wall = uniform(0.05, 6.0, 1.0);
  wall.thickness[3] = 0.0;
  EXPECT_THROW(WrungTube(wall, 3), Error);
  EXPECT_THROW(WrungTube(uniform(0.05, 0.0, 1.0), 3), Error);
  EXPECT_THROW(WrungTube(uniform(0.05, 6.0, 1.0, 4), 3), Error);
}

}  // namespace
}  // namespace torsio
