// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/remesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;

constexpr double kLong = 4.0 / 3.0;  // of the wanted length (Botsch and Kobbelt 2004)
constexpr double kShort = 4.0 / 5.0;
constexpr int kRounds = 12;
constexpr int kCollapsePasses = 40;
constexpr int kTurnPasses = 12;
constexpr double kRelaxation = 0.6;
constexpr double kSmallestTurn = 0.5;  // cosine: a face may tilt by 60 degrees when an edge collapses

// Triangles around each vertex, as one array.
class Stars {
 public:
  explicit Stars(const TriangleMesh& mesh) : first_(mesh.vertices_m.size() + 1, 0) {
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t corner : t) {
        ++first_[corner + 1];
      }
    }
    for (std::size_t v = 1; v < first_.size(); ++v) {
      first_[v] += first_[v - 1];
    }
    triangles_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t corner : mesh.triangles[t]) {
        triangles_[next[corner]++] = t;
      }
    }
  }
  [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t vertex) const {
    return std::span(triangles_).subspan(first_[vertex], first_[vertex + 1] - first_[vertex]);
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> triangles_;
};

// The original surface: nearest points by walking from a triangle already near.
class Reference {
 public:
  explicit Reference(const TriangleMesh& mesh) : mesh_(mesh), stars_(mesh) {}

  // Moves `point` to the surface and `home` to the triangle on which it then lies.
  void project(Vec3& point, std::uint32_t& home) const {
    NearestOnTriangle best = nearest(point, home);
    for (bool moved = true; moved;) {
      moved = false;
      const Triangle here = mesh_.triangles[home];
      for (const std::uint32_t corner : here) {
        for (const std::uint32_t t : stars_.of(corner)) {
          const NearestOnTriangle n = nearest(point, t);
          if (!(n.distance2 < best.distance2)) {
            continue;
          }
          best = n;
          home = t;
          moved = true;
        }
      }
    }
    point = best.point;
  }
  [[nodiscard]] std::uint32_t someTriangleOf(std::uint32_t vertex) const { return stars_.of(vertex).front(); }

 private:
  [[nodiscard]] NearestOnTriangle nearest(const Vec3& p, std::uint32_t triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    return nearestOnTriangle(p, {mesh_.vertices_m[t[0]], mesh_.vertices_m[t[1]], mesh_.vertices_m[t[2]]});
  }
  const TriangleMesh& mesh_;
  Stars stars_;
};

// One edge of a closed surface: triangles (a, b, c) and (b, a, d).
struct Edge {
  double ratio = 0.0;  // length over wanted length
  std::uint32_t a = 0, b = 0, c = 0, d = 0;
  std::uint32_t left = 0, right = 0;
};

class Remesher {
 public:
  Remesher(const TriangleMesh& mesh, const std::function<double(const Vec3&)>& edgeLength)
      : reference_(mesh), edgeLength_(edgeLength), mesh_(mesh), homes_(mesh.vertices_m.size()) {
    for (std::uint32_t v = 0; v < homes_.size(); ++v) {
      homes_[v] = reference_.someTriangleOf(v);
    }
  }

  TriangleMesh run() {
    for (int pass = 0; pass < kCollapsePasses && collapseShort() > 0; ++pass) {
      turnEdges();
    }
    for (int round = 0; round < kRounds; ++round) {
      splitLong();
      collapseShort();
      for (int pass = 0; pass < kTurnPasses && turnEdges() > 0; ++pass) {
        continue;
      }
      relax();
    }
    for (int pass = 0; pass < kTurnPasses && turnEdges() > 0; ++pass) {
      continue;
    }
    return std::move(mesh_);
  }

 private:
  const Vec3& at(std::uint32_t vertex) const { return mesh_.vertices_m[vertex]; }

  double ratio(const Vec3& p, const Vec3& q) const { return norm(p - q) / edgeLength_(0.5 * (p + q)); }

