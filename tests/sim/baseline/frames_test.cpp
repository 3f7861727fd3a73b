// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "sim/baseline/corotational_frames.h"
#include "sim/baseline/equilibrium.h"
#include "sim/baseline/spring_lattice.h"
#include "sim/core/error.h"
#include "tests/sim/baseline/bars.h"

namespace torsio {
namespace {

constexpr double kFrameRadius_m = 0.03;
constexpr double kFrameLength_m = 0.18;
constexpr ElasticConstants kFrameConstants{4000.0, 0.30};

DynamicsOptions damped() {
  DynamicsOptions options;
  options.drag_per_s = criticalDrag_per_s(kFrameConstants, options.density_kg_per_m3, kFrameLength_m);
  return options;
}

double stiffness_Nm() {
  return kFrameConstants.shearModulus_Pa * 0.5 * kPi * std::pow(kFrameRadius_m, 4) / kFrameLength_m;
}

double equilibriumTurn(const ElasticBody& body, const SweptSolid& bar, const TwistEnds& ends,
                       double torque_Nm, TwistPose pose) {
  Equilibrium equilibrium(body, ends, bar.points_m);
  static_cast<void>(equilibrium.solve(torque_Nm, pose));
  return pose.angle_rad;
}

TEST(TwistDynamics, DragOfTissueKeepsTheFirstTwistFromSwinging) {
  // sqrt(4000 / 1000) = 2 m/s; pi 2 / 0.18 = 34.9 /s
  EXPECT_NEAR(criticalDrag_per_s(kFrameConstants, 1000.0, kFrameLength_m), 34.907, 0.001);
}

TEST(TwistDynamics, NodesWeighWhatTheirBarWeighs) {
  const SweptSolid bar = straightBar(12, 6, 2, kFrameRadius_m, kFrameLength_m);

  const std::vector<double> masses_kg = nodeMasses(tetrahedra(bar), bar.points_m, 1000.0);

  double sum_kg = 0.0;
  for (const double m : masses_kg) {
    sum_kg += m;
  }
  EXPECT_NEAR(sum_kg, 1000.0 * 3.0 * kFrameRadius_m * kFrameRadius_m * kFrameLength_m, 1e-12);
}

TEST(CorotationalFrames, ComeToRestInTheEquilibriumOfTheirElements) {
  const SweptSolid bar = straightBar(12, 10, 2, kFrameRadius_m, kFrameLength_m);
  CorotationalFrames frames(bar, twistEnds(bar), kFrameConstants, damped());
  const double torque_Nm = stiffness_Nm() * 1.0;

  for (int frame = 0; frame < 150; ++frame) {
    frames.step(torque_Nm);
  }

  // 1e-3 is the tolerance of the conjugate gradients.
  const double expected = equilibriumTurn(frames.body(), bar, frames.ends(), torque_Nm, frames.pose());
  EXPECT_NEAR(frames.pose().angle_rad / expected, 1.0, 2e-3);
  EXPECT_GT(frames.gradientSteps(), 5);
}

TEST(CorotationalFrames, TurnedByAJawComeToRestInTheEquilibriumOfTheirElements) {
  const SweptSolid bar = bentBar(12, 10, 2, kFrameRadius_m, kFrameLength_m, kPi / 3.0);
  CorotationalFrames frames(bar, twistEnds(bar, jawAt(0.7)), kFrameConstants, damped());
  const double torque_Nm = 0.5 * stiffness_Nm();

  for (int frame = 0; frame < 150; ++frame) {
    frames.step(torque_Nm);
  }

  const double expected = equilibriumTurn(frames.body(), bar, frames.ends(), torque_Nm, frames.pose());
  EXPECT_NEAR(frames.pose().angle_rad / expected, 1.0, 2e-3);
  EXPECT_GT(norm(frames.pose().way_m), 1e-4);  // the bend lets a free place wander
}

TEST(CorotationalFrames, StayAtRestWithoutATorque) {
  const SweptSolid bar = straightBar(12, 6, 2, kFrameRadius_m, kFrameLength_m);
  CorotationalFrames frames(bar, twistEnds(bar), kFrameConstants, damped());

  frames.step(0.0);

  EXPECT_NEAR(frames.pose().angle_rad, 0.0, 1e-12);
}

/// Springs calibrated to half the energy that a turn of 0.01 rad holds in the round bar.
SpringLattice springsOf(const SweptSolid& bar) {
  std::vector<Vec3> turned = bar.points_m;
  for (Vec3& p : turned) {
    const double angle = 0.01 * p.z / kFrameLength_m;
    p = {std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y, p.z};
  }
  return SpringLattice(bar, kFrameConstants).calibrated(turned, 0.5e-4 * stiffness_Nm());
}

TEST(XpbdFrames, ApproachTheEquilibriumOfTheirSpringsWithMoreSubsteps) {
  const SweptSolid bar = straightBar(12, 10, 2, kFrameRadius_m, kFrameLength_m);
  const double torque_Nm = 0.5 * stiffness_Nm();
  std::vector<double> errors;
  for (const int substeps : {5, 20, 80}) {
    XpbdFrames frames(bar, twistEnds(bar), springsOf(bar), damped(), substeps);
    for (int frame = 0; frame < 150; ++frame) {
      frames.step(torque_Nm);
    }
    const double expected = equilibriumTurn(frames.body(), bar, frames.ends(), torque_Nm, frames.pose());
    errors.push_back(frames.pose().angle_rad / expected - 1.0);
  }

  // Few substeps make position-based dynamics soft: it is the known trap of the method.
  EXPECT_GT(errors[0], errors[1]);
  EXPECT_GT(errors[1], errors[2]);
  EXPECT_NEAR(errors[2], 0.0, 0.05);
}

TEST(XpbdFrames, TurnedByAJawApproachTheEquilibriumOfTheirSprings) {
  const SweptSolid bar = bentBar(12, 10, 2, kFrameRadius_m, kFrameLength_m, kPi / 3.0);
  const double torque_Nm = 0.3 * stiffness_Nm();
  XpbdFrames frames(bar, twistEnds(bar, jawAt(0.7)), SpringLattice(bar, kFrameConstants), damped(), 80);

  for (int frame = 0; frame < 150; ++frame) {
    frames.step(torque_Nm);
  }

  const double expected = equilibriumTurn(frames.body(), bar, frames.ends(), torque_Nm, frames.pose());
  EXPECT_NEAR(frames.pose().angle_rad / expected, 1.0, 0.08);
}

TEST(XpbdFrames, RefuseAFrameWithoutSubsteps) {
  const SweptSolid bar = straightBar(6, 3, 1, kFrameRadius_m, kFrameLength_m);

  EXPECT_THROW(XpbdFrames(bar, twistEnds(bar), SpringLattice(bar, kFrameConstants), damped(), 0), Error);
}

}  // namespace
}  // namespace torsio
