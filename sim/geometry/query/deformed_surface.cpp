// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/query/deformed_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"

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

/// Distance of a segment from a triangle, from below.
double nearerThan_m(const Segment& segment, const TriangleCorners& corners) noexcept {
  const Vec3 toA = segment.at(nearestAlong(segment, corners.a)) - corners.a;
  const Vec3 ab = corners.b - corners.a;
  const Vec3 ac = corners.c - corners.a;
  return std::sqrt(dot(toA, toA)) - std::sqrt(std::max(dot(ab, ab), dot(ac, ac)));
}

/// `moved`: vertex k of those that the facets name.
template <typename Facet, typename Moved>
void look(const Segment& segment, std::span<const Facet> facets, const Moved& moved, Best& best) noexcept {
  for (const Facet& facet : facets) {
    const TriangleCorners corners{moved(facet.corner[0]), moved(facet.corner[1]), moved(facet.corner[2])};
    // Most triangles of a patch are farther than their own size.
    const double near_m = nearerThan_m(segment, corners);
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

  std::array<Entry, SurfacePatches::kMaxGroups + SurfacePatches::kMaxPatches> entries_;
  std::size_t count_ = 0;
};

}  // namespace

bool FacetList::add(std::uint32_t triangle, const std::array<std::uint32_t, 3>& corners) noexcept {
  if (facetCount == kMaxFacets) {
    return false;
  }
  Facet& facet = facets[facetCount];
  facet.triangle = triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto* const end = vertices.data() + vertexCount;
    const auto* const known = std::find(vertices.data(), vertices.data() + vertexCount, corners[k]);
    if (known == end) {
      if (vertexCount == kMaxVertices) {
        return false;
      }
      vertices[vertexCount++] = corners[k];
    }
    facet.corner[k] = static_cast<std::uint8_t>(known - vertices.data());
  }
  ++facetCount;
  return true;
}

DeformedSurface::DeformedSurface(const SurfacePatches& patches, const VertexPlaces& places,
                                 const PieceBounds& bounds) noexcept
    : patches_(patches), places_(places), bounds_(bounds) {}

void DeformedSurface::moveSeeds() noexcept {
  if (seeded_) {
    return;
  }
  seeded_ = true;
  const auto groups = patches_.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groups_m_[g] = kept(place(groups[g].seed));
  }
  if (bounds_.group_m == nullptr) {
    stretch_ = wholeStretch();
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    groupRadii_m_[g] = bounds_.group_m != nullptr ? bounds_.group_m(bounds_.self, g)
                                                  : bounded(stretch_) * groups[g].radius_m;
  }
}

double DeformedSurface::wholeStretch() const noexcept {
  double stretch2 = 1.0;
  for (const SurfacePatches::Neighbours& pair : patches_.neighbours()) {
    const Vec3 way = at(groups_m_[pair.one]) - at(groups_m_[pair.other]);
    stretch2 = std::max(stretch2, dot(way, way) / (pair.apart_m * pair.apart_m));
  }
  return std::sqrt(stretch2);
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
    radii_m_[p] = bounds_.patch_m != nullptr ? bounds_.patch_m(bounds_.self, p)
                                             : bounded(stretch) * patches_.patches()[p].radius_m;
  }
}

std::uint32_t DeformedSurface::movePatch(std::size_t patch) noexcept {
  if (movedAt_[patch] != kNotMoved) {
    return movedAt_[patch];
  }
  const auto vertices = patches_.vertices(patches_.patches()[patch]);
  if (movedCount_ + vertices.size() > kMaxMoved) {
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

SegmentHit DeformedSurface::nearest(const Segment& segment, double reach_m, std::uint32_t hint) noexcept {
  moveSeeds();
  OpenList open;
  Best best;
  best.pair.on.distance2 = reach_m * reach_m;
  bool found = false;
  if (hint < patches_.triangles()) {
    const TriangleMesh::Triangle& t = patches_.corners(hint);
    const NearestToSegment pair = nearestToSegment(segment, {place(t[0]), place(t[1]), place(t[2])});
    if (pair.on.distance2 < best.pair.on.distance2) {
      best = {pair, hint};
      found = true;
    }
  }
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
    add(groups_m_[g], groupRadii_m_[g], g, true);
  }
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
  return found ? hitOf(segment, best.pair.along, best.triangle, best.pair.on) : SegmentHit{};
}

SegmentHit DeformedSurface::hitOf(const Segment& segment, double along, std::uint32_t triangle,
                                  const NearestOnTriangle& on) const noexcept {
  SegmentHit hit;
  hit.found = true;
  hit.along = along;
  hit.surface.triangle = triangle;
  hit.surface.position_m = on.point;
  hit.surface.normal = featureNormal(triangle, on.feature);
  hit.surface.barycentric[0] = on.u;
  hit.surface.barycentric[1] = on.v;
  hit.surface.barycentric[2] = on.w;
  const double distance_m = std::sqrt(on.distance2);
  const Vec3 way = segment.at(along) - on.point;
  hit.surface.distance_m = dot(way, hit.surface.normal) < 0.0 ? -distance_m : distance_m;
  return hit;
}

SegmentHit DeformedSurface::nearestAmong(const Segment& segment, const FacetList& list) const noexcept {
  std::array<Place, FacetList::kMaxVertices> moved_m;
  for (std::size_t v = 0; v < list.vertexCount; ++v) {
    moved_m[v] = kept(place(list.vertices[v]));
  }
  Best best;
  best.triangle = kNoTriangle;
  look(
      segment, std::span(list.facets).first(list.facetCount),
      [&moved_m](std::size_t vertex) { return at(moved_m[vertex]); }, best);
  return best.triangle == kNoTriangle ? SegmentHit{}
                                      : hitOf(segment, best.pair.along, best.triangle, best.pair.on);
}

bool DeformedSurface::gather(const Segment& segment, double reach_m, FacetList& out) noexcept {
  moveSeeds();
  out.facetCount = 0;
  out.vertexCount = 0;
  const auto groups = patches_.groups();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (distance(segment, at(groups_m_[g])) - groupRadii_m_[g] > reach_m) {
      continue;
    }
    if (!opened_[g]) {
      openGroup(g);
    }
    for (std::size_t p = groups[g].firstPatch; p < groups[g].firstPatch + groups[g].patchCount; ++p) {
      if (distance(segment, at(patches_m_[p])) - radii_m_[p] > reach_m) {
        continue;
      }
      const std::uint32_t first = movePatch(p);
      for (const SurfacePatches::Facet& facet : patches_.facets(patches_.patches()[p])) {
        const TriangleCorners corners{at(moved_m_[first + facet.corner[0]]),
                                      at(moved_m_[first + facet.corner[1]]),
                                      at(moved_m_[first + facet.corner[2]])};
        if (!(nearerThan_m(segment, corners) > reach_m) &&
            !out.add(facet.triangle, patches_.corners(facet.triangle))) {
          return false;
        }
      }
    }
  }
  return true;
}

SurfacePoint DeformedSurface::closest(const Vec3& point_m, std::uint32_t hint) noexcept {
  const SegmentHit hit = nearest({point_m, point_m}, kInfinity, hint);
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
