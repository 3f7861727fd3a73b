// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/plane_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

struct HalfEdge {
  int low = 0;
  int high = 0;
  int triangle = 0;
  int corner = 0;
};

/// The refinement of one mesh; the neighbours are kept up to date all the way.
class Bisection {
 public:
  explicit Bisection(PlaneMesh& mesh) : mesh_(mesh) {}

  /// Follows the chain of ever longer edges until the edge that two triangles agree on, splits it, and
  /// repeats until `triangle` itself was split.
  void split(int triangle) {
    for (;;) {
      int t = triangle;
      for (;;) {
        const int corner = longest(t);
        const int other = mesh_.neighbours[at(t)][at(corner)];
        if (other < 0 || mesh_.neighbours[at(other)][at(longest(other))] == t) {
          splitEdge(t, corner);
          if (t == triangle || other == triangle) {
            return;
          }
          break;
        }
        t = other;
      }
    }
  }

 private:
  /// Corner that faces the longest edge. Ties are broken by the point numbers, so that the order of edges is
  /// strict and the chain above ends.
  [[nodiscard]] int longest(int t) const {
    int best = 0;
    for (int k = 1; k < 3; ++k) {
      if (shorter(t, best, k)) {
        best = k;
      }
    }
    return best;
  }

  [[nodiscard]] bool shorter(int t, int j, int k) const {
    const auto [a, b] = ends(t, j);
    const auto [c, d] = ends(t, k);
    const double first = squaredLength(a, b), second = squaredLength(c, d);
    if (first != second) {
      return first < second;
    }
    return std::pair{a, b} < std::pair{c, d};
  }

  [[nodiscard]] std::pair<int, int> ends(int t, int corner) const {
    const int a = mesh_.triangles[at(t)][at((corner + 1) % 3)];
    const int b = mesh_.triangles[at(t)][at((corner + 2) % 3)];
    return {std::min(a, b), std::max(a, b)};
  }

  [[nodiscard]] double squaredLength(int a, int b) const {
    const double dx = mesh_.points[at(b)][0] - mesh_.points[at(a)][0];
    const double dy = mesh_.points[at(b)][1] - mesh_.points[at(a)][1];
    return dx * dx + dy * dy;
  }

  int addMiddle(int a, int b, bool onBoundary) {
    const Point2 p = mesh_.points[at(a)], q = mesh_.points[at(b)];
    mesh_.points.push_back({0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])});
    mesh_.arc.push_back(onBoundary ? middleArc(mesh_, a, b) : 0.0);
    mesh_.loop.push_back(onBoundary ? mesh_.loop[at(a)] : -1);
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  /// Splits `t` towards the middle point `m` of the edge facing `corner`: `t` keeps the side of the next
  /// point, the returned triangle has the other.
  int halve(int t, int corner, int m) {
    const int apex = mesh_.triangles[at(t)][at(corner)];
    const int a = mesh_.triangles[at(t)][at((corner + 1) % 3)];
    const int b = mesh_.triangles[at(t)][at((corner + 2) % 3)];
    const int facingA = mesh_.neighbours[at(t)][at((corner + 1) % 3)];
    const int facingB = mesh_.neighbours[at(t)][at((corner + 2) % 3)];
    const int created = static_cast<int>(mesh_.triangles.size());
    mesh_.triangles[at(t)] = {apex, a, m};
    mesh_.neighbours[at(t)] = {-1, created, facingB};
    mesh_.triangles.push_back({apex, m, b});
    mesh_.neighbours.push_back({-1, facingA, t});
    relink(mesh_, facingA, t, created);
    return created;
  }

  void splitEdge(int t, int corner) {
    const int a = mesh_.triangles[at(t)][at((corner + 1) % 3)];
    const int b = mesh_.triangles[at(t)][at((corner + 2) % 3)];
    const int other = mesh_.neighbours[at(t)][at(corner)];
    const int m = addMiddle(a, b, other < 0);
    int otherCorner = 0;
    if (other >= 0) {
      while (mesh_.neighbours[at(other)][at(otherCorner)] != t) {
        ++otherCorner;
      }
    }
    const int created = halve(t, corner, m);
    if (other < 0) {
      return;
    }
    const int createdOther = halve(other, otherCorner, m);
    // `other` starts at b (it runs the edge the other way round): it meets `created`.
    mesh_.neighbours[at(t)][0] = createdOther;
    mesh_.neighbours[at(created)][0] = other;
    mesh_.neighbours[at(other)][0] = created;
    mesh_.neighbours[at(createdOther)][0] = t;
  }

  PlaneMesh& mesh_;
};

/// Rays of a ring stay at least this many, so that the fan round the centre has no blunt corners.
constexpr std::size_t kMinRays = 8;

