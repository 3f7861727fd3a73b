// SPDX-License-Identifier: GPL-3.0-or-later
// The models of a comparison, and the one interface for every model in a hand.

#include "sim/baseline/twist_simulation.h"

#include <cmath>
#include <filesystem>
#include <optional>

#include <gtest/gtest.h>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/equilibrium.h"
#include "sim/baseline/grasped_organ.h"
#include "sim/baseline/lattice_surface.h"
#include "sim/baseline/reference_solid.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/tissue/view/cpu_features.h"
#include "tests/sim/baseline/bars.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {

namespace {

constexpr double kTwistRadius_m = 0.03;
constexpr double kTwistLength_m = 0.18;

/// A round bar of soft tissue with every model of it.
class Comparison : public ::testing::Test {
 protected:
  TriangleMesh mesh_ = testing::prism(testing::circleOutline(kTwistRadius_m, 96), kTwistLength_m, 40);
  SectionLattice lattice_{mesh_, options()};
  Material material_{"tissue", 4000.0, "assumed", "Tissue", 4000.0, 4000.0};
  TwistModel model_{mesh_, lattice_, material_, {}};
  ComparedOrgan organ_ = compared();

  static LatticeOptions options() {
    return {.ridges = 24,
            .sections = 25,
            .mode = LatticeMode::kStraightAxis,
            .spacing = RidgeSpacing::kAngle,
            .fixedEnd_m = {0.0, 0.0, 0.0},
            .freeEnd_m = {0.0, 0.0, kTwistLength_m}};
  }
  [[nodiscard]] ComparedOrgan compared() const {
    ComparedOrgan organ{&mesh_, &lattice_, {4000.0, 0.45}, {}, {}};
    organ.dynamics.drag_per_s = criticalDrag_per_s(organ.constants, 1000.0, kTwistLength_m);
    return organ;
  }
  /// Torque that turns the end by this angle as the membrane analogy says.
  [[nodiscard]] double torqueFor(double angle_rad) const {
    return angle_rad / model_.graspCompliance(lattice_.length_m());
  }
};

TEST_F(Comparison, ReferenceAndTwistModelAgreeOnARoundBar) {
  const auto reference = referenceSimulation(organ_, 2);
  const auto twist = twistModelSimulation(organ_, model_, bestIsa());

  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    reference->step(torqueFor(1.0) * share);
    twist->step(torqueFor(1.0) * share);
  }

  EXPECT_NEAR(twist->angle_rad(), 1.0, 1e-6);
  EXPECT_NEAR(reference->angle_rad(), 1.0, 0.01);
  EXPECT_NEAR(twist->energy_J() / reference->energy_J(), 1.0, 0.02);
  const LatticePlaces places = twist->surface();
  EXPECT_LT(rootMeanSquareDistance_m(places, reference->surface()), 0.02 * kTwistRadius_m);
  EXPECT_NEAR(latticeVolume_m3(places) / latticeVolume_m3(restPlaces(lattice_)), 1.0, 1e-3);
  EXPECT_LT(twist->unknowns(), reference->unknowns());
}

TEST_F(Comparison, FiniteElementsComeToRestTooStiff) {
  const auto elements = finiteElementSimulation(organ_, 2);
  const double torque_Nm = torqueFor(0.5);
  for (int frame = 0; frame < 30; ++frame) {
    elements->step(torque_Nm);
  }

  elements->settle(torque_Nm);

  // Linear tetrahedra of this division lock: some tenths too stiff at nu 0.45.
  EXPECT_LT(elements->angle_rad(), 0.5 / 1.1);
  EXPECT_GT(elements->angle_rad(), 0.5 / 1.9);
  EXPECT_NEAR(elements->energy_J() / (0.5 * torque_Nm * elements->angle_rad()), 1.0, 0.05);
}

TEST_F(Comparison, SpringsSettleWhereverTheirFramesStand) {
  const auto springs = massSpringSimulation(organ_, model_, 2, {4, Calibration::kAffine});
  const double torque_Nm = torqueFor(0.3);
  for (int frame = 0; frame < 60; ++frame) {
    springs->step(torque_Nm);
  }
  const double moving_rad = springs->angle_rad();

  springs->settle(torque_Nm);
  const double settled_rad = springs->angle_rad();
  springs->settle(torque_Nm);

  EXPECT_GT(moving_rad, settled_rad);  // few substeps are soft
  EXPECT_NEAR(springs->angle_rad() / settled_rad, 1.0, 1e-6);
}

