// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/side_branch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "sim/geometry/mesh/surface_topology.h"

namespace torsio {

namespace {

using Index = std::uint32_t;

constexpr double kMaxOfOrgan = 0.1;

[[noreturn]] void refuseBranch(const Text& what) {
  throw Error(
      ErrorCode::kBadParameter, what, Text::tr("side branch"),
      Text::tr("Move its root to where the branch leaves the organ, or turn the direction of the cut."));
}

/// Marks the vertices of the piece beyond the plane that lies nearest to `root_m`.
std::vector<std::uint8_t> branchOf(const TriangleMesh& mesh, const Vec3& root_m, const Vec3& direction) {
  std::vector<std::uint8_t> open(mesh.vertices_m.size(), 0);
  Index nearest = 0;
  double least_m = std::numeric_limits<double>::infinity();
  for (Index v = 0; v < open.size(); ++v) {
    const Vec3 from = mesh.vertices_m[v] - root_m;
    open[v] = dot(from, direction) >= 0.0 ? 1 : 0;
    if (open[v] != 0 && norm(from) < least_m) {
      least_m = norm(from);
      nearest = v;
    }
  }
  const std::vector<Index> piece = takeConnected(SurfaceTopology(mesh), open, nearest);
  if (piece.empty()) {
    refuseBranch(Text::tr("nothing of the organ lies beyond the cut of its side branch"));
  }
  if (static_cast<double>(piece.size()) > kMaxOfOrgan * static_cast<double>(open.size())) {
    refuseBranch(Text::tr("the side branch is more than a tenth of the organ"));
  }
  std::vector<std::uint8_t> branch(open.size(), 0);
  for (const Index v : piece) {
    branch[v] = 1;
  }
  return branch;
}

constexpr double kMaxArea = 0.1;           // of the organ's surface
constexpr double kLeastSlenderness = 0.4;  // area over squared girth: 0.16 of a hemisphere, more of a stub
constexpr double kSaddle = 0.7;            // of the slenderness at the root: beyond it the organ opens out
constexpr double kTip = 0.15;              // of a branch's length: what its tip is
constexpr double kEdgesInStep = 1.5;
constexpr std::size_t kMaxTips = 24;

/// Vertices, each with the third of the surface that surrounds it.
std::vector<double> vertexAreas_m2(const TriangleMesh& mesh) {
  std::vector<double> areas(mesh.vertices_m.size(), 0.0);
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    const double third = norm(cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a)) / 6.0;
    for (const Index v : t) {
      areas[v] += third;
    }
  }
  return areas;
}

class BranchFinder {
 public:
  explicit BranchFinder(const TriangleMesh& mesh)
      : mesh_(mesh), topology_(mesh), areas_m2_(vertexAreas_m2(mesh)) {
    for (const double area : areas_m2_) {
      whole_m2_ += area;
    }
    // Of equilateral triangles.
    step_m_ = kEdgesInStep * std::sqrt(4.0 / std::sqrt(3.0) * whole_m2_ /
                                       static_cast<double>(std::max<std::size_t>(mesh.triangles.size(), 1)));
  }

  std::optional<SideBranch> find(const Vec3& fixedEnd_m, const Vec3& freeEnd_m) const {
    std::optional<SideBranch> best;
    for (const Index tip : tips(nearest(fixedEnd_m), nearest(freeEnd_m))) {
      const std::optional<SideBranch> branch = branchAt(tip);
      if (branch && (!best || branch->length_m * best->width_m > best->length_m * branch->width_m)) {
        best = branch;
      }
    }
    return best;
  }

 private:
  /// How far a branch reaches from its tip, and how slender it is.
  struct Reach {
    double length_m = 0.0;
    double slenderness = 0.0;
  };

  [[nodiscard]] Index nearest(const Vec3& point_m) const {
    Index best = 0;
    for (Index v = 1; v < mesh_.vertices_m.size(); ++v) {
      if (norm(mesh_.vertices_m[v] - point_m) < norm(mesh_.vertices_m[best] - point_m)) {
        best = v;
      }
    }
    return best;
  }

  [[nodiscard]] std::vector<double> distances(std::span<const Index> sources) const {
    return edgeDistances_m(mesh_, topology_, sources);
  }

