// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>

#include "sim/base/vec3.h"
#include "sim/geometry/triangle_mesh.h"

namespace torsio {

/// Closest point of the organ's rest surface to a query point. Metres.
struct SurfacePoint {
  Vec3 position_m;
  Vec3 normal;              ///< unit, outwards (angle-weighted pseudonormal)
  double distance_m = 0.0;  ///< signed: negative inside the organ
  std::uint32_t triangle = 0;
  double barycentric[3] = {1.0, 0.0, 0.0};  ///< of the triangle's corners
};

/// Bounding-volume hierarchy over a closed rest surface (FCL, private). Immutable after construction: queries
/// keep no state, so that any thread may ask, and are noexcept and without allocation, so that they may run
/// in the servo tick. The answer does not depend on the shape of the hierarchy: of equally near triangles the
/// one with the lowest index is taken, and all arithmetic is IEEE basic operations in a fixed order.
class CollisionMesh {
 public:
  /// `mesh`: closed and consistently oriented (requireOrgan), at least 4 triangles; copied.
  explicit CollisionMesh(const TriangleMesh& mesh);
  ~CollisionMesh();
  CollisionMesh(CollisionMesh&&) noexcept;
  CollisionMesh& operator=(CollisionMesh&&) noexcept;

  /// The nearest surface point. The sign comes from the pseudonormal of the face, edge or vertex on which it
  /// lies (Baerentzen and Aanaes 2005), which is exact for a closed surface; on the surface itself the
  /// distance is zero. A point that is not finite gets an infinite distance.
  [[nodiscard]] SurfacePoint closest(const Vec3& point_m) const noexcept;

 private:
  struct Hierarchy;
  std::unique_ptr<Hierarchy> hierarchy_;
};

}  // namespace torsio
