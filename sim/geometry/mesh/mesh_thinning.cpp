// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_thinning.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_repair.h"

namespace torsio {

namespace {

constexpr int kMostPasses = 40;
constexpr double kLeastCosine = 0.3;   // between a triangle's normal before and after a collapse
constexpr double kShareOfEdges = 0.3;  // of the edges, the shortest, that a pass tries

/// One pass of collapses over a surface: neighbours of a collapsed edge are left alone until the next.
class ThinningPass {
 public:
  explicit ThinningPass(TriangleMesh& mesh)
      : mesh_(mesh), locked_(mesh.vertices_m.size(), false), gone_(mesh.triangles.size(), false) {
    listFans();
  }

  /// Collapses at most `most` edges, the shortest first; returns how many.
  std::size_t run(std::size_t most) {
    std::size_t done = 0;
    for (const auto& [length2, low, high] : shortestEdges()) {
      if (done == most) {
        break;
      }
      if (!locked_[low] && !locked_[high] && mayCollapse(low, high)) {
        collapse(low, high);
        ++done;
      }
    }
    dropGone();
    return done;
  }

 private:
  struct Edge {
    double length2 = 0.0;
    std::uint32_t low = 0;
    std::uint32_t high = 0;
  };

  void listFans() {
    first_.assign(mesh_.vertices_m.size() + 1, 0);
    for (const TriangleMesh::Triangle& t : mesh_.triangles) {
      for (const std::uint32_t v : t) {
        ++first_[v + 1];
      }
    }
    for (std::size_t v = 1; v < first_.size(); ++v) {
      first_[v] += first_[v - 1];
    }
    fans_.resize(3 * mesh_.triangles.size());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t i = 0; i < mesh_.triangles.size(); ++i) {
      for (const std::uint32_t v : mesh_.triangles[i]) {
        fans_[next[v]++] = i;
      }
    }
  }

  std::vector<Edge> shortestEdges() const {
    std::vector<Edge> edges;
    edges.reserve(mesh_.triangles.size() * 3 / 2);
    for (const TriangleMesh::Triangle& t : mesh_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        if (a < b) {  // of a closed surface each edge runs once so
          const Vec3 along = mesh_.vertices_m[b] - mesh_.vertices_m[a];
          edges.push_back({dot(along, along), a, b});
        }
      }
    }
    const auto before = [](const Edge& x, const Edge& y) {
      return x.length2 != y.length2 ? x.length2 < y.length2
                                    : std::pair(x.low, x.high) < std::pair(y.low, y.high);
    };
    const auto tried = static_cast<std::ptrdiff_t>(kShareOfEdges * static_cast<double>(edges.size()));
    std::nth_element(edges.begin(), edges.begin() + tried, edges.end(), before);
    edges.resize(static_cast<std::size_t>(tried));
    std::sort(edges.begin(), edges.end(), before);
    return edges;
  }

  template <typename Visit>
  void eachNeighbour(std::uint32_t v, const Visit& visit) const {
    for (std::uint32_t i = first_[v]; i < first_[v + 1]; ++i) {
      for (const std::uint32_t other : mesh_.triangles[fans_[i]]) {
        if (other != v) {
          visit(other);
        }
      }
    }
  }

  /// Tells whether the edge may go: its ends share two neighbours and no more, which keeps the topology, and
  /// no triangle turns over when `high` moves to `low`.
  bool mayCollapse(std::uint32_t low, std::uint32_t high) {
    around_.clear();
    eachNeighbour(low, [this](std::uint32_t v) { around_.push_back(v); });
    std::sort(around_.begin(), around_.end());
    around_.erase(std::unique(around_.begin(), around_.end()), around_.end());
    shared_.clear();
    bool free = true;
    eachNeighbour(high, [&](std::uint32_t v) {
      free = free && !locked_[v];
      if (std::binary_search(around_.begin(), around_.end(), v)) {
        shared_.push_back(v);
      }
    });
    std::sort(shared_.begin(), shared_.end());
    shared_.erase(std::unique(shared_.begin(), shared_.end()), shared_.end());
    return free && shared_.size() == 2 && turnsNothingOver(low, high);
  }

  bool turnsNothingOver(std::uint32_t low, std::uint32_t high) const {
    for (std::uint32_t i = first_[high]; i < first_[high + 1]; ++i) {
      const TriangleMesh::Triangle& t = mesh_.triangles[fans_[i]];
      if (std::find(t.begin(), t.end(), low) != t.end()) {
        continue;
      }
      TriangleMesh::Triangle moved = t;
      std::replace(moved.begin(), moved.end(), high, low);
      const auto& p = mesh_.vertices_m;
      const Vec3 was = cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
      const Vec3 is = cross(p[moved[1]] - p[moved[0]], p[moved[2]] - p[moved[0]]);
      if (isDegenerate(p[moved[0]], p[moved[1]], p[moved[2]]) ||
          dot(was, is) < kLeastCosine * norm(was) * norm(is)) {
        return false;
      }
    }
    return true;
  }

  void collapse(std::uint32_t low, std::uint32_t high) {
    eachNeighbour(high, [this](std::uint32_t v) { locked_[v] = true; });
    eachNeighbour(low, [this](std::uint32_t v) { locked_[v] = true; });
    locked_[low] = true;
    locked_[high] = true;
    for (std::uint32_t i = first_[high]; i < first_[high + 1]; ++i) {
      TriangleMesh::Triangle& t = mesh_.triangles[fans_[i]];
      if (std::find(t.begin(), t.end(), low) != t.end()) {
        gone_[fans_[i]] = true;
      } else {
        std::replace(t.begin(), t.end(), high, low);
      }
    }
  }

  void dropGone() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!gone_[i]) {
        mesh_.triangles[kept++] = mesh_.triangles[i];
      }
    }
    mesh_.triangles.resize(kept);
  }

  TriangleMesh& mesh_;
  std::vector<bool> locked_;
  std::vector<bool> gone_;
  std::vector<std::uint32_t> first_;  // of each vertex, in fans_
  std::vector<std::uint32_t> fans_;   // triangles round each vertex
  std::vector<std::uint32_t> around_;
  std::vector<std::uint32_t> shared_;
};

}  // namespace

TriangleMesh thinned(TriangleMesh mesh, std::size_t most) {
  MeshRepairs ignored;
  for (int pass = 0; pass < kMostPasses && mesh.triangles.size() > most; ++pass) {
    const std::size_t wanted = (mesh.triangles.size() - most + 1) / 2;
    if (ThinningPass(mesh).run(wanted) == 0) {
      break;
    }
    removeUnusedVertices(mesh, ignored);
  }
  return mesh;
}

}  // namespace torsio
