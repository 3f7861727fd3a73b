// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/triangle_mesh.h"

#include <algorithm>

#include "sim/core/digest.h"

namespace torsio {

void BoundingBox::add(const Vec3& p) noexcept {
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

double BoundingBox::largestSide() const noexcept {
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

BoundingBox boxOf(std::span<const Vec3> points) noexcept {
  BoundingBox box;
  for (const Vec3& p : points) {
    box.add(p);
  }
  return box;
}

std::vector<Vec3> vertexNormals(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.vertices_m.size());
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    const Vec3& a = mesh.vertices_m[t[0]];
    const Vec3 twiceArea = cross(mesh.vertices_m[t[1]] - a, mesh.vertices_m[t[2]] - a);
    for (const std::uint32_t corner : t) {
      normals[corner] += twiceArea;
    }
  }
  for (Vec3& normal : normals) {
    normal = normalized(normal);
  }
  return normals;
}

double signedVolume_m3(const TriangleMesh& mesh) {
  if (mesh.vertices_m.empty()) {
    return 0.0;
  }
  // Relative to a vertex, not to the world's origin: a small organ far away would lose digits.
  const Vec3 origin = mesh.vertices_m.front();
  double sixfold = 0.0;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    sixfold += dot(mesh.vertices_m[t[0]] - origin,
                   cross(mesh.vertices_m[t[1]] - origin, mesh.vertices_m[t[2]] - origin));
  }
  return sixfold / 6.0;
}

std::string contentHash(const TriangleMesh& mesh) {
  Digest digest;
  digest.update(std::string_view("torsio triangle mesh 1"));
  digest.update(static_cast<std::int64_t>(mesh.vertices_m.size()));
  digest.update(static_cast<std::int64_t>(mesh.triangles.size()));
  for (const Vec3& v : mesh.vertices_m) {
    digest.update(v.x);
    digest.update(v.y);
    digest.update(v.z);
  }
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      digest.update(static_cast<std::int64_t>(corner));
    }
  }
  return digest.hex();
}

}  // namespace torsio
