// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <tuple>
#include <utility>
#include <vector>

#include <queue>

#include "sim/geometry/mesh/flat_faces.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/surface_topology.h"

namespace torsio {

namespace {

constexpr double kLeastCosine = 0.3;     // between a triangle's normal before and after a collapse
constexpr double kEvenness = 5e-3;       // weight of the squared edge length beside the squared distance
constexpr double kTowardsMiddle = 1e-3;  // weight of the edge's middle where planes leave the place open
constexpr double kHold = 100.0;          // weight of the plane of a flat face beside all others of a vertex

/// Sum of squared distances to planes, each weighted by its triangle's area.
struct PlaneSum {
  std::array<double, 6> matrix{};  // xx, xy, xz, yy, yz, zz
  Vec3 vector;
  double constant = 0.0;
  double weight = 0.0;

  /// The plane through `point` with the unit normal `n`.
  void add(const Vec3& n, const Vec3& point, double area) {
    hold(n, point, area);
    weight += area;
  }
  /// The same as a condition on the place, which does not count as area.
  void hold(const Vec3& n, const Vec3& point, double area) {
    const double d = -dot(n, point);
    matrix[0] += area * n.x * n.x, matrix[1] += area * n.x * n.y, matrix[2] += area * n.x * n.z;
    matrix[3] += area * n.y * n.y, matrix[4] += area * n.y * n.z, matrix[5] += area * n.z * n.z;
    vector += (area * d) * n;
    constant += area * d * d;
  }
  void add(const PlaneSum& other) {
    for (std::size_t i = 0; i < matrix.size(); ++i) {
      matrix[i] += other.matrix[i];
    }
    vector += other.vector;
    constant += other.constant;
    weight += other.weight;
  }
  [[nodiscard]] double at(const Vec3& p) const {
    const Vec3 product{matrix[0] * p.x + matrix[1] * p.y + matrix[2] * p.z,
                       matrix[1] * p.x + matrix[3] * p.y + matrix[4] * p.z,
                       matrix[2] * p.x + matrix[4] * p.y + matrix[5] * p.z};
    return std::max(0.0, dot(p, product) + 2.0 * dot(vector, p) + constant);
  }
  /// Where the sum is least; near `middle` as far as the planes do not say.
  [[nodiscard]] Vec3 least(const Vec3& middle) const {
    const double pull = kTowardsMiddle * weight;
    const double xx = matrix[0] + pull;
    const double yy = matrix[3] + pull;
    const double zz = matrix[5] + pull;
    const auto [xy, xz, yz] = std::tuple(matrix[1], matrix[2], matrix[4]);
    const Vec3 wanted = pull * middle - vector;
    const Vec3 x{xx, xy, xz};
    const Vec3 y{xy, yy, yz};
    const Vec3 z{xz, yz, zz};
    const double all = dot(x, cross(y, z));
    if (!(all > 0.0)) {
      return middle;
    }
    return Vec3{dot(wanted, cross(y, z)), dot(wanted, cross(z, x)), dot(wanted, cross(x, y))} / all;
  }
};

/// Collapses edges in the order of what they cost.
class EdgeThinning {
 public:
  explicit EdgeThinning(TriangleMesh& mesh)
      : mesh_(mesh),
        left_(mesh.triangles.size()),
        gone_(mesh.triangles.size(), false),
        fans_(mesh.vertices_m.size()),
        planes_(mesh.vertices_m.size()),
        version_(mesh.vertices_m.size(), 0) {
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      const TriangleMesh::Triangle& corners = mesh_.triangles[t];
      const Vec3 twice = normalTimesTwiceArea(corners);
      const double length = norm(twice);
      for (const std::uint32_t v : corners) {
        fans_[v].push_back(t);
        if (length > 0.0) {
          planes_[v].add(twice / length, mesh_.vertices_m[corners[0]], 0.5 * length);
        }
      }
    }
    holdFlatFaces();
    for (const TriangleMesh::Triangle& t : mesh_.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (t[k] < t[(k + 1) % 3]) {  // of a closed surface each edge runs once so
          offer(t[k], t[(k + 1) % 3]);
        }
      }
    }
  }

  void run(std::size_t most) {
    while (left_ > most && !waiting_.empty()) {
      const Collapse next = waiting_.top();
      waiting_.pop();
      if (next.versions == std::array{version_[next.kept], version_[next.lost]}) {
        const Vec3 place = placeFor(next.kept, next.lost);
        if (mayCollapse(next.kept, next.lost, place)) {
          collapse(next.kept, next.lost, place);
        }
      }
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      if (!gone_[i]) {
        mesh_.triangles[kept++] = mesh_.triangles[i];
      }
    }
    mesh_.triangles.resize(kept);
  }

 private:
  struct Collapse {
    double cost = 0.0;
    std::uint32_t kept = 0;
    std::uint32_t lost = 0;
    std::array<std::uint32_t, 2> versions{};
    /// The cheapest comes first; among equals the one of the earlier vertices.
    friend bool operator<(const Collapse& a, const Collapse& b) {
      return std::tie(b.cost, b.kept, b.lost) < std::tie(a.cost, a.kept, a.lost);
    }
  };

