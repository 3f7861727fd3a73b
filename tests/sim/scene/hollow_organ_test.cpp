// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/hollow_organ.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/organ_wall.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wrung_tube.h"
#include "tests/sim/servo/hollow_bar.h"

namespace torsio {
namespace {

/// A tube of two limbs that are held at the bar's ends, 90 mm each; 70 mm between them are mobile.
const Scene& twoLimbs() {
  static const Scene kScene = [] {
    Detorsion limbs = twistedTube();
    limbs.spans = {{0.0, 0.36}, {1.0, 0.64}};
    Scene scene = barScene();
    scene.pattern.graspArc = 0.5;
    scene.pattern.detorsion = std::make_shared<const Detorsion>(limbs);
    scene.hollow =
        std::make_shared<const HollowOrgan>(HollowOrgan::Parts{.lattice = &scene.lattice(),
                                                               .shearModulus_Pa = kBarShear_Pa,
                                                               .graspArc = 0.5,
                                                               .detorsion = limbs,
                                                               .vertices_m = scene.mesh.vertices_m});
    return scene;
  }();
  return kScene;
}

TEST(HollowOrgan, AddsTheTorquesOfItsLimbs) {
  const HollowOrgan& organ = *twoLimbs().hollow;
  const double pressure_Pa = organ.detorsion().wall.pressure_Pa;

  for (const double angle_rad : {-2.0, 0.4, 1.0, 3.0}) {
    const double both_Nm =
        organ.tube(0)->at(angle_rad, pressure_Pa).torque + organ.tube(1)->at(angle_rad, pressure_Pa).torque;

    EXPECT_DOUBLE_EQ(organ.torque_Nm(angle_rad, pressure_Pa), both_Nm);
    EXPECT_DOUBLE_EQ(organ.torque_Nm(-angle_rad, pressure_Pa), -both_Nm);
  }
  EXPECT_NEAR(organ.closing_rad(pressure_Pa),
              std::min(organ.tube(0)->closing_rad(pressure_Pa), organ.tube(1)->closing_rad(pressure_Pa)),
              0.0);
}

/// The tube of twistedTube() with its content as a gas that stays in.
Detorsion sealedTube() {
  Detorsion sealed = twistedTube();
  sealed.wall.restPressure_Pa = 4.0 * kPascalsPerMmHg;
  sealed.wall.pressure_Pa = 4.0 * kPascalsPerMmHg;
  sealed.wall.sealed = true;
  return sealed;
}

/// Volume of a sealed organ of one span at an angle and a pressure, m^3, without a table: the span by
/// Newton's method, the mobile part by the balance of its hoops.
double solvedVolume_m3(const Scene& scene, double angle_rad, double pressure_Pa) {
  const HollowWall& wall = scene.hollow->detorsion().wall;
  const double span_m = scene.hollow->detorsion().spans[0].mobile * scene.hollow->length_m();
  const double mobile_m = scene.hollow->length_m() - span_m;
  const auto [radius_m, thickness_m] =
      wallPlaces(scene.lattice(), WallMap(wall.thickness_m), 0.0, span_m)[20];
  const double rest = restStretch(wall.restPressure_Pa * radius_m / (kBarShear_Pa * thickness_m), 1.0);
  const double unit_m = radius_m / rest;
  const double thinness = thickness_m * rest / unit_m;
  const TubePlace place{thinness, span_m / unit_m, pressure_Pa / (kBarShear_Pa * thinness), 1.0};
  TubeWall tubeWall;
  tubeWall.radius.assign(41, 1.0);
  tubeWall.thickness.assign(41, thinness);
  tubeWall.length = span_m / unit_m;
  tubeWall.ends = {rest, rest};
  const WrungTube tube(tubeWall, foldWaves(place));
  WrungShape shape = tube.start();
  constexpr int kSteps = 60;
  for (int k = 0; k <= kSteps; ++k) {
    tube.solve(angle_rad * k / kSteps, pressure_Pa / kBarShear_Pa, shape);
  }
  const double widened_m = unit_m * tautTube(place.pressure, 1.0, 0.0).stretch;
  return unit_m * unit_m * unit_m * shape.volume + kPi * widened_m * widened_m * mobile_m;
}

TEST(HollowOrgan, KeepsPressureTimesVolumeOfAGasThatStaysIn) {
  const Scene scene = hollowScene(sealedTube());
  const HollowOrgan& organ = *scene.hollow;
  const double start_Pa = organ.detorsion().wall.pressure_Pa;
  const double gas_J = organ.gas_J(radians(120.0), start_Pa);

  EXPECT_NEAR(organ.sealedPressure_Pa(radians(120.0), gas_J), start_Pa, 1e-5 * start_Pa);
  double before_Pa = start_Pa + 1.0;
  for (const double angle_deg : {120.0, 105.0, 90.0, 60.0, 0.0}) {
    const double pressure_Pa = organ.sealedPressure_Pa(radians(angle_deg), gas_J);

    EXPECT_LT(pressure_Pa, before_Pa) << angle_deg;
    const double solved_m3 = solvedVolume_m3(scene, radians(angle_deg), pressure_Pa);
    EXPECT_NEAR((101'325.0 + pressure_Pa) * solved_m3, gas_J, 2e-3 * gas_J) << angle_deg;
    before_Pa = pressure_Pa;
  }
  EXPECT_LT(before_Pa, 0.95 * start_Pa);
  EXPECT_NEAR(organ.sealedPressure_Pa(radians(500.0), gas_J), start_Pa, 1e-5 * start_Pa);  // the table's end
}

TEST(HollowOrgan, KnowsNoGasWhereThePressureIsGiven) {
  const Scene scene = hollowScene(twistedTube());

  EXPECT_EQ(scene.hollow->gas_J(1.0, 300.0), 0.0);
}

TEST(HollowOrgan, KnowsWhichSectionsAreWrungAndWhichTurnAsAWhole) {
  const HollowOrgan& organ = *twoLimbs().hollow;
  const OrganState state = organ.stateAt(radians(200.0));
  const double length_m = organ.length_m();

  EXPECT_EQ(organ.placeOf(0.18 * length_m).span, 0);
  EXPECT_NEAR(organ.placeOf(0.18 * length_m).share, 0.5, 1e-12);
  EXPECT_EQ(organ.placeOf(0.82 * length_m).span, 1);
  EXPECT_NEAR(organ.placeOf(0.82 * length_m).share, 0.5, 1e-12);
  EXPECT_EQ(organ.placeOf(0.5 * length_m).span, -1);
  EXPECT_EQ(organ.sectionAt(0.0, state).turn_rad, 0.0);
  EXPECT_EQ(organ.sectionAt(length_m, state).turn_rad, 0.0);
  EXPECT_EQ(organ.sectionAt(0.5 * length_m, state).turn_rad, radians(200.0));
  EXPECT_EQ(organ.sectionAt(0.5 * length_m, state).radius, 1.0);
}

TEST(HollowOrgan, TurnsTheSectionsOfALimbMoreAndMoreTowardsTheMobilePart) {
  const HollowOrgan& organ = *twoLimbs().hollow;
  const OrganState state = organ.stateAt(radians(120.0));

  double before_rad = 0.0;
  for (int i = 0; i <= 100; ++i) {
    const HollowOrgan::Section section = organ.sectionAt(0.0036 * i * organ.length_m(), state);
    EXPECT_GE(section.turn_rad, before_rad - 1e-9) << i;
    EXPECT_LE(section.turn_rad, radians(120.0) + 1e-9) << i;
    EXPECT_GT(section.radius, 0.0) << i;
    EXPECT_LT(section.radius, 1.2) << i;
    before_rad = section.turn_rad;
  }
}

TEST(HollowOrgan, IsContinuousIntoItsMobilePart) {
  // Gas out: the wall between its ends draws in; what it ends at keeps its radius.
  const HollowOrgan& organ = *twoLimbs().hollow;
  OrganState state = organ.stateAt(0.2);
  state.hollow.reading.pressure_Pa = organ.detorsion().wall.ventedPressure_Pa;
  constexpr double kCell = 1.0 / 64.0;

  for (const double share : {kCell, 1.0 - kCell}) {
    EXPECT_NEAR(organ.sectionIn(0, share, state).radius, 1.0, 0.02) << share;
  }
  EXPECT_LT(organ.sectionIn(0, 0.5, state).radius, 0.95);
}

TEST(HollowOrgan, RefusesAGraspThatIsNotOnTheMobilePart) {
  EXPECT_THROW(HollowOrgan({.lattice = &twoLimbs().lattice(),
                            .shearModulus_Pa = kBarShear_Pa,
                            .graspArc = 0.2,
                            .detorsion = twistedTube()}),
               Error);
}

TEST(HollowOrgan, ShearsItsWallByTorqueOverTwicePiRadiusSquaredThickness) {
  const HollowOrgan& organ = *twoLimbs().hollow;
  const double angle_rad = radians(5.0);  // before any fold: the radius is that of rest
  const OrganState state = organ.stateAt(angle_rad);
  const double arc_m = 0.18 * organ.length_m();

  const double shear_Pa = organ.wallShear_Pa(arc_m, state);

  const double radius_m = (kBarRadius_m - 0.0015) * organ.sectionAt(arc_m, state).radius;
  const double torque_Nm = organ.tube(0)->at(angle_rad, state.hollow.reading.pressure_Pa).torque;
  EXPECT_NEAR(shear_Pa, torque_Nm / (kTurn * radius_m * radius_m * 0.003), 0.01 * shear_Pa);
  EXPECT_EQ(organ.wallShear_Pa(0.5 * organ.length_m(), state), 0.0);
}

TEST(HollowMap, MapsBackWhatItMapsForward) {
  const Scene& scene = twoLimbs();
  for (const double angle_deg : {-300.0, 40.0, 120.0, 360.0}) {
    const OrganState state = scene.stateAt(radians(angle_deg));
    const HollowMap map(scene.lattice(), *scene.hollow, state);
    for (const double height_m : {0.01, 0.045, 0.08, 0.12, 0.2}) {
      const Vec3 rest_m{0.03, 0.02, height_m};

      EXPECT_LT(norm(map.backward(map.forward(rest_m)) - rest_m), 1e-9) << angle_deg << " " << height_m;
      EXPECT_LT(norm(scene.toDeformed_m(rest_m, state) - map.forward(rest_m)), 1e-12);
    }
  }
}

}  // namespace
}  // namespace torsio
