// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/skin/surface_walk.h"

#include <cmath>
#include <limits>
#include <unordered_map>

namespace torsio {

namespace {

constexpr int kMaxCrossings = 64;  // a step is shorter than a few triangles; a corner must not hold it

std::uint64_t edgeKey(std::uint32_t from, std::uint32_t to) {
  return (static_cast<std::uint64_t>(from) << 32U) | to;
}

}  // namespace

SurfaceWalk::SurfaceWalk(const TriangleMesh& mesh)
    : mesh_(mesh), neighbours_(mesh.triangles.size(), {kNone, kNone, kNone}) {
  std::unordered_map<std::uint64_t, std::uint32_t> owners;
  owners.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corner = mesh.triangles[t];
    const Vec3& a = mesh.vertices_m[corner[0]];
    normals_.push_back(normalized(cross(mesh.vertices_m[corner[1]] - a, mesh.vertices_m[corner[2]] - a)));
    for (std::size_t k = 0; k < 3; ++k) {
      owners[edgeKey(corner[k], corner[(k + 1) % 3])] = t;
    }
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corner = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = owners.find(edgeKey(corner[(k + 1) % 3], corner[k]));
      if (other != owners.end()) {
        neighbours_[t][k] = other->second;
      }
    }
  }
}

bool SurfaceWalk::step(SurfaceWalker& walker, double way_m) const {
  double left_m = way_m;
  for (int crossing = 0; crossing < kMaxCrossings; ++crossing) {
    const TriangleMesh::Triangle& corner = mesh_.triangles[walker.triangle];
    const Vec3& normal = normals_[walker.triangle];
    double nearest_m = std::numeric_limits<double>::max();
    std::size_t through = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = mesh_.vertices_m[corner[k]];
      const Vec3 inwards = normalized(cross(normal, mesh_.vertices_m[corner[(k + 1) % 3]] - a));
      const double approach = -dot(walker.heading, inwards);
      if (approach <= 1e-9) {
        continue;
      }
      const double way = std::max(0.0, dot(walker.place_m - a, inwards)) / approach;
      if (way < nearest_m) {
        nearest_m = way, through = k;
      }
    }
    if (nearest_m >= left_m) {
      walker.place_m += walker.heading * left_m;
      return true;
    }
    walker.place_m += walker.heading * nearest_m;
    left_m -= nearest_m;
    const std::uint32_t next = neighbours_[walker.triangle][through];
    if (next == kNone) {
      return false;
    }
    const Vec3 edge =
        normalized(mesh_.vertices_m[corner[(through + 1) % 3]] - mesh_.vertices_m[corner[through]]);
    const double along = dot(walker.heading, edge);
    const double across = dot(walker.heading, cross(normal, edge));
    walker.heading = normalized(edge * along + cross(normals_[next], edge) * across);
    walker.triangle = next;
  }
  return false;
}

void SurfaceWalk::turn(SurfaceWalker& walker, double angle_rad) const {
  const Vec3 left = cross(normals_[walker.triangle], walker.heading);
  walker.heading = normalized(walker.heading * std::cos(angle_rad) + left * std::sin(angle_rad));
}

void SurfaceWalk::head(SurfaceWalker& walker, const Vec3& direction) const {
  const Vec3& normal = normals_[walker.triangle];
  walker.heading = normalized(direction - normal * dot(normal, direction));
}

}  // namespace torsio
