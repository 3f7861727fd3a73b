// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/geometry/segment.h"
#include "sim/geometry/surface_patches.h"
#include "sim/geometry/surface_point.h"

namespace torsio {

/// Where the vertices of the mesh are now. Called in the servo tick.
struct VertexPlaces {
  const void* self = nullptr;
  Vec3 (*at)(const void* self, std::uint32_t vertex) noexcept = nullptr;
};

/// A surface in one deformed state, for the queries of one tick: exact on the triangles of the moved
/// vertices, yet only some hundred of them are moved. On construction one seed a group of patches is moved; a
/// query visits groups and patches nearest first and moves the vertices of those that can hold the answer.
///
/// A patch is taken to lie within its rest radius times the stretch about its seed: the largest ratio of
/// moved to resting distance between neighbouring seeds, with a margin of 30 %, which the stretch within
/// a patch must not pass; nor is more than threefold stretch followed. That holds for a twist, whose rate
/// changes little over a patch; a test compares with FCL on fully deformed organs. Other ways were measured
/// and left: docs/contact.md.
///
/// Lives on the stack (80 KB with a query). noexcept, allocation-free; IEEE basic operations in a fixed
/// order.
class DeformedSurface {
 public:
  /// `patches` and what `places` points to outlive the object.
  DeformedSurface(const SurfacePatches& patches, const VertexPlaces& places) noexcept;

  /// The closest pair of surface and segment when it is nearer than `reach_m`; signs and normals as
  /// CollisionMesh::nearest.
  [[nodiscard]] SegmentHit nearest(const Segment& segment, double reach_m) noexcept;
  /// As CollisionMesh::closest.
  [[nodiscard]] SurfacePoint closest(const Vec3& point_m) noexcept;

 private:
  [[nodiscard]] Vec3 place(std::uint32_t vertex) const noexcept { return places_.at(places_.self, vertex); }
  void openGroup(std::size_t group) noexcept;
  [[nodiscard]] Vec3 faceNormal(std::uint32_t triangle) const noexcept;
  [[nodiscard]] Vec3 featureNormal(std::uint32_t triangle, std::uint8_t feature) const noexcept;

  const SurfacePatches& patches_;
  VertexPlaces places_;
  double stretch_ = 1.0;  // of the surface on the whole
  std::array<Vec3, SurfacePatches::kMostGroups> groups_m_;
  std::array<bool, SurfacePatches::kMostGroups> opened_{};
  std::array<double, SurfacePatches::kMostGroups> groupStretch_;
  std::array<Vec3, SurfacePatches::kMostPatches> patches_m_;  // of the opened groups
};

}  // namespace torsio
