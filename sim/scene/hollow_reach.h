// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/mesh/surface_patches.h"

namespace torsio {

class HollowMap;
class HollowOrgan;

/// How far the pieces of a hollow organ's surface (SurfacePatches) reach from their seeds as it lies, from
/// above for every angle and pressure: from the map itself (docs/contact.md). A point of the surface lies at
/// c + Q(d, turn) (u + (radius - 1) e): c a point of its axis, u from there, e the part of u that shrinks, d
/// the line that its section turns about. With turn and radius of the seed's section for all, how far the
/// piece reaches depends on these two alone and is tabled; by how much other sections turn and shrink
/// otherwise goes with their lever arm. Immutable.
class HollowReach {
 public:
  HollowReach() = default;
  /// Measures all pieces; `patches` are those of the mesh whose vertices the organ has.
  HollowReach(const HollowOrgan& organ, const SurfacePatches& patches);

  /// Tells whether nothing was measured.
  [[nodiscard]] bool empty() const noexcept { return patches_.empty(); }
  /// Returns a length from the moved seed that no vertex of the piece is beyond, m. In the tick.
  [[nodiscard]] double group_m(std::size_t group, const HollowMap& map) const noexcept;
  [[nodiscard]] double patch_m(std::size_t patch, const HollowMap& map) const noexcept;

 private:
  /// Where a vertex lies in its section.
  struct Lever {
    Vec3 foot_m;
    Vec3 line;      // direction
    Vec3 along_m;   // u - e
    Vec3 across_m;  // e
    int span = -1;
    double share = 1.0;
  };
  /// Shares of a span that a piece covers.
  struct Range {
    double from = 1.0;
    double to = 0.0;  // below `from`: none
  };
  static constexpr std::size_t kAngles = 24;  // of the seed's turn
  static constexpr std::size_t kRadii = 3;    // 0, 1 and 2: between them the reach is convex
  struct Piece {
    int span = -1;  // of the seed
    double share = 1.0;
    std::array<Range, 2> spans;
    bool mobile = false;
    double across_m = 0.0;  // largest lever arms: of what shrinks
    double along_m = 0.0;   // of what does not
    std::array<std::array<double, kAngles>, kRadii> reach_m{};
  };
  static Lever leverOf(const HollowOrgan& organ, std::size_t vertex);
  static Piece measured(const Lever& seed, const std::vector<Lever>& levers,
                        std::span<const std::uint32_t> vertices);
  static double reachOf_m(const Piece& piece, const HollowMap& map) noexcept;

  std::vector<Piece> patches_;
  std::vector<Piece> groups_;
};

}  // namespace torsio
