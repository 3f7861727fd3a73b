// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/baseline/spring_lattice.h"
#include "sim/baseline/twist_dynamics.h"

namespace torsio {

/// Springs in motion by extended position-based dynamics (Macklin, Mueller and Chentanez 2016): small
/// substeps, one pass over all springs each. The turned part is a rigid body with one freedom, four where its
/// place is free. Quick and never unstable; its stiffness depends on substeps and masses, and only many
/// substeps approach the equilibrium of the springs. One thread.
class XpbdFrames {
 public:
  /// Prepares masses. `substeps`: a frame's, 1 or more (Error{kBadParameter}).
  XpbdFrames(const SweptSolid& solid, TwistEnds ends, SpringLattice springs, const DynamicsOptions& options,
             int substeps);

  /// Computes the next frame under a torque on the turned part, N m.
  void step(double torque_Nm);
  /// Computes the next frame with the turned part led to this angle, rad: a small turn a frame.
  void stepTo(double angle_rad);

  [[nodiscard]] const TwistEnds& ends() const noexcept { return ends_; }
  [[nodiscard]] const TwistPose& pose() const noexcept { return pose_; }
  [[nodiscard]] const SpringLattice& body() const noexcept { return springs_; }

 private:
  void substep(double torque_Nm, double time_s);
  /// Moves the nodes of one spring so that it does what its stiffness says. `excess`: length or volume over
  /// that at rest; `gradients`: its derivatives by the places.
  void project(std::span<const int> nodes, std::span<const Vec3> gradients, double excess,
               double inverseStiffness_per_s2);
  [[nodiscard]] Vec3 endPlace(std::size_t node) const noexcept;

  TwistEnds ends_;
  DynamicsOptions options_;
  std::vector<Vec3> rest_m_;
  SpringLattice springs_;
  int substeps_ = 10;
  std::vector<double> inverseMass_;  ///< of a node; 0 held or turned
  std::vector<char> turned_;         ///< whether the node belongs to the turned part
  double inverseInertia_ = 0.0;      ///< of the turned part about its axis
  double inverseTurnedMass_ = 0.0;   ///< of the turned part; 0 where its place is held
  double angle_rad_ = 0.0;           ///< of the turned part within a substep
  double cosine_ = 1.0;
  double sine_ = 0.0;
  double spin_rad_per_s_ = 0.0;
  Vec3 turnedVelocity_;
  std::vector<Vec3> velocity_;
  std::vector<Vec3> before_m_;
  TwistPose pose_;
};

}  // namespace torsio