  /// Vertices from which every way leads back to one of the ends, the farthest first, none near another.
  [[nodiscard]] std::vector<Index> tips(Index fixed, Index free) const {
    std::vector<Index> found;
    for (const Index end : {fixed, free}) {
      const std::vector<double> from = distances({&end, 1});
      std::vector<Index> peaks;
      for (Index v = 0; v < from.size(); ++v) {
        const auto around = topology_.outgoing(v);
        if (std::all_of(around.begin(), around.end(),
                        [&](Index half) { return from[topology_.target(half)] <= from[v]; })) {
          peaks.push_back(v);
        }
      }
      std::stable_sort(peaks.begin(), peaks.end(), [&](Index a, Index b) { return from[a] > from[b]; });
      for (const Index v : peaks) {
        const auto isNear = [&](Index other) {
          return norm(mesh_.vertices_m[v] - mesh_.vertices_m[other]) < 4.0 * step_m_;
        };
        if (found.size() < kMaxTips && !isNear(fixed) && !isNear(free) &&
            std::none_of(found.begin(), found.end(), isNear)) {
          found.push_back(v);
        }
      }
    }
    return found;
  }

  /// Area within a way of the tip over its squared girth there: it grows along a stub and falls where the
  /// stub opens out into the organ.
  [[nodiscard]] std::optional<Reach> reachOf(const std::vector<double>& way_m) const {
    std::vector<double> areas;
    for (std::size_t v = 0; v < way_m.size(); ++v) {
      const auto k = static_cast<std::size_t>(way_m[v] / step_m_);
      areas.resize(std::max(areas.size(), k + 1), 0.0);
      areas[k] += areas_m2_[v];
    }
    Reach best;
    double within_m2 = 0.0;
    for (std::size_t k = 0; k + 1 < areas.size() && within_m2 < 0.5 * whole_m2_; ++k) {
      within_m2 += areas[k];
      const double girth_m = (areas[k] + areas[k + 1]) / (2.0 * step_m_);
      const double slenderness = within_m2 / (girth_m * girth_m);
      if (within_m2 < kMaxArea * whole_m2_ && slenderness > best.slenderness) {
        best = {static_cast<double>(k + 1) * step_m_, slenderness};
      } else if (best.slenderness >= kLeastSlenderness && slenderness < kSaddle * best.slenderness) {
        return best;
      }
    }
    return std::nullopt;
  }

  [[nodiscard]] std::optional<SideBranch> branchAt(Index tip) const {
    std::vector<double> way_m = distances({&tip, 1});
    std::optional<Reach> reach = reachOf(way_m);
    if (!reach) {
      return std::nullopt;
    }
    // Repeat from the whole tip: one corner of a flat end lies off its axis.
    const SideBranch askew = pieceWithin(way_m, reach->length_m);
    std::vector<Index> sources;
    double farthest_m = 0.0;
    const auto height_m = [&](std::size_t v) {
      return dot(mesh_.vertices_m[v] - askew.root_m, askew.outward);
    };
    for (std::size_t v = 0; v < way_m.size(); ++v) {
      farthest_m = way_m[v] <= reach->length_m ? std::max(farthest_m, height_m(v)) : farthest_m;
    }
    for (Index v = 0; v < way_m.size(); ++v) {
      if (way_m[v] <= reach->length_m && height_m(v) >= (1.0 - kTip) * farthest_m) {
        sources.push_back(v);
      }
    }
    way_m = distances(sources);
    reach = reachOf(way_m);
    return reach ? cut(pieceWithin(way_m, reach->length_m)) : std::nullopt;
  }

  /// The piece within a way of its tip: its surface, turned outwards, sums up to the hole that it leaves.
  [[nodiscard]] SideBranch pieceWithin(const std::vector<double>& way_m, double reach_m) const {
    SideBranch branch;
    Vec3 area_m2;
    Vec3 rim_m;
    double rims = 0.0;
    for (const TriangleMesh::Triangle& t : mesh_.triangles) {
      const auto inside = std::count_if(t.begin(), t.end(), [&](Index v) { return way_m[v] <= reach_m; });
      const Vec3& a = mesh_.vertices_m[t[0]];
      if (inside == 3) {
        area_m2 += 0.5 * cross(mesh_.vertices_m[t[1]] - a, mesh_.vertices_m[t[2]] - a);
      } else if (inside > 0) {
        rim_m += (a + mesh_.vertices_m[t[1]] + mesh_.vertices_m[t[2]]) / 3.0;
        rims += 1.0;
      }
    }
    branch.root_m = rims > 0.0 ? rim_m / rims : rim_m;
    branch.outward = normalized(area_m2);
    branch.width_m = 2.0 * std::sqrt(norm(area_m2) / kPi);
    for (std::size_t v = 0; v < way_m.size(); ++v) {
      if (way_m[v] <= reach_m) {
        branch.length_m = std::max(branch.length_m, dot(mesh_.vertices_m[v] - branch.root_m, branch.outward));
      }
    }
    return branch;
  }

