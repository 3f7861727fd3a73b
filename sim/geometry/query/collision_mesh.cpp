// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/query/collision_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;
using Model = fcl::BVHModel<fcl::AABBd>;

constexpr std::size_t kDeepest = 64;  // a median split halves: 2 million triangles need 21 levels

// The box is a lower bound only up to rounding.
constexpr double kRoundingMargin = 1.0 - 1e-12;

double boxDistance2(const fcl::AABBd& box, const Vec3& p) {
  const double dx = std::max({box.min_[0] - p.x, 0.0, p.x - box.max_[0]});
  const double dy = std::max({box.min_[1] - p.y, 0.0, p.y - box.max_[1]});
  const double dz = std::max({box.min_[2] - p.z, 0.0, p.z - box.max_[2]});
  return dx * dx + dy * dy + dz * dz;
}

/// The segment with the box round it.
struct Reaching {
  explicit Reaching(const Segment& s)
      : segment(s),
        low{std::min(s.from_m.x, s.to_m.x), std::min(s.from_m.y, s.to_m.y), std::min(s.from_m.z, s.to_m.z)},
        high{std::max(s.from_m.x, s.to_m.x), std::max(s.from_m.y, s.to_m.y), std::max(s.from_m.z, s.to_m.z)} {
  }

  /// Lower bound of the squared distance to a box: between the boxes, and to the ball round the other box.
  [[nodiscard]] double distance2(const fcl::AABBd& box) const {
    const double dx = std::max({box.min_[0] - high.x, 0.0, low.x - box.max_[0]});
    const double dy = std::max({box.min_[1] - high.y, 0.0, low.y - box.max_[1]});
    const double dz = std::max({box.min_[2] - high.z, 0.0, low.z - box.max_[2]});
    const Vec3 centre{0.5 * (box.min_[0] + box.max_[0]), 0.5 * (box.min_[1] + box.max_[1]),
                      0.5 * (box.min_[2] + box.max_[2])};
    const Vec3 corner{box.max_[0] - centre.x, box.max_[1] - centre.y, box.max_[2] - centre.z};
    const double ball = norm(segment.at(nearestAlong(segment, centre)) - centre) - norm(corner);
    return std::max(dx * dx + dy * dy + dz * dz, ball > 0.0 ? ball * ball : 0.0);
  }

  Segment segment;
  Vec3 low;
  Vec3 high;
};

double squaredDistance(const NearestOnTriangle& nearest) {
  return nearest.distance2;
}
double squaredDistance(const NearestToSegment& nearest) {
  return nearest.on.distance2;
}

int depthBelow(const Model& model, int node) {
  const auto& bv = model.getBV(node);
  if (bv.isLeaf()) {
    return 1;
  }
  return 1 + std::max(depthBelow(model, bv.leftChild()), depthBelow(model, bv.rightChild()));
}

}  // namespace

struct CollisionMesh::Hierarchy {
  // Normals of the seven features of a triangle, in the order of NearestOnTriangle::feature.
  using FeatureNormals = std::array<Vec3, 7>;

  Model model;
  std::vector<TriangleCorners> corners;
  std::vector<FeatureNormals> normals;

  /// Depth first, nearer child first, from `best` on. `bound2`: lower bound of the squared distance to a box;
  /// `look`: a triangle's own.
  template <typename Nearest, typename Bound, typename Look>
  void search(Nearest& best, std::uint32_t& triangle, const Bound& bound2, const Look& look) const noexcept;
  /// Begins a search with the triangle `hint`, if there is one.
  template <typename Nearest, typename Look>
  void begin(Nearest& best, std::uint32_t& triangle, std::uint32_t hint, const Look& look) const noexcept;
};

namespace {

void buildModel(Model& model, const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> points;
  points.reserve(mesh.vertices_m.size());
  for (const Vec3& v : mesh.vertices_m) {
    points.emplace_back(v.x, v.y, v.z);
  }
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  model.bv_splitter = std::make_shared<fcl::detail::BVSplitter<fcl::AABBd>>(fcl::detail::SPLIT_METHOD_MEDIAN);
  // FCL reports failure by code and standard error only.
  TORSIO_EXPECTS(model.beginModel(static_cast<int>(triangles.size()), static_cast<int>(points.size())) ==
                 fcl::BVH_OK);
  TORSIO_EXPECTS(model.addSubModel(points, triangles) == fcl::BVH_OK);
  TORSIO_EXPECTS(model.endModel() == fcl::BVH_OK);
}

// Pseudonormals: the face's own, the sum of two at an edge, angle-weighted at a corner.
std::vector<std::array<Vec3, 7>> featureNormals(const TriangleMesh& mesh) {
  std::vector<std::array<Vec3, 7>> normals(mesh.triangles.size());
  std::vector<Vec3> atVertex(mesh.vertices_m.size());
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const Triangle& t = mesh.triangles[i];
    const std::array<Vec3, 3> p{mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]]};
    const Vec3 face = normalized(cross(p[1] - p[0], p[2] - p[0]));
    normals[i][6] = face;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 e = p[(k + 1) % 3] - p[k];
      const Vec3 f = p[(k + 2) % 3] - p[k];
      atVertex[t[k]] += portableAtan2(norm(cross(e, f)), dot(e, f)) * face;
    }
  }
  for (std::size_t i = 0; i < normals.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      normals[i][k] = normalized(atVertex[mesh.triangles[i][k]]);
    }
  }
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    Vec3 sum;
    std::size_t end = i;
    for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end) {
      sum += normals[edges[end].triangle][6];
    }
    for (; i < end; ++i) {
      normals[edges[i].triangle][3 + edges[i].side] = normalized(sum);
    }
  }
  return normals;
}

}  // namespace