TEST_F(Comparison, SpringsCalibratedInEquilibriumTurnAsTheMembraneAnalogySays) {
  const auto springs = massSpringSimulation(organ_, model_, 2, {4, Calibration::kEquilibrium});
  const double torque_Nm = torqueFor(0.02);

  springs->step(torque_Nm);
  springs->settle(torque_Nm);

  EXPECT_NEAR(springs->angle_rad() / 0.02, 1.0, 0.01);
}

TEST_F(Comparison, TurnedOnDoublesTheTurnOfEverySection) {
  const SweptSolid solid = straightBar(12, 6, 1, kTwistRadius_m, kTwistLength_m);
  TwistPose pose{solid.points_m, 0.4};
  const auto turnedBy = [](const Vec3& p, double angle) {
    return Vec3{std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y,
                p.z};
  };
  for (Vec3& p : pose.places_m) {
    p = turnedBy(p, 3.0 * p.z / kTwistLength_m);
  }

  const TwistPose twice = turnedOn(solid, twistEnds(solid), pose, 2.0);

  EXPECT_EQ(twice.angle_rad, 0.8);
  for (std::size_t i = 0; i + static_cast<std::size_t>(solid.pointsPerSection()) < twice.places_m.size();
       ++i) {
    const Vec3& rest = solid.points_m[i];
    EXPECT_NEAR(norm(twice.places_m[i] - turnedBy(rest, 6.0 * rest.z / kTwistLength_m)), 0.0, 1e-12);
  }
}

constexpr double kRodRadius_m = 0.025;
constexpr double kRodLength_m = 0.240;

/// A round tube, straight or bent by `bend_rad`, with its lattice and its twist model.
struct ComparedTube {
  explicit ComparedTube(double bend_rad)
      : mesh(bend_rad > 0.0 ? testing::bentTube(kRodRadius_m, kRodLength_m / bend_rad, bend_rad, 96, 60)
                            : testing::prism(testing::circleOutline(kRodRadius_m, 96), kRodLength_m, 60)),
        lattice(mesh, options(bend_rad)),
        model(mesh, lattice, {"tissue", 10000.0, "assumed", "Tissue", 10000.0, 10000.0}, {}) {
    organ.mesh = &mesh;
    organ.lattice = &lattice;
    organ.constants = {10000.0, 0.45};
  }

  static LatticeOptions options(double bend_rad) {
    LatticeOptions o{.ridges = 24,
                     .sections = 41,
                     .mode = bend_rad > 0.0 ? LatticeMode::kHarmonic : LatticeMode::kStraightAxis,
                     .fixedEnd_m = {0.0, 0.0, 0.0},
                     .freeEnd_m = {0.0, 0.0, kRodLength_m}};
    if (bend_rad > 0.0) {
      const double radius_m = kRodLength_m / bend_rad;
      o.freeEnd_m = {radius_m * (1.0 - std::cos(bend_rad)), 0.0, radius_m * std::sin(bend_rad)};
    }
    return o;
  }

  TriangleMesh mesh;
  SectionLattice lattice;
  TwistModel model;
  ComparedOrgan organ;
};

TEST(RodSimulation, TurnsAStraightBarAsFarAsTheTwistModel) {
  const ComparedTube bar(0.0);
  const auto rod = rodSimulation(bar.organ, bar.model);
  const auto twist = twistModelSimulation(bar.organ, bar.model, bestIsa());
  const double torque_Nm = 1.0 / bar.model.graspCompliance(bar.lattice.length_m());

  rod->settle(torque_Nm);
  twist->settle(torque_Nm);

  EXPECT_NEAR(twist->angle_rad(), 1.0, 1e-9);
  EXPECT_NEAR(rod->angle_rad() / twist->angle_rad(), 1.0, 1e-4);
  EXPECT_NEAR(rod->energy_J() / twist->energy_J(), 1.0, 1e-4);
  EXPECT_LT(rootMeanSquareDistance_m(rod->surface(), twist->surface()), 1e-3 * kRodRadius_m);
  EXPECT_NEAR(latticeVolume_m3(rod->surface()) / latticeVolume_m3(restPlaces(bar.lattice)), 1.0, 1e-3);
}

