// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/rounded_end.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/core/portable_math.h"
#include "sim/geometry/lattice/level_loops.h"

namespace torsio {

namespace {

using Index = std::uint32_t;

constexpr double kCone = 0.86602540;  // cosine of 30 degrees
constexpr int kRounds = 8;            // of finding the axis; it settles within four
constexpr double kNear = 0.8;         // local radii below the outermost point: the two sections whose
constexpr double kFar = 1.8;          // centroids give the axis
constexpr double kReach = 3.0;        // local radii along the surface that belong to the end
constexpr double kWidth = 1.4;        // local radii from the axis that the tip may reach
constexpr double kWander = 1.5;       // local radii: an axis further from the seed has left the end

/// A planar section through the end.
struct EndSection {
  Vec3 centroid_m;
  double radius_m = 0.0;  ///< of the circle with its area
};

struct EndAxis {
  Vec3 point_m;
  Vec3 direction;  ///< outwards
  double radius_m = 0.0;
};

class OrganEnd {
 public:
  OrganEnd(const TriangleMesh& mesh, const SurfaceTopology& topology, Index seed)
      : mesh_(mesh),
        topology_(topology),
        fromSeed_m_(edgeDistances_m(mesh, topology, {&seed, 1})),
        seed_m_(mesh.vertices_m[seed]) {
    heights_.angle_rad.assign(mesh.vertices_m.size(), 0.0);
    heights_.turns.assign(topology.halfEdges(), 0);
  }

  /// The axis at the end, or nothing when a plane misses the organ.
  std::optional<EndAxis> findAxis(double meanRadius_m) {
    EndAxis axis{seed_m_, normalized(seed_m_ - middleWithin(2.0 * meanRadius_m)), meanRadius_m};
    for (int round = 0; round < kRounds; ++round) {
      heights_.level.clear();
      double top = dot(seed_m_, axis.direction);
      for (std::size_t v = 0; v < mesh_.vertices_m.size(); ++v) {
        heights_.level.push_back(dot(mesh_.vertices_m[v], axis.direction));
        if (fromSeed_m_[v] < kReach * axis.radius_m) {
          top = std::max(top, heights_.level.back());
        }
      }
      const std::optional<EndSection> near = section(top - kNear * axis.radius_m, axis.point_m);
      const std::optional<EndSection> far = section(top - kFar * axis.radius_m, axis.point_m);
      if (!near || !far) {
        return std::nullopt;
      }
      const Vec3 along = near->centroid_m - far->centroid_m;
      if (!(norm(along) > 0.0)) {
        return std::nullopt;
      }
      axis = {near->centroid_m, normalized(along), std::min(far->radius_m, meanRadius_m)};
    }
    const Vec3 aside = seed_m_ - axis.point_m;
    const double way = norm(aside - dot(aside, axis.direction) * axis.direction);
    return way < kWander * axis.radius_m ? std::optional(axis) : std::nullopt;
  }

  /// Through the seed, along the surface normals about it: for a dome that has no axis of its own.
  EndAxis axisAtSeed(double meanRadius_m) const {
    const std::vector<Vec3> normals = vertexNormals(mesh_);
    Vec3 sum;
    for (std::size_t v = 0; v < fromSeed_m_.size(); ++v) {
      if (fromSeed_m_[v] <= 0.5 * meanRadius_m) {
        sum += normals[v];
      }
    }
    const Vec3 direction = normalized(sum);
    return {seed_m_ - meanRadius_m * direction, direction, meanRadius_m};
  }

  std::vector<Index> tip(const EndAxis& axis) const {
    const std::vector<Vec3> normals = vertexNormals(mesh_);
    std::vector<std::uint8_t> open(mesh_.vertices_m.size(), 0);
    Index start = 0;
    double highest = -1.0;
    for (Index v = 0; v < open.size(); ++v) {
      const Vec3 from = mesh_.vertices_m[v] - axis.point_m;
      const double height = dot(from, axis.direction);
      const double aside = norm(from - height * axis.direction);
      if (fromSeed_m_[v] > kReach * axis.radius_m || aside > kWidth * axis.radius_m) {
        continue;
      }
      if (height < 0.0 || dot(normals[v], axis.direction) < kCone) {
        continue;
      }
      open[v] = 1;
      if (height > highest) {
        highest = height;
        start = v;
      }
    }
    return takeConnected(topology_, open, start);
  }

 private:
  /// Mean of the vertices within a way from the seed.
  Vec3 middleWithin(double way_m) const {
    Vec3 sum;
    double count = 0.0;
    for (std::size_t v = 0; v < fromSeed_m_.size(); ++v) {
      if (fromSeed_m_[v] > way_m) {
        continue;
      }
      sum += mesh_.vertices_m[v];
      count += 1.0;
    }
    return sum / count;
  }

  /// The loop at a height whose centroid lies nearest to `point_m`.
  std::optional<EndSection> section(double height, const Vec3& point_m) const {
    const LevelTracer tracer(mesh_, topology_, heights_);
    std::optional<EndSection> best;
    for (const LevelLoop& loop : tracer.trace(height)) {
      const double radius = std::sqrt(norm(loop.areaVector_m2) / kPi);
      if (best && norm(loop.centroid_m - point_m) >= norm(best->centroid_m - point_m)) {
        continue;
      }
      best = EndSection{loop.centroid_m, radius};
    }
    return best;
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  std::vector<double> fromSeed_m_;
  Vec3 seed_m_;
  HarmonicField heights_;  // only the levels mean something
};

}  // namespace

std::vector<Index> roundedEnd(const TriangleMesh& mesh, const SurfaceTopology& topology, Index seed,
                              double meanRadius_m) {
  OrganEnd end(mesh, topology, seed);
  const std::optional<EndAxis> axis = end.findAxis(meanRadius_m);
  std::vector<Index> tip = end.tip(axis ? *axis : end.axisAtSeed(meanRadius_m));
  constexpr std::size_t kFewest = 4;
  return tip.size() < kFewest ? std::vector<Index>{} : tip;
}

}  // namespace torsio
