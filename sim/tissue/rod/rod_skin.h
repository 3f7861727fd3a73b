// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "sim/core/organ_pose.h"
#include "sim/core/vec3.h"
#include "sim/tissue/rod/rod_sections.h"

namespace torsio {

/// Curve through the nodes of a rod that the surface is drawn from: smoothed nodes, cubic pieces between
/// them. Places and frames have continuous derivatives. Fixed size, trivially copyable; made by
/// RodSkin::curveOf.
struct RodCurve {
  static constexpr int kSamples = 4;  ///< places an element that a search for the nearest one begins at
  int count = 0;                      ///< nodes in use
  std::array<double, kMaxRodNodes> arcs_m{};  ///< of the nodes along the curve at rest, from 0
  std::array<Pose, kMaxRodNodes> nodes{};
  std::array<Vec3, kMaxRodNodes> slopes{};       ///< d place / d arc
  std::array<Vec3, kMaxRodNodes> bends_per_m{};  ///< curvature in the axes of the node
  std::array<Vec3, kMaxRodNodes> turns{};        ///< 4 sigma from a node to the next
  std::array<Vec3, kMaxRodNodes> lastRates{};    ///< d (4 sigma) / d arc at the end of that element
  /// How wide the section at a node is against its own width at rest, beside what stretch and bend make of
  /// it: 1, but of a wall that its content widens or a twist narrows.
  std::array<double, kMaxRodNodes> widths{};

  /// Returns that width in an element.
  [[nodiscard]] double widthAt(std::size_t element, double share) const noexcept {
    return widths[element] + share * (widths[element + 1] - widths[element]);
  }

  /// Returns the length of the curve at rest.
  [[nodiscard]] double length_m() const noexcept {
    return count > 0 ? arcs_m[static_cast<std::size_t>(count - 1)] : 0.0;
  }
};
static_assert(std::is_trivially_copyable_v<RodCurve>);

/// How a section lies on a curve, as RodSkin::positionOf_m needs it.
struct RodCurvePlace {
  Vec3 place_m;
  Quat turn;
  std::array<double, 2> inwards_per_m{};  ///< bend over stretch, towards the inside of the bend
  double stretch = 1.0;
  double twist_per_m = 0.0;
};

/// Coordinates of a point of the organ that go with the tissue: section, place in the straightened section,
/// distance from the section beyond an end.
struct RodSkinPlace {
  double arc_m = 0.0;                 ///< along the rod at rest, from node 0
  std::size_t element = 0;            ///< that arc_m lies in
  double share = 0.0;                 ///< of the way along that element, 0..1
  std::array<double, 2> section_m{};  ///< in the section, brought to a straight axis
  double beyond_m = 0.0;              ///< along the tangent, where the point lies in a cap
  double restStretch = 1.0;           ///< Gamma3 of the curve at rest
  double restFibre = 1.0;             ///< rest length of this fibre over that of the axis
  std::array<double, 2> left_m{};     ///< what the map cannot say: zero except near the centre of a bend
  double restTwist_per_m = 0.0;       ///< of the curve at rest
  double warping_m2 = 0.0;            ///< psi: way along the tangent for unit twist rate; vertices only
};

/// Shape of an organ whose rod has moved: maps the organ at rest onto the organ as it is. The map keeps every
/// volume (det F = 1) as long as no section is bent more sharply than z = 0.455 (docs/model.md R.8), and
/// gives back the organ at rest to rounding. Immutable; the queries are noexcept and allocate nothing; + - *
/// / and square roots only.
class RodSkin {
 public:
  /// Takes the rest pose of `organ` and finds where the vertices of `mesh`, the surface of `lattice`, belong.
  /// `sections`: of the same lattice; vertices are warped by theta psi, which fades out over half a radius
  /// towards both ends of the rod, as a held face keeps flat. Where the axis at rest bends more sharply than
  /// the sections allow, the curve is smoothed further.
  RodSkin(const OrganRod& organ, const SectionLattice& lattice, const SolvedSections& sections,
          const TriangleMesh& mesh);

  /// Draws the curve of a pose.
  [[nodiscard]] RodCurve curveOf(const RodPose& pose) const noexcept;
  /// Returns the curve at rest.
  [[nodiscard]] const RodCurve& restCurve() const noexcept { return rest_; }
  /// Returns a place of a curve, `share` of the way along an element.
  [[nodiscard]] static RodCurvePlace placeOn(const RodCurve& curve, std::size_t element,
                                             double share) noexcept;
  /// Returns the coordinates of the vertices of the mesh.
  [[nodiscard]] std::span<const RodSkinPlace> vertexPlaces() const noexcept { return vertices_; }
  /// Returns the coordinates of a point of the organ at rest, or near it.
  [[nodiscard]] RodSkinPlace placeOf(const Vec3& rest_m) const noexcept;
  /// Returns where the point with these coordinates lies.
  [[nodiscard]] Vec3 positionOf_m(const RodSkinPlace& place, const RodCurve& curve) const noexcept;
  /// Maps a point of the organ at rest to its place now, without warping.
  [[nodiscard]] Vec3 toDeformed_m(const Vec3& rest_m, const RodCurve& curve) const noexcept;
  /// Maps a point near the organ as it is back to where it would be at rest: the inverse of toDeformed_m.
  [[nodiscard]] Vec3 toRest_m(const Vec3& deformed_m, const RodCurve& curve) const noexcept;
  /// Returns where a vertex of the mesh lies, warped.
  [[nodiscard]] Vec3 vertex_m(std::size_t vertex, const RodCurve& curve) const noexcept {
    return positionOf_m(vertices_[vertex], curve);
  }
  /// Returns the largest normalised bend z that a pose asks of the surface at the nodes of the curve: up to
  /// 0.455 every volume is kept, at 0.495 tissue is folded away (docs/model.md R.8). In the tick.
  [[nodiscard]] double sharpestBend(const RodCurve& curve) const noexcept;
  /// Computes the vertices of the mesh into `out_m`, one entry a vertex.
  void deform(const RodCurve& curve, std::span<Vec3> out_m) const noexcept;

 private:
  void findRims();
  void warpVertices(const OrganRod& organ, const SectionLattice& lattice, const SolvedSections& sections);
  [[nodiscard]] RodSkinPlace placeAt(const Vec3& rest_m, double arc_m) const noexcept;

  int smoothings_ = 0;
  RodCurve rest_;
  std::vector<RodSkinPlace> vertices_;
  /// Of each node, the outermost points of the surface beside it in kRimPoints directions, brought to a
  /// straight axis, m.
  static constexpr std::size_t kRimPoints = 16;
  std::vector<std::array<std::array<double, 2>, kRimPoints>> rims_m_;
};

}  // namespace torsio