TEST(RodSimulation, FramesOfTicksComeToRestInTheEquilibrium) {
  for (const std::optional<double>& grasp : {std::optional<double>(), std::optional<double>(0.6)}) {
    ComparedTube bend(kPi / 2.0);
    bend.organ.hold.grasp = grasp;
    const auto moving = rodSimulation(bend.organ, bend.model);
    const auto settled = rodSimulation(bend.organ, bend.model);
    const double torque_Nm = 0.02;

    for (int frame = 0; frame < 120; ++frame) {
      moving->step(torque_Nm);
    }
    settled->settle(torque_Nm);

    // In motion the sections of a jaw give way to one another: each has its share of the coupling. Measured
    // 1.7 %; the end of the other case has one section and none of it.
    EXPECT_NEAR(moving->angle_rad() / settled->angle_rad(), 1.0, grasp ? 0.025 : 2e-3);
    EXPECT_LT(rootMeanSquareDistance_m(moving->surface(), settled->surface()), grasp ? 5e-4 : 1e-4);
  }
}

TEST(RodSimulation, AgreesWithTheReferenceOnABend) {
  for (const std::optional<double>& grasp : {std::optional<double>(), std::optional<double>(0.5)}) {
    ComparedTube bend(kPi / 2.0);
    bend.organ.hold.grasp = grasp;
    const auto rod = rodSimulation(bend.organ, bend.model);
    const auto reference = referenceSimulation(bend.organ, 2);
    const double torque_Nm = grasp ? 0.03 : 0.04;

    rod->settle(torque_Nm);
    for (const double share : {0.25, 0.5, 0.75, 1.0}) {
      reference->step(share * torque_Nm);
    }

    EXPECT_GT(reference->angle_rad(), 0.4);
    EXPECT_NEAR(rod->angle_rad() / reference->angle_rad(), 1.0, 0.03) << grasp.value_or(1.0);
    EXPECT_NEAR(rod->energy_J() / reference->energy_J(), 1.0, 0.03) << grasp.value_or(1.0);
    EXPECT_LT(rootMeanSquareDistance_m(rod->surface(), reference->surface()), 0.05 * kRodRadius_m);
    EXPECT_LT(rod->unknowns(), reference->unknowns() / 10);
  }
}

TEST(RodSimulation, RefusesAJawOnTheHeldEndAndATorqueThatNothingHolds) {
  ComparedTube bar(0.0);
  const auto rod = rodSimulation(bar.organ, bar.model);
  bar.organ.hold.grasp = 0.01;

  EXPECT_THROW(static_cast<void>(rodSimulation(bar.organ, bar.model)), Error);
  EXPECT_THROW(rod->settle(1e3), Error);
}

constexpr double kGraspedRadius_m = 0.04;
constexpr double kGraspedLength_m = 0.25;
constexpr double kGraspedShear_Pa = 5000.0;

/// A round bar along z that stands at z = 0.
struct Bar {
  TriangleMesh mesh = testing::prism(testing::circleOutline(kGraspedRadius_m, 48), kGraspedLength_m, 24);
  SectionLattice lattice;
  TwistModel model;

  Bar() : lattice(mesh, options()), model(mesh, lattice, material(), {}) {}
  static LatticeOptions options() {
    return {.ridges = 12,
            .sections = 11,
            .mode = LatticeMode::kStraightAxis,
            .freeEnd_m = {0.0, 0.0, kGraspedLength_m},
            .ridgeZero = {1.0, 0.0, 0.0}};
  }
  static Material material() {
    Material soft;
    soft.shearModulus_Pa = kGraspedShear_Pa;
    return soft;
  }
  [[nodiscard]] Grasp graspAt(double share) const {
    return {&mesh, &lattice, &model, share * kGraspedLength_m};
  }
};

const Bar& bar() {
  static const Bar kBar;
  return kBar;
}

class InAHand : public ::testing::TestWithParam<TissueModel> {};

TEST_P(InAHand, ResistsTheJawInItsDirectionAndLiesAtRestWithoutIt) {
  const auto organ = graspedOrgan(GetParam(), bar().graspAt(0.8));
  EXPECT_NEAR(organ->torque_Nm(), 0.0, 1e-12);

  for (int frame = 1; frame <= 60; ++frame) {
    organ->turnTo(0.5);
  }

  EXPECT_NEAR(organ->angle_rad(), 0.5, 1e-12);
  // G pi r^4 / (2 s) for the twist model (0.101 N m/rad); coarse elements lock, coarse springs are soft.
  const double exact_Nm = kGraspedShear_Pa * 3.14159265 * std::pow(kGraspedRadius_m, 4) / (2.0 * 0.2) * 0.5;
  EXPECT_GT(organ->torque_Nm(), 0.3 * exact_Nm);
  EXPECT_LT(organ->torque_Nm(), 4.0 * exact_Nm);
  EXPECT_NEAR(organ->slope_Nm_per_rad(), organ->torque_Nm() / 0.5, 1e-9);
  EXPECT_EQ(organ->surface().places_m.size(), 12U * 11U);
}

