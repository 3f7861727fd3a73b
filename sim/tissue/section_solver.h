// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

namespace torsio {

/// What the membrane analogy says about one section, for G = 1 and unit twist rate. Lengths in the unit of
/// the outline (metres in scenes): area [L^2], torsion constant [L^4], sag [L^2 per unit q/f], psi [L^2].
struct SectionProperties {
  double area = 0.0;
  std::array<double, 2> centroid{};    ///< in the outline's coordinates
  double polarMoment = 0.0;            ///< Ip about the centroid, upper bound of every J
  double torsionConstant = 0.0;        ///< J = 4 V f / q, mean of the bracket
  double torsionLower = 0.0;           ///< rigorous lower bound of J (Prandtl-Galerkin)
  double torsionUpper = 0.0;           ///< rigorous upper bound of J (warping-Galerkin)
  double sag = 0.0;                    ///< l = largest membrane height for q/f = 1
  double volume = 0.0;                 ///< membrane volume for q/f = 1: J / 4
  double maxShear = 0.0;               ///< largest |tau| on the outline for G = 1, unit twist rate
  double warpingMin = 0.0;             ///< smallest psi
  double warpingMax = 0.0;             ///< largest psi
  std::vector<double> outlineWarping;  ///< psi at each outline point given
  std::vector<double> outlineShear;    ///< |tau| at each outline point given
};

enum class SectionMethod {
  kFiniteElements,    ///< P2 on a polar mesh: outlines star-shaped about the centroid
  kBoundaryElements,  ///< any simple outline
  kAutomatic,         ///< finite elements where possible, else boundary elements
};

struct SectionSolverOptions {
  SectionMethod method = SectionMethod::kAutomatic;
  int outlinePoints = 128;  ///< the outline is resampled to this many points (corners are kept)
  int rings = 8;
};

/// Solves lap z = -1 (stress function, Eqs. 10-12) and lap psi = 0 (warping) on a simple polygon.
/// `outline`: at least 3 points, any orientation, first point not repeated; `holes` likewise.
/// Throws Error{kBadParameter}: fewer than 3 points, not finite, crosses itself, zero area.
[[nodiscard]] SectionProperties solveSection(std::span<const std::array<double, 2>> outline,
                                             const SectionSolverOptions& options = {},
                                             std::span<const std::vector<std::array<double, 2>>> holes = {});

}  // namespace torsio
