// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_holes.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "sim/geometry/mesh/mesh_repair.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNowhere = 0xffffffffU;

/// The vertex after each on a rim, in the direction of the faces that are to be made; kNowhere off the rims,
/// and where rims meet.
std::vector<std::uint32_t> rimsOf(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> next(mesh.vertices_m.size(), kNowhere);
  std::vector<std::uint32_t> met;
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) {
      ++end;
    }
    if (end - i == 1) {
      const std::uint32_t from = edges[i].ascending ? edges[i].high : edges[i].low;
      const std::uint32_t to = edges[i].ascending ? edges[i].low : edges[i].high;
      if (next[from] != kNowhere) {
        met.push_back(from);
      }
      next[from] = to;
    }
    i = end;
  }
  for (const std::uint32_t v : met) {
    next[v] = kNowhere;
  }
  return next;
}

/// The rim through a vertex; empty where it does not come back to it.
std::vector<std::uint32_t> rimFrom(std::uint32_t start, std::vector<std::uint32_t>& next) {
  std::vector<std::uint32_t> rim;
  std::uint32_t v = start;
  do {
    rim.push_back(v);
    const std::uint32_t following = next[v];
    next[v] = kNowhere;
    v = following;
  } while (v != kNowhere && v != start);
  return v == start ? rim : std::vector<std::uint32_t>{};
}

double widthOf_m(const TriangleMesh& mesh, const std::vector<std::uint32_t>& rim) {
  Vec3 low = mesh.vertices_m[rim.front()];
  Vec3 high = low;
  for (const std::uint32_t v : rim) {
    const Vec3& p = mesh.vertices_m[v];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

void closeRim(TriangleMesh& mesh, const std::vector<std::uint32_t>& rim) {
  if (rim.size() == 3) {
    mesh.triangles.push_back({rim[0], rim[1], rim[2]});
    return;
  }
  Vec3 middle;
  for (const std::uint32_t v : rim) {
    middle += mesh.vertices_m[v] / static_cast<double>(rim.size());
  }
  const auto centre = static_cast<std::uint32_t>(mesh.vertices_m.size());
  mesh.vertices_m.push_back(middle);
  for (std::size_t i = 0; i < rim.size(); ++i) {
    mesh.triangles.push_back({rim[i], rim[(i + 1) % rim.size()], centre});
  }
}

}  // namespace

ClosedHoles closeHoles(TriangleMesh& mesh) {
  ClosedHoles closed;
  std::vector<std::uint32_t> next = rimsOf(mesh);
  const auto vertices = static_cast<std::uint32_t>(next.size());
  for (std::uint32_t v = 0; v < vertices; ++v) {
    if (next[v] == kNowhere) {
      continue;
    }
    const std::vector<std::uint32_t> rim = rimFrom(v, next);
    if (rim.size() >= 3) {
      ++closed.count;
      closed.widest_m = std::max(closed.widest_m, widthOf_m(mesh, rim));
      closeRim(mesh, rim);
    }
  }
  return closed;
}

}  // namespace torsio
