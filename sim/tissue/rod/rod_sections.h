// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "sim/core/organ_pose.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/tissue/rod/rod.h"
#include "sim/tissue/section/wall_section.h"
#include "sim/tissue/twist/saint_venant.h"
#include "sim/tissue/twist/twist_model_sections.h"

namespace torsio {

/// Tissue of a rod.
struct RodMaterial {
  double shearModulus_Pa = 0.0;  ///< G > 0
  double poisson = 0.5;          ///< nu, 0 to 0.5: E = 2 G (1 + nu); 0.5 is incompressible, E = 3 G
  WallMap wall = {};             ///< of a hollow organ, along the lattice; empty: filled
  /// `restrainedEnds`: not for walls
  TorsionCorrections corrections = {};
  EndCondition ends = EndCondition::kClampedFree;  ///< which ends are held, for the corrections
};

/// Number of elements that the shape and the torque of an organ need: 24 differ from 96 by 0.1 % in torque on
/// a tube bent by 90 degrees.
inline constexpr int kRodElements = 31;

/// An organ cut into the elements of a rod, before anything holds it. The rod ends where the organ begins to
/// round off to a tip: what lies beyond is a rigid cap.
struct OrganRod {
  std::vector<RodElement> elements;
  RodPose rest;                 ///< nodes on the centreline, axes of its frames
  std::vector<double> arcs_m;   ///< one a node, along the lattice's centreline, ascending
  std::vector<double> radii_m;  ///< one a node, of the circle that has the section's area
};

/// Request for the nodes of a rod.
struct RodDivision {
  int elements = kRodElements;
  /// Arc length along the lattice's centreline at which a node must lie, as at a jaw. Outside the rod: none.
  double node_m = -1.0;
};

/// Makes the elements of a rod from the sections of an organ as they are. J and the shear centre come from
/// `sections`; all integrals over the section are taken over its outline and weighted with 1 / j0, the rest
/// length of a fibre of the bent organ (docs/model.md R.2). Each element gets the mean of the compliance (6 x
/// 6) over its arc length by Gauss's rule, so that a straight bar twists by C(s). A wall has Bredt's J
/// (wall_section.h) and the moments between its two sides; bent at rest it bends more easily, because its
/// section goes oval (von Karman; docs/model.md H.5), but not beside the held ends. Throws
/// Error{kBadParameter} for G, nu or a number of elements out of range, Error{kBadMesh} where the organ has
/// no simple section.
[[nodiscard]] OrganRod rodOfOrgan(const SectionLattice& lattice, const SolvedSections& sections,
                                  const RodMaterial& material, const RodDivision& division = {});

/// Returns j0 of a point of a section bent at rest, not below 0.25: a section that reaches the centre of its
/// bend is cut off there.
[[nodiscard]] double restFibre(const Point2& point_m, double kappa1_per_m, double kappa2_per_m);

/// Moments of an outline about its frame's origin, each point weighted with 1 / j0, j0 = 1 + kappa1 y -
/// kappa2 x, the length of a fibre of a section bent at rest over that of the axis. Exact for kappa = 0.
struct SectionMoments {
  double area_m2 = 0.0;  ///< of 1
  double x_m3 = 0.0;     ///< of x
  double y_m3 = 0.0;     ///< of y
  double xx_m4 = 0.0;    ///< of x x
  double xy_m4 = 0.0;    ///< of x y
  double yy_m4 = 0.0;    ///< of y y
};
[[nodiscard]] SectionMoments momentsOf(std::span<const Point2> outline_m, double kappa1_per_m,
                                       double kappa2_per_m);

}  // namespace torsio
