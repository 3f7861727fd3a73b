// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/core/vec3.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Limits of what tissue can do: beyond them a deformation is a picture, no organ.
inline constexpr double kLeastDeterminant = 0.2;  ///< of det F
inline constexpr double kMaxVolumeChange = 0.02;  ///< of the organ, either way

/// Which limit a deformation passes.
enum class FoldLimit { kNone, kDeterminant, kCrossings, kVolume };

/// What a body bears; by default filled tissue.
struct FoldLimits {
  double leastDeterminant = kLeastDeterminant;  ///< of det F
  double mostCrossings = 0.0;                   ///< new pairs of triangles that cross
  double leastVolume = 1.0 - kMaxVolumeChange;  ///< over that at rest
  double mostVolume = 1.0 + kMaxVolumeChange;
};

/// What a deformation does to the organ as a body.
struct FoldReport {
  double volumeRatio = 1.0;     ///< volume now over volume at rest
  double minDeterminant = 1.0;  ///< det F, local volume ratio, smallest of the points asked for
  double maxDeterminant = 1.0;
  std::size_t crossings = 0;  ///< pairs of triangles that cut through one another and did not at rest

  /// Returns the first limit that is passed.
  [[nodiscard]] FoldLimit passed(const FoldLimits& limits = {}) const noexcept;
  /// Tells whether the tissue would have to be folded, torn or swollen to look like this.
  [[nodiscard]] bool folded() const noexcept { return passed() != FoldLimit::kNone; }
  /// Says what is wrong, for people: "det F, the local volume ratio, falls to -0.31"; empty where no limit is
  /// passed.
  [[nodiscard]] Text reason(const FoldLimits& limits = {}) const;
};

/// Judges deformations of one organ. Immutable.
class FoldCheck {
 public:
  /// Takes the organ at rest. `lattice`: of `mesh`; det F is looked at on the axis and at 0.5 and 0.95 of the
  /// way to each key point of its inner sections.
  FoldCheck(const TriangleMesh& mesh, const SectionLattice& lattice);

  /// Measures and judges a deformation: `vertices_m` of the mesh now, and the map of the tissue inside, whose
  /// det F is taken by central differences. Allocates; not for the tick.
  [[nodiscard]] FoldReport judge(std::span<const Vec3> vertices_m,
                                 const std::function<Vec3(const Vec3&)>& toDeformed_m) const;

 private:
  TriangleMesh rest_;
  double volume_m3_ = 0.0;
  std::vector<TrianglePair> crossingsAtRest_;
  std::vector<Vec3> inside_m_;
};

}  // namespace torsio
