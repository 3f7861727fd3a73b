// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

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