// FCL builds the hierarchy; its own distance query compares oriented boxes with shapes, takes three to four
// times as long for a point, and leaves open which of two equally near triangles it reports.
template <typename Nearest, typename Bound, typename Look>
void CollisionMesh::Hierarchy::search(Nearest& best, std::uint32_t& triangle, const Bound& bound2,
                                      const Look& look) const noexcept {
  struct Open {
    int node;
    double bound2;
  };
  std::array<Open, kDeepest> stack;
  std::size_t open = 0;
  stack[open++] = {0, 0.0};
  double best2 = squaredDistance(best);
  while (open > 0) {
    const Open top = stack[--open];
    if (top.bound2 * kRoundingMargin > best2) {
      continue;
    }
    const auto& node = model.getBV(top.node);
    if (node.isLeaf()) {
      const auto candidate = static_cast<std::uint32_t>(node.primitiveId());
      const Nearest n = look(corners[candidate]);
      const double n2 = squaredDistance(n);
      if (n2 < best2 || (n2 == best2 && candidate < triangle)) {
        best = n;
        best2 = n2;
        triangle = candidate;
      }
      continue;
    }
    const Open left{node.leftChild(), bound2(model.getBV(node.leftChild()).bv)};
    const Open right{node.rightChild(), bound2(model.getBV(node.rightChild()).bv)};
    const bool leftFirst = left.bound2 <= right.bound2;
    stack[open++] = leftFirst ? right : left;
    stack[open++] = leftFirst ? left : right;
  }
}

// What is found first does not count: of equally near ones the lowest index is taken whenever it is met.
template <typename Nearest, typename Look>
void CollisionMesh::Hierarchy::begin(Nearest& best, std::uint32_t& triangle, std::uint32_t hint,
                                     const Look& look) const noexcept {
  if (hint >= corners.size()) {
    return;
  }
  const Nearest n = look(corners[hint]);
  if (squaredDistance(n) < squaredDistance(best)) {
    best = n;
    triangle = hint;
  }
}

namespace {

const TriangleMesh& solid(const TriangleMesh& mesh) {
  TORSIO_EXPECTS(mesh.triangles.size() >= 4);
  return mesh;
}

}  // namespace

CollisionMesh::CollisionMesh(const TriangleMesh& mesh) : patches_(solid(mesh)) {
  const auto hierarchy = std::make_shared<Hierarchy>();
  buildModel(hierarchy->model, mesh);
  TORSIO_EXPECTS(depthBelow(hierarchy->model, 0) + 1 < static_cast<int>(kDeepest));
  hierarchy->corners.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    hierarchy->corners.push_back({mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]]});
  }
  hierarchy->normals = featureNormals(mesh);
  hierarchy_ = hierarchy;
}

SurfacePoint CollisionMesh::closest(const Vec3& point_m, std::uint32_t hint) const noexcept {
  SurfacePoint surface;
  std::uint32_t triangle = 0;
  NearestOnTriangle best;
  const auto look = [&point_m](const TriangleCorners& corners) {
    return nearestOnTriangle(point_m, corners);
  };
  hierarchy_->begin(best, triangle, hint, look);
  hierarchy_->search(
      best, triangle, [&point_m](const fcl::AABBd& box) { return boxDistance2(box, point_m); }, look);
  surface.triangle = triangle;
  surface.normal = hierarchy_->normals[triangle][best.feature];
  surface.position_m = hierarchy_->corners[triangle].a;
  surface.distance_m = std::numeric_limits<double>::infinity();
  if (!std::isfinite(best.distance2)) {
    return surface;
  }
  surface.position_m = best.point;
  surface.barycentric[0] = best.u;
  surface.barycentric[1] = best.v;
  surface.barycentric[2] = best.w;
  const double distance_m = std::sqrt(best.distance2);
  surface.distance_m = dot(point_m - best.point, surface.normal) < 0.0 ? -distance_m : distance_m;
  return surface;
}

SegmentHit CollisionMesh::nearest(const Segment& segment, double reach_m, std::uint32_t hint) const noexcept {
  SegmentHit hit;
  if (!isFinite(segment.from_m) || !isFinite(segment.to_m)) {
    return hit;
  }
  const Reaching reaching(segment);
  NearestToSegment best;
  best.on.distance2 = reach_m * reach_m;
  std::uint32_t triangle = kNoTriangle;
  const auto look = [&segment](const TriangleCorners& corners) { return nearestToSegment(segment, corners); };
  hierarchy_->begin(best, triangle, hint, look);
  hierarchy_->search(
      best, triangle, [&reaching](const fcl::AABBd& box) { return reaching.distance2(box); }, look);
  if (triangle == kNoTriangle) {
    return hit;
  }
  hit.found = true;
  hit.along = best.along;
  hit.surface.triangle = triangle;
  hit.surface.position_m = best.on.point;
  hit.surface.normal = hierarchy_->normals[triangle][best.on.feature];
  hit.surface.barycentric[0] = best.on.u;
  hit.surface.barycentric[1] = best.on.v;
  hit.surface.barycentric[2] = best.on.w;
  const double distance_m = std::sqrt(best.on.distance2);
  const Vec3 way = segment.at(best.along) - best.on.point;
  hit.surface.distance_m = dot(way, hit.surface.normal) < 0.0 ? -distance_m : distance_m;
  return hit;
}

}  // namespace torsio
