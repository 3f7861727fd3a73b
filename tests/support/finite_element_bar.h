// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/tissue/section/polygon.h"
#include "tests/support/finite_element_bar_mesh.h"

namespace torsio {

/// Elastic constants of a bar. Lame's first constant is 2 G nu / (1 - 2 nu).
struct BarMaterial {
  double shearModulus_Pa = 5000.0;  ///< G > 0
  double poissonRatio = 0.45;       ///< 0 <= nu < 0.5
};

/// Result of a bar under large twist.
struct BarTwist {
  double torque_Nm = 0.0;
  double radiusChange = 0.0;    ///< largest |r / R - 1| of the points of the outline, all layers
  double angleError_rad = 0.0;  ///< largest deviation of these points from the rotation angle z / length
  int iterations = 0;           ///< Newton steps (factorisations), all sub-steps together
};

/// Finite elements as the twist model is compared with: a straight bar of constant section whose two end
/// faces are held; the upper one is turned about the axis at fixed distance. Holds mesh and material only:
/// each call builds, factorises and solves anew, so calls on one bar may run in several threads. Not for the
/// servo tick.
class FiniteElementBar {
 public:
  /// Makes a bar. `outline` in metres, anticlockwise, star-shaped about the axis at (0, 0). Throws
  /// Error{kBadParameter}.
  FiniteElementBar(std::span<const Point2> outline, double length_m, BarElement element,
                   const BarDivision& division, const BarMaterial& material);

  /// Computes the torque at the turned end by linear elasticity, sigma = 2 G eps + lambda tr(eps) I, with
  /// the linearised rotation u = angle (-y, x, 0) of that end: T = 2 E / angle, E = u K u / 2 the strain
  /// energy. One sparse LDLT solve; the torque is proportional to the angle. Throws Error{kBadParameter}
  /// for an angle that is not finite.
  [[nodiscard]] double linearTorque_Nm(double angle_rad) const;

  /// Computes the torque at the end turned by a true rotation: compressible neo-Hookean material W = G/2
  /// (tr F^T F - 3) - G ln J + lambda/2 (ln J)^2, total Lagrangian, Newton's method with a step halved
  /// while a cell would turn inside out or the residual would grow. The angle is reached in `steps` equal
  /// sub-steps (15 degrees each do well), each started from the last one turned on by its share. T is the
  /// moment of the nodal forces of the turned end. Throws Error{kBadParameter} for bad input (also 90
  /// degrees or more in one layer), and Error{kBadParameter} that names the sub-step when the iteration
  /// does not converge.
  [[nodiscard]] BarTwist neoHookeanTorque(double angle_rad, int steps) const;

  [[nodiscard]] const BarMesh& mesh() const noexcept { return mesh_; }

 private:
  BarMesh mesh_;
  BarMaterial material_;
  int outlinePoints_ = 0;
  int layers_ = 0;
};

/// Returns the corners of a regular polygon about (0, 0), anticlockwise, the first on the x axis. Throws
/// Error{kBadParameter} for fewer than 3 points or a radius that is not positive.
[[nodiscard]] std::vector<Point2> regularOutline(int points, double radius_m);

}  // namespace torsio
