// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/branch_finder.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/side_branch.h"
#include "sim/geometry/mesh/surface_topology.h"

namespace torsio {

namespace {

using Index = std::uint32_t;

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
    // Once more from all of the tip: the corner of a flat end lies askew.
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

std::optional<SideBranch> findSideBranch(const TriangleMesh& mesh, const Vec3& fixedEnd_m,
                                         const Vec3& freeEnd_m) {
  return BranchFinder(mesh).find(fixedEnd_m, freeEnd_m);
}

}  // namespace torsio
