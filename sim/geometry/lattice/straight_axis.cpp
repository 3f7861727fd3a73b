// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/straight_axis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "sim/core/error.h"
#include "sim/geometry/lattice/level_loops.h"
#include "sim/geometry/mesh/flat_faces.h"

namespace torsio {

namespace {

constexpr double kAcross = 0.98480775;  // cosine of 10 degrees: a flat end lies across the axis
constexpr double kAtEnd = 0.02;         // of the length: how near to the extreme a flat end must be
constexpr double kInsets[] = {0.002, 0.005, 0.01, 0.02};  // of the length: what a rounded end may lose
constexpr double kFurther = 0.01;      // of the length: the plane behind an end plane, for comparison
constexpr double kWhole = 0.85;        // of its area: then the end plane is off the rounding
constexpr double kOnPlane = 1e-9;      // of the length: rounding of a vertex on an end plane
constexpr double kSlenderness = 1.2;   // least ratio of the longest to the next extent
constexpr double kBarParallel = 1e-3;  // of the length: how far a flat end of a bar may lean
constexpr double kBarStraight = 0.01;  // of the length: how far its sections may lie aside
constexpr int kBarPlanes = 64;
constexpr Phrase kGiveAxisEnds = Text::tr("Give the two end points of the axis, or use the harmonic mode.");

/// The direction of the largest spread of the surface, weighted by area.
Vec3 principalAxis(const TriangleMesh& mesh) {
  double area = 0.0;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();
  const auto vector = [](const Vec3& v) { return Eigen::Vector3d(v.x, v.y, v.z); };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Eigen::Vector3d a = vector(mesh.vertices_m[i] - mesh.vertices_m[0]);
    const Eigen::Vector3d b = vector(mesh.vertices_m[j] - mesh.vertices_m[0]);
    const Eigen::Vector3d c = vector(mesh.vertices_m[k] - mesh.vertices_m[0]);
    const double part = 0.5 * (b - a).cross(c - a).norm();
    const Eigen::Vector3d sum = a + b + c;
    area += part;
    mean += part / 3.0 * sum;
    // Exact integral over the triangle: A / 12 (aa' + bb' + cc' + sum sum').
    second +=
        part / 12.0 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  mean /= area;
  const Eigen::Matrix3d covariance = second / area - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& spread = solver.eigenvalues();  // ascending
  if (!(spread[2] > kSlenderness * kSlenderness * spread[1])) {
    const double ratio = spread[1] > 0.0 ? std::sqrt(spread[2] / spread[1]) : 0.0;
    throw Error(
        ErrorCode::kBadMesh,
        Text::tr("the organ has no longest direction: its two largest extents are as %1 to 1, at least "
                 "1.2 is needed",
                 std::to_string(ratio)),
        "", kGiveAxisEnds);
  }
  const Eigen::Vector3d axis = solver.eigenvectors().col(2);
  return normalized({axis.x(), axis.y(), axis.z()});
}

std::pair<double, double> extent_m(const TriangleMesh& mesh, const Vec3& direction) {
  double low = dot(mesh.vertices_m.front(), direction);
  double high = low;
  for (const Vec3& p : mesh.vertices_m) {
    const double h = dot(p, direction);
    low = std::min(low, h);
    high = std::max(high, h);
  }
  return {low, high};
}

/// The flat end across `direction` (outwards) at its extreme, largest first.
std::optional<FlatFace> extremeFace(const std::vector<FlatFace>& faces, const TriangleMesh& mesh,
                                    const Vec3& direction) {
  const auto [low, high] = extent_m(mesh, direction);
  for (const FlatFace& face : faces) {
    const bool across = dot(face.normal, direction) > kAcross;
    if (across && dot(face.centroid_m, direction) > high - kAtEnd * (high - low)) {
      return face;
    }
  }
  return std::nullopt;
}

/// The flat end across `direction` (outwards) on which `point` was given.
std::optional<FlatFace> faceAt(const std::vector<FlatFace>& faces, const TriangleMesh& mesh,
                               const Vec3& point_m, const Vec3& direction) {
  const std::uint32_t nearest = nearestTriangle(mesh, point_m);
  for (const FlatFace& face : faces) {
    if (std::find(face.triangles.begin(), face.triangles.end(), nearest) == face.triangles.end()) {
      continue;
    }
    return dot(face.normal, direction) > kAcross ? std::optional(face) : std::nullopt;
  }
  return std::nullopt;
}

/// Between the flat ends where there are any, else from `low` to `high` along `direction`.
StraightAxis between(const std::optional<FlatFace>& fixedFace, const std::optional<FlatFace>& freeFace,
                     const Vec3& direction, const Vec3& low_m, const Vec3& high_m) {
  StraightAxis axis;
  axis.direction = direction;
  if (fixedFace && freeFace) {
    axis.direction = normalized(freeFace->normal - fixedFace->normal);
  } else if (fixedFace) {
    axis.direction = -fixedFace->normal;
  } else if (freeFace) {
    axis.direction = freeFace->normal;
  }
  axis.origin_m = fixedFace ? fixedFace->centroid_m : low_m;
  axis.length_m = dot((freeFace ? freeFace->centroid_m : high_m) - axis.origin_m, axis.direction);
  return axis;
}

/// How far the end plane must stay from the extreme of a rounded end: the rim of a cut takes little, a dome
/// the most that is given.
double insetOf(const LevelTracer& tracer, double extreme, double inwards, double length) {
  const auto area = [&](double share) {
    double sum = 0.0;
    for (const LevelLoop& loop : tracer.trace(extreme + share * inwards * length)) {
      sum += norm(loop.areaVector_m2);
    }
    return sum;
  };
  for (const double inset : kInsets) {
    if (area(inset) > kWhole * area(inset + kFurther)) {
      return inset * length;
    }
  }
  return std::end(kInsets)[-1] * length;
}

/// Keeps the end planes off rounded ends: a plane that touches a dome cuts nothing.
void insetRoundedEnds(StraightAxis& axis, const TriangleMesh& mesh, const SurfaceTopology& topology) {
  if (!axis.fixedFace.empty() && !axis.freeFace.empty()) {
    return;
  }
  HarmonicField heights;
  for (const Vec3& p : mesh.vertices_m) {
    heights.level.push_back(dot(p, axis.direction));
  }
  heights.angle_rad.assign(mesh.vertices_m.size(), 0.0);
  heights.turns.assign(topology.halfEdges(), 0);
  const LevelTracer tracer(mesh, topology, heights);
  const auto [low, high] = extent_m(mesh, axis.direction);
  double from = dot(axis.origin_m, axis.direction);
  double to = from + axis.length_m;
  if (axis.fixedFace.empty()) {
    from = std::max(from, low + insetOf(tracer, low, 1.0, high - low));
  }
  if (axis.freeFace.empty()) {
    to = std::min(to, high - insetOf(tracer, high, -1.0, high - low));
  }
  axis.origin_m += (from - dot(axis.origin_m, axis.direction)) * axis.direction;
  axis.length_m = to - from;
}

}  // namespace

StraightAxis findStraightAxis(const TriangleMesh& mesh, const SurfaceTopology& topology,
                              const CapRequest& request) {
  checkCapRequest(request);
  const std::vector<FlatFace> faces = findFlatFaces(mesh, topology);
  Vec3 direction;
  std::optional<FlatFace> fixedFace;
  std::optional<FlatFace> freeFace;
  Vec3 low = request.fixedEnd_m;
  Vec3 high = request.freeEnd_m;
  if (request.automatic()) {
    direction = principalAxis(mesh);
    if (isLower(direction, -direction, 1.0)) {
      direction = -direction;  // the fixed end is the lower one
    }
    fixedFace = extremeFace(faces, mesh, -direction);
    freeFace = extremeFace(faces, mesh, direction);
    const auto [least, most] = extent_m(mesh, direction);
    low = least * direction;
    high = most * direction;
  } else {
    direction = normalized(high - low);
    fixedFace = faceAt(faces, mesh, low, -direction);
    freeFace = faceAt(faces, mesh, high, direction);
  }
  StraightAxis axis = between(fixedFace, freeFace, direction, low, high);
  if (fixedFace) {
    axis.fixedFace = fixedFace->vertices;
  }
  if (freeFace) {
    axis.freeFace = freeFace->vertices;
  }
  insetRoundedEnds(axis, mesh, topology);
  if (!(axis.length_m > 0.0)) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("the end planes of the axis are outside the organ or coincide"), "",
                Text::tr("Give end points inside the organ."));
  }
  return axis;
}

