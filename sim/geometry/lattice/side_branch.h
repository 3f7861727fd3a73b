// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// An organ without what hangs on its side, and how the two belong together.
class TrimmedOrgan {
 public:
  /// Cuts off the piece beyond the plane through `root_m` with the outward direction `outward` that lies
  /// nearest to `root_m`, and closes the hole with a lid. `mesh`: closed and manifold. Throws
  /// Error{kBadParameter}: nothing beyond the plane, more than a tenth of the vertices, or a cut that is no
  /// simple loop.
  TrimmedOrgan(const TriangleMesh& mesh, const Vec3& root_m, const Vec3& outward);

  /// Returns the organ without the branch: closed, manifold, its vertices in the order of the whole organ,
  /// the middle of the lid last.
  [[nodiscard]] const TriangleMesh& mesh() const noexcept { return mesh_; }

  /// Takes coordinates of the trimmed organ's vertices to those of the whole: a vertex of the branch has that
  /// of the point of the lid on which it stands.
  [[nodiscard]] std::vector<LatticeCoordinate> toWhole(std::span<const LatticeCoordinate> trimmed) const;
  /// The same for parts: the branch is `side`.
  [[nodiscard]] std::vector<LatticePart> toWhole(std::span<const LatticePart> trimmed) const;
  /// Takes a point of the trimmed organ to one of the whole: one of the lid goes to the rim.
  [[nodiscard]] LatticePoint toWhole(const LatticePoint& point) const;

 private:
  /// Of a vertex of the whole: its number in the trimmed organ, or the triangle of the lid that it stands on.
  struct Place {
    std::uint32_t vertex = 0;
    bool onLid = false;
    std::uint32_t lidTriangle = 0;
    std::array<double, 3> weights{};
  };
  struct Rim {
    std::uint32_t triangle = 0;  ///< of the whole, beside the edge
    std::uint32_t corner = 0;    ///< of that triangle, where the edge starts
  };

  void cut(const TriangleMesh& mesh, const std::vector<std::uint8_t>& branch);
  void close(const TriangleMesh& mesh);
  void place(const TriangleMesh& mesh, const std::vector<std::uint8_t>& branch, const Vec3& root_m,
             const Vec3& direction);

  TriangleMesh mesh_;
  std::vector<Place> places_;             // one a vertex of the whole
  std::vector<std::uint32_t> triangles_;  // of the whole, one per triangle of mesh_ outside the lid
  std::vector<Rim> rims_;                 // one a triangle of the lid, which come last
};

/// What hangs on the side of an organ, as the oesophagus on the stomach.
struct SideBranch {
  Vec3 root_m;            ///< middle of its root, where it begins to open out into the organ
  Vec3 outward;           ///< unit, along it
  Vec3 away;              ///< unit, from the middle of the organ beside its root to that root
  double width_m = 0.0;   ///< diameter of the round section of the area at its root
  double length_m = 0.0;  ///< from its root to its tip
};

/// Finds the longest side branch of at most a tenth of the organ, for its width, away from the two named
/// ends: a piece as long as three quarters of its width that ends in a tip. None if there is no such piece.
/// `mesh`: closed and manifold. Some tenths of a second for 100 000 triangles.
[[nodiscard]] std::optional<SideBranch> findSideBranch(const TriangleMesh& mesh, const Vec3& fixedEnd_m,
                                                       const Vec3& freeEnd_m);

}  // namespace torsio