TEST_P(InAHand, TurnsTheKeyPointsOfTheGraspedSection) {
  const auto organ = graspedOrgan(GetParam(), bar().graspAt(1.0));
  const Vec3 before = organ->surface().at(10, 0);

  for (int frame = 1; frame <= 60; ++frame) {
    organ->turnTo(0.5);
  }

  const Vec3 after = organ->surface().at(10, 0);
  EXPECT_NEAR(std::atan2(after.y, after.x) - std::atan2(before.y, before.x), 0.5, 5e-3);
}

INSTANTIATE_TEST_SUITE_P(Models, InAHand, ::testing::ValuesIn(kTissueModels),
                         [](const auto& one) { return std::string(tissueModelId(one.param)); });

TEST(FiniteElementsInAHand, NeedAtRestTheTorqueOfTheirEquilibrium) {
  const auto organ = graspedOrgan(TissueModel::kFiniteElements, bar().graspAt(1.0));
  const SweptSolid solid = sweptSolid(bar().lattice, kGraspedRings);
  const CorotationalTetrahedra body(tetrahedra(solid), solid.points_m, {kGraspedShear_Pa, kGraspedPoisson});
  const TwistEnds ends = twistEnds(solid);
  TwistPose pose{solid.points_m};
  turnEnd(ends, solid.points_m, 0.4, pose);
  const double equilibrium_Nm = Equilibrium(body, ends, solid.points_m).keepAngle(pose).torque_Nm;

  for (int frame = 0; frame < 300; ++frame) {
    organ->turnTo(0.4);
  }

  EXPECT_NEAR(organ->torque_Nm(), equilibrium_Nm, 2e-3 * equilibrium_Nm);
}

TEST(InAHandAtTheHeldEnd, NoElementsCanBeTurned) {
  const auto atTheFoot = [] {
    static_cast<void>(graspedOrgan(TissueModel::kFiniteElements, bar().graspAt(0.01)));
  };

  EXPECT_THROW(atTheFoot(), Error);
}

}  // namespace

namespace {

LatticePlaces bar(int ridges, int layers, double radius_m, double length_m) {
  LatticePlaces places{ridges, layers + 1, {}};
  for (const std::vector<Vec3>& outline : straightOutlines(ridges, layers, radius_m, length_m)) {
    places.places_m.insert(places.places_m.end(), outline.begin(), outline.end());
  }
  return places;
}

template <typename Move>
LatticePlaces mapped(LatticePlaces places, const Move& move) {
  for (Vec3& p : places.places_m) {
    p = move(p);
  }
  return places;
}

TEST(LatticePlaces, EncloseTheVolumeOfTheirPolygon) {
  // Area of the 12-gon: 3 R^2.
  EXPECT_NEAR(latticeVolume_m3(bar(12, 5, 0.02, 0.1)), 3.0 * 0.02 * 0.02 * 0.1, 1e-18);
}

TEST(LatticePlaces, RootMeanSquareDistanceOfAShiftIsTheShift) {
  const LatticePlaces rest = bar(8, 3, 0.02, 0.1);
  const LatticePlaces moved = mapped(rest, [](const Vec3& p) { return p + Vec3{0.003, 0.0, 0.004}; });

  EXPECT_NEAR(rootMeanSquareDistance_m(rest, moved), 0.005, 1e-15);
}

TEST(LatticePlaces, ARigidMotionIsNeitherRoughNorSwollen) {
  const LatticePlaces rest = bar(8, 3, 0.02, 0.1);
  const LatticePlaces moved = mapped(rest, [](const Vec3& p) {
    return Vec3{-p.y, p.x, p.z} + Vec3{0.1, 0.2, 0.3};
  });

  EXPECT_NEAR(largestRadiusChange(rest, moved), 0.0, 1e-12);
  EXPECT_NEAR(roughness_m(rest, moved), 0.0, 1e-15);
}

TEST(LatticePlaces, EvenSwellingIsARadiusChangeAndNotRough) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  const LatticePlaces swollen = mapped(rest, [](const Vec3& p) { return Vec3{1.1 * p.x, 1.1 * p.y, p.z}; });

  EXPECT_NEAR(largestRadiusChange(rest, swollen), 0.1, 1e-12);
  EXPECT_NEAR(roughness_m(rest, swollen), 0.0, 1e-15);
}

