// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/collision_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "sim/base/contracts.h"
#include "sim/base/portable_math.h"
#include "sim/geometry/mesh_repair.h"

namespace torsio {

namespace {

using Triangle = TriangleMesh::Triangle;
using Model = fcl::BVHModel<fcl::AABBd>;

constexpr std::size_t kDeepest = 64;  // a median split halves: 2 million triangles need 21 levels

// The box is a lower bound only up to rounding.
constexpr double kRoundingMargin = 1.0 - 1e-12;

// Closest point of one triangle, with the feature on which it lies.
struct Nearest {
  double distance2 = std::numeric_limits<double>::infinity();
  Vec3 point;
  double u = 1.0, v = 0.0, w = 0.0;  // barycentric
  std::uint8_t feature = 0;          // 0..2 corner, 3..5 edge from corner k - 3, 6 face
};

struct Corners {
  Vec3 a, b, c;
};

Nearest finish(const Vec3& p, const Corners& t, double u, double v, double w, int feature) {
  Nearest n;
  n.point = feature < 3 ? (feature == 0 ? t.a : feature == 1 ? t.b : t.c) : u * t.a + v * t.b + w * t.c;
  const Vec3 d = p - n.point;
  n.distance2 = dot(d, d);
  n.u = u, n.v = v, n.w = w;
  n.feature = static_cast<std::uint8_t>(feature);
  return n;
}

// Ericson, Real-Time Collision Detection, 5.1.5: by Voronoi regions. A triangle without area may give NaN,
// which is never nearer than its neighbours.
Nearest nearestOnTriangle(const Vec3& p, const Corners& t) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a;
  const Vec3 ap = p - t.a;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return finish(p, t, 1.0, 0.0, 0.0, 0);
  const Vec3 bp = p - t.b;
  const double d3 = dot(ab, bp), d4 = dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return finish(p, t, 0.0, 1.0, 0.0, 1);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
    const double v = d1 / (d1 - d3);
    return finish(p, t, 1.0 - v, v, 0.0, 3);
  }
  const Vec3 cp = p - t.c;
  const double d5 = dot(ab, cp), d6 = dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return finish(p, t, 0.0, 0.0, 1.0, 2);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
    const double w = d2 / (d2 - d6);
    return finish(p, t, 1.0 - w, 0.0, w, 5);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return finish(p, t, 0.0, 1.0 - w, w, 4);
  }
  const double sum = va + vb + vc;
  return finish(p, t, va / sum, vb / sum, vc / sum, 6);
}

double boxDistance2(const fcl::AABBd& box, const Vec3& p) {
  const double dx = std::max({box.min_[0] - p.x, 0.0, p.x - box.max_[0]});
  const double dy = std::max({box.min_[1] - p.y, 0.0, p.y - box.max_[1]});
  const double dz = std::max({box.min_[2] - p.z, 0.0, p.z - box.max_[2]});
  return dx * dx + dy * dy + dz * dz;
}

int depthBelow(const Model& model, int node) {
  const auto& bv = model.getBV(node);
  if (bv.isLeaf()) return 1;
  return 1 + std::max(depthBelow(model, bv.leftChild()), depthBelow(model, bv.rightChild()));
}

}  // namespace

struct CollisionMesh::Hierarchy {
  // Normals of the seven features of a triangle, in the order of Nearest::feature.
  using FeatureNormals = std::array<Vec3, 7>;

  Model model;
  std::vector<Corners> corners;
  std::vector<FeatureNormals> normals;

  Nearest search(const Vec3& p, std::uint32_t& triangle) const noexcept;
};

namespace {

void buildModel(Model& model, const TriangleMesh& mesh) {
  std::vector<fcl::Vector3d> points;
  points.reserve(mesh.vertices_m.size());
  for (const Vec3& v : mesh.vertices_m) points.emplace_back(v.x, v.y, v.z);
  std::vector<fcl::Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) triangles.emplace_back(t[0], t[1], t[2]);
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
    for (std::size_t k = 0; k < 3; ++k) normals[i][k] = normalized(atVertex[mesh.triangles[i][k]]);
  }
  const std::vector<EdgeUse> edges = sortedEdges(mesh);
  for (std::size_t i = 0; i < edges.size();) {
    Vec3 sum;
    std::size_t end = i;
    for (; end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high; ++end) {
      sum += normals[edges[end].triangle][6];
    }
    for (; i < end; ++i) normals[edges[i].triangle][3 + edges[i].side] = normalized(sum);
  }
  return normals;
}

}  // namespace

// Depth first, nearer child first. FCL builds the hierarchy; its own distance query works on oriented boxes
// with shapes and takes ten times as long for a point (docs and tests/sim/geometry/collision_mesh_test.cpp).
Nearest CollisionMesh::Hierarchy::search(const Vec3& p, std::uint32_t& triangle) const noexcept {
  struct Open {
    int node;
    double bound2;
  };
  std::array<Open, kDeepest> stack;
  std::size_t open = 0;
  stack[open++] = {0, 0.0};
  Nearest best;
  while (open > 0) {
    const Open top = stack[--open];
    if (top.bound2 * kRoundingMargin > best.distance2) continue;
    const auto& node = model.getBV(top.node);
    if (node.isLeaf()) {
      const auto candidate = static_cast<std::uint32_t>(node.primitiveId());
      const Nearest n = nearestOnTriangle(p, corners[candidate]);
      if (n.distance2 < best.distance2 || (n.distance2 == best.distance2 && candidate < triangle)) {
        best = n;
        triangle = candidate;
      }
      continue;
    }
    const Open left{node.leftChild(), boxDistance2(model.getBV(node.leftChild()).bv, p)};
    const Open right{node.rightChild(), boxDistance2(model.getBV(node.rightChild()).bv, p)};
    const bool leftFirst = left.bound2 <= right.bound2;
    stack[open++] = leftFirst ? right : left;
    stack[open++] = leftFirst ? left : right;
  }
  return best;
}

CollisionMesh::CollisionMesh(const TriangleMesh& mesh) : hierarchy_(std::make_unique<Hierarchy>()) {
  TORSIO_EXPECTS(mesh.triangles.size() >= 4);
  buildModel(hierarchy_->model, mesh);
  TORSIO_EXPECTS(depthBelow(hierarchy_->model, 0) + 1 < static_cast<int>(kDeepest));
  hierarchy_->corners.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    hierarchy_->corners.push_back({mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]]});
  }
  hierarchy_->normals = featureNormals(mesh);
}

CollisionMesh::~CollisionMesh() = default;
CollisionMesh::CollisionMesh(CollisionMesh&&) noexcept = default;
CollisionMesh& CollisionMesh::operator=(CollisionMesh&&) noexcept = default;

SurfacePoint CollisionMesh::closest(const Vec3& point_m) const noexcept {
  SurfacePoint surface;
  std::uint32_t triangle = 0;
  const Nearest best = hierarchy_->search(point_m, triangle);
  surface.triangle = triangle;
  surface.normal = hierarchy_->normals[triangle][best.feature];
  surface.position_m = hierarchy_->corners[triangle].a;
  surface.distance_m = std::numeric_limits<double>::infinity();
  if (!std::isfinite(best.distance2)) return surface;
  surface.position_m = best.point;
  surface.barycentric[0] = best.u;
  surface.barycentric[1] = best.v;
  surface.barycentric[2] = best.w;
  const double distance_m = std::sqrt(best.distance2);
  surface.distance_m = dot(point_m - best.point, surface.normal) < 0.0 ? -distance_m : distance_m;
  return surface;
}

}  // namespace torsio
