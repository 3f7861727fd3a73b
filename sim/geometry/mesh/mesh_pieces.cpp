// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr std::uint32_t kUnnumbered = 0xffffffffU;

double twiceArea(const TriangleMesh& mesh, const Triangle& t) {
  const Vec3& a = mesh.vertices_m[t[0]];
  return norm(cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a));
}

// Union-find with path halving.
class Partition {
 public:
  explicit Partition(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      i = parent_[i] = parent_[parent_[i]];
    }
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a != b) {
      parent_[std::max(a, b)] = std::min(a, b);
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// Solid angle of the surface seen from `p` over 4 pi (van Oosterom and Strackee): +-1 inside, 0 outside.
double windingNumber(const TriangleMesh& mesh, const std::vector<std::uint32_t>& component,
                     std::uint32_t which, const Vec3& p) {
  double twice = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (component[t] != which) {
      continue;
    }
    const Vec3 a = mesh.vertices_m[mesh.triangles[t][0]] - p;
    const Vec3 b = mesh.vertices_m[mesh.triangles[t][1]] - p;
    const Vec3 c = mesh.vertices_m[mesh.triangles[t][2]] - p;
    const double na = norm(a), nb = norm(b), nc = norm(c);
    twice +=
        portableAtan2(dot(a, cross(b, c)), na * nb * nc + dot(a, b) * nc + dot(b, c) * na + dot(c, a) * nb);
  }
  return twice / (2.0 * kPi);
}

void keepComponents(TriangleMesh& mesh, const std::vector<std::uint32_t>& component,
                    const std::vector<bool>& keep) {
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (keep[component[t]]) {
      kept.push_back(mesh.triangles[t]);
    }
  }
  mesh.triangles = std::move(kept);
}

}  // namespace

std::vector<std::uint32_t> componentOfTriangles(const TriangleMesh& mesh) {
  Partition partition(mesh.vertices_m.size());
  for (const Triangle& t : mesh.triangles) {
    partition.join(t[0], t[1]);
    partition.join(t[0], t[2]);
  }
  std::vector<std::uint32_t> number(mesh.vertices_m.size(), kUnnumbered);
  std::vector<std::uint32_t> component(mesh.triangles.size());
  std::uint32_t next = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& n = number[partition.find(mesh.triangles[t][0])];
    if (n == kUnnumbered) {
      n = next++;
    }
    component[t] = n;
  }
  return component;
}

double keepMainComponent(TriangleMesh& mesh, double smallShare, MeshRepairs& repairs) {
  const std::vector<std::uint32_t> component = componentOfTriangles(mesh);
  const std::size_t count =
      component.empty() ? 0 : *std::max_element(component.begin(), component.end()) + std::size_t{1};
  if (count < 2) {
    return 0.0;
  }
  std::vector<double> area(count, 0.0);
  std::vector<Vec3> somePoint(count);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    area[component[t]] += twiceArea(mesh, mesh.triangles[t]);
    somePoint[component[t]] = mesh.vertices_m[mesh.triangles[t][0]];
  }
  const auto main = static_cast<std::uint32_t>(std::max_element(area.begin(), area.end()) - area.begin());
  const double total = std::accumulate(area.begin(), area.end(), 0.0);

  constexpr double kWorthTesting = 1e-3;  // the inside test costs a pass over the mesh
  constexpr double kInside = 0.5;
  std::size_t shells = 0;
  double outside = 0.0;
  for (std::uint32_t c = 0; c < count; ++c) {
    if (c == main) {
      continue;
    }
    const bool inner = area[c] > kWorthTesting * total &&
                       std::abs(windingNumber(mesh, component, main, somePoint[c])) > kInside;
    if (inner) {
      ++shells;
    } else {
      outside += area[c];
    }
  }
  const double share = total > 0.0 ? outside / total : 0.0;
  if (share > smallShare) {
    return share;
  }
  std::vector<bool> keep(count, false);
  keep[main] = true;
  keepComponents(mesh, component, keep);
  repairs.droppedShells += shells;
  repairs.droppedComponents += count - 1 - shells;
  return 0.0;
}

}  // namespace torsio
