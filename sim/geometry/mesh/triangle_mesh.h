// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
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

/// Computes area-weighted unit normals, one a vertex, pointing outwards.
[[nodiscard]] std::vector<Vec3> vertexNormals(const TriangleMesh& mesh);

/// Computes the enclosed volume in m^3 (divergence theorem); negative when the surface is inside out.
[[nodiscard]] double signedVolume_m3(const TriangleMesh& mesh);

/// Computes the hash over the exact vertices and triangles: names the organ in every recorded trial.
[[nodiscard]] std::string contentHash(const TriangleMesh& mesh);

}  // namespace torsio
