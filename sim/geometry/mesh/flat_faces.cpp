// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/flat_faces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sim/geometry/mesh/nearest_on_triangle.h"

namespace torsio {

namespace {

constexpr double kFlatness = 1e-5;        // distance from the plane as a share of the bounding box diagonal
constexpr double kParallel = 0.99984770;  // cosine of 1 degree: between a triangle and the face
constexpr double kSharpRim = 0.93969262;  // cosine of 20 degrees: a rounded end is not a flat face
constexpr double kSmallestShare = 1e-3;   // of the surface's area

Vec3 areaVector(const TriangleMesh& mesh, std::size_t t) {
  const auto& [a, b, c] = mesh.triangles[t];
  return 0.5 * cross(mesh.vertices_m[b] - mesh.vertices_m[a], mesh.vertices_m[c] - mesh.vertices_m[a]);
}

class FaceGrower {
 public:
  FaceGrower(const TriangleMesh& mesh, const SurfaceTopology& topology)
      : mesh_(mesh), topology_(topology), taken_(mesh.triangles.size(), 0) {
    const BoundingBox box = boxOf(mesh.vertices_m);
    tolerance_m_ = kFlatness * norm(box.high - box.low);
    areas_.reserve(mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      areas_.push_back(areaVector(mesh, t));
    }
    for (const Vec3& a : areas_) {
      total_m2_ += norm(a);
    }
  }

  std::vector<FlatFace> grow() {
    std::vector<std::uint32_t> order(mesh_.triangles.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [this](std::uint32_t a, std::uint32_t b) {
      return dot(areas_[a], areas_[a]) > dot(areas_[b], areas_[b]);
    });
    std::vector<FlatFace> faces;
    for (const std::uint32_t seed : order) {
      if (taken_[seed] != 0) {
        continue;
      }
      growFrom(seed);
      double area = 0.0;
      for (const std::uint32_t t : grown_) {
        area += norm(areas_[t]);
      }
      if (area < kSmallestShare * total_m2_ || !rimIsSharp(normalized(areas_[seed]))) {
        continue;
      }
      faces.push_back({grown_, {}, {}, {}, area});
    }
    std::stable_sort(faces.begin(), faces.end(),
                     [](const FlatFace& a, const FlatFace& b) { return a.area_m2 > b.area_m2; });
    for (FlatFace& face : faces) {
      finish(face);
    }
    return faces;
  }

 private:
  /// All triangles around `seed` in its plane, into grown_.
  void growFrom(std::uint32_t seed) {
    const Vec3 normal = normalized(areas_[seed]);
    const Vec3 origin = mesh_.vertices_m[mesh_.triangles[seed][0]];
    grown_.assign(1, seed);
    taken_[seed] = 1;
    for (std::size_t i = 0; i < grown_.size(); ++i) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t other = topology_.opposite(3 * grown_[i] + k) / 3;
        if (taken_[other] != 0 || !inPlane(other, origin, normal)) {
          continue;
        }
        taken_[other] = 1;
        grown_.push_back(other);
      }
    }
  }

  bool inPlane(std::uint32_t triangle, const Vec3& origin, const Vec3& normal) const {
    const double along = dot(areas_[triangle], normal);
    const double squared = dot(areas_[triangle], areas_[triangle]);
    if (squared > 0.0 && !(along > 0.0 && along * along > kParallel * kParallel * squared)) {
      return false;
    }
    for (const std::uint32_t v : mesh_.triangles[triangle]) {
      if (std::abs(dot(mesh_.vertices_m[v] - origin, normal)) > tolerance_m_) {
        return false;
      }
    }
    return true;
  }

  /// Most of the rim of what was grown is an edge of more than 20 degrees.
  bool rimIsSharp(const Vec3& normal) {
    ++mark_;
    for (const std::uint32_t t : grown_) {
      taken_[t] = mark_;
    }
    double length = 0.0;
    double sharp = 0.0;
    for (const std::uint32_t t : grown_) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t half = 3 * t + k;
        const std::uint32_t other = topology_.opposite(half) / 3;
        if (taken_[other] == mark_) {
          continue;
        }
        const double edge =
            norm(mesh_.vertices_m[topology_.target(half)] - mesh_.vertices_m[topology_.origin(half)]);
        length += edge;
        if (dot(normalized(areas_[other]), normal) < kSharpRim) {
          sharp += edge;
        }
      }
    }
    return length > 0.0 && sharp > 0.5 * length;
  }

  void finish(FlatFace& face) {
    Vec3 total;
    Vec3 moment;
    for (const std::uint32_t t : face.triangles) {
      const auto& [a, b, c] = mesh_.triangles[t];
      total += areas_[t];
      moment += norm(areas_[t]) / 3.0 * (mesh_.vertices_m[a] + mesh_.vertices_m[b] + mesh_.vertices_m[c]);
      for (const std::uint32_t v : mesh_.triangles[t]) {
        face.vertices.push_back(v);
      }
    }
    std::sort(face.vertices.begin(), face.vertices.end());
    face.vertices.erase(std::unique(face.vertices.begin(), face.vertices.end()), face.vertices.end());
    face.normal = normalized(total);
    face.centroid_m = moment / face.area_m2;
  }

  const TriangleMesh& mesh_;
  const SurfaceTopology& topology_;
  std::vector<std::uint32_t> taken_;  // 0: free; afterwards the mark of the face looked at last
  std::vector<std::uint32_t> grown_;
  std::vector<Vec3> areas_;
  std::uint32_t mark_ = 1;
  double tolerance_m_ = 0.0;
  double total_m2_ = 0.0;
};

}  // namespace

std::vector<FlatFace> findFlatFaces(const TriangleMesh& mesh, const SurfaceTopology& topology) {
  return FaceGrower(mesh, topology).grow();
}

std::uint32_t nearestTriangle(const TriangleMesh& mesh, const Vec3& point_m) {
  std::uint32_t best = 0;
  double shortest = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const NearestOnTriangle here =
        nearestOnTriangle(point_m, {mesh.vertices_m[a], mesh.vertices_m[b], mesh.vertices_m[c]});
    if (here.distance2 < shortest) {
      shortest = here.distance2;
      best = static_cast<std::uint32_t>(t);
    }
  }
  return best;
}

}  // namespace torsio
