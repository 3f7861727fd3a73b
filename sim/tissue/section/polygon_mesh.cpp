// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/core/index.h"
#include "sim/tissue/section/plane_mesh.h"

namespace torsio {

namespace {

double squaredDistance(const Point2& a, const Point2& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return dx * dx + dy * dy;
}

/// Turns outline and holes into one polygon by walking to each hole and back along a bridge.
class Bridging {
 public:
  explicit Bridging(const PlaneMesh& mesh) : mesh_(mesh) {}

  /// `loops`: point numbers, outline first. Empty when a hole cannot be seen from anywhere.
  std::vector<int> join(std::vector<std::vector<int>> loops) const {
    std::vector<int> polygon = loops.front();
    loops.erase(loops.begin());
    while (!loops.empty()) {
      const auto bridge = shortestBridge(polygon, loops);
      if (bridge.hole < 0) {
        return {};
      }
      std::vector<int>& hole = loops[at(bridge.hole)];
      std::rotate(hole.begin(), hole.begin() + bridge.to, hole.end());
      std::vector<int> detour(hole.begin(), hole.end());
      detour.push_back(hole.front());
      detour.push_back(polygon[at(bridge.from)]);
      polygon.insert(polygon.begin() + bridge.from + 1, detour.begin(), detour.end());
      loops.erase(loops.begin() + bridge.hole);
    }
    return polygon;
  }

 private:
  struct Bridge {
    double squaredLength = 0.0;
    int from = -1;  // place in the polygon
    int hole = -1;
    int to = -1;  // place in the hole
  };

  Bridge shortestBridge(const std::vector<int>& polygon, const std::vector<std::vector<int>>& holes) const {
    std::vector<Bridge> bridges;
    for (int i = 0; i < static_cast<int>(polygon.size()); ++i) {
      for (int h = 0; h < static_cast<int>(holes.size()); ++h) {
        for (int j = 0; j < static_cast<int>(holes[at(h)].size()); ++j) {
          bridges.push_back({squaredDistance(point(polygon[at(i)]), point(holes[at(h)][at(j)])), i, h, j});
        }
      }
    }
    std::sort(bridges.begin(), bridges.end(), [](const Bridge& p, const Bridge& q) {
      return std::tuple{p.squaredLength, p.from, p.hole, p.to} <
             std::tuple{q.squaredLength, q.from, q.hole, q.to};
    });
    for (const Bridge& b : bridges) {
      const int from = polygon[at(b.from)], to = holes[at(b.hole)][at(b.to)];
      if (!entersAngle(polygon, b.from, to) || crosses(polygon, from, to)) {
        continue;
      }
      const bool blocked = std::any_of(holes.begin(), holes.end(),
                                       [&](const std::vector<int>& hole) { return crosses(hole, from, to); });
      if (!blocked) {
        return b;
      }
    }
    return {};
  }

  /// The bridge must leave its point on the material side: a point that carries a bridge already occurs in
  /// the polygon more than once, each time with another angle.
  bool entersAngle(const std::vector<int>& polygon, int place, int to) const {
    const int n = static_cast<int>(polygon.size());
    const Point2& a = point(polygon[at((place + n - 1) % n)]);
    const Point2& b = point(polygon[at(place)]);
    const Point2& c = point(polygon[at((place + 1) % n)]);
    const bool leftOfFirst = orientation(a, b, point(to)) > 0.0;
    const bool leftOfSecond = orientation(b, c, point(to)) > 0.0;
    return orientation(a, b, c) > 0.0 ? leftOfFirst && leftOfSecond : leftOfFirst || leftOfSecond;
  }

  [[nodiscard]] bool crosses(const std::vector<int>& loop, int from, int to) const {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const int a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a == from || b == from || a == to || b == to) {
        continue;
      }
      const double p = orientation(point(from), point(to), point(a));
      const double q = orientation(point(from), point(to), point(b));
      const double r = orientation(point(a), point(b), point(from));
      const double s = orientation(point(a), point(b), point(to));
      if (p * q <= 0.0 && r * s <= 0.0) {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] const Point2& point(int i) const { return mesh_.points[at(i)]; }

