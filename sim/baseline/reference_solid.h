// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "sim/baseline/equilibrium.h"
#include "sim/baseline/neo_hookean_elements.h"
#include "sim/baseline/swept_solid.h"

namespace torsio {

/// Of what the accuracy reference is made.
enum class ReferenceElements { kWedges, kTetrahedra };

/// The accuracy reference of an organ: neo-Hookean wedges, quadratic ones if ridges, rings and steps between
/// sections are even, else linear ones, or quadratic tetrahedra on the same points; always in equilibrium. An
/// end, or a jaw, is turned by a torque or to an angle, while the other end stands still. One thread.
class ReferenceSolid {
 public:
  /// Takes the organ at rest. `check`: called in each step of Newton's method; what it throws ends it. Throws
  /// as twistEnds, quadraticTetrahedra and NeoHookeanElements.
  ReferenceSolid(SweptSolid solid, const ElasticConstants& constants, const TwistHold& hold,
                 std::function<void()> check = {}, ReferenceElements elements = ReferenceElements::kWedges);

  /// Goes on to the equilibrium under a torque, N m, in one step from where it is. Throws as
  /// Equilibrium::solve.
  void load(double torque_Nm);
  /// Goes on to the equilibrium at an angle, in steps of ten degrees. Throws as Equilibrium::keepAngle.
  void turnTo(double angle_rad);

  [[nodiscard]] const SweptSolid& solid() const noexcept { return solid_; }
  [[nodiscard]] const TwistEnds& ends() const noexcept { return ends_; }
  [[nodiscard]] const TwistPose& pose() const noexcept { return pose_; }
  [[nodiscard]] double torque_Nm() const noexcept { return torque_Nm_; }
  [[nodiscard]] double energy_J() const noexcept { return energy_J_; }
  /// Returns how many numbers are solved for.
  [[nodiscard]] int unknowns() const noexcept { return freeUnknowns(solid_, ends_); }

 private:
  [[nodiscard]] SolidMesh meshOf(ReferenceElements elements) const;
  void toRest();
  void stepTo(double angle_rad);

  SweptSolid solid_;
  TwistEnds ends_;
  NeoHookeanElements body_;
  Equilibrium newton_;
  TwistPose pose_;
  double torque_Nm_ = 0.0;
  double energy_J_ = 0.0;
};

/// Share of a torque or an angle that a body at rest is given first: the shape that it then has is turned on.
inline constexpr double kFirstShare = 1e-3;

/// Returns the turn of every section about its own tangent at rest, rad, what is left beside a swing of the
/// tangent, from the best rotation of its outline. Between neighbours lies less than half a turn.
[[nodiscard]] std::vector<double> sectionTurns_rad(const SweptSolid& solid, std::span<const Vec3> places_m);

/// Turns a pose on: the turn of every section since rest, and the way of its centre, become `ratio` times
/// what they are. Where Newton's method starts from when the load grows.
[[nodiscard]] TwistPose turnedOn(const SweptSolid& solid, const TwistEnds& ends, const TwistPose& pose,
                                 double ratio);

}  // namespace torsio