bool isStraightBar(const TriangleMesh& mesh, const SurfaceTopology& topology, const CapRequest& request) {
  StraightAxis axis;
  try {
    axis = findStraightAxis(mesh, topology, request);
  } catch (const Error&) {
    return false;  // no longest direction: not for parallel planes
  }
  if (axis.fixedFace.empty() || axis.freeFace.empty()) {
    return false;
  }
  HarmonicField field;
  field.level = axisLevels(mesh, axis);
  field.angle_rad.assign(mesh.vertices_m.size(), 0.0);
  field.turns.assign(topology.halfEdges(), 0);
  // The faces lie on the end planes only if these are parallel to them.
  const double across = kBarParallel * axis.length_m;
  for (const std::uint32_t v : axis.fixedFace) {
    if (std::abs(dot(mesh.vertices_m[v] - axis.origin_m, axis.direction)) > across) {
      return false;
    }
  }
  for (const std::uint32_t v : axis.freeFace) {
    const double height = dot(mesh.vertices_m[v] - axis.origin_m, axis.direction);
    if (std::abs(height - axis.length_m) > across) {
      return false;
    }
  }
  std::vector<double> planes;
  for (int k = 0; k <= kBarPlanes; ++k) {
    planes.push_back(static_cast<double>(k) / kBarPlanes);
  }
  bool straight = true;
  const LevelTracer tracer(mesh, topology, field);
  tracer.traceAll(planes, [&](std::size_t, const std::vector<LevelLoop>& loops) {
    if (loops.size() != 1) {
      straight = false;
      return;
    }
    const Vec3 aside = loops.front().centroid_m - axis.origin_m;
    const Vec3 off = aside - dot(aside, axis.direction) * axis.direction;
    straight = straight && norm(off) < kBarStraight * axis.length_m;
  });
  return straight;
}

std::vector<double> axisLevels(const TriangleMesh& mesh, const StraightAxis& axis) {
  std::vector<double> levels;
  levels.reserve(mesh.vertices_m.size());
  for (const Vec3& p : mesh.vertices_m) {
    double level = axis.level(p);
    if (std::abs(level) < kOnPlane) {
      level = 0.0;
    }
    if (std::abs(level - 1.0) < kOnPlane) {
      level = 1.0;
    }
    levels.push_back(level);
  }
  for (const std::uint32_t v : axis.fixedFace) {
    levels[v] = 0.0;
  }
  for (const std::uint32_t v : axis.freeFace) {
    levels[v] = 1.0;
  }
  return levels;
}

}  // namespace torsio