  const PlaneMesh& mesh_;
};

/// Cuts ears off until a triangle is left. False when no ear is found.
bool cutEars(PlaneMesh& mesh, std::vector<int> polygon) {
  // Points along a straight edge are collinear up to rounding; such an ear would have no area.
  constexpr double kLeastSine = 1e-9;
  const auto point = [&](int i) -> const Point2& { return mesh.points[at(i)]; };
  const auto isEar = [&](std::size_t k) {
    const std::size_t n = polygon.size();
    const int a = polygon[(k + n - 1) % n], b = polygon[k], c = polygon[(k + 1) % n];
    const double least =
        kLeastSine * (squaredDistance(point(a), point(b)) + squaredDistance(point(b), point(c)));
    if (orientation(point(a), point(b), point(c)) <= least) {
      return false;
    }
    // A point on the cut, up to rounding, would leave a polygon that touches itself.
    return std::none_of(polygon.begin(), polygon.end(), [&](int p) {
      return p != a && p != b && p != c && orientation(point(a), point(b), point(p)) >= -least &&
             orientation(point(b), point(c), point(p)) >= -least &&
             orientation(point(c), point(a), point(p)) >= -least;
    });
  };
  std::size_t k = 0, misses = 0;
  while (polygon.size() > 3) {
    const std::size_t n = polygon.size();
    if (misses > n) {
      return false;
    }
    k %= n;
    if (!isEar(k)) {
      ++k, ++misses;
      continue;
    }
    mesh.triangles.push_back({polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n]});
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
    misses = 0;
  }
  if (orientation(point(polygon[0]), point(polygon[1]), point(polygon[2])) <= 0.0) {
    return false;
  }
  mesh.triangles.push_back({polygon[0], polygon[1], polygon[2]});
  return true;
}

/// Positive when d lies inside the circle through the anticlockwise a, b, c.
double insideCircle(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double ax = a[0] - d[0], ay = a[1] - d[1];
  const double bx = b[0] - d[0], by = b[1] - d[1];
  const double cx = c[0] - d[0], cy = c[1] - d[1];
  return (ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) +
         (cx * cx + cy * cy) * (ax * by - bx * ay);
}

/// Lawson's flips: afterwards no circle round a triangle holds a visible point.
class Flipping {
 public:
  explicit Flipping(PlaneMesh& mesh) : mesh_(mesh) {}

  void all() {
    std::vector<int> waiting(mesh_.triangles.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      waiting[i] = static_cast<int>(waiting.size() - 1 - i);
    }
    from(std::move(waiting));
  }

  /// Flips what needs it, starting at the triangles given; returns every triangle that was touched.
  std::vector<int> from(std::vector<int> waiting) {
    std::vector<int> touched = waiting;
    while (!waiting.empty()) {
      const int t = waiting.back();
      waiting.pop_back();
      for (int k = 0; k < 3; ++k) {
        const int other = mesh_.neighbours[at(t)][at(k)];
        if (other < 0 || !flipIfBetter(t, k, other)) {
          continue;
        }
        waiting.push_back(other);
        waiting.push_back(t);
        touched.push_back(other);
        break;
      }
    }
    return touched;
  }

 private:
  bool flipIfBetter(int t, int k, int other) {
    int m = 0;
    while (mesh_.neighbours[at(other)][at(m)] != t) {
      ++m;
    }
    const int apex = mesh_.triangles[at(t)][at(k)];
    const int a = mesh_.triangles[at(t)][at((k + 1) % 3)];
    const int b = mesh_.triangles[at(t)][at((k + 2) % 3)];
    const int far = mesh_.triangles[at(other)][at(m)];
    const auto& p = mesh_.points;
    const double scale = squaredDistance(p[at(a)], p[at(b)]);
    // A tie (four points on a circle) must not be flipped for ever.
    if (insideCircle(p[at(apex)], p[at(a)], p[at(b)], p[at(far)]) <= 1e-11 * scale * scale) {
      return false;
    }
    if (orientation(p[at(apex)], p[at(a)], p[at(far)]) <= 0.0) {
      return false;
    }
    if (orientation(p[at(apex)], p[at(far)], p[at(b)]) <= 0.0) {
      return false;
    }
    const int besideA = mesh_.neighbours[at(t)][at((k + 2) % 3)];       // across apex-a
    const int besideB = mesh_.neighbours[at(t)][at((k + 1) % 3)];       // across b-apex
    const int farFromA = mesh_.neighbours[at(other)][at((m + 2) % 3)];  // across far-b
    const int farFromB = mesh_.neighbours[at(other)][at((m + 1) % 3)];  // across a-far
    mesh_.triangles[at(t)] = {apex, a, far};
    mesh_.neighbours[at(t)] = {farFromB, other, besideA};
    mesh_.triangles[at(other)] = {apex, far, b};
    mesh_.neighbours[at(other)] = {farFromA, besideB, t};
    relink(mesh_, farFromB, other, t);
    relink(mesh_, besideB, t, other);
    return true;
  }

  PlaneMesh& mesh_;
};

/// Puts points inside until the triangles are well shaped: the centre of the circle round a thin triangle
/// becomes a point, as in Ruppert's method, but boundary edges are never split; where the centre lies outside
/// or too near an edge the triangle is left to the adaptive splitting. Sizes then grow away from the
/// boundary.
class Filling {
 public:
  explicit Filling(PlaneMesh& mesh) : mesh_(mesh), flipping_(mesh) {}

  void run() {
    const std::size_t mostPoints = 6 * mesh_.points.size();
    std::vector<int> waiting(mesh_.triangles.size());
    for (std::size_t i = 0; i < waiting.size(); ++i) {
      waiting[i] = static_cast<int>(waiting.size() - 1 - i);
    }
    while (!waiting.empty() && mesh_.points.size() < mostPoints) {
      const int t = waiting.back();
      waiting.pop_back();
      if (!isThin(t)) {
        continue;
      }
      const Point2 centre = circleCentre(t);
      const int host = locate(t, centre);
      if (host < 0 || nearBoundary(host, centre)) {
        continue;
      }
      const std::vector<int> touched = insert(host, centre);
      waiting.insert(waiting.end(), touched.rbegin(), touched.rend());
    }
  }

