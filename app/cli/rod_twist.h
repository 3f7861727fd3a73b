// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/baseline/reference_solid.h"
#include "sim/scene/scene.h"
#include "sim/tissue/rod/fold_check.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio::cli {

/// Ends of an organ that is twisted as a curved rod.
enum class RodEnds {
  kClampedTurned,  ///< lower face held; upper face turned about its tangent, its place held
  kClampedFree,    ///< lower face held; one section turned about its tangent, all else free
};

/// Request for one twist of an organ as a curved rod.
struct RodTwistRequest {
  RodEnds ends = RodEnds::kClampedTurned;
  double shearModulus_Pa = 0.0;
  double poisson = 0.5;
  double angle_rad = 0.0;
  double grasp = 1.0;  ///< place of the turned section, fraction of the length; the upper face: 1
  /// Whether a jaw grips there: the sections within half a local radius turn as one (kClampedFree only).
  bool jaw = false;
  WallMap wall;            ///< of a hollow organ; empty: filled
  bool reference = false;  ///< whether the accuracy reference is turned likewise; needs poisson < 0.5
  ReferenceElements referenceElements = ReferenceElements::kWedges;
};

/// The accuracy reference (sim/baseline/reference_solid.h) turned as the rod is.
struct TwistReference {
  ReferenceElements elements = ReferenceElements::kWedges;
  double torque_Nm = 0.0;
  double energy_J = 0.0;
  int unknowns = 0;
  std::vector<double> turn_rad;  ///< of the sections of the lattice, as the rod's
};

/// What one twist of an organ as a curved rod comes to.
struct RodTwistResult {
  std::vector<double> nodeArcs_m;  ///< of the nodes of the rod
  std::vector<double> arcs_m;      ///< of the sections of the lattice
  std::vector<double> turn_rad;    ///< of each about its own tangent at rest
  double torque_Nm = 0.0;          ///< about the tangent at rest of the turned section
  double energy_J = 0.0;
  int elements = 0;
  std::vector<Vec3> vertices_m;  ///< of the mesh, twisted
  double inverse_m = 0.0;        ///< largest error of a vertex that is moved and traced back to rest
  FoldReport fold;
  std::optional<TwistReference> reference;
};

/// Twists the organ of a scene as a curved rod. Throws Error{kBadParameter} for a material out of range, or
/// when no pose at rest is found at this angle, and for a jaw that reaches the clamp.
[[nodiscard]] RodTwistResult rodTwist(const Scene& scene, const RodTwistRequest& request);

}  // namespace torsio::cli