  /// Keeps flat ends flat and their rims sharp. The triangles at a rim may be slivers whose area says next to
  /// nothing of their plane, and each collapse would lift the rim a little.
  void holdFlatFaces() {
    for (const FlatFace& face : findFlatFaces(mesh_, SurfaceTopology(mesh_))) {
      for (const std::uint32_t v : face.vertices) {
        planes_[v].hold(face.normal, face.centroid_m, kHold * planes_[v].weight);
      }
    }
  }

  Vec3 normalTimesTwiceArea(const TriangleMesh::Triangle& t) const {
    const auto& p = mesh_.vertices_m;
    return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
  }

  Vec3 placeFor(std::uint32_t kept, std::uint32_t lost) const {
    PlaneSum sum = planes_[kept];
    sum.add(planes_[lost]);
    const Vec3 middle = 0.5 * (mesh_.vertices_m[kept] + mesh_.vertices_m[lost]);
    const Vec3 place = sum.least(middle);
    const double length = norm(mesh_.vertices_m[kept] - mesh_.vertices_m[lost]);
    return norm(place - middle) <= length ? place : middle;
  }

  void offer(std::uint32_t a, std::uint32_t b) {
    const auto [kept, lost] = std::minmax(a, b);
    const Vec3 place = placeFor(kept, lost);
    const Vec3 along = mesh_.vertices_m[kept] - mesh_.vertices_m[lost];
    const double cost = planes_[kept].at(place) + planes_[lost].at(place) +
                        kEvenness * dot(along, along) * (planes_[kept].weight + planes_[lost].weight);
    waiting_.push({cost, kept, lost, {version_[kept], version_[lost]}});
  }

  /// The neighbours of a vertex, ascending, each once.
  void listAround(std::uint32_t v, std::vector<std::uint32_t>& around) const {
    around.clear();
    for (const std::uint32_t t : fans_[v]) {
      for (const std::uint32_t other : mesh_.triangles[t]) {
        if (other != v) {
          around.push_back(other);
        }
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
  }

  /// Tells whether an edge may go: its ends share two neighbours and no more, which keeps the topology, and
  /// no triangle turns over or loses its area.
  bool mayCollapse(std::uint32_t kept, std::uint32_t lost, const Vec3& place) {
    listAround(kept, around_);
    listAround(lost, aroundLost_);
    shared_.clear();
    std::set_intersection(around_.begin(), around_.end(), aroundLost_.begin(), aroundLost_.end(),
                          std::back_inserter(shared_));
    return shared_.size() == 2 && turnsNothingOver(kept, lost, place) && turnsNothingOver(lost, kept, place);
  }

  bool turnsNothingOver(std::uint32_t moved, std::uint32_t other, const Vec3& place) const {
    for (const std::uint32_t t : fans_[moved]) {
      const TriangleMesh::Triangle& corners = mesh_.triangles[t];
      if (std::find(corners.begin(), corners.end(), other) != corners.end()) {
        continue;
      }
      std::array<Vec3, 3> p{};
      for (std::size_t k = 0; k < 3; ++k) {
        p[k] = corners[k] == moved ? place : mesh_.vertices_m[corners[k]];
      }
      const Vec3 was = normalTimesTwiceArea(corners);
      const Vec3 is = cross(p[1] - p[0], p[2] - p[0]);
      if (isDegenerate(p[0], p[1], p[2]) || dot(was, is) < kLeastCosine * norm(was) * norm(is)) {
        return false;
      }
    }
    return true;
  }

  void collapse(std::uint32_t kept, std::uint32_t lost, const Vec3& place) {
    mesh_.vertices_m[kept] = place;
    planes_[kept].add(planes_[lost]);
    for (const std::uint32_t t : fans_[lost]) {
      TriangleMesh::Triangle& corners = mesh_.triangles[t];
      if (std::find(corners.begin(), corners.end(), kept) != corners.end()) {
        gone_[t] = true;
        --left_;
        const std::uint32_t third = corners[0] + corners[1] + corners[2] - kept - lost;
        std::erase(fans_[third], t);
      } else {
        std::replace(corners.begin(), corners.end(), lost, kept);
        fans_[kept].push_back(t);
      }
    }
    std::erase_if(fans_[kept], [this](std::uint32_t t) { return gone_[t]; });
    fans_[lost] = {};
    ++version_[kept];
    ++version_[lost];
    listAround(kept, around_);
    for (const std::uint32_t v : around_) {
      offer(kept, v);
    }
  }

  TriangleMesh& mesh_;
  std::size_t left_;
  std::vector<bool> gone_;
  std::vector<std::vector<std::uint32_t>> fans_;  // triangles round each vertex
  std::vector<PlaneSum> planes_;
  std::vector<std::uint32_t> version_;
  std::priority_queue<Collapse> waiting_;
  std::vector<std::uint32_t> around_;
  std::vector<std::uint32_t> aroundLost_;
  std::vector<std::uint32_t> shared_;
};

}  // namespace

TriangleMesh thinned(TriangleMesh mesh, std::size_t most) {
  if (mesh.triangles.size() > most) {
    MeshRepairs ignored;
    EdgeThinning(mesh).run(most);
    removeUnusedVertices(mesh, ignored);
  }
  return mesh;
}

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
