// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_holes.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_repair.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNowhere = 0xffffffffU;

/// The edges of the rims, in the direction of the faces that are to be made, by their first vertices.
std::vector<std::pair<std::uint32_t, std::uint32_t>> rimEdges(const TriangleMesh& mesh) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rims;
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) {
      ++end;
    }
    if (end - i == 1) {
      rims.emplace_back(edges[i].ascending ? edges[i].high : edges[i].low,
                        edges[i].ascending ? edges[i].low : edges[i].high);
    }
    i = end;
  }
  std::sort(rims.begin(), rims.end());
  return rims;
}

/// Walks along rims and hands each that comes back to a vertex over, so that two which meet in a vertex are
/// two rims. Edges that lead nowhere, since the faces along them disagree, are none of any.
class RimWalk {
 public:
  explicit RimWalk(const TriangleMesh& mesh)
      : edges_(rimEdges(mesh)), place_(mesh.vertices_m.size(), kNowhere) {
    next_.resize(mesh.vertices_m.size() + 1, 0);
    for (const auto& [from, to] : edges_) {
      ++next_[from + 1];
    }
    std::partial_sum(next_.begin(), next_.end(), next_.begin());
    ends_.assign(next_.begin() + 1, next_.end());
  }

  template <typename Take>
  void walk(const Take& take) {
    for (std::uint32_t v = 0; v < place_.size(); ++v) {
      while (next_[v] < ends_[v]) {
        walkFrom(v, take);
      }
    }
  }

 private:
  template <typename Take>
  void walkFrom(std::uint32_t start, const Take& take) {
    std::vector<std::uint32_t> path{start};
    place_[start] = 0;
    while (next_[path.back()] < ends_[path.back()]) {
      const std::uint32_t to = edges_[next_[path.back()]++].second;
      if (place_[to] == kNowhere) {
        place_[to] = static_cast<std::uint32_t>(path.size());
        path.push_back(to);
        continue;
      }
      const auto rim = path.begin() + place_[to];
      take(std::vector<std::uint32_t>(rim, path.end()));
      for (auto behind = rim + 1; behind != path.end(); ++behind) {
        place_[*behind] = kNowhere;
      }
      path.erase(rim + 1, path.end());
    }
    for (const std::uint32_t v : path) {
      place_[v] = kNowhere;
    }
  }

  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges_;
  std::vector<std::uint32_t> place_;  ///< of a vertex on the path
  std::vector<std::size_t> next_;     ///< edge that leaves a vertex and was not walked yet
  std::vector<std::size_t> ends_;
};

double widthOf_m(const TriangleMesh& mesh, const std::vector<std::uint32_t>& rim) {
  BoundingBox box;
  for (const std::uint32_t v : rim) {
    box.add(mesh.vertices_m[v]);
  }
  return box.largestSide();
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
  RimWalk(mesh).walk([&](const std::vector<std::uint32_t>& rim) {
    if (rim.size() >= 3) {
      ++closed.count;
      closed.widest_m = std::max(closed.widest_m, widthOf_m(mesh, rim));
      closeRim(mesh, rim);
    }
  });
  return closed;
}

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