struct Ring {
  std::vector<int> rays;    // numbers of the outline points, ascending
  std::vector<int> points;  // mesh points, one a ray
  double fraction = 1.0;    // of the way from the centre to the outline
};

double squaredGap(const Point2& a, const Point2& b) {
  const double dx = b[0] - a[0], dy = b[1] - a[1];
  return dx * dx + dy * dy;
}

/// Triangles between an outer ring and an inner one whose rays are all or some of the outer ones.
std::vector<std::array<int, 3>> strip(const PlaneMesh& mesh, const Ring& outer, const Ring& inner) {
  const auto point = [&mesh](int k) -> const Point2& { return mesh.points[static_cast<std::size_t>(k)]; };
  std::vector<std::array<int, 3>> triangles;
  const std::size_t n = outer.rays.size(), m = inner.rays.size();
  std::size_t begin = 0;
  for (std::size_t i = 0; i < m; ++i) {
    const int b0 = inner.points[i], b1 = inner.points[(i + 1) % m];
    std::size_t end = begin + 1;
    while (end < n && (i + 1 == m || outer.rays[end] < inner.rays[i + 1])) {
      ++end;
    }
    // The outer points up to the middle one look at b0, the others at b1.
    const auto a = [&](std::size_t k) { return outer.points[k % n]; };
    std::size_t middle = begin + (end - begin) / 2;
    if (end == begin + 1 && squaredGap(point(a(end)), point(b0)) <= squaredGap(point(a(begin)), point(b1))) {
      middle = end;
    }
    for (std::size_t k = begin; k < middle; ++k) {
      triangles.push_back({a(k), a(k + 1), b0});
    }
    triangles.push_back({a(middle), b1, b0});
    for (std::size_t k = middle; k < end; ++k) {
      triangles.push_back({a(k), a(k + 1), b1});
    }
    begin = end;
  }
  return triangles;
}

bool allAnticlockwise(const PlaneMesh& mesh, const std::vector<std::array<int, 3>>& triangles) {
  // A sliver counts as turned over: its corner angles would spoil the elements.
  constexpr double kLeastRoundness = 0.02;
  for (const auto& t : triangles) {
    const Point2& a = mesh.points[static_cast<std::size_t>(t[0])];
    const Point2& b = mesh.points[static_cast<std::size_t>(t[1])];
    const Point2& c = mesh.points[static_cast<std::size_t>(t[2])];
    const double edges = squaredGap(a, b) + squaredGap(b, c) + squaredGap(c, a);
    if (orientation(a, b, c) < kLeastRoundness * edges) {
      return false;
    }
  }
  return true;
}

class PolarMesher {
 public:
  PolarMesher(const BoundaryLoop& outline, const Point2& centre) : outline_(outline), centre_(centre) {}

  PlaneMesh build(int rings) {
    Ring outer;
    const int first = addLoop(mesh_, outline_);
    for (int i = 0; i < static_cast<int>(outline_.points.size()); ++i) {
      outer.rays.push_back(i);
      outer.points.push_back(first + i);
    }
    // Half the mean step at the outline, where the stress changes, one and a half at the centre.
    for (int r = rings - 1; r >= 1; --r) {
      const double even = static_cast<double>(r) / rings;
      outer = nextRing(outer, 0.5 * even * (3.0 - even));
    }
    // The top of the membrane is often at the centre: once more halfway there.
    outer = nextRing(outer, 0.5 * outer.fraction);
    const int middle = addPoint(centre_);
    for (std::size_t i = 0; i < outer.points.size(); ++i) {
      mesh_.triangles.push_back({outer.points[i], outer.points[(i + 1) % outer.points.size()], middle});
    }
    linkNeighbours(mesh_);
    return std::move(mesh_);
  }

 private:
  int addPoint(const Point2& p) {
    mesh_.points.push_back(p);
    mesh_.loop.push_back(-1);
    mesh_.arc.push_back(0.0);
    return static_cast<int>(mesh_.points.size()) - 1;
  }

  Ring nextRing(const Ring& outer, double fraction) {
    // Mean way across a cell on this ring against the way along the ray.
    const double across = 2.0 * kPi * fraction / static_cast<double>(outer.rays.size());
    if (across < outer.fraction - fraction && outer.rays.size() >= 2 * kMinRays) {
      // An odd number leaves out two in one place, so that no narrow gap is handed on to the next ring.
      std::vector<int> half;
      for (std::size_t i = 0; i + 1 < outer.rays.size(); i += 2) {
        half.push_back(outer.rays[i]);
      }
      if (tryRing(outer, half, fraction)) {
        return ring_;
      }
    }
    const bool kept = tryRing(outer, outer.rays, fraction);
    if (!kept) {
      mesh_.triangles.insert(mesh_.triangles.end(), strip_.begin(), strip_.end());
    }
    return ring_;
  }

