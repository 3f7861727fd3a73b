// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/query/deformed_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "sim/base/portable_math.h"
#include "sim/geometry/query/nearest_to_segment.h"

namespace torsio {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// How much more a patch may stretch than its surroundings do on the whole.
constexpr double kStretchMargin = 1.3;
// Tissue tears long before; the bound keeps a tick from looking at the whole organ.
constexpr double kLargestStretch = 3.0;

/// The best pair so far.
struct Best {
  NearestToSegment pair;
  std::uint32_t triangle = 0;
};

/// `moved`: the patch's vertex k.
template <typename Moved>
void look(const Segment& segment, std::span<const SurfacePatches::Facet> facets, const Moved& moved,
          Best& best) noexcept {
  for (const SurfacePatches::Facet& facet : facets) {
    const TriangleCorners corners{moved(facet.corner[0]), moved(facet.corner[1]), moved(facet.corner[2])};
    // Most triangles of a patch are farther than their own size.
    const Vec3 toA = segment.at(nearestAlong(segment, corners.a)) - corners.a;
    const Vec3 ab = corners.b - corners.a;
    const Vec3 ac = corners.c - corners.a;
    const double near_m = std::sqrt(dot(toA, toA)) - std::sqrt(std::max(dot(ab, ab), dot(ac, ac)));
    if (near_m > 0.0 && near_m * near_m > best.pair.on.distance2) {
      continue;
    }
    const NearestToSegment pair = nearestToSegment(segment, corners);
    const double before2 = best.pair.on.distance2;
    if (pair.on.distance2 < before2 || (pair.on.distance2 == before2 && facet.triangle < best.triangle)) {
      best = {pair, facet.triangle};
    }
  }
}

double bounded(double stretch) noexcept {
  return std::min(kLargestStretch, stretch * kStretchMargin);
}

double distance(const Segment& segment, const Vec3& point_m) noexcept {
  return norm(segment.at(nearestAlong(segment, point_m)) - point_m);
}

/// What may hold the answer, nearest first.
class OpenList {
 public:
  struct Entry {
    double bound_m;
    std::uint32_t index;
    bool isGroup;
  };

  [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
  void push(const Entry& entry) noexcept {
    entries_[count_++] = entry;
    std::push_heap(entries_.begin(), end(), farther);
  }
  Entry pop() noexcept {
    std::pop_heap(entries_.begin(), end(), farther);
    return entries_[--count_];
  }

 private:
  static bool farther(const Entry& a, const Entry& b) noexcept { return a.bound_m > b.bound_m; }
  [[nodiscard]] Entry* end() noexcept { return entries_.data() + count_; }

  std::array<Entry, SurfacePatches::kMostGroups + SurfacePatches::kMostPatches> entries_;
  std::size_t count_ = 0;
};

}  // namespace

DeformedSurface::DeformedSurface(const SurfacePatches& patches, const VertexPlaces& places) noexcept
    : patches_(patches), places_(places) {
  const auto groups = patches.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups_m_[g] = kept(place(groups[g].seed));
  }
  for (const SurfacePatches::Neighbours& pair : patches.neighbours()) {
    const double apart_m = norm(at(groups_m_[pair.one]) - at(groups_m_[pair.other]));
    stretch_ = std::max(stretch_, apart_m / pair.apart_m);
  }
}

// Moves the seeds of its patches, which also tell how the surface is stretched here.
void DeformedSurface::openGroup(std::size_t group) noexcept {
  const SurfacePatches::Group& own = patches_.groups()[group];
  opened_[group] = true;
  double stretch = stretch_;
  for (std::size_t p = own.firstPatch; p < own.firstPatch + own.patchCount; ++p) {
    const SurfacePatches::Patch& patch = patches_.patches()[p];
    const Vec3 seed_m = place(patch.seed);
    patches_m_[p] = kept(seed_m);
    movedAt_[p] = kNotMoved;
    if (patch.apart_m > 0.0) {
      stretch = std::max(stretch, norm(seed_m - at(groups_m_[group])) / patch.apart_m);
    }
  }
  for (std::size_t p = own.firstPatch; p < own.firstPatch + own.patchCount; ++p) {
    radii_m_[p] = bounded(stretch) * patches_.patches()[p].radius_m;
  }
}

std::uint32_t DeformedSurface::movePatch(std::size_t patch) noexcept {
  if (movedAt_[patch] != kNotMoved) {
    return movedAt_[patch];
  }
  const auto vertices = patches_.vertices(patches_.patches()[patch]);
  if (movedCount_ + vertices.size() > kMostMoved) {
    movedAt_.fill(kNotMoved);
    movedCount_ = 0;
  }
  const auto first = static_cast<std::uint32_t>(movedCount_);
  const Vec3 seed_m = at(patches_m_[patch]);
  double radius2 = 0.0;
  for (const std::uint32_t vertex : vertices) {
    const Vec3 v = place(vertex);
    moved_m_[movedCount_++] = kept(v);
    radius2 = std::max(radius2, dot(v - seed_m, v - seed_m));
  }
  radii_m_[patch] = std::sqrt(radius2);
  return movedAt_[patch] = first;
}

