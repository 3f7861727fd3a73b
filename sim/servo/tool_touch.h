// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include "sim/core/angle.h"
#include "sim/core/device_sample.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "sim/geometry/query/deformed_surface.h"
#include "sim/scene/organ_state.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Distance of the jaw's hinge behind the tip: `jaws.pivot_mm` of assets/instruments/grasper.json, as
/// tests/sim/servo/tool_touch_test.cpp checks.
inline constexpr double kJawLength_m = 0.020;
/// Turn of each blade when the jaw is open: `jaws.opening_deg` of the same file.
inline constexpr double kJawOpening_rad = radians(25.0);
/// Radius of a blade as a share of the tip's radius: a blade is thinner than the closed jaw.
inline constexpr double kBladeShare = 0.6;
/// Distance from blade and shaft within which surfaces are searched.
inline constexpr double kLookAhead_m = 0.001;

/// The instrument as the collision sees it, world frame: a sphere at the tip, where the blades meet; two
/// blades from the hinge, which open by `grip` in the tool's y-z plane; the shaft from the hinge along the
/// tool's +z axis, as thick as the tip.
struct ToolShape {
  Vec3 tip_m;
  std::array<Segment, 2> blades;
  Segment shaft;
  Segment
      mouth;  ///< between the blades, from the tip halfway to the hinge: what tissue must reach to be held
  double tipRadius_m = 0.0;
  double bladeRadius_m = 0.0;
};

/// Returns the shape of `instrument` in the pose and with the grip of `tool`. Any thread.
[[nodiscard]] ToolShape toolShape(const ToolState& tool, const Instrument& instrument) noexcept;

/// Contact of one part of the instrument with the deformed surface, world frame.
struct PartTouch {
  double gap_m = std::numeric_limits<double>::infinity();  ///< between them; negative: that deep inside
  Vec3 point_m;                                            ///< of the surface
  Vec3 normal;                                             ///< unit, outwards: where the surface pushes
  double radius_m = 0.0;                                   ///< of the part
};

/// What is remembered of one part of the instrument from the ticks before.
struct PartMemory {
  std::uint32_t triangle = kNoTriangle;  ///< nearest when it was last looked for
  Segment axis;                          ///< of the part then
  TwistState twist;                      ///< of the organ then
  double free_m = -1.0;  ///< the surface was that far from the part at least; below 0: unknown
};

/// Triangles near the tip, of the organ as it lay at one time: no other one came nearer than `reach_m`.
struct TipPlace {
  double reach_m = -1.0;  ///< below 0: unknown
  Vec3 tip_m;
  TwistState twist;
  FacetList near;
};

/// What is remembered of the instrument, so that the next tick need not look where it cannot touch: a part
/// that was so far from the surface, and with it the surface, has not gone that far since. Changes no answer
/// but a gap beyond kLookAhead_m, which may be told as infinite. Trivially copyable; of one scene.
struct TouchMemory {
  PartMemory tip;
  std::array<PartMemory, 2> blades;
  PartMemory shaft;
  TipPlace place;  ///< of the tip, where it may touch
};

/// What each part of the instrument touches.
struct ToolTouch {
  PartTouch tip;    ///< the sphere at the tip; of a deformed organ infinite gap beyond a centimetre
  PartTouch jaw;    ///< the deeper of tip and blades
  PartTouch shaft;  ///< infinite gap beyond kLookAhead_m
};

/// Finds where the instrument touches the organ as it lies. A part whose axis lies outside has
/// the depth of the capsule; one whose axis has entered is as deep as the deepest of some points of the
/// axis near the place of entry. `holding`: the blades are in the tissue and do not collide.
///
/// At rest the rest hierarchy answers (CollisionMesh::nearest), else DeformedSurface over the vertices as the
/// model moves them: the surface that is drawn. Parts that cannot have come near since the ticks that
/// `memory` tells of are not asked for; it is brought up to date, and a fresh one remembers nothing.
/// noexcept, allocation-free; runs in the servo tick.
[[nodiscard]] ToolTouch touchTool(const ToolShape& shape, const Scene& scene, const OrganState& organ,
                                  bool holding, TouchMemory& memory) noexcept;

/// Finds the point of the surface that is nearest to `point_m` on the organ as it lies. Any thread.
[[nodiscard]] SurfacePoint nearestSurface(const Vec3& point_m, const Scene& scene,
                                          const OrganState& organ) noexcept;

/// Finds what closing the jaw would take hold of: the surface point nearest to the mouth within `gripReach_m`
/// of the tip's radius, if it lies between the open blades; nothing else can be held. The point is given on
/// the organ at rest.
[[nodiscard]] std::optional<SurfacePoint> tissueInMouth(const ToolShape& shape, const ToolState& tool,
                                                        const Scene& scene, const OrganState& organ) noexcept;

}  // namespace torsio
