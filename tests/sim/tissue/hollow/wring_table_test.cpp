// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/wring_table.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "tests/support/allocation_count.h"

namespace torsio {
namespace {

TubeWall uniform(double thinness) {
  TubeWall wall;
  wall.radius.assign(41, 1.0);
  wall.thickness.assign(41, thinness);
  wall.length = 6.0;
  return wall;
}

const WringTable& table() {
  static const WringTable kTable(uniform(0.05), 0.5 * 0.05);
  return kTable;
}

TEST(WringTable, HasTorqueAndPatencyOfTheTube) {
  // One tube, t / R 0.05, L / R 6, J_m 1, from a prototype of the same equations in another language: P,
  // angle, T / (2 pi G t R^2), patency. P = 0 and 0.5 are rows of the table.
  struct Case {
    double pressure, angle_deg, torque, patency;
  };
  for (const Case& c :
       {Case{0, 30, .0298, .70}, Case{0, 60, .0320, .38}, Case{0, 90, .0299, .11}, Case{0, 120, .0244, 0},
        Case{.5, 45, .1858, 1}, Case{.5, 90, .3633, 1}, Case{.5, 105, .4081, 1}, Case{.5, 120, .3680, .65},
        Case{.5, 135, .2825, .27}, Case{.5, 150, .1949, .03}}) {
    const WrungState state = table().at(radians(c.angle_deg), c.pressure * 0.05);

    EXPECT_NEAR(state.torque / (kTurn * 0.05), c.torque, 0.01 * (c.pressure > 0 ? .4081 : .032))
        << c.pressure << ' ' << c.angle_deg;
    EXPECT_NEAR(state.patency, c.patency, 0.015) << c.pressure << ' ' << c.angle_deg;
  }
}

TEST(WringTable, BetweenItsPressuresAgreesWithTheTube) {
  // 0.35 lies between rows; the same prototype as above. Normalised rows: 1 % of the peak.
  struct Case {
    double angle_deg, torque;
  };
  for (const Case& c : {Case{30, .1093}, Case{60, .2191}, Case{75, .2699}, Case{105, .2792}, Case{120, .2358},
                        Case{135, .1855}}) {
    EXPECT_NEAR(table().at(radians(c.angle_deg), 0.35 * 0.05).torque / (kTurn * 0.05), c.torque, 0.012 * 0.31)
        << c.angle_deg;
  }
}

TEST(WringTable, BetweenItsPressuresIsTheTubeWithinOneInAHundred) {
  // Midway between rows 0.070 and 0.125 (four folds) and 0.195 and 0.281 (five): torque against the peak,
  // waist against R.
  for (const double pressure : {0.0977, 0.2383}) {
    const int waves = foldWaves({0.05, 6.0, pressure, 1.0});
    const WrungTube tube(uniform(0.05), waves);
    WrungShape shape = tube.start();
    double peak = 0.0;
    double torque = 0.0;
    double waist = 0.0;
    for (int degree = 0; radians(degree) < table().closing_rad(pressure * 0.05); degree += 2) {
      tube.solve(radians(degree), pressure * 0.05, shape);
      const WrungState solved = wrungState(tube.wall(), shape, waves);
      const WrungState tabled = table().at(radians(degree), pressure * 0.05);
      peak = std::max(peak, solved.torque);
      torque = std::max(torque, std::abs(tabled.torque - solved.torque));
      waist = std::max(waist, std::abs(tabled.waist - solved.waist));
    }

    EXPECT_LT(torque, 0.01 * peak) << pressure;
    EXPECT_LT(waist, 0.01) << pressure;
  }
}

TEST(WringTable, TorqueGoesOverEvenlyWhereTheNumberOfFoldsChanges) {
  // Three folds up to P 0.026, four up to 0.19, then five: gas that is let out goes through them.
  constexpr double kStep = 2e-5;
  ASSERT_NE(foldWaves({0.05, 6.0, 0.008, 1.0}), foldWaves({0.05, 6.0, 0.031, 1.0}));
  ASSERT_NE(foldWaves({0.05, 6.0, 0.125, 1.0}), foldWaves({0.05, 6.0, 0.195, 1.0}));
  for (const double angle_deg : {12.0, 40.0, 70.0, 100.0}) {
    for (double pressure = 0.002; pressure < 0.2; pressure += kStep) {
      const double before = table().torqueAt(radians(angle_deg), pressure * 0.05);
      const double after = table().torqueAt(radians(angle_deg), (pressure + kStep) * 0.05);

      ASSERT_NEAR(after, before, 0.002 * table().peakTorque(pressure * 0.05)) << pressure << ' ' << angle_deg;
    }
  }
}

TEST(WringTable, ClosesLaterUnderPressure) {
  double before = 0.0;
  for (const double pressure : {0.0, 0.05, 0.1, 0.2, 0.3, 0.5}) {
    const double closing = table().closing_rad(pressure * 0.05);
    EXPECT_GT(closing, before) << pressure;
    EXPECT_NEAR(table().at(closing, pressure * 0.05).patency, 0.0, 0.005) << pressure;
    before = closing;
  }
}

TEST(WringTable, PatencyNeverRisesWithTheAngle) {
  for (const double pressure : {0.0, 0.03, 0.2, 0.5}) {
    double before = 1.0;
    for (int degree = 0; degree <= 400; ++degree) {
      const double patency = table().at(radians(degree), pressure * 0.05).patency;
      EXPECT_LE(patency, before + 1e-12) << pressure << ' ' << degree;
      before = patency;
    }
  }
}

TEST(WringTable, TakesAnAngleOfEitherSign) {
  const WrungState right = table().at(1.0, 0.01);
  const WrungState left = table().at(-1.0, 0.01);

  EXPECT_EQ(left.torque, -right.torque);
  EXPECT_EQ(left.patency, right.patency);
  EXPECT_EQ(left.waist, right.waist);
  EXPECT_EQ(table().at(0.0, 0.01).torque, 0.0);
}

TEST(WringTable, TellsTheTorqueAloneToTheSameBit) {
  for (int k = -400; k <= 400; ++k) {  // to beyond closing
    for (const double pressure : {0.0, 3e-4, 0.011, 0.02, 0.5}) {
      ASSERT_EQ(table().torqueAt(0.0125 * k, pressure), table().at(0.0125 * k, pressure).torque)
          << k << ' ' << pressure;
    }
  }
}

TEST(WringTable, AnswersWithoutAllocation) {
  static_assert(noexcept(std::declval<const WringTable&>().at(1.0, 0.01)));
  static_assert(std::is_trivially_copyable_v<WrungState>);
  const WringTable& queried = table();
  const auto before = testing::allocationCount();
  double sum = 0.0;

  for (int k = 0; k < 1000; ++k) {
    sum += queried.at(0.005 * k, 2e-5 * k).torque;
  }

  EXPECT_EQ(testing::allocationCount(), before);
  EXPECT_GT(sum, 0.0);
}

TEST(WringTable, PeakIsTheLargestTorqueOnTheWay) {
  double most = 0.0;
  for (int k = 0; k <= 2000; ++k) {
    most = std::max(most, table().at(table().closing_rad(0.02) * k / 2000, 0.02).torque);
  }

  EXPECT_NEAR(table().peakTorque(0.02), most, 1e-3 * most);
}

constexpr double kThinness = 0.05;

const WrungOrgan& filled() {
  static const WrungOrgan kOrgan(
      std::vector<WallPlace>(41, WallPlace{0.035, 0.002}), 0.2,
      {.shearModulus_Pa = 1e4, .gentLimit = 0.6, .restPressure_Pa = 1333.0, .highestPressure_Pa = 2000.0});
  return kOrgan;
}

WrungShape solved(double angle_rad, double pressure) {
  const WrungTube tube(uniform(kThinness), foldWaves({kThinness, 6.0, pressure / kThinness, 1.0}));
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
      const WrungPlace place = table().placeAt(static_cast<double>(i) / 40.0, angle, c.pressure * kThinness);
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
  const double closing = table().closing_rad(0.01);
  const auto least = [](double angle) {
    double slack = 1.0;
    for (int k = 0; k <= 40; ++k) {
      slack = std::min(slack, table().placeAt(k / 40.0, angle, 0.01).slack);
    }
    return slack;
  };

  EXPECT_EQ(least(0.1 * closing), 1.0);
  EXPECT_LT(least(0.7 * closing), 0.8);
  EXPECT_LT(least(0.9 * closing), least(0.7 * closing));
}

TEST(WringPlace, FoldsRunTheWayThatTheTubeIsTurned) {
  const double closing = table().closing_rad(0.0);
  const WrungPlace right = table().placeAt(0.5, 0.3 * closing, 0.0);
  const WrungPlace left = table().placeAt(0.5, -0.3 * closing, 0.0);

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

std::vector<WallPlace> places(double radius_mm, double thickness_mm) {
  return std::vector<WallPlace>(41, WallPlace{1e-3 * radius_mm, 1e-3 * thickness_mm});
}

TEST(WrungOrgan, AnEmptyStomachFoldsEarlyAndClosesAt130) {
  // Wall 3 mm, R 40, L 250, G 5 kPa. Prototype in another language, steps of 10 degrees: a plateau of 8 N mm,
  // closed at 130. Donnell: 2.643 (0.075)^(5/4) (6.25)^(1/2) rad = 14.9 degrees.
  const WrungOrgan stomach(places(40, 3), 0.25, {.shearModulus_Pa = 5e3});

  EXPECT_NEAR(1e3 * stomach.peakTorque_Nm(0.0), 8.0, 0.3);
  EXPECT_NEAR(degrees(stomach.closing_rad(0.0)), 125.0, 7.0);
  EXPECT_NEAR(degrees(stomach.onset_rad(0.0)), 14.9, 0.5);
  EXPECT_EQ(stomach.at(radians(180.0), 0.0).patency, 0.0);
}

TEST(WrungOrgan, LettingGasOutMakesASigmoidLimbEasyToTurn) {
  // R 35, L 200, wall 2 mm at 10 mmHg, G 10 kPa, J_m 0.6: 142 N mm at the peak; at 1 mmHg 25 N mm (prototype,
  // the deflated limb with a radius of 30 and a wall of 2.3 mm, here from the same unloaded wall).
  const HollowContent content{.shearModulus_Pa = 1e4,
                              .gentLimit = 0.6,
                              .restPressure_Pa = 10.0 * kPascalsPerMmHg,
                              .highestPressure_Pa = 10.0 * kPascalsPerMmHg};
  const WrungOrgan limb(places(35, 2), 0.2, content);
  const double full_Pa = 10.0 * kPascalsPerMmHg;
  const double vented_Pa = 1.0 * kPascalsPerMmHg;

  EXPECT_NEAR(1e3 * limb.peakTorque_Nm(full_Pa), 142.0, 7.0);
  EXPECT_NEAR(1e3 * limb.peakTorque_Nm(vented_Pa), 25.0, 1.5);
  EXPECT_NEAR(1e3 * limb.at(radians(30.0), full_Pa).torque, 28.0, 1.0);
  EXPECT_NEAR(1e3 * limb.at(radians(90.0), full_Pa).torque, 82.0, 1.5);
  EXPECT_NEAR(1e3 * limb.at(radians(90.0), vented_Pa).torque, 23.0, 1.5);
  EXPECT_NEAR(degrees(limb.closing_rad(full_Pa)), 180.0, 8.0);
  EXPECT_NEAR(degrees(limb.closing_rad(vented_Pa)), 140.0, 5.0);
}

TEST(WrungOrgan, AtRestIsAsWideAsItIsDrawn) {
  const HollowContent content{.shearModulus_Pa = 5e3, .restPressure_Pa = 550.0, .highestPressure_Pa = 550.0};
  const WrungOrgan organ(places(40, 3), 0.25, content);

  const WrungState rest = organ.at(0.0, 550.0);

  EXPECT_NEAR(rest.waist, 0.040, 1e-6);
  EXPECT_NEAR(rest.volume, kPi * 0.04 * 0.04 * 0.25, 1e-8);
  EXPECT_EQ(rest.torque, 0.0);
  EXPECT_EQ(rest.patency, 1.0);
}

TEST(WrungOrgan, SealedGasIsCompressedAsItsVolumeFalls) {
  const HollowContent content{.shearModulus_Pa = 5e3, .restPressure_Pa = 400.0, .highestPressure_Pa = 6000.0};
  const WrungOrgan organ(places(12.5, 2), 0.085, content);

  const double sealed_Pa = organ.sealedPressure_Pa(radians(60.0), 400.0);

  const double before = (101'325.0 + 400.0) * organ.at(0.0, 400.0).volume;
  EXPECT_NEAR((101'325.0 + sealed_Pa) * organ.at(radians(60.0), sealed_Pa).volume / before, 1.0, 1e-6);
  EXPECT_GT(sealed_Pa, 400.0);
}

TEST(WrungOrgan, FoldsFirstWhereItsWallIsThin) {
  std::vector<WallPlace> tapered = places(30, 3);
  for (std::size_t i = 0; i < tapered.size(); ++i) {
    tapered[i].thickness_m = 3e-3 - 1.5e-3 * static_cast<double>(i) / 40.0;
  }
  const WrungOrgan thinner(tapered, 0.2, {.shearModulus_Pa = 5e3});
  const WrungOrgan even(places(30, 3), 0.2, {.shearModulus_Pa = 5e3});

  EXPECT_LT(thinner.onset_rad(0.0), even.onset_rad(0.0));
  EXPECT_GT(thinner.at(radians(60.0), 0.0).waistPlace, 0.5);
  EXPECT_LT(thinner.peakTorque_Nm(0.0), even.peakTorque_Nm(0.0));
}

TEST(WrungOrgan, RefusesNumbersOutOfRange) {
  const HollowContent content{.shearModulus_Pa = 5e3};
  EXPECT_THROW(WrungOrgan(places(30, 0), 0.2, content), Error);
  EXPECT_THROW(WrungOrgan(places(30, 15), 0.2, content), Error);
  EXPECT_THROW(WrungOrgan(places(30, 3), 0.0, content), Error);
  EXPECT_THROW(WrungOrgan(places(30, 3), 0.2, {.shearModulus_Pa = 0.0}), Error);
  EXPECT_THROW(WrungOrgan(places(30, 3), 0.2, {.shearModulus_Pa = 5e3, .restPressure_Pa = -1.0}), Error);
  // Drawn there is a tube; let down, the wall alone would fill it.
  const HollowContent full{.shearModulus_Pa = 5e3, .restPressure_Pa = 1067.0, .highestPressure_Pa = 1067.0};
  EXPECT_THROW(WrungOrgan(places(10, 4), 0.2, full), Error);
}

}  // namespace
}  // namespace torsio