  std::vector<Edge> edges() const {
    const std::vector<EdgeUse> uses = sortedEdges(mesh_);
    std::vector<Edge> found;
    found.reserve(uses.size() / 2);
    for (std::size_t i = 0; i + 1 < uses.size(); i += 2) {
      const EdgeUse& up = uses[i].ascending ? uses[i] : uses[i + 1];
      const EdgeUse& down = uses[i].ascending ? uses[i + 1] : uses[i];
      found.push_back({ratio(at(up.low), at(up.high)), up.low, up.high,
                       mesh_.triangles[up.triangle][(up.side + 2U) % 3],
                       mesh_.triangles[down.triangle][(down.side + 2U) % 3], up.triangle, down.triangle});
    }
    return found;
  }

  std::uint32_t addMidpoint(std::uint32_t a, std::uint32_t b) {
    Vec3 middle = 0.5 * (at(a) + at(b));
    std::uint32_t home = homes_[a];
    reference_.project(middle, home);
    mesh_.vertices_m.push_back(middle);
    homes_.push_back(home);
    return static_cast<std::uint32_t>(homes_.size() - 1);
  }

  void splitLong() {
    std::vector<Edge> candidates = edges();
    std::erase_if(candidates, [](const Edge& e) { return e.ratio <= kLong; });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](auto& x, auto& y) { return x.ratio > y.ratio; });
    std::vector<bool> touched(mesh_.triangles.size(), false);
    for (const Edge& e : candidates) {
      if (touched[e.left] || touched[e.right]) {
        continue;
      }
      touched[e.left] = touched[e.right] = true;
      const std::uint32_t m = addMidpoint(e.a, e.b);
      mesh_.triangles[e.left] = {e.a, m, e.c};
      mesh_.triangles[e.right] = {e.b, m, e.d};
      mesh_.triangles.push_back({m, e.b, e.c});
      mesh_.triangles.push_back({m, e.a, e.d});
    }
  }

  std::vector<std::uint32_t> ringOf(const Stars& stars, std::uint32_t vertex) const {
    std::vector<std::uint32_t> ring;
    for (const std::uint32_t t : stars.of(vertex)) {
      for (const std::uint32_t corner : mesh_.triangles[t]) {
        if (corner != vertex) {
          ring.push_back(corner);
        }
      }
    }
    std::sort(ring.begin(), ring.end());
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    return ring;
  }

  // Whether the triangles around `vertex`, except the two at the edge, stay upright and short-sided when it
  // moves to `target`.
  bool mayMove(const Stars& stars, std::uint32_t vertex, const Edge& e, const Vec3& target) const {
    for (const std::uint32_t t : stars.of(vertex)) {
      if (t == e.left || t == e.right) {
        continue;
      }
      std::array<Vec3, 3> p{};
      std::array<Vec3, 3> q{};
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t corner = mesh_.triangles[t][k];
        p[k] = at(corner);
        q[k] = corner == vertex ? target : p[k];
        if (corner != vertex && ratio(target, p[k]) > kLong) {
          return false;
        }
      }
      const Vec3 before = normalized(cross(p[1] - p[0], p[2] - p[0]));
      const Vec3 after = normalized(cross(q[1] - q[0], q[2] - q[0]));
      // A sliver of the fine surface has no direction worth keeping.
      if (!isDegenerate(p[0], p[1], p[2]) && dot(before, after) < kSmallestTurn) {
        return false;
      }
    }
    return true;
  }

  std::size_t collapseShort() {
    std::vector<Edge> candidates = edges();
    std::erase_if(candidates, [](const Edge& e) { return e.ratio >= kShort; });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](auto& x, auto& y) { return x.ratio < y.ratio; });
    const Stars stars(mesh_);
    std::vector<bool> locked(mesh_.vertices_m.size(), false);
    std::vector<bool> dead(mesh_.triangles.size(), false);
    std::size_t collapsed = 0;
    for (const Edge& e : candidates) {
      if (locked[e.a] || locked[e.b]) {
        continue;
      }
      const std::vector<std::uint32_t> ringA = ringOf(stars, e.a);
      const std::vector<std::uint32_t> ringB = ringOf(stars, e.b);
      std::vector<std::uint32_t> common;
      std::set_intersection(ringA.begin(), ringA.end(), ringB.begin(), ringB.end(),
                            std::back_inserter(common));
      if (common.size() != 2) {
        continue;  // link condition: otherwise the surface would be pinched
      }
      Vec3 target = 0.5 * (at(e.a) + at(e.b));
      std::uint32_t home = homes_[e.a];
      reference_.project(target, home);
      if (!mayMove(stars, e.a, e, target) || !mayMove(stars, e.b, e, target)) {
        continue;
      }
      mesh_.vertices_m[e.a] = target;
      homes_[e.a] = home;
      for (const std::uint32_t t : stars.of(e.b)) {
        for (std::uint32_t& corner : mesh_.triangles[t]) {
          corner = corner == e.b ? e.a : corner;
        }
      }
      dead[e.left] = dead[e.right] = true;
      for (const std::uint32_t v : ringA) {
        locked[v] = true;
      }
      for (const std::uint32_t v : ringB) {
        locked[v] = true;
      }
      ++collapsed;
    }
    removeDead(dead);
    return collapsed;
  }

  void removeDead(const std::vector<bool>& dead) {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < dead.size(); ++t) {
      if (!dead[t]) {
        mesh_.triangles[kept++] = mesh_.triangles[t];
      }
    }
    mesh_.triangles.resize(kept);
    std::vector<std::uint32_t> target(mesh_.vertices_m.size(), 0);
    for (const Triangle& t : mesh_.triangles) {
      for (const std::uint32_t corner : t) {
        target[corner] = 1;
      }
    }
    std::uint32_t next = 0;
    for (std::size_t v = 0; v < target.size(); ++v) {
      if (target[v] == 0) {
        continue;
      }
      mesh_.vertices_m[next] = mesh_.vertices_m[v];
      homes_[next] = homes_[v];
      target[v] = next++;
    }
    mesh_.vertices_m.resize(next);
    homes_.resize(next);
    for (Triangle& t : mesh_.triangles) {
      for (std::uint32_t& corner : t) {
        corner = target[corner];
      }
    }
  }

  Vec3 normal(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return normalized(cross(at(b) - at(a), at(c) - at(a)));
  }

  // Cotangent of the angle at `apex` over the edge p-q.
  double cotangent(std::uint32_t apex, std::uint32_t p, std::uint32_t q) const {
    const Vec3 u = at(p) - at(apex);
    const Vec3 v = at(q) - at(apex);
    return dot(u, v) / norm(cross(u, v));
  }

  // Turns edges whose opposite angles sum to more than 180 degrees. Returns how many.
  std::size_t turnEdges() {
    const std::vector<Edge> all = edges();
    std::set<std::pair<std::uint32_t, std::uint32_t>> added;
    const auto connected = [&all, &added](std::uint32_t p, std::uint32_t q) {
      const std::pair wanted{std::min(p, q), std::max(p, q)};
      const auto found =
          std::lower_bound(all.begin(), all.end(), wanted, [](const Edge& e, const auto& pair) {
            return std::pair{e.a, e.b} < pair;
          });
      return added.contains(wanted) || (found != all.end() && std::pair{found->a, found->b} == wanted);
    };
    std::vector<bool> touched(mesh_.triangles.size(), false);
    std::size_t turned = 0;
    for (const Edge& e : all) {
      if (touched[e.left] || touched[e.right] || e.c == e.d || connected(e.c, e.d)) {
        continue;
      }
      constexpr double kWorthIt = -1e-6;
      if (!(cotangent(e.c, e.a, e.b) + cotangent(e.d, e.a, e.b) < kWorthIt)) {
        continue;
      }
      const Vec3 old = normalized(normal(e.a, e.b, e.c) + normal(e.b, e.a, e.d));
      if (dot(old, normal(e.a, e.d, e.c)) < kSmallestTurn ||
          dot(old, normal(e.d, e.b, e.c)) < kSmallestTurn) {
        continue;
      }
      mesh_.triangles[e.left] = {e.a, e.d, e.c};
      mesh_.triangles[e.right] = {e.d, e.b, e.c};
      touched[e.left] = touched[e.right] = true;
      added.emplace(std::min(e.c, e.d), std::max(e.c, e.d));
      ++turned;
    }
    return turned;
  }

  // Each vertex moves towards the middle of its neighbours, along the surface only.
  void relax() {
    const std::vector<Vec3> normals = vertexNormals(mesh_);
    std::vector<Vec3> sum(mesh_.vertices_m.size());
    std::vector<double> weight(mesh_.vertices_m.size(), 0.0);
    for (const Triangle& t : mesh_.triangles) {
      const Vec3 middle = (at(t[0]) + at(t[1]) + at(t[2])) / 3.0;
      const double length = edgeLength_(middle);
      const double area = norm(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
      const double w = area / (length * length);
      for (const std::uint32_t corner : t) {
        sum[corner] += w * middle;
        weight[corner] += w;
      }
    }
    for (std::uint32_t v = 0; v < sum.size(); ++v) {
      if (!(weight[v] > 0.0)) {
        continue;
      }
      Vec3 step = kRelaxation * (sum[v] / weight[v] - at(v));
      step -= dot(step, normals[v]) * normals[v];
      mesh_.vertices_m[v] += step;
      reference_.project(mesh_.vertices_m[v], homes_[v]);
    }
  }

  Reference reference_;
  const std::function<double(const Vec3&)>& edgeLength_;
  TriangleMesh mesh_;
  std::vector<std::uint32_t> homes_;  // triangle of the reference on which each vertex lies
};

}  // namespace

