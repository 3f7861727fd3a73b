// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "sim/geometry/mesh/surface_patches.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Bounding-volume hierarchy over a closed rest surface (FCL, private). Immutable after construction: queries
/// keep no state, so that any thread may ask, and are noexcept and without allocation, so that they may run
/// in the servo tick. The answer does not depend on the shape of the hierarchy: of equally near triangles the
/// one with the lowest index is taken, and all arithmetic is IEEE basic operations in a fixed order. Copies
/// share the hierarchy.
class CollisionMesh {
 public:
  /// Builds the hierarchy of `mesh`, which is copied: closed and consistently oriented (requireOrgan), at
  /// least 4 triangles.
  explicit CollisionMesh(const TriangleMesh& mesh);

  /// Returns the nearest surface point. The sign of the distance comes from the pseudonormal of the face,
  /// edge or vertex on which the point lies (Baerentzen and Aanaes 2005), which is exact for a closed
  /// surface; on the surface itself the distance is zero. A point that is not finite gets an infinite
  /// distance. `hint`: a triangle that may be near, which makes the query quick and changes no answer.
  [[nodiscard]] SurfacePoint closest(const Vec3& point_m, std::uint32_t hint = kNoTriangle) const noexcept;

  /// Returns the closest pair of surface and segment when it is nearer than `reach_m`; a small reach makes
  /// the query quick. The sign of the distance belongs to the segment's point. A segment that pierces the
  /// surface has distance 0 there; a surface that is merely touched by a segment inside has a negative one.
  /// `hint` as for closest().
  [[nodiscard]] SegmentHit nearest(const Segment& segment, double reach_m,
                                   std::uint32_t hint = kNoTriangle) const noexcept;

  /// Returns the patches for queries of the surface in a deformed state (deformed_surface.h).
  [[nodiscard]] const SurfacePatches& patches() const noexcept { return patches_; }

 private:
  struct Hierarchy;
  std::shared_ptr<const Hierarchy> hierarchy_;
  SurfacePatches patches_;
};

}  // namespace torsio