TEST(LatticePlaces, TeethOfAMillimetreAreTwoMillimetresRough) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  LatticePlaces rough = rest;
  for (std::size_t i = 0; i < rough.places_m.size(); ++i) {
    const double sign = (i % 8 + i / 8) % 2 == 0 ? 1.0 : -1.0;
    Vec3& p = rough.places_m[i];
    p += (sign * 1e-3 / 0.02) * Vec3{p.x, p.y, 0.0};
  }

  // + 1 mm against a mean of - 1 mm over the four neighbours.
  EXPECT_NEAR(roughness_m(rest, rough), 2e-3, 1e-12);
}

TEST(MarkerAnchor, FollowsItsThreeKeyPoints) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  LatticePlaces now = rest;
  now.places_m[3] += {0.0, 0.0, 0.006};
  MarkerAnchor marker{.rest_m = {0.02, 0.0, 0.05}, .points = {3, 4, 11}, .weights = {0.5, 0.25, 0.25}};

  const Vec3 place = markerPlace_m(marker, rest, now, {}, 0.0);

  EXPECT_NEAR(norm(place - Vec3{0.02, 0.0, 0.053}), 0.0, 1e-15);
}

TEST(MarkerAnchor, BeyondTheFreeEndTurnsWithItAndBeyondTheFixedEndStays) {
  const LatticePlaces rest = bar(8, 4, 0.02, 0.1);
  const AxisFrame end{{0.0, 0.0, 0.1}, {0.0, 0.0, 1.0}, {1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
  MarkerAnchor marker{.part = LatticePart::kFreeCap, .rest_m = {0.03, 0.0, 0.15}};

  EXPECT_NEAR(norm(markerPlace_m(marker, rest, rest, end, kPi / 2.0) - Vec3{0.0, 0.03, 0.15}), 0.0, 1e-12);
  marker.part = LatticePart::kFixedCap;
  EXPECT_EQ(norm(markerPlace_m(marker, rest, rest, end, kPi / 2.0) - marker.rest_m), 0.0);
}

/// The forearm between elbow and wrist; the hand beyond is a cap.
struct Forearm {
  TriangleMesh mesh = importMesh(
      std::filesystem::path(TORSIO_SOURCE_DIR) / "assets" / "organs" / "forearm.ply", {.scale_m = 1e-3});
  SectionLattice lattice{mesh, LatticeOptions{.ridges = 36,
                                              .sections = 37,
                                              .mode = LatticeMode::kStraightAxis,
                                              .freeEnd_m = {0.0, 0.0, 0.262},
                                              .freeCut = {0.0, 0.0, 1.0},
                                              .ridgeZero = {1.0, 0.0, 0.0}}};
};

TEST(LatticeSkin, FollowsKeyPointsThatTurnAsOneAndTurnsTheHandWithThem) {
  const Forearm arm;
  const LatticeSkin skin(arm.mesh, arm.lattice);
  const AxisFrame end = arm.lattice.frameAt(arm.lattice.length_m());
  // A quarter turn about the axis, x to y, of everything.
  LatticePlaces turned = restPlaces(arm.lattice);
  const auto quarter = [&](const Vec3& place) {
    const Vec3 from = place - end.centre_m;
    return end.centre_m + dot(from, end.tangent) * end.tangent + cross(end.tangent, from);
  };
  for (Vec3& place : turned.places_m) {
    place = quarter(place);
  }
  std::vector<Vec3> shown(arm.mesh.vertices_m.size());

  skin.deform(turned, 0.5 * kPi, shown);

  int caps = 0;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    caps += arm.lattice.vertexParts()[i] == LatticePart::kFreeCap ? 1 : 0;
    if (arm.lattice.vertexParts()[i] != LatticePart::kFixedCap) {
      EXPECT_LT(norm(shown[i] - quarter(arm.mesh.vertices_m[i])), 1e-12);
    }
  }
  EXPECT_GT(caps, 100);
}

TEST(LatticeSkin, LeavesTheOrganAtRestWhereTheKeyPointsAre) {
  const Forearm arm;
  const LatticeSkin skin(arm.mesh, arm.lattice);
  std::vector<Vec3> shown(arm.mesh.vertices_m.size());

  skin.deform(restPlaces(arm.lattice), 0.0, shown);

  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_LT(norm(shown[i] - arm.mesh.vertices_m[i]), 1e-12);
  }
}

}  // namespace

}  // namespace torsio
