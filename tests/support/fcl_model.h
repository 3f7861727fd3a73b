// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::testing {

/// Returns the same triangles for the Flexible Collision Library, to compare our answers with.
inline std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> fclModel(const TriangleMesh& mesh) {
  auto model = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  std::vector<fcl::Vector3d> points;
  for (const Vec3& v : mesh.vertices_m) {
    points.emplace_back(v.x, v.y, v.z);
  }
  std::vector<fcl::Triangle> triangles;
  for (const TriangleMesh::Triangle& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  model->beginModel();
  model->addSubModel(points, triangles);
  model->endModel();
  return model;
}

}  // namespace torsio::testing
