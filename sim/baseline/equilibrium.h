// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"

namespace torsio {

/// What a body does under a torque or at an angle, as found by Newton's method.
struct EquilibriumReport {
  int iterations = 0;      ///< factorisations
  double energy_J = 0.0;   ///< stored
  double torque_Nm = 0.0;  ///< on the turned part, about its axis
  double residual = 0.0;   ///< of the forces, over the forces that hold the ends
};

/// Static equilibrium of an elastic body with one end held and another part turned, by a torque or to an
/// angle. Under a torque the angle is an unknown beside the free nodes: no search for the angle that belongs
/// to a torque. Newton's method with a factorisation that uses how slender a bar is; a tangent that is not
/// positive definite is shifted until it is; a step is halved until the potential energy falls. One thread at
/// a time; body and rest places outlive it.
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

  /// Moves `pose` into equilibrium with the turned part kept at the angle that it has there; the report tells
  /// the torque that keeps it. Throws Error{kBadParameter} when it finds none near the pose.
  [[nodiscard]] EquilibriumReport keepAngle(TwistPose& pose);

 private:
  struct Linear;  // the tangent and its factors
  /// What turns the body: a torque, or whatever keeps the angle.
  struct Load {
    double torque_Nm = 0.0;
    bool keepsAngle = false;
  };
  /// A freedom of a node in the unknowns: the number of one, and how far it moves the freedom.
  struct Share {
    int unknown = 0;
    double factor = 0.0;
  };
  [[nodiscard]] EquilibriumReport find(const Load& load, TwistPose& pose);
  [[nodiscard]] bool evaluate(const Load& load, const TwistPose& pose);
  [[nodiscard]] bool advance(const Load& load, std::span<const double> move, TwistPose& pose);
  void numberUnknowns();
  void numberLevel(std::span<const int> nodes, bool turned);
  void shareFreedoms(const TwistPose& pose, int node, std::vector<Share>& shares,
                     std::vector<std::size_t>& starts) const;
  void assemble(const Load& load, const TwistPose& pose);
  [[nodiscard]] bool factorise(const Load& load, const TwistPose& pose);
  [[nodiscard]] double forceScale() const;
  [[nodiscard]] int turnUnknowns() const noexcept { return ends_.placeFree ? 4 : 1; }

  const ElasticBody& body_;
  TwistEnds ends_;
  std::vector<Vec3> rest_m_;
  std::function<void()> check_;
  std::vector<int> unknownOf_;  ///< first unknown of a free node; -1 held, -2 turned
  int unknowns_ = 0;
  int turn_ = 0;  ///< number of the angle; the way of the turned part follows, where its place is free
  std::vector<Vec3> forces_N_;
  std::vector<double> residual_;  ///< force an unknown; of the angle N m
  double potential_J_ = 0.0;
  double energy_J_ = 0.0;
  double moment_Nm_ = 0.0;  ///< of the body on the turned part, about its axis
  std::unique_ptr<Linear> linear_;
};

}  // namespace torsio