TriangleMesh remeshed(const TriangleMesh& mesh, const std::function<double(const Vec3&)>& edgeLength) {
  return Remesher(mesh, edgeLength).run();
}

namespace {

constexpr std::size_t kBlock = 8;  // grid steps of one skipped region

// Values of the field where the surface may be near, the value at the middle of the block elsewhere.
std::vector<double> sample(const SampleGrid& grid, double slope,
                           const std::function<double(const Vec3&)>& field) {
  const auto [nx, ny, nz] = grid.count;
  std::vector<double> values(nx * ny * nz);
  const double half = 0.5 * static_cast<double>(kBlock) * grid.step;
  for (std::size_t z0 = 0; z0 < nz; z0 += kBlock) {
    for (std::size_t y0 = 0; y0 < ny; y0 += kBlock) {
      for (std::size_t x0 = 0; x0 < nx; x0 += kBlock) {
        const Vec3 corner = grid.origin + grid.step * Vec3{static_cast<double>(x0), static_cast<double>(y0),
                                                           static_cast<double>(z0)};
        const double middle = field(corner + Vec3{half, half, half});
        const bool clear = std::abs(middle) > slope * std::sqrt(3.0) * half;
        for (std::size_t z = z0; z < std::min(nz, z0 + kBlock); ++z) {
          for (std::size_t y = y0; y < std::min(ny, y0 + kBlock); ++y) {
            for (std::size_t x = x0; x < std::min(nx, x0 + kBlock); ++x) {
              const Vec3 step{static_cast<double>(x - x0), static_cast<double>(y - y0),
                              static_cast<double>(z - z0)};
              values[(z * ny + y) * nx + x] = clear ? middle : field(corner + grid.step * step);
            }
          }
        }
      }
    }
  }
  return values;
}

}  // namespace

TriangleMesh zeroSurface(const SampleGrid& grid, double slope,
                         const std::function<double(const Vec3&)>& field) {
  const std::vector<double> values = sample(grid, slope, field);
  return isoSurface(grid, [&values](std::size_t z, std::span<double> layer) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(z * layer.size()), layer.size(), layer.begin());
  });
}

}  // namespace torsio