SegmentHit DeformedSurface::nearest(const Segment& segment, double reach_m) noexcept {
  OpenList open;
  Best best;
  best.pair.on.distance2 = reach_m * reach_m;
  const auto within = [&best](double bound_m) {
    return bound_m <= 0.0 || bound_m * bound_m <= best.pair.on.distance2;
  };
  const auto add = [&](const Place& seed_m, double radius_m, std::size_t index, bool isGroup) {
    const double bound_m = distance(segment, at(seed_m)) - radius_m;
    if (within(bound_m)) {
      open.push({bound_m, static_cast<std::uint32_t>(index), isGroup});
    }
  };
  const auto groups = patches_.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    add(groups_m_[g], bounded(stretch_) * groups[g].radius_m, g, true);
  }
  bool found = false;
  while (!open.empty()) {
    const OpenList::Entry top = open.pop();
    if (!within(top.bound_m)) {
      break;
    }
    if (top.isGroup) {
      const SurfacePatches::Group& group = groups[top.index];
      if (!opened_[top.index]) {
        openGroup(top.index);
      }
      for (std::size_t p = group.firstPatch; p < group.firstPatch + group.patchCount; ++p) {
        add(patches_m_[p], radii_m_[p], p, false);
      }
      continue;
    }
    const std::uint32_t first = movePatch(top.index);
    const double before2 = best.pair.on.distance2;
    look(
        segment, patches_.facets(patches_.patches()[top.index]),
        [this, first](std::size_t vertex) { return at(moved_m_[first + vertex]); }, best);
    found = found || best.pair.on.distance2 < before2;
  }
  SegmentHit hit;
  hit.found = found;
  if (!found) {
    return hit;
  }
  hit.along = best.pair.along;
  hit.surface.triangle = best.triangle;
  hit.surface.position_m = best.pair.on.point;
  hit.surface.normal = featureNormal(best.triangle, best.pair.on.feature);
  hit.surface.barycentric[0] = best.pair.on.u;
  hit.surface.barycentric[1] = best.pair.on.v;
  hit.surface.barycentric[2] = best.pair.on.w;
  const double distance_m = std::sqrt(best.pair.on.distance2);
  const Vec3 way = segment.at(hit.along) - best.pair.on.point;
  hit.surface.distance_m = dot(way, hit.surface.normal) < 0.0 ? -distance_m : distance_m;
  return hit;
}

SurfacePoint DeformedSurface::closest(const Vec3& point_m) noexcept {
  const SegmentHit hit = nearest({point_m, point_m}, kInfinity);
  if (hit.found) {
    return hit.surface;
  }
  SurfacePoint nowhere;
  nowhere.position_m = at(groups_m_[0]);
  nowhere.normal = faceNormal(0);
  nowhere.distance_m = kInfinity;
  return nowhere;
}

Vec3 DeformedSurface::faceNormal(std::uint32_t triangle) const noexcept {
  const TriangleMesh::Triangle& t = patches_.corners(triangle);
  const Vec3 a = place(t[0]);
  return normalized(cross(place(t[1]) - a, place(t[2]) - a));
}

// Pseudonormals: the face's own, the sum of two at an edge, angle-weighted at a corner.
Vec3 DeformedSurface::featureNormal(std::uint32_t triangle, std::uint8_t feature) const noexcept {
  if (feature == 6) {
    return faceNormal(triangle);
  }
  const TriangleMesh::Triangle& t = patches_.corners(triangle);
  const std::uint32_t vertex = t[feature % 3];
  const std::uint32_t far = feature < 3 ? vertex : t[(feature + 1U) % 3];
  const Vec3 corner = place(vertex);
  Vec3 sum;
  for (const std::uint32_t other : patches_.ring(vertex)) {
    const TriangleMesh::Triangle& o = patches_.corners(other);
    if (std::find(o.begin(), o.end(), far) == o.end()) {
      continue;
    }
    const std::size_t k = static_cast<std::size_t>(std::find(o.begin(), o.end(), vertex) - o.begin());
    const Vec3 e = place(o[(k + 1) % 3]) - corner;
    const Vec3 f = place(o[(k + 2) % 3]) - corner;
    const Vec3 normal = cross(e, f);
    const double weight = feature < 3 ? portableAtan2(norm(normal), dot(e, f)) : 1.0;
    sum += normalized(normal) * weight;
  }
  return normalized(sum);
}

}  // namespace torsio
