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

/// A flat map of a closed surface: pieces that look nearly one way, each laid flat and packed beside the
/// others. A vertex on the border of pieces is drawn once for each.
struct SkinCharts {
  struct Corner {
    std::uint32_t vertex = 0;      ///< of the mesh
    std::array<float, 2> place{};  ///< on the map, pixels from its top left corner
  };
  std::vector<Corner> corners;                    ///< what is drawn; the first are not in the mesh's order
  std::vector<TriangleMesh::Triangle> triangles;  ///< of corners, in the order of the mesh
  int width = 0;                                  ///< of the map, pixels
  int height = 0;
  double pixel_m = 0.0;  ///< size of a pixel on tissue that lies flat
};

/// Empty ground round every piece, pixels: what a smoothed look-up may touch.
inline constexpr int kChartMargin = 3;

/// Lays the surface flat. `pixel_m`: the wished size; larger when the map would pass `mostPixels`.
[[nodiscard]] SkinCharts layFlat(const TriangleMesh& mesh, double pixel_m, int mostPixels);

}  // namespace torsio
