// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/section/plane_mesh.h"

namespace torsio {

namespace {

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

PlaneMesh polarMesh(const BoundaryLoop& outline, const Point2& centre, int rings) {
  TORSIO_EXPECTS(rings >= 1 && outline.points.size() >= 3);
  return PolarMesher(outline, centre).build(rings);
}

}  // namespace torsio
