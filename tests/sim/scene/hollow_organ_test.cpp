// SPDX-License-Identifier: GPL-3.0-or-later
// How the shipped hollow organs go round: rigidly in the mobile part, nowhere through themselves.
#include "sim/scene/hollow_organ.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/organ_wall.h"
#include "sim/tissue/hollow/tube_onset.h"
#include "sim/tissue/hollow/wrung_tube.h"
#include "sim/tissue/rod/fold_check.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/support/shipped_scene.h"

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

TEST(HollowOrgan, ShearsItsCordByTheTwistRate) {
  // A solid cord in place of a wall: G times the twist rate times the largest shear of its section, which is
  // about 1.1 r of a circle of equal area.
  for (const char* id : {"testis", "midgut"}) {
    const Scene& scene = testing::twistedOrgan(id);
    const WrungSpan& span = scene.hollow->detorsion().spans.front();
    const double length_m = std::abs(span.mobile - span.held) * scene.lattice().length_m();
    const OrganState state = scene.stateAt(radians(90.0));

    const double rate = scene.hollow->cordTwist_rad_per_m(
        0.5 * (span.held + span.mobile) * scene.lattice().length_m(), state);

    EXPECT_NEAR(rate * length_m, radians(90.0), 1e-9) << id;
    EXPECT_GT(scene.peakShear_Pa(state), 0.0) << id;
    EXPECT_NEAR(scene.peakShear_Pa(scene.stateAt(radians(180.0))) / scene.peakShear_Pa(state), 2.0, 1e-9)
        << id;
    EXPECT_EQ(scene.peakShear_Pa(scene.stateAt(0.0)), 0.0) << id;
  }
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

using testing::smoothAt;
using testing::twistedOrgan;

/// The angles at which the organ is looked at: from rest to its largest twist, both ways.
std::vector<double> wayOf(const Scene& scene, double step_rad) {
  std::vector<double> angles{0.0};
  const double most_rad = scene.hollow->detorsion().start.most_rad;
  for (double angle_rad = step_rad; angle_rad < most_rad + 0.5 * step_rad; angle_rad += step_rad) {
    angles.push_back(std::min(angle_rad, most_rad));
    angles.push_back(-std::min(angle_rad, most_rad));
  }
  return angles;
}

/// Least det F against the square of the section's own narrowing, on the axis and at 0.5 and 0.95 of the way
/// to the surface: how much of their distance neighbouring sections keep.
double leastRoomBetweenSections(const Scene& scene, const OrganState& lies) {
  constexpr double kDifference_m = 1e-7;
  const SectionLattice& lattice = scene.lattice();
  const HollowMap map(lattice, *scene.hollow, lies);
  double least = 1e9;
  const auto look = [&](const Vec3& p) {
    const auto column = [&](const Vec3& step) {
      return (map.forward(p + step) - map.forward(p - step)) / (2.0 * kDifference_m);
    };
    const double determinant = dot(column({kDifference_m, 0, 0}),
                                   cross(column({0, kDifference_m, 0}), column({0, 0, kDifference_m})));
    const double radius = map.section(scene.hollow->turningPlace(lattice.nearestArc_m(p), p)).radius;
    least = std::min(least, determinant / (radius * radius));
  };
  for (int j = 1; j + 1 < lattice.sections(); ++j) {
    const Vec3 centre = lattice.frameAt(lattice.sectionArc_m(j)).centre_m;
    look(centre);
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      look(centre + 0.5 * (lattice.keyPoint_m(ridge, j) - centre));
      look(centre + 0.95 * (lattice.keyPoint_m(ridge, j) - centre));
    }
  }
  return least;
}

/// The organ's centre line as it lies, with the mean radius of its sections, which shrink with their neck.
struct Strand {
  std::vector<Vec3> centre_m;
  std::vector<double> radius_m;
  std::vector<double> rest_m;  // radius
  double step_m = 0.0;
};

Strand strandOf(const Scene& scene, const OrganState& lies) {
  constexpr int kPlaces = 121;
  const SectionLattice& lattice = scene.lattice();
  const HollowMap map(lattice, *scene.hollow, lies);
  const double length_m = scene.hollow->length_m();
  std::vector<double> radii_m;
  for (int j = 0; j < lattice.sections(); ++j) {
    const Vec3 centre = lattice.frameAt(lattice.sectionArc_m(j)).centre_m;
    double sum_m = 0.0;
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      sum_m += norm(lattice.keyPoint_m(ridge, j) - centre);
    }
    radii_m.push_back(sum_m / lattice.ridges());
  }
  Strand strand;
  strand.step_m = length_m / (kPlaces - 1);
  for (int i = 0; i < kPlaces; ++i) {
    const double arc_m = strand.step_m * i;
    const double at = arc_m / length_m * (lattice.sections() - 1);
    const auto cell = std::min(static_cast<std::size_t>(at), radii_m.size() - 2);
    const double share = at - static_cast<double>(cell);
    const Vec3 centre = lattice.frameAt(arc_m).centre_m;
    strand.rest_m.push_back((1.0 - share) * radii_m[cell] + share * radii_m[cell + 1]);
    strand.centre_m.push_back(map.forward(centre));
    strand.radius_m.push_back(strand.rest_m.back() *
                              map.section(scene.hollow->turningPlace(arc_m, centre)).radius);
  }
  return strand;
}