  /// From the middle of what surrounds the root to the root.
  [[nodiscard]] Vec3 awayFromOrgan(const SideBranch& branch) const {
    constexpr double kAround = 3.0;  // of the width
    Vec3 middle_m;
    double area_m2 = 0.0;
    for (std::size_t v = 0; v < areas_m2_.size(); ++v) {
      const Vec3 from = mesh_.vertices_m[v] - branch.root_m;
      if (norm(from) < kAround * branch.width_m && dot(from, branch.outward) < 0.0) {
        middle_m += areas_m2_[v] * mesh_.vertices_m[v];
        area_m2 += areas_m2_[v];
      }
    }
    return area_m2 > 0.0 ? normalized(branch.root_m - middle_m / area_m2) : branch.outward;
  }

  /// The branch from where a plane takes it alone off the organ.
  [[nodiscard]] std::optional<SideBranch> cut(SideBranch branch) const {
    constexpr int kSteps = 6;
    const double step_m = branch.length_m / (2.0 * kSteps);
    for (int k = 0; k < kSteps; ++k) {
      try {
        const TrimmedOrgan trimmed(mesh_, branch.root_m, branch.outward);
        branch.away = awayFromOrgan(branch);
        return branch;
      } catch (const Error&) {
        branch.root_m += step_m * branch.outward;  // the plane runs into the organ beside it
        branch.length_m -= step_m;
      }
    }
    return std::nullopt;
  }

  const TriangleMesh& mesh_;
  SurfaceTopology topology_;
  std::vector<double> areas_m2_;
  double whole_m2_ = 0.0;
  double step_m_ = 0.0;
};

}  // namespace

TrimmedOrgan::TrimmedOrgan(const TriangleMesh& mesh, const Vec3& root_m, const Vec3& outward) {
  const Vec3 direction = normalized(outward);
  if (!isFinite(root_m) || !isFinite(direction) || direction == Vec3{}) {
    refuseBranch(Text::tr("the place or the direction of the side branch is not finite"));
  }
  const std::vector<std::uint8_t> branch = branchOf(mesh, root_m, direction);
  cut(mesh, branch);
  close(mesh);
  place(mesh, branch, root_m, direction);
}

void TrimmedOrgan::cut(const TriangleMesh& mesh, const std::vector<std::uint8_t>& branch) {
  places_.resize(mesh.vertices_m.size());
  for (Index v = 0; v < branch.size(); ++v) {
    places_[v].onLid = branch[v] != 0;
    if (!places_[v].onLid) {
      places_[v].vertex = static_cast<Index>(mesh_.vertices_m.size());
      mesh_.vertices_m.push_back(mesh.vertices_m[v]);
    }
  }
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corners = mesh.triangles[t];
    if (std::none_of(corners.begin(), corners.end(), [&branch](Index v) { return branch[v] != 0; })) {
      triangles_.push_back(t);
      mesh_.triangles.push_back(
          {places_[corners[0]].vertex, places_[corners[1]].vertex, places_[corners[2]].vertex});
    }
  }
}

void TrimmedOrgan::close(const TriangleMesh& mesh) {
  const SurfaceTopology whole(mesh);
  std::vector<std::uint8_t> kept(mesh.triangles.size(), 0);
  for (const Index t : triangles_) {
    kept[t] = 1;
  }
  std::map<Index, Index> rimFrom;  // half-edge of the whole by the vertex where it starts
  for (const Index t : triangles_) {
    for (Index half = 3 * t; half < 3 * t + 3; ++half) {
      if (kept[whole.opposite(half) / 3] == 0 && !rimFrom.emplace(whole.origin(half), half).second) {
        refuseBranch(Text::tr("the cut of the side branch is not a simple loop"));
      }
    }
  }
  const Index start = rimFrom.begin()->first;
  Vec3 middle_m;
  std::size_t steps = 0;
  Index at = start;
  do {
    const Index half = rimFrom.at(at);
    middle_m += mesh.vertices_m[at] / static_cast<double>(rimFrom.size());
    rims_.push_back({half / 3, half % 3});
    at = whole.target(half);
    ++steps;
  } while (at != start && rimFrom.count(at) != 0 && steps < rimFrom.size());
  if (at != start || steps != rimFrom.size()) {
    refuseBranch(Text::tr("the cut of the side branch is not a simple loop"));
  }
  const auto centre = static_cast<Index>(mesh_.vertices_m.size());
  mesh_.vertices_m.push_back(middle_m);
  for (const Rim& rim : rims_) {
    const TriangleMesh::Triangle& corners = mesh.triangles[rim.triangle];
    mesh_.triangles.push_back(
        {places_[corners[(rim.corner + 1) % 3]].vertex, places_[corners[rim.corner]].vertex, centre});
  }
}

