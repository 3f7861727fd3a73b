// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/baseline/reference_solid.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/rod/fold_check.h"
#include "sim/tissue/section/wall_section.h"

namespace torsio::cli {

/// Boundary conditions of an organ twisted as a curved rod.
enum class RodEnds {
  kClampedTurned,  ///< lower face held; upper face rotated about its tangent in place
  kClampedFree,    ///< lower face held; one section rotated about its tangent, otherwise free
};

struct RodTwistRequest {
  RodEnds ends = RodEnds::kClampedTurned;
  double shearModulus_Pa = 0.0;
  double poisson = 0.5;
  double angle_rad = 0.0;
  double grasp = 1.0;  ///< position of the rotated section, fraction of the length; the upper face: 1
  /// True: a jaw grips, so that the sections within half a local radius rotate as one (kClampedFree only).
  bool jaw = false;
  WallMap wall;            ///< of a hollow organ; empty: solid
  bool reference = false;  ///< also rotates the accuracy reference; requires poisson < 0.5
  ReferenceElements referenceElements = ReferenceElements::kWedges;
};

/// The accuracy reference (sim/baseline/reference_solid.h) rotated like the rod.
struct TwistReference {
  ReferenceElements elements = ReferenceElements::kWedges;
  double torque_Nm = 0.0;
  double energy_J = 0.0;
  int unknowns = 0;
  std::vector<double> turn_rad;  ///< rotation of the lattice sections
};

struct RodTwistResult {
  std::vector<double> nodeArcs_m;  ///< of the nodes of the rod
  std::vector<double> arcs_m;      ///< of the sections of the lattice
  std::vector<double> turn_rad;    ///< rotation of each about its own rest tangent
  double angle_rad = 0.0;  ///< as far as it goes: below that of the request if no pose is at rest there
  Text beyond;             ///< the limit that the answer passes; empty: none
  double torque_Nm = 0.0;  ///< about the rest tangent of the rotated section
  double energy_J = 0.0;
  int elements = 0;
  std::vector<Vec3> vertices_m;  ///< of the mesh, twisted
  double inverse_m = 0.0;        ///< largest error of a vertex moved and traced back to rest
  FoldReport fold;
  std::optional<TwistReference> reference;
};

/// Twists the organ of a scene as a curved rod, as far as it finds a pose at rest. Throws
/// Error{kBadParameter} for a material out of range, and for a jaw that reaches the clamp.
[[nodiscard]] RodTwistResult rodTwist(const Scene& scene, const RodTwistRequest& request);

// Output of `torsio twist` by kind of organ. docs/cli.md lists the keys.

/// By section: position, angle and twist rate by the twist model.
[[nodiscard]] nlohmann::ordered_json angleProfile(const TwistModel& model, const TwistState& state);
/// By section: position and twist rate of an organ modelled as a rod.
[[nodiscard]] nlohmann::ordered_json twistProfile(const Scene& scene, const RodPose& pose);
/// By section: position and rotation about its own tangent, with those of the reference if present.
[[nodiscard]] nlohmann::ordered_json turnProfile(const RodTwistResult& twist);
/// By section: position, rotation and radius of an organ that is twisted initially.
[[nodiscard]] nlohmann::ordered_json hollowProfile(const Scene& scene, const OrganState& state);

/// Torque, compliance and the twist model's measures of the shape.
[[nodiscard]] nlohmann::ordered_json modelResult(const Scene& scene, const TwistState& state);
/// Result of a pattern's task for an organ modelled as a rod.
[[nodiscard]] nlohmann::ordered_json taskResult(const Scene& scene, const TaskPoint& point);
/// State of an initially twisted organ at an angle and the pressure of its scene.
[[nodiscard]] nlohmann::ordered_json hollowResult(const HollowOrgan& organ, const OrganState& state);

}  // namespace torsio::cli
