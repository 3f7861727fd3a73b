// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "sim/core/vec3.h"

namespace torsio {

/// An indexed triangle surface. Metres, LPS frame (x left, y back, z up); corners anticlockwise seen from
/// outside. Plain value: checks are in mesh_check.h.
struct TriangleMesh {
  using Triangle = std::array<std::uint32_t, 3>;
  std::vector<Vec3> vertices_m;
  std::vector<Triangle> triangles;
};

/// A box along the axes about the points that were added.
struct BoundingBox {
  Vec3 low{1e300, 1e300, 1e300};
  Vec3 high{-1e300, -1e300, -1e300};

  void add(const Vec3& p) noexcept;
  [[nodiscard]] double largestSide() const noexcept;
};
[[nodiscard]] BoundingBox boxOf(std::span<const Vec3> points) noexcept;

/// Computes area-weighted unit normals, one a vertex, pointing outwards.
[[nodiscard]] std::vector<Vec3> vertexNormals(const TriangleMesh& mesh);

/// Computes the enclosed volume in m^3 (divergence theorem); negative when the surface is inside out.
[[nodiscard]] double signedVolume_m3(const TriangleMesh& mesh);

/// Computes the hash over the exact vertices and triangles: names the organ in every recorded trial.
[[nodiscard]] std::string contentHash(const TriangleMesh& mesh);

}  // namespace torsio
