// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/tissue/section/plane_mesh.h"

namespace torsio {

/// The two fields on the boundary of a section, for G = 1, unit twist rate, q/f = 1, about the origin.
struct BoundaryFields {
  double torsionConstant = 0.0;              ///< J
  double sag = 0.0;                          ///< largest membrane height
  std::vector<std::vector<double>> warping;  ///< psi, per loop and point; mean over the section 0
  std::vector<std::vector<double>> slope;    ///< |grad z|, per loop and edge (from point i to i + 1)
};

/// Solves lap z = -1 on any section by boundary elements. With H = z + r^2/4, which is harmonic and known
/// on the outline (r^2/4), Green's identity at the middle x of each edge
///   H(x)/2 = sum over edges (integral G dH/dn - integral H dG/dn),  G = -ln(r)/(2 pi),
/// gives dH/dn, constant on each edge. All integrals are in closed form, H is taken as the exact parabola on
/// each edge. On hole k, H = r^2/4 + c_k with the closing condition: integral dH/dn = 0. Then
/// J = Ip - integral r^2 dH/dn, and psi is the harmonic conjugate: dpsi/ds = -2 dH/dn.
/// `loops`: outline (anticlockwise), then holes (clockwise), lengths of order 1. `polarMoment` of the
/// material about the origin, `area` of the material.
[[nodiscard]] BoundaryFields solveBoundaryElements(std::span<const BoundaryLoop> loops, double polarMoment,
                                                   double area);

}  // namespace torsio
