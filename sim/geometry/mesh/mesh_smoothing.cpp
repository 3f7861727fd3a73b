// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_smoothing.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace torsio {

namespace {

constexpr double kInwards = 0.5;
constexpr double kOutwards = -0.53;

}  // namespace

void smooth(TriangleMesh& mesh, int passes) {
  std::vector<std::uint32_t> neighbours(mesh.vertices_m.size(), 0);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      ++neighbours[v];
    }
  }
  std::vector<Vec3> sums(mesh.vertices_m.size());
  for (int half = 0; half < 2 * passes; ++half) {
    std::fill(sums.begin(), sums.end(), Vec3{});
    for (const TriangleMesh::Triangle& t : mesh.triangles) {
      // On a closed surface each edge runs once either way: every neighbour is counted once.
      sums[t[0]] += mesh.vertices_m[t[1]];
      sums[t[1]] += mesh.vertices_m[t[2]];
      sums[t[2]] += mesh.vertices_m[t[0]];
    }
    const double share = half % 2 == 0 ? kInwards : kOutwards;
    for (std::size_t v = 0; v < sums.size(); ++v) {
      if (neighbours[v] > 0) {
        const Vec3 middle = sums[v] / static_cast<double>(neighbours[v]);
        mesh.vertices_m[v] += share * (middle - mesh.vertices_m[v]);
      }
    }
  }
}

}  // namespace torsio
