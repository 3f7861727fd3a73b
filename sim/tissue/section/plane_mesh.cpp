// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/plane_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "sim/core/contracts.h"
#include "sim/core/index.h"

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

  void replaceNeighbour(int t, int old, int now) {
    if (t < 0) {
      return;
    }
    for (int& n : mesh_.neighbours[at(t)]) {
      if (n == old) {
        n = now;
        return;
      }
    }
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
    replaceNeighbour(facingA, t, created);
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

}  // namespace

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

}  // namespace torsio
