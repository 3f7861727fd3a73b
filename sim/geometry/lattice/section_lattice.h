// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/centreline.h"
#include "sim/geometry/lattice/end_caps.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Coordinates of a surface point on the organ: arc length along the centreline from the fixed end, and ridge
/// angle about it.
struct LatticeCoordinate {
  double arc_m = 0.0;
  double angle_rad = 0.0;  ///< [0, 2 pi), ridge 0 at 0; equal steps are equal ridges (see RidgeSpacing)
};

using Point2 = std::array<double, 2>;

/// Outline of one section in the frame of the centreline there: (x, y) along e1, e2 from the centre, metres,
/// anticlockwise about the tangent, first point not repeated, with the ridge angle of each point.
struct LatticeOutline {
  std::vector<Point2> points_m;
  std::vector<double> angles_rad;  ///< strictly increasing from 0, below 2 pi
};

enum class LatticeMode {
  kHarmonic,  ///< level sets of a harmonic field between two caps: any closed genus-0 organ, curved or not
  kStraightAxis,  ///< the paper's parallel planes along the principal axis
  kAutomatic,     ///< planes for a straight bar with two parallel flat ends, else the harmonic field
};

enum class RidgeSpacing {
  kAngle,      ///< equal polar angle about the centroid (star-shaped sections only)
  kArcLength,  ///< equal way along each section's outline
};

inline constexpr int kMinRidges = 3;  ///< two ridges cannot bound an area
inline constexpr int kMaxRidges = 360;
inline constexpr int kMinSections = 2;
inline constexpr int kMaxSections = 360;
inline constexpr int kMinOutlinePoints = 96;  ///< fewer make a round section more than 0.2 % too soft

struct LatticeOptions {
  int ridges = 36;    ///< N, 3..360 (two ridges cannot bound an area)
  int sections = 25;  ///< M, 2..360, both ends included
  LatticeMode mode = LatticeMode::kHarmonic;
  RidgeSpacing spacing = RidgeSpacing::kArcLength;
  /// Some point near the middle of each end cap; when both are equal the caps are found automatically, and
  /// the lower one (smaller z, then y, then x) is the fixed end, as in the paper's cylinder. A lattice with
  /// caps that were found also ends where the organ branches, as at the thumb: the rest is free cap.
  Vec3 fixedEnd_m{};
  Vec3 freeEnd_m{};
  /// Outward direction of a cut through an end point: everything beyond that plane belongs to the cap and
  /// follows the end section rigidly (the hand beyond the wrist). Zero: the flat face at the end point, or
  /// the rounded tip. Straight mode always cuts at right angles to the axis.
  Vec3 fixedCut{};
  Vec3 freeCut{};
  double capRadius_m = 0.0;  ///< > 0: a disc on the surface about the end point instead of the rounded tip
  /// Ridge 0 starts nearest to this direction (world frame); zero: the frame's e1.
  Vec3 ridgeZero{};
  double ridgeZeroFraction = 0.0;  ///< where along the length `ridgeZero` applies, 0..1
  /// What hangs on the side of the organ, as the oesophagus on the stomach: the piece beyond the plane
  /// through `branchRoot_m` with the outward direction `branchCut`. It belongs to the surface but to no
  /// section, and follows the places of the organ that it stands on. Zero: none.
  Vec3 branchRoot_m{};
  Vec3 branchCut{};
};

/// A point of the organ's surface at rest, as a point of one of its triangles.
struct LatticePoint {
  Vec3 position_m;
  std::uint32_t triangle = 0;
  std::array<double, 3> barycentric{1.0, 0.0, 0.0};  ///< of the triangle's corners, sum 1
};

struct LatticeField;
class TrimmedOrgan;

/// The paper's lattice of N ridges and M sections on the real outline (section 3.1, Eqs. 13, 14). Section
/// index j counts from the fixed end (j = 0, the clamp) to the free end (j = M - 1); the paper's label i is M
/// - j. Immutable after construction; copies share the surface data. Throws Error{kBadMesh, kBadParameter}
/// naming the value and the limit.
class SectionLattice {
 public:
  /// Builds the lattice of `mesh`: closed, manifold, outward-oriented, genus 0 (requireOrgan).
  SectionLattice(const TriangleMesh& mesh, const LatticeOptions& options);

