// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Neighbourhood of triangles, edges and vertices on a closed, oriented, manifold surface. Half-edge 3 t +
/// k runs from corner k of triangle t to corner k + 1.
class SurfaceTopology {
 public:
  using Index = std::uint32_t;

  /// Builds the topology of a mesh. Throws Error{kBadMesh} for an open, non-manifold or inconsistently
  /// oriented edge, an index out of range or a vertex that is not finite. O(T log T).
  explicit SurfaceTopology(const TriangleMesh& mesh);

  [[nodiscard]] static Index next(Index half) noexcept { return half % 3 == 2 ? half - 2 : half + 1; }
  [[nodiscard]] static Index previous(Index half) noexcept { return half % 3 == 0 ? half + 2 : half - 1; }
  [[nodiscard]] Index opposite(Index half) const noexcept { return opposite_[half]; }
  [[nodiscard]] Index origin(Index half) const noexcept { return origin_[half]; }
  [[nodiscard]] Index target(Index half) const noexcept { return origin_[next(half)]; }
  [[nodiscard]] Index halfEdges() const noexcept { return static_cast<Index>(origin_.size()); }
  [[nodiscard]] Index vertices() const noexcept { return static_cast<Index>(firstOutgoing_.size() - 1); }
  /// Returns the half-edges that start at a vertex, one a neighbour.
  [[nodiscard]] std::span<const Index> outgoing(Index vertex) const noexcept {
    return {outgoing_.data() + firstOutgoing_[vertex], outgoing_.data() + firstOutgoing_[vertex + 1]};
  }

 private:
  void findOutgoing(std::size_t vertices);
  void pairEdges(const TriangleMesh& mesh);

  std::vector<Index> origin_;
  std::vector<Index> opposite_;
  std::vector<Index> firstOutgoing_;  // CSR over vertices
  std::vector<Index> outgoing_;
};

/// Computes the length of the shortest way along edges from any of `sources` to every vertex (Dijkstra),
/// metres; infinity where there is none.
[[nodiscard]] std::vector<double> edgeDistances_m(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                                  std::span<const std::uint32_t> sources);

/// Takes the vertices that are connected with `seed` among those whose `open` is not 0, and sets theirs to
/// 0. None when that of `seed` is 0.
[[nodiscard]] std::vector<std::uint32_t> takeConnected(const SurfaceTopology& topology,
                                                       std::vector<std::uint8_t>& open, std::uint32_t seed);

}  // namespace torsio
