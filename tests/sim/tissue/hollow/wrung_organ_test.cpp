// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/hollow/wrung_organ.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"

namespace torsio {
namespace {

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
