// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/spring_calibration.h"

#include <cstddef>
#include <vector>

#include "sim/baseline/equilibrium.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr double kSmallTurn_rad = 0.01;  ///< of the free end: springs are calibrated where they are linear

/// Every section turned in its plane as the membrane analogy says when the free end turns by kSmallTurn_rad.
std::vector<Vec3> sectionsTurned(const SweptSolid& solid, const SectionLattice& lattice,
                                 const TwistModel& model) {
  const TwistState state =
      model.stateForTorque(lattice.length_m(), kSmallTurn_rad / model.graspCompliance(lattice.length_m()));
  std::vector<Vec3> turned = solid.points_m;
  for (int j = 0; j < solid.sections; ++j) {
    const double arc_m = lattice.sectionArc_m(j);
    const AxisFrame frame = lattice.frameAt(arc_m);
    const SinCos turn = portableSinCos(model.angleAt(arc_m, state));
    for (int i = 0; i < solid.pointsPerSection(); ++i) {
      Vec3& place = turned[static_cast<std::size_t>(j) * static_cast<std::size_t>(solid.pointsPerSection()) +
                           static_cast<std::size_t>(i)];
      const Vec3 arm = place - frame.centre_m;
      const Vec3 along = dot(arm, frame.tangent) * frame.tangent;
      place = frame.centre_m + along + turn.cos * (arm - along) + turn.sin * cross(frame.tangent, arm);
    }
  }
  return turned;
}

}  // namespace

SpringLattice calibratedSprings(const SweptSolid& solid, const SectionLattice& lattice,
                                const ElasticConstants& constants, const TwistModel& model,
                                Calibration calibration, const std::function<void()>& check) {
  const double compliance = model.graspCompliance(lattice.length_m());
  const double energy_J = 0.5 * kSmallTurn_rad * kSmallTurn_rad / compliance;
  SpringLattice springs =
      SpringLattice(solid, constants).calibrated(sectionsTurned(solid, lattice, model), energy_J);
  if (calibration == Calibration::kAffine) {
    return springs;
  }
  Equilibrium newton(springs, twistEnds(solid), solid.points_m, check);
  TwistPose pose{solid.points_m};
  static_cast<void>(newton.solve(kSmallTurn_rad / compliance, pose));
  return springs.scaled(pose.angle_rad / kSmallTurn_rad);
}

}  // namespace torsio