  /// Leaves the new ring in `ring_` and its triangles in `strip_`; takes both back out of the mesh when a
  /// triangle came out too thin and fewer rays were asked for.
  bool tryRing(const Ring& outer, const std::vector<int>& rays, double fraction) {
    ring_ = {rays, {}, fraction};
    const std::size_t before = mesh_.points.size();
    for (const int ray : rays) {
      const Point2& p = outline_.points[static_cast<std::size_t>(ray)];
      ring_.points.push_back(addPoint(
          {centre_[0] + fraction * (p[0] - centre_[0]), centre_[1] + fraction * (p[1] - centre_[1])}));
    }
    strip_ = strip(mesh_, outer, ring_);
    if (allAnticlockwise(mesh_, strip_)) {
      mesh_.triangles.insert(mesh_.triangles.end(), strip_.begin(), strip_.end());
      return true;
    }
    if (rays.size() != outer.rays.size()) {
      mesh_.points.resize(before);
      mesh_.loop.resize(before);
      mesh_.arc.resize(before);
    }
    return false;
  }

  const BoundaryLoop& outline_;
  Point2 centre_;
  PlaneMesh mesh_;
  Ring ring_;
  std::vector<std::array<int, 3>> strip_;
};

}  // namespace

void relink(PlaneMesh& mesh, int t, int old, int now) {
  if (t < 0) {
    return;
  }
  for (int& neighbour : mesh.neighbours[at(t)]) {
    if (neighbour == old) {
      neighbour = now;
      return;
    }
  }
}

int addLoop(PlaneMesh& mesh, const BoundaryLoop& boundary) {
  const int first = static_cast<int>(mesh.points.size());
  const int loop = static_cast<int>(mesh.loopLength.size());
  mesh.points.insert(mesh.points.end(), boundary.points.begin(), boundary.points.end());
  mesh.arc.insert(mesh.arc.end(), boundary.arc.begin(), boundary.arc.end());
  mesh.loop.insert(mesh.loop.end(), boundary.points.size(), loop);
  mesh.loopLength.push_back(boundary.length);
  return first;
}

void linkNeighbours(PlaneMesh& mesh) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
    for (int k = 0; k < 3; ++k) {
      const int a = mesh.triangles[at(t)][at((k + 1) % 3)];
      const int b = mesh.triangles[at(t)][at((k + 2) % 3)];
      edges.push_back({std::min(a, b), std::max(a, b), t, k});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& p, const HalfEdge& q) {
    return std::array{p.low, p.high, p.triangle} < std::array{q.low, q.high, q.triangle};
  });
  mesh.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const HalfEdge& p = edges[i];
    const HalfEdge& q = edges[i + 1];
    if (p.low != q.low || p.high != q.high) {
      continue;
    }
    mesh.neighbours[at(p.triangle)][at(p.corner)] = q.triangle;
    mesh.neighbours[at(q.triangle)][at(q.corner)] = p.triangle;
  }
}

double middleArc(const PlaneMesh& mesh, int a, int b) {
  TORSIO_EXPECTS(mesh.loop[at(a)] >= 0 && mesh.loop[at(a)] == mesh.loop[at(b)]);
  const double length = mesh.loopLength[at(mesh.loop[at(a)])];
  const double low = std::min(mesh.arc[at(a)], mesh.arc[at(b)]);
  const double high = std::max(mesh.arc[at(a)], mesh.arc[at(b)]);
  // The edge that closes the loop runs from the last point to the first.
  if (low == 0.0 && high > 0.5 * length) {
    return 0.5 * (high + length);
  }
  return 0.5 * (low + high);
}

void bisect(PlaneMesh& mesh, std::span<const char> marked) {
  TORSIO_EXPECTS(marked.size() == mesh.triangles.size());
  Bisection bisection(mesh);
  // A triangle may have been split for a neighbour's sake already; its remaining half is split once more only
  // if nothing has happened to it, which its points tell.
  const std::vector<std::array<int, 3>> before(mesh.triangles.begin(), mesh.triangles.end());
  for (std::size_t t = 0; t < marked.size(); ++t) {
    if (marked[t] != 0 && mesh.triangles[t] == before[t]) {
      bisection.split(static_cast<int>(t));
    }
  }
}

PlaneMesh polarMesh(const BoundaryLoop& outline, const Point2& centre, int rings) {
  TORSIO_EXPECTS(rings >= 1 && outline.points.size() >= 3);
  return PolarMesher(outline, centre).build(rings);
}

}  // namespace torsio
