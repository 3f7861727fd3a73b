// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "tests/support/allocation_count.h"

namespace torsio {
namespace {

constexpr double kThinness = 0.05;

TubeWall tubeWall() {
  TubeWall wall;
  wall.radius.assign(41, 1.0);
  wall.thickness.assign(41, kThinness);
  wall.length = 6.0;
  return wall;
}

const WringTable& profiles() {
  static const WringTable kTable(tubeWall(), 0.5 * kThinness);
  return kTable;
}

const WrungOrgan& filled() {
  static const WrungOrgan kOrgan(
      std::vector<WallPlace>(41, WallPlace{0.035, 0.002}), 0.2,
      {.shearModulus_Pa = 1e4, .gentLimit = 0.6, .restPressure_Pa = 1333.0, .highestPressure_Pa = 2000.0});
  return kOrgan;
}

WrungShape solved(double angle_rad, double pressure) {
  const WrungTube tube(tubeWall(), foldWaves({kThinness, 6.0, pressure / kThinness, 1.0}));
  WrungShape shape = tube.start();
  for (double angle = 0.0; angle < angle_rad; angle += 0.03) {
    tube.solve(angle, pressure, shape);
  }
  tube.solve(angle_rad, pressure, shape);
  return shape;
}

TEST(WringPlace, HasTheProfileOfTheTubeBetweenTheAnglesOfItsTable) {
  // P = 0 and 0.5 are rows of the table; the angles lie between its angles. A neck 0.2 R wide is steep there:
  // 0.02 R.
  struct Case {
    double pressure, angle_deg;
  };
  for (const Case& c : {Case{0.0, 5.0}, Case{0.0, 37.0}, Case{0.0, 71.0}, Case{0.5, 50.0}, Case{0.5, 101.0},
                        Case{0.5, 127.0}}) {
    const double angle = radians(c.angle_deg);
    const WrungShape shape = solved(angle, c.pressure * kThinness);

    for (std::size_t i = 0; i < shape.nodes.size(); ++i) {
      const WrungPlace place =
          profiles().placeAt(static_cast<double>(i) / 40.0, angle, c.pressure * kThinness);
      EXPECT_NEAR(place.radius, shape.nodes[i].r, 0.02) << c.pressure << ' ' << c.angle_deg << ' ' << i;
      EXPECT_NEAR(place.turn * angle, shape.nodes[i].turn_rad, 0.02 * angle)
          << c.pressure << ' ' << c.angle_deg << ' ' << i;
      EXPECT_NEAR(place.shift, shape.nodes[i].z, 0.02) << c.pressure << ' ' << c.angle_deg << ' ' << i;
    }
  }
}

TEST(WringPlace, IsAsDrawnAtRest) {
  for (int k = 0; k <= 100; ++k) {
    const WrungPlace place = filled().placeAt(0.01 * k, 0.0, 1333.0);

    EXPECT_EQ(place.radius, 1.0) << k;
    EXPECT_EQ(place.shift, 0.0) << k;
    EXPECT_EQ(place.slack, 1.0) << k;
    EXPECT_NEAR(place.turn, 0.01 * k, 0.01) << k;
  }
}

TEST(WringPlace, TurnsFromNothingAtTheFixedEndToAllAtTheMobileEnd) {
  for (const double angle : {0.0, 0.3, 1.0, 2.0, 3.0, 5.0}) {
    double before = 0.0;
    EXPECT_EQ(filled().placeAt(0.0, angle, 1000.0).turn, 0.0);
    EXPECT_NEAR(filled().placeAt(1.0, angle, 1000.0).turn, 1.0, 1e-12);
    for (int k = 1; k <= 200; ++k) {
      const double turn = filled().placeAt(0.005 * k, angle, 1000.0).turn;
      EXPECT_GE(turn, before - 1e-9) << angle << ' ' << k;
      before = turn;
    }
  }
}

TEST(WringPlace, HasASlackWallOnlyWhereItFolds) {
  const double closing = profiles().closing_rad(0.01);
  const auto least = [](double angle) {
    double slack = 1.0;
    for (int k = 0; k <= 40; ++k) {
      slack = std::min(slack, profiles().placeAt(k / 40.0, angle, 0.01).slack);
    }
    return slack;
  };

  EXPECT_EQ(least(0.1 * closing), 1.0);
  EXPECT_LT(least(0.7 * closing), 0.8);
  EXPECT_LT(least(0.9 * closing), least(0.7 * closing));
}

TEST(WringPlace, FoldsRunTheWayThatTheTubeIsTurned) {
  const double closing = profiles().closing_rad(0.0);
  const WrungPlace right = profiles().placeAt(0.5, 0.3 * closing, 0.0);
  const WrungPlace left = profiles().placeAt(0.5, -0.3 * closing, 0.0);

  // At 45 degrees, the most that shear alone can bring, half the length would be 3 rad.
  EXPECT_GT(right.foldTurn, 0.5);
  EXPECT_LT(right.foldTurn, 3.0);
  EXPECT_EQ(left.foldTurn, -right.foldTurn);
  EXPECT_EQ(left.radius, right.radius);
  EXPECT_EQ(left.turn, right.turn);
}

TEST(WringPlace, AnswersWithoutAllocation) {
  static_assert(noexcept(std::declval<const WrungOrgan&>().placeAt(0.5, 1.0, 10.0)));
  const WrungOrgan& organ = filled();
  const auto before = testing::allocationCount();
  double sum = 0.0;

  for (int k = 0; k < 1000; ++k) {
    sum += organ.placeAt(0.001 * k, 0.004 * k, 2.0 * k).radius;
  }

  EXPECT_EQ(testing::allocationCount(), before);
  EXPECT_GT(sum, 0.0);
}

}  // namespace
}  // namespace torsio
