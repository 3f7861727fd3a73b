// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/geometry/mesh/nearest_on_triangle.h"
#include "sim/geometry/mesh/surface_patches.h"

namespace torsio {

/// Access to the present places of the vertices of the mesh. Called in the servo tick.
struct VertexPlaces {
  const void* self = nullptr;
  Vec3 (*at)(const void* self, std::uint32_t vertex) noexcept = nullptr;
};

/// Access to how far the pieces of the mesh reach as they lie: a length from the moved seed beyond which no
/// vertex of the piece is. Called in the servo tick. Without functions nothing is known (DeformedSurface).
struct PieceBounds {
  const void* self = nullptr;
  double (*group_m)(const void* self, std::size_t group) noexcept = nullptr;
  double (*patch_m)(const void* self, std::size_t patch) noexcept = nullptr;
};

/// Some triangles that lie together, with the vertices that they share. Fixed size, trivially copyable.
struct FacetList {
  static constexpr std::size_t kMaxFacets = 128;
  static constexpr std::size_t kMaxVertices = 128;

  struct Facet {
    std::uint32_t triangle;
    std::array<std::uint8_t, 3> corner;  ///< in `vertices`
  };
  std::array<Facet, kMaxFacets> facets;
  std::array<std::uint32_t, kMaxVertices> vertices;
  std::size_t facetCount = 0;
  std::size_t vertexCount = 0;

  /// Adds a triangle with these vertices; false when it does not fit.
  [[nodiscard]] bool add(std::uint32_t triangle, const std::array<std::uint32_t, 3>& corners) noexcept;
};

/// A surface in one deformed state, for the queries of one tick: exact on the triangles of the moved
/// vertices, yet only some hundred of them are moved. For the first query one seed a group of patches is
/// moved; a query visits groups and patches nearest first and moves the vertices of those that can hold the
/// answer. Moved patches stay for the next queries, with their exact radius.
///
/// Where bounds are given, groups and patches lie within them. Else a patch is taken to lie within its rest
/// radius times the stretch about its seed: the largest ratio of moved to resting distance between
/// neighbouring seeds, with a margin of 30 %, which the stretch within a patch must not pass; nor is more
/// than threefold stretch followed. That holds for a twist, whose rate changes little over a patch; a test
/// compares with FCL on fully deformed organs. Other ways were measured and left: docs/contact.md.
///
/// Lives on the stack (160 KB with a query). noexcept, allocation-free; IEEE basic operations in a fixed
/// order.
class DeformedSurface {
 public:
  /// Moves nothing yet. `patches` and what `places` and `bounds` point to outlive the object.
  DeformedSurface(const SurfacePatches& patches, const VertexPlaces& places,
                  const PieceBounds& bounds = {}) noexcept;

  /// Returns the closest pair of surface and segment when it is nearer than `reach_m`; signs and normals as
  /// CollisionMesh::nearest. `hint`: a triangle that may be near, which makes the query quick.
  [[nodiscard]] SegmentHit nearest(const Segment& segment, double reach_m,
                                   std::uint32_t hint = kNoTriangle) noexcept;
  /// Returns the nearest point of the deformed surface; signs and normals as CollisionMesh::closest.
  [[nodiscard]] SurfacePoint closest(const Vec3& point_m, std::uint32_t hint = kNoTriangle) noexcept;
  /// Returns the closest pair of a segment and the triangles of a list, as nearest().
  [[nodiscard]] SegmentHit nearestAmong(const Segment& segment, const FacetList& list) const noexcept;
  /// Lists every triangle that comes nearer than `reach_m` to a segment, and some that do not. Returns false
  /// when they do not fit.
  [[nodiscard]] bool gather(const Segment& segment, double reach_m, FacetList& out) noexcept;

 private:
  // Without initial values: most of the arrays is never used, and to fill them takes longer than a query.
  struct Place {
    double x, y, z;
  };
  static Place kept(const Vec3& v) noexcept { return {v.x, v.y, v.z}; }
  static Vec3 at(const Place& place) noexcept { return {place.x, place.y, place.z}; }
  static constexpr std::uint32_t kNotMoved = 0xFFFFFFFFU;
  static constexpr std::size_t kMaxMoved = 4096;  // vertices; more than this and they are moved anew
  static_assert(kMaxMoved >= SurfacePatches::kMaxVertices);

  [[nodiscard]] Vec3 place(std::uint32_t vertex) const noexcept { return places_.at(places_.self, vertex); }
  void moveSeeds() noexcept;
  [[nodiscard]] double wholeStretch() const noexcept;
  void openGroup(std::size_t group) noexcept;
  /// Moves the patch's vertices unless they are moved already; returns where they begin in moved_m_.
  std::uint32_t movePatch(std::size_t patch) noexcept;
  [[nodiscard]] SegmentHit hitOf(const Segment& segment, double along, std::uint32_t triangle,
                                 const NearestOnTriangle& on) const noexcept;
  [[nodiscard]] Vec3 faceNormal(std::uint32_t triangle) const noexcept;
  [[nodiscard]] Vec3 featureNormal(std::uint32_t triangle, std::uint8_t feature) const noexcept;

  const SurfacePatches& patches_;
  VertexPlaces places_;
  PieceBounds bounds_;
  bool seeded_ = false;   // the seeds of the groups are moved
  double stretch_ = 1.0;  // of the surface on the whole; unused with bounds
  std::array<Place, SurfacePatches::kMaxGroups> groups_m_;
  std::array<double, SurfacePatches::kMaxGroups> groupRadii_m_;
  std::array<bool, SurfacePatches::kMaxGroups> opened_{};
  // Of the patches of the opened groups.
  std::array<Place, SurfacePatches::kMaxPatches> patches_m_;
  std::array<double, SurfacePatches::kMaxPatches> radii_m_;
  std::array<std::uint32_t, SurfacePatches::kMaxPatches> movedAt_;
  std::array<Place, kMaxMoved> moved_m_;
  std::size_t movedCount_ = 0;
};

}  // namespace torsio
