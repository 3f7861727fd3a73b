// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_cut.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_repair.h"

namespace torsio {

namespace {

class PlaneCut {
 public:
  PlaneCut(const TriangleMesh& mesh, const Vec3& normal, double offset_m) : whole_(mesh) {
    part_.vertices_m = mesh.vertices_m;
    heights_m_.reserve(mesh.vertices_m.size());
    for (const Vec3& p : mesh.vertices_m) {
      heights_m_.push_back(dot(normal, p) - offset_m);
    }
  }

  TriangleMesh cut() {
    for (const TriangleMesh::Triangle& t : whole_.triangles) {
      cutTriangle(t);
    }
    MeshRepairs ignored;
    removeUnusedVertices(part_, ignored);
    return std::move(part_);
  }

 private:
  [[nodiscard]] bool kept(std::uint32_t v) const { return heights_m_[v] >= 0.0; }

  void cutTriangle(const TriangleMesh::Triangle& t) {
    std::array<std::uint32_t, 4> corners{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      if (kept(from)) {
        corners[count++] = from;
      }
      if (kept(from) != kept(to)) {
        corners[count++] = crossing(from, to);
      }
    }
    for (std::size_t k = 2; k < count; ++k) {
      part_.triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
  }

  /// The vertex where the plane crosses an edge: the same from both sides.
  std::uint32_t crossing(std::uint32_t from, std::uint32_t to) {
    const auto [a, b] = std::minmax(from, to);
    const auto [place, isNew] = crossings_.try_emplace({a, b}, 0U);
    if (isNew) {
      const double share = heights_m_[a] / (heights_m_[a] - heights_m_[b]);
      place->second = static_cast<std::uint32_t>(part_.vertices_m.size());
      part_.vertices_m.push_back(whole_.vertices_m[a] +
                                 share * (whole_.vertices_m[b] - whole_.vertices_m[a]));
    }
    return place->second;
  }

  const TriangleMesh& whole_;
  TriangleMesh part_;
  std::vector<double> heights_m_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
};

}  // namespace

TriangleMesh cutAt(const TriangleMesh& mesh, const Vec3& normal, double offset_m) {
  return PlaneCut(mesh, normal, offset_m).cut();
}

}  // namespace torsio
