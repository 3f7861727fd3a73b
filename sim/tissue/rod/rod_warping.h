// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "sim/geometry/lattice/section_lattice.h"

namespace torsio {

/// What a bend at rest does to the torsion of a section, whose shear strain is r/j0 + j0 grad(u/j0) per twist
/// rate, r = (-y, x) about the centroid and u the warping, of all polynomials of degree 6 the one of least
/// energy (docs/model.md R.13).
struct BentTorsion {
  double stiffening = 1.0;  ///< of the torsion without a shear force, over that of the straight section
  /// Minus the shear strain that such a torsion brings along, per twist rate.
  std::array<double, 2> shear_m{};
};
[[nodiscard]] BentTorsion bentTorsion(std::span<const Point2> outline_m, double kappa1_per_m,
                                      double kappa2_per_m);

/// Factor S of a section's bending stiffness C near a held face, as S C S: the face keeps its section from
/// narrowing on the stretched side and widening on the other, so that it bends less easily there.
struct FlatBending {
  double xx = 1.0;
  double xy = 0.0;
  double yy = 1.0;
};
/// Of an outline in coordinates whose x and y are the axes of curvature; `away_m`: to each held end, empty:
/// no end. What is left of the compliance about each principal axis is 1 - s exp(-away / l), s = 4 nu^2 / (4
/// nu^2
/// + 2 (1 + nu) (1 - 2 nu)), l = 0.8 / (1 + 0.06 I' / I) nu sqrt(W / (2 (1 + nu) I s)); I' is the other
/// second moment, W the integral of the square of the displacement within the section, less its mean, that
/// bending brings for nu = 1 and unit curvature (docs/model.md R.13).
[[nodiscard]] FlatBending flatBending(std::span<const Point2> outline_m, double poisson,
                                      std::span<const double> away_m);

}  // namespace torsio
