// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::gui {

/// A vertex as sent to the graphics card: view frame, mm.
struct SurfaceVertex {
  float position[3];
  float normal[3];
  float colour[4];  ///< linear; white unless painted
};
static_assert(sizeof(SurfaceVertex) == 40, "the layout that OrganGeometry announces");

/// The drawn shape of the organ: takes deformed vertices, computes smooth normals, can be painted. Plain
/// value without a scene graph; use from one thread.
class OrganSurface {
 public:
  OrganSurface() = default;
  explicit OrganSurface(const TriangleMesh& mesh);

  /// Sets the vertices, metres, world frame, one per mesh vertex; recomputes normals (area-weighted).
  void update(std::span<const Vec3> vertices_m);

  /// Sets one vertex, metres, world frame, and its normal, of any length.
  void place(std::uint32_t vertex, const Vec3& at_m, const Vec3& normal);

  /// Moves all vertices inwards along their normals, so that a coincident surface is seen instead.
  void sink(float depth_mm);

  /// Sets colours, sRGB, one per vertex; empty: white.
  void paint(std::span<const std::array<float, 3>> colours);

  [[nodiscard]] std::span<const SurfaceVertex> vertices() const noexcept { return vertices_; }
  [[nodiscard]] std::span<const TriangleMesh::Triangle> triangles() const noexcept { return triangles_; }
  /// Returns every edge once, for the wireframe.
  [[nodiscard]] std::vector<std::array<std::uint32_t, 2>> edges() const;

 private:
  /// Input of the normals, packed together.
  struct Turning {
    std::array<float, 4> place{};
    std::array<float, 4> sum{};
  };

  std::vector<SurfaceVertex> vertices_;
  std::vector<Turning> turning_;  // one per vertex
  std::vector<TriangleMesh::Triangle> triangles_;
};

}  // namespace torsio::gui
