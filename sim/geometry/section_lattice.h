// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "sim/base/vec3.h"
#include "sim/geometry/triangle_mesh.h"

namespace torsio {

/// Coordinates of a surface point on the organ: arc length along the centreline from the fixed end, and ridge
/// angle about it.
struct LatticeCoordinate {
  double arc_m = 0.0;
  double angle_rad = 0.0;  ///< [0, 2 pi), ridge 0 at 0
};

/// Right-handed frame of the centreline: e1 x e2 = tangent. Rotation-minimising along a curved organ.
struct AxisFrame {
  Vec3 centre_m;
  Vec3 tangent;
  Vec3 e1;
  Vec3 e2;
};

using Point2 = std::array<double, 2>;

enum class LatticeMode {
  kHarmonic,  ///< level sets of a harmonic field between two caps: any closed genus-0 organ, curved or not
  kStraightAxis,  ///< the paper's parallel planes along the principal axis
};

enum class RidgeSpacing {
  kAngle,      ///< equal polar angle about the centroid (star-shaped sections only)
  kArcLength,  ///< equal way along each section's outline
};

struct LatticeOptions {
  int ridges = 36;    ///< N, 3..360 (two ridges cannot bound an area)
  int sections = 25;  ///< M, 2..360, both ends included
  LatticeMode mode = LatticeMode::kHarmonic;
  RidgeSpacing spacing = RidgeSpacing::kArcLength;
  /// Some point near the middle of each end cap; when both are equal the caps are found automatically.
  Vec3 fixedEnd_m;
  Vec3 freeEnd_m;
  /// Ridge 0 starts nearest to this direction (world frame); zero: the frame's e1.
  Vec3 ridgeZero;
};

/// The paper's lattice of N ridges and M sections on the real outline (section 3.1, Eqs. 13, 14). Section
/// index j counts from the fixed end (j = 0, the clamp) to the free end (j = M - 1); the paper's label i is M
/// - j. Immutable after construction. Throws Error{kBadMesh, kBadParameter} naming the value and the limit.
class SectionLattice {
 public:
  SectionLattice(const TriangleMesh& mesh, const LatticeOptions& options);

  [[nodiscard]] int ridges() const noexcept { return options_.ridges; }
  [[nodiscard]] int sections() const noexcept { return options_.sections; }
  /// S = (M - 1) N (Eq. 13).
  [[nodiscard]] int patches() const noexcept { return (options_.sections - 1) * options_.ridges; }
  [[nodiscard]] const LatticeOptions& options() const noexcept { return options_; }
  [[nodiscard]] double length_m() const noexcept { return length_m_; }

  /// Arc length of section j: j length / (M - 1) (Eq. 14 with the clamp at 0).
  [[nodiscard]] double sectionArc_m(int j) const;
  /// Key point A_K(H_i) of ridge K = ridge + 1, i = M - j. World frame, rest.
  [[nodiscard]] Vec3 keyPoint_m(int ridge, int j) const;
  /// The real outline of section j in its frame: (x, y) along e1, e2 from the centre, anticlockwise about the
  /// tangent, not closed (first point not repeated), metres.
  [[nodiscard]] std::span<const Point2> outline_m(int j) const;
  /// One coordinate a mesh vertex, in the order of the mesh.
  [[nodiscard]] std::span<const LatticeCoordinate> vertexCoordinates() const noexcept { return coordinates_; }

  /// Frame at an arc length, clamped to [0, length]. Allocation-free: runs in the servo tick.
  [[nodiscard]] AxisFrame frameAt(double arc_m) const noexcept;
  /// Arc length of the centreline point nearest to `point_m`. Allocation-free: runs in the servo tick.
  [[nodiscard]] double nearestArc_m(const Vec3& point_m) const noexcept;

 private:
  LatticeOptions options_;
  double length_m_ = 0.0;
  std::vector<AxisFrame> axis_;                  // equally spaced in arc length, from fixed to free end
  std::vector<Vec3> keyPoints_m_;                // [j * N + ridge]
  std::vector<std::vector<Point2>> outlines_m_;  // [j]
  std::vector<LatticeCoordinate> coordinates_;
};

}  // namespace torsio
