// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A closed surface cut into connected patches of some 32 triangles, and these joined to connected groups
/// of some 16, so that queries of a deformed surface need not move all of it: one vertex of each group and
/// patch (its seed) is moved, and the rest lies within the radius times the stretch of the surface
/// (deformed_surface.h). Immutable.
class SurfacePatches {
 public:
  static constexpr std::size_t kMaxPatches = 1024;
  static constexpr std::size_t kMaxGroups = 256;
  static constexpr std::size_t kMaxVertices = 2048;  ///< of one patch

  struct Facet {
    std::uint32_t triangle = 0;
    std::uint16_t corner[3] = {0, 0, 0};  ///< in the patch's own vertices
  };
  struct Patch {
    std::uint32_t seed = 0;  ///< vertex
    double radius_m = 0.0;   ///< largest distance of a vertex from the seed, at rest
    double apart_m = 0.0;    ///< of the seed from the group's seed
    std::uint32_t firstVertex = 0;
    std::uint32_t firstFacet = 0;
    std::uint32_t vertexCount = 0;
    std::uint32_t facetCount = 0;
  };
  struct Group {
    std::uint32_t seed = 0;  ///< that of one of its patches
    double radius_m = 0.0;   ///< largest distance of a vertex from the seed, at rest
    std::uint32_t firstPatch = 0;
    std::uint32_t patchCount = 0;
  };
  /// Two groups that touch, with the distance of their seeds at rest.
  struct Neighbours {
    std::uint32_t one = 0;
    std::uint32_t other = 0;
    double apart_m = 0.0;
  };

  /// Cuts a closed mesh into patches. Throws Error{kBadMesh} for more than about a million triangles.
  explicit SurfacePatches(const TriangleMesh& mesh);

  /// Returns the patches in the order of their groups.
  [[nodiscard]] std::span<const Patch> patches() const noexcept { return patches_; }
  [[nodiscard]] std::span<const Group> groups() const noexcept { return groups_; }
  [[nodiscard]] std::span<const Neighbours> neighbours() const noexcept { return neighbours_; }
  /// Returns the vertices of a patch; its facets name them by their place in this list.
  [[nodiscard]] std::span<const std::uint32_t> vertices(const Patch& patch) const noexcept {
    return std::span(vertices_).subspan(patch.firstVertex, patch.vertexCount);
  }
  [[nodiscard]] std::span<const Facet> facets(const Patch& patch) const noexcept {
    return std::span(facets_).subspan(patch.firstFacet, patch.facetCount);
  }
  [[nodiscard]] const TriangleMesh::Triangle& corners(std::uint32_t triangle) const noexcept {
    return triangles_[triangle];
  }
  /// Returns the number of triangles.
  [[nodiscard]] std::size_t triangles() const noexcept { return triangles_.size(); }
  /// Returns the triangles round a vertex.
  [[nodiscard]] std::span<const std::uint32_t> ring(std::uint32_t vertex) const noexcept {
    return std::span(ring_).subspan(ringBegins_[vertex], ringBegins_[vertex + 1] - ringBegins_[vertex]);
  }

 private:
  void findRings(std::size_t vertices);
  void cut(const TriangleMesh& mesh);
  void fill(const TriangleMesh& mesh, const std::vector<std::vector<std::uint32_t>>& members);
  void join(const TriangleMesh& mesh, const std::vector<std::uint32_t>& groupOf, std::size_t groups);

  std::vector<TriangleMesh::Triangle> triangles_;
  std::vector<std::uint32_t> ringBegins_;
  std::vector<std::uint32_t> ring_;
  std::vector<Patch> patches_;
  std::vector<Group> groups_;
  std::vector<std::uint32_t> vertices_;
  std::vector<Facet> facets_;
  std::vector<Neighbours> neighbours_;
};

}  // namespace torsio
