// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"

namespace torsio {

/// What a body does under a torque, as found by Newton's method.
struct EquilibriumReport {
  int iterations = 0;     ///< factorisations
  double energy_J = 0.0;  ///< stored
  double residual = 0.0;  ///< of the forces, over the forces that hold the ends
};

/// Static equilibrium of an elastic body with one end held and a torque on the other. The turned end's angle
/// is an unknown beside the free nodes: no search for the angle that belongs to a torque. Newton's method
/// with a factorisation that uses how slender a bar is; a tangent that is not positive definite is shifted
/// until it is; a step is halved until the potential energy falls. One thread at a time; body and rest places
/// outlive it.
class Equilibrium {
 public:
  /// `check`: called many times a second while solve() computes; what it throws ends it, and the pose is then
  /// no equilibrium. Empty: none.
  Equilibrium(const ElasticBody& body, TwistEnds ends, std::span<const Vec3> rest_m,
              std::function<void()> check = {});
  ~Equilibrium();
  Equilibrium(const Equilibrium&) = delete;
  Equilibrium& operator=(const Equilibrium&) = delete;

  /// Moves `pose` into equilibrium with the torque on the turned end, N m, about the axis of the ends. Throws
  /// Error{kBadParameter} for a torque that is not finite, and when it finds none near the pose: the torque
  /// is too large, or too far from the one before.
  [[nodiscard]] EquilibriumReport solve(double torque_Nm, TwistPose& pose);

 private:
  struct Linear;  // the tangent and its factors
  [[nodiscard]] bool evaluate(double torque_Nm, const TwistPose& pose);
  [[nodiscard]] bool advance(double torque_Nm, std::span<const double> move, TwistPose& pose);
  void numberUnknowns();
  void assemble(const TwistPose& pose);
  [[nodiscard]] bool factorise(const TwistPose& pose);
  [[nodiscard]] double forceScale() const;

  const ElasticBody& body_;
  TwistEnds ends_;
  std::vector<Vec3> rest_m_;
  std::function<void()> check_;
  std::vector<int> unknownOf_;  ///< first unknown of a free node; -1 held, -2 turned
  int unknowns_ = 0;            ///< the last one is the angle
  std::vector<Vec3> forces_N_;
  std::vector<double> residual_;  ///< force an unknown; of the angle N m
  double potential_J_ = 0.0;
  double energy_J_ = 0.0;
  std::unique_ptr<Linear> linear_;
};

}  // namespace torsio