void TrimmedOrgan::place(const TriangleMesh& mesh, const std::vector<std::uint8_t>& branch,
                         const Vec3& root_m, const Vec3& direction) {
  for (Index v = 0; v < branch.size(); ++v) {
    if (branch[v] == 0) {
      continue;
    }
    const Vec3& p = mesh.vertices_m[v];
    const Vec3 foot_m = p - dot(p - root_m, direction) * direction;
    NearestOnTriangle nearest;
    for (auto t = static_cast<Index>(triangles_.size()); t < mesh_.triangles.size(); ++t) {
      const TriangleMesh::Triangle& corners = mesh_.triangles[t];
      const NearestOnTriangle found = nearestOnTriangle(
          foot_m, {mesh_.vertices_m[corners[0]], mesh_.vertices_m[corners[1]], mesh_.vertices_m[corners[2]]});
      if (found.distance2 < nearest.distance2) {
        nearest = found;
        places_[v].lidTriangle = t;
        places_[v].weights = {found.u, found.v, found.w};
      }
    }
  }
}

std::vector<LatticeCoordinate> TrimmedOrgan::toWhole(std::span<const LatticeCoordinate> trimmed) const {
  std::vector<LatticeCoordinate> whole;
  whole.reserve(places_.size());
  for (const Place& place : places_) {
    if (!place.onLid) {
      whole.push_back(trimmed[place.vertex]);
      continue;
    }
    const TriangleMesh::Triangle& corners = mesh_.triangles[place.lidTriangle];
    const double first_rad = trimmed[corners[0]].angle_rad;
    LatticeCoordinate at{0.0, first_rad};
    for (std::size_t k = 0; k < 3; ++k) {
      const LatticeCoordinate& corner = trimmed[corners[k]];
      const double turns = (corner.angle_rad - first_rad) / (2.0 * kPi);
      at.arc_m += place.weights[k] * corner.arc_m;
      at.angle_rad += place.weights[k] * 2.0 * kPi * (turns - std::round(turns));
    }
    const double turns = at.angle_rad / (2.0 * kPi);
    at.angle_rad = std::min(2.0 * kPi * (turns - std::floor(turns)), std::nextafter(2.0 * kPi, 0.0));
    whole.push_back(at);
  }
  return whole;
}

std::vector<LatticePart> TrimmedOrgan::toWhole(std::span<const LatticePart> trimmed) const {
  std::vector<LatticePart> whole;
  whole.reserve(places_.size());
  for (const Place& place : places_) {
    whole.push_back(place.onLid ? LatticePart::kSide : trimmed[place.vertex]);
  }
  return whole;
}

LatticePoint TrimmedOrgan::toWhole(const LatticePoint& point) const {
  LatticePoint found = point;
  if (point.triangle < triangles_.size()) {
    found.triangle = triangles_[point.triangle];
    return found;
  }
  const Rim& rim = rims_[point.triangle - triangles_.size()];
  const TriangleMesh::Triangle& lid = mesh_.triangles[point.triangle];
  const Vec3& from = mesh_.vertices_m[lid[1]];
  const Vec3 edge = mesh_.vertices_m[lid[0]] - from;
  const double share = std::clamp(dot(point.position_m - from, edge) / dot(edge, edge), 0.0, 1.0);
  found.position_m = from + share * edge;
  found.triangle = rim.triangle;
  found.barycentric = {};
  found.barycentric[rim.corner] = 1.0 - share;
  found.barycentric[(rim.corner + 1) % 3] = share;
  return found;
}

std::optional<SideBranch> findSideBranch(const TriangleMesh& mesh, const Vec3& fixedEnd_m,
                                         const Vec3& freeEnd_m) {
  return BranchFinder(mesh).find(fixedEnd_m, freeEnd_m);
}

}  // namespace torsio
