// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// One corner as the graphics card reads it: view frame, millimetres.
struct SurfaceVertex {
  float position[3];
  float normal[3];
  float colour[4];  ///< linear; white unless painted
};
static_assert(sizeof(SurfaceVertex) == 40, "the layout that OrganGeometry announces");

/// The drawn shape of the organ: takes twisted vertices, makes smooth normals, can be painted.
/// Plain value without a scene graph; one thread.
class OrganSurface {
 public:
  OrganSurface() = default;
  explicit OrganSurface(const TriangleMesh& mesh);

  /// Vertices in metres, world frame, one a mesh vertex; normals are recomputed (area-weighted).
  void update(std::span<const Vec3> vertices_m);

  /// Moves every vertex inward along its normal: where another surface has the same place, that one is seen.
  void sink(float depth_mm);

  /// Colours of one's own, sRGB, one a vertex; empty: none, which is white.
  void paint(std::span<const std::array<float, 3>> colours);

  [[nodiscard]] std::span<const SurfaceVertex> vertices() const noexcept { return vertices_; }
  [[nodiscard]] std::span<const TriangleMesh::Triangle> triangles() const noexcept { return triangles_; }
  /// Every edge once: the wireframe.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> edges() const;

 private:
  /// What normals are made of, side by side.
  struct Turning {
    std::array<float, 4> place{};
    std::array<float, 4> sum{};
  };

  std::vector<SurfaceVertex> vertices_;
  std::vector<Turning> turning_;  // one a vertex
  std::vector<TriangleMesh::Triangle> triangles_;
};

}  // namespace torsio::gui