  [[nodiscard]] int ridges() const noexcept { return options_.ridges; }
  [[nodiscard]] int sections() const noexcept { return options_.sections; }
  /// Returns the number of patches, S = (M - 1) N (Eq. 13).
  [[nodiscard]] int patches() const noexcept { return (options_.sections - 1) * options_.ridges; }
  /// Returns the options as they were given.
  [[nodiscard]] const LatticeOptions& options() const noexcept { return options_; }
  /// Returns the spacing of the ridges as built: kArcLength although kAngle was asked for when some section
  /// is not star-shaped.
  [[nodiscard]] RidgeSpacing spacing() const noexcept { return spacing_; }
  [[nodiscard]] double length_m() const noexcept { return centreline_.length_m(); }

  /// Returns the arc length of section j: j length / (M - 1) (Eq. 14 with the clamp at 0).
  [[nodiscard]] double sectionArc_m(int j) const;
  /// Returns the key point A_K(H_i) of ridge K = ridge + 1, i = M - j. World frame, rest, on the mesh.
  [[nodiscard]] Vec3 keyPoint_m(int ridge, int j) const;
  /// Returns the real outline of section j in its frame: (x, y) along e1, e2 from the centre, anticlockwise
  /// about the tangent, not closed (first point not repeated), metres. Starts on ridge 0 and holds every
  /// key point, at least kMinOutlinePoints equal steps of the ridge angle, and every corner of the
  /// mesh's section in between: its area is that of the section.
  [[nodiscard]] std::span<const Point2> outline_m(int j) const;
  /// Returns the ridge angle of each outline point of section j, strictly increasing from 0, below 2 pi.
  [[nodiscard]] std::span<const double> outlineAngles_rad(int j) const;
  /// Cuts the outlines of sections at other places than the lattice's own, as outline_m and
  /// outlineAngles_rad give them. `arcs_m`: ascending, in [0, length]. Throws Error{kBadMesh} naming the
  /// place where the organ has no simple section. Allocates, not for the tick.
  [[nodiscard]] std::vector<LatticeOutline> outlinesAt(std::span<const double> arcs_m) const;
  /// Returns the coordinates of the mesh's vertices, in their order.
  [[nodiscard]] std::span<const LatticeCoordinate> vertexCoordinates() const noexcept { return coordinates_; }
  [[nodiscard]] std::span<const LatticePart> vertexParts() const noexcept { return parts_; }

  /// Returns the surface point with these coordinates (inverse of vertexCoordinates on the side of the
  /// organ). `arc_m` is clamped to [0, length]; allocates, not for the tick.
  /// Where a branch leaves the organ, the point of its rim that is nearest.
  [[nodiscard]] LatticePoint surfacePoint(const LatticeCoordinate& coordinate) const;

  /// Tells whether all sections are parallel planes (kStraightAxis, or kAutomatic on a straight bar).
  [[nodiscard]] bool straight() const noexcept { return centreline_.straight(); }
  [[nodiscard]] const Centreline& centreline() const noexcept { return centreline_; }
  /// Returns the frame at an arc length, clamped to [0, length]. Allocation-free: runs in the servo tick.
  [[nodiscard]] AxisFrame frameAt(double arc_m) const noexcept { return centreline_.frameAt(arc_m); }
  /// Returns the arc length of the centreline point nearest to `point_m`. Allocation-free: runs in the
  /// servo tick.
  [[nodiscard]] double nearestArc_m(const Vec3& point_m) const noexcept {
    return centreline_.nearestArc_m(point_m);
  }

 private:
  LatticeOptions options_;
  RidgeSpacing spacing_ = RidgeSpacing::kArcLength;
  Centreline centreline_;
  std::shared_ptr<const LatticeField> field_;       // mesh with its two coordinates: surfacePoint
  std::shared_ptr<const TrimmedOrgan> trimmed_;     // null without a branch
  std::vector<Vec3> keyPoints_m_;                   // [j * N + ridge]
  std::vector<std::vector<Point2>> outlines_m_;     // [j]
  std::vector<std::vector<double>> outlineAngles_;  // [j]
  std::vector<LatticeCoordinate> coordinates_;
  std::vector<LatticePart> parts_;
};

}  // namespace torsio