 private:
  [[nodiscard]] const Point2& corner(int t, int k) const {
    return mesh_.points[at(mesh_.triangles[at(t)][at(k % 3)])];
  }

  /// Radius of the circle against the shortest edge.
  [[nodiscard]] bool isThin(int t) const {
    constexpr double kLargestSquaredRatio = 1.3;
    const Point2 c = circleCentre(t);
    const double shortest =
        std::min({squaredDistance(corner(t, 0), corner(t, 1)), squaredDistance(corner(t, 1), corner(t, 2)),
                  squaredDistance(corner(t, 2), corner(t, 0))});
    return squaredDistance(c, corner(t, 0)) > kLargestSquaredRatio * shortest;
  }

  [[nodiscard]] Point2 circleCentre(int t) const {
    const Point2 &a = corner(t, 0), &b = corner(t, 1), &c = corner(t, 2);
    const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
    const double d = 2.0 * (bx * cy - by * cx);
    const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    return {a[0] + (cy * b2 - by * c2) / d, a[1] + (bx * c2 - cx * b2) / d};
  }

  /// Walks from `t` towards `p`; -1 when a boundary edge is in the way.
  [[nodiscard]] int locate(int t, const Point2& p) const {
    for (std::size_t steps = 0; steps < mesh_.triangles.size(); ++steps) {
      int out = -1;
      for (int k = 0; k < 3 && out < 0; ++k) {
        if (orientation(corner(t, k + 1), corner(t, k + 2), p) < 0.0) {
          out = k;
        }
      }
      if (out < 0) {
        return t;
      }
      t = mesh_.neighbours[at(t)][at(out)];
      if (t < 0) {
        return -1;
      }
    }
    return -1;
  }

  /// Whether `p` lies within the circle over a boundary edge of its triangle or of a neighbour.
  [[nodiscard]] bool nearBoundary(int host, const Point2& p) const {
    const auto& around = mesh_.neighbours[at(host)];
    for (const int t : {host, around[0], around[1], around[2]}) {
      if (t < 0) {
        continue;
      }
      for (int k = 0; k < 3; ++k) {
        if (mesh_.neighbours[at(t)][at(k)] >= 0) {
          continue;
        }
        const Point2 &a = corner(t, k + 1), &b = corner(t, k + 2);
        if ((a[0] - p[0]) * (b[0] - p[0]) + (a[1] - p[1]) * (b[1] - p[1]) < 0.0) {
          return true;
        }
      }
    }
    return false;
  }

  std::vector<int> insert(int t, const Point2& p) {
    const int m = static_cast<int>(mesh_.points.size());
    mesh_.points.push_back(p);
    mesh_.loop.push_back(-1);
    mesh_.arc.push_back(0.0);
    const auto [a, b, c] = mesh_.triangles[at(t)];
    const auto [beyondA, beyondB, beyondC] = mesh_.neighbours[at(t)];
    const int second = static_cast<int>(mesh_.triangles.size()), third = second + 1;
    mesh_.triangles[at(t)] = {a, b, m};
    mesh_.neighbours[at(t)] = {second, third, beyondC};
    mesh_.triangles.push_back({b, c, m});
    mesh_.neighbours.push_back({third, t, beyondA});
    mesh_.triangles.push_back({c, a, m});
    mesh_.neighbours.push_back({t, second, beyondB});
    for (const auto& [outer, now] : {std::pair{beyondA, second}, std::pair{beyondB, third}}) {
      if (outer >= 0) {
        for (int& n : mesh_.neighbours[at(outer)]) {
          if (n == t) {
            n = now;
            break;
          }
        }
      }
    }
    return flipping_.from({t, second, third});
  }

  PlaneMesh& mesh_;
  Flipping flipping_;
};

}  // namespace

std::optional<PlaneMesh> polygonMesh(const BoundaryLoop& outline, std::span<const BoundaryLoop> holes) {
  PlaneMesh mesh;
  std::vector<std::vector<int>> loops;
  const auto take = [&](const BoundaryLoop& loop) {
    const int first = addLoop(mesh, loop);
    std::vector<int> numbers(loop.points.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      numbers[i] = first + static_cast<int>(i);
    }
    loops.push_back(std::move(numbers));
  };
  take(outline);
  for (const BoundaryLoop& hole : holes) {
    take(hole);
  }
  std::vector<int> polygon = Bridging(mesh).join(std::move(loops));
  if (polygon.empty() || !cutEars(mesh, std::move(polygon))) {
    return std::nullopt;
  }
  linkNeighbours(mesh);
  Flipping(mesh).all();
  Filling(mesh).run();
  return mesh;
}

}  // namespace torsio