/// Least distance of two places that lie farther apart along the line than one and a half times the sum of
/// their radii, against the sum of their radii as they lie.
double nearestOf(const Strand& strand) {
  double nearest = 1e9;
  for (std::size_t i = 0; i < strand.centre_m.size(); ++i) {
    for (std::size_t k = i + 1; k < strand.centre_m.size(); ++k) {
      const double along_m = strand.step_m * static_cast<double>(k - i);
      if (along_m > 1.5 * (strand.rest_m[i] + strand.rest_m[k])) {
        nearest = std::min(nearest, norm(strand.centre_m[i] - strand.centre_m[k]) /
                                        (strand.radius_m[i] + strand.radius_m[k]));
      }
    }
  }
  return nearest;
}

class HollowTurn : public ::testing::TestWithParam<const char*> {};

TEST_P(HollowTurn, FoldsNoTissueHoweverFarItIsTurned) {
  const Scene& scene = twistedOrgan(GetParam());
  const FoldCheck check(scene.mesh, scene.lattice());
  const double most_rad = scene.hollow->detorsion().start.most_rad;

  for (const double angle_rad : {radians(180.0), radians(360.0)}) {
    for (const double way : {1.0, -1.0}) {
      const OrganState lies = scene.stateAt(way * std::min(angle_rad, most_rad));
      const FoldReport report = check.judge(
          smoothAt(scene, lies), [&](const Vec3& rest_m) { return scene.toDeformed_m(rest_m, lies); });

      EXPECT_GT(report.minDeterminant, 0.05) << degrees(angle_rad) * way;  // of a neck that is closed
      EXPECT_EQ(report.crossings, 0U) << degrees(angle_rad) * way;
    }
  }
}

TEST_P(HollowTurn, SectionsKeepAFifthOfTheirDistanceAtLeast) {
  const Scene& scene = twistedOrgan(GetParam());

  for (const double angle_rad : wayOf(scene, radians(30.0))) {
    EXPECT_GE(leastRoomBetweenSections(scene, scene.stateAt(angle_rad)), kLeastDeterminant)
        << degrees(angle_rad);
  }
}

TEST_P(HollowTurn, NoTwoPartsComeNearerThanTheirRadii) {
  const Scene& scene = twistedOrgan(GetParam());

  for (const double angle_rad : wayOf(scene, radians(15.0))) {
    OrganState lies = scene.stateAt(angle_rad);
    EXPECT_GE(nearestOf(strandOf(scene, lies)), 1.0) << degrees(angle_rad);
    lies.hollow.reading.pressure_Pa = scene.hollow->detorsion().wall.ventedPressure_Pa;
    EXPECT_GE(nearestOf(strandOf(scene, lies)), 1.0) << degrees(angle_rad) << " let out";
  }
}

TEST_P(HollowTurn, TheMobilePartKeepsItsShapeAndItsDistanceFromItsLine) {
  const Scene& scene = twistedOrgan(GetParam());
  const OrganState lies = scene.stateAt(radians(130.0));
  const std::vector<Vec3> moved_m = smoothAt(scene, lies);
  const TwistLine& line = scene.hollow->line();
  const auto arm_m = [&](const Vec3& x) { return norm(cross(line.direction, x - line.point_m)); };

  const std::vector<TwistVertex>& vertices = scene.hollow->vertices();
  std::size_t first = vertices.size();
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    if (scene.hollow->turningPlace(vertices[i].arc_m, vertices[i].rest_m).span >= 0) {
      continue;
    }
    first = std::min(first, i);
    const double before_m = norm(vertices[i].rest_m - vertices[first].rest_m);
    EXPECT_NEAR(norm(moved_m[i] - moved_m[first]), before_m, 1e-12) << i;
    EXPECT_NEAR(arm_m(moved_m[i]), arm_m(vertices[i].rest_m), 1e-12) << i;
  }
  EXPECT_LT(first, vertices.size());
}

TEST_P(HollowTurn, FindsItsWayBackFromEveryVertex) {
  const Scene& scene = twistedOrgan(GetParam());
  const OrganState lies = scene.stateAt(radians(150.0));
  const HollowMap map(scene.lattice(), *scene.hollow, lies);

  const std::vector<TwistVertex>& vertices = scene.hollow->vertices();
  // Where a turned place lies between two places of the axis, either way back is one.
  std::size_t ambiguous = 0;
  for (std::size_t i = 0; i < vertices.size(); i += 5) {
    const double astray_m = norm(map.backward(map.forward(vertices[i].rest_m)) - vertices[i].rest_m);
    EXPECT_LT(astray_m, 0.002) << i;
    ambiguous += astray_m < 1e-6 ? 0 : 1;
  }
  EXPECT_LE(ambiguous, vertices.size() / 5 / 1000);
}

TEST_P(HollowTurn, LeavesEveryVertexAtRestUnchanged) {
  const Scene& scene = twistedOrgan(GetParam());
  const TwistVertex& vertex = scene.hollow->vertices().front();
  const HollowOrgan& organ = *scene.hollow;

  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double arc_m = share * organ.length_m();
    const HollowOrgan::Place place = organ.turningPlace(arc_m, vertex.rest_m);
    EXPECT_EQ(organ.moved(vertex.rest_m, vertex.line, place, {}, {}), vertex.rest_m);
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, HollowTurn,
                         ::testing::Values("small-bowel-loop", "gastric-mesentero-axial", "sigmoid", "midgut",
                                           "testis"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(HollowLine, OnlyLimbsSideBySideAndALimbBesideItsStalkAreWound) {
  for (const char* id : {"sigmoid", "small-bowel-loop", "midgut"}) {
    EXPECT_TRUE(twistedOrgan(id).hollow->wound()) << id;
  }
  for (const char* id : {"testis", "gastric-mesentero-axial", "gastric-organo-axial"}) {
    EXPECT_FALSE(twistedOrgan(id).hollow->wound()) << id;
  }
}

}  // namespace
}  // namespace torsio
