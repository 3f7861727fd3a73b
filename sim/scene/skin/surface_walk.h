// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A point that walks on a surface: where it is, in which triangle, and the unit direction in its plane.
struct SurfaceWalker {
  Vec3 place_m;
  Vec3 heading;
  std::uint32_t triangle = 0;
};

/// Straight ways on a triangle surface: over an edge the way goes on as if both triangles were folded flat.
/// Keeps a reference to the mesh. Plain value.
class SurfaceWalk {
 public:
  explicit SurfaceWalk(const TriangleMesh& mesh);

  [[nodiscard]] const Vec3& normal(std::uint32_t triangle) const { return normals_[triangle]; }
  /// The triangle on the other side of the edge from corner `k` to the next; kNone at a hole.
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t triangle, std::size_t k) const {
    return neighbours_[triangle][k];
  }
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  /// Moves by `way_m`; false when the surface ends before.
  bool step(SurfaceWalker& walker, double way_m) const;
  /// Turns the heading to the left, seen from outside.
  void turn(SurfaceWalker& walker, double angle_rad) const;
  /// Puts a wished direction into the plane of the walker's triangle.
  void head(SurfaceWalker& walker, const Vec3& direction) const;

 private:
  const TriangleMesh& mesh_;
  std::vector<Vec3> normals_;
  std::vector<std::array<std::uint32_t, 3>> neighbours_;
};

}  // namespace torsio
