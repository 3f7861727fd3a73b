// SPDX-License-Identifier: GPL-3.0-or-later
// One interface for every model in a hand.
#include "sim/baseline/grasped_organ.h"

#include <cmath>

#include <gtest/gtest.h>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/equilibrium.h"
#include "sim/core/error.h"
#include "tests/support/procedural_mesh.h"

namespace torsio {
namespace {

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
    LatticeOptions wanted{.ridges = 12,
                          .sections = 11,
                          .mode = LatticeMode::kStraightAxis,
                          .freeEnd_m = {0.0, 0.0, kGraspedLength_m},
                          .ridgeZero = {1.0, 0.0, 0.0}};
    return wanted;
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
}  // namespace torsio
