// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/geometry/lattice/end_caps.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// The places of all key points of a lattice, metres: the one of a ridge and a section at [section N +
/// ridge]. Every model of an organ is read in this form.
struct LatticePlaces {
  int ridges = 0;
  int sections = 0;
  std::vector<Vec3> places_m;

  [[nodiscard]] const Vec3& at(int section, int ridge) const noexcept {
    return places_m[static_cast<std::size_t>(section) * static_cast<std::size_t>(ridges) +
                    static_cast<std::size_t>(ridge % ridges)];
  }
};

/// Returns the key points at rest.
[[nodiscard]] LatticePlaces restPlaces(const SectionLattice& lattice);

/// The key points of a lattice as points of the triangles of its mesh, carried along as the vertices move.
class CarriedKeyPoints {
 public:
  CarriedKeyPoints(const TriangleMesh& mesh, const SectionLattice& lattice);
  /// Returns where they are when the vertices of the mesh are at `vertices_m`.
  [[nodiscard]] LatticePlaces at(const TriangleMesh& mesh, std::span<const Vec3> vertices_m) const;

 private:
  int ridges_ = 0;
  int sections_ = 0;
  std::vector<LatticePoint> points_;
};

/// Computes the root mean square distance of corresponding key points, m.
[[nodiscard]] double rootMeanSquareDistance_m(const LatticePlaces& a, const LatticePlaces& b);
/// Computes the volume within the outlines and the two end sections, m^3; each patch is taken as four
/// triangles round its middle.
[[nodiscard]] double latticeVolume_m3(const LatticePlaces& places);
/// Computes the largest |r / r0 - 1|, r the distance of a key point from the centroid of its section's key
/// points.
[[nodiscard]] double largestRadiusChange(const LatticePlaces& rest, const LatticePlaces& now);
/// Computes how rough a deformation made the outline, m: root mean square, over all key points between the
/// ends, of what the change of the radius differs from its mean over the four neighbours. A smooth swelling
/// is not rough; burrs and saw teeth from point to point are.
[[nodiscard]] double roughness_m(const LatticePlaces& rest, const LatticePlaces& now);

/// A marker on the skin: carried by three key points, or by an end as a rigid body.
struct MarkerAnchor {
  LatticePart part = LatticePart::kSide;
  Vec3 rest_m;
  std::array<std::size_t, 3> points{};  ///< of the lattice places; kSide only
  std::array<double, 3> weights{};
};

/// Attaches a marker: beyond an end (as the nearest vertex of the mesh says) to that end, else to the nearest
/// place on the patches of the lattice.
[[nodiscard]] MarkerAnchor anchorMarker(const TriangleMesh& mesh, const SectionLattice& lattice,
                                        const Vec3& position_m);

/// Returns where a point of a cap (not kSide, contract) is when the free end has turned by `angle_rad` about
/// the tangent of the frame `end`.
[[nodiscard]] Vec3 capPlace_m(LatticePart part, const Vec3& rest_m, const AxisFrame& end, double angle_rad);

/// Returns where a marker is when the key points are at `now` and the free end has turned by `angle_rad`
/// about the tangent of the frame `end`.
[[nodiscard]] Vec3 markerPlace_m(const MarkerAnchor& marker, const LatticePlaces& rest,
                                 const LatticePlaces& now, const AxisFrame& end, double angle_rad);

/// Returns the same where the free end is not held in its place: a marker beyond it is carried by the key
/// points of the last section as by a rigid body.
[[nodiscard]] Vec3 markerPlace_m(const MarkerAnchor& marker, const LatticePlaces& rest,
                                 const LatticePlaces& now);

/// Shows a model by the organ's own mesh: what lies between key points moves as they do, bilinearly in arc
/// length and ridge angle, and what stands out from their patch turns with it; beyond the fixed end nothing
/// moves, beyond the free end all turns with it as a rigid body. Immutable; copies its data.
class LatticeSkin {
 public:
  LatticeSkin(const TriangleMesh& mesh, const SectionLattice& lattice);

  /// Computes where the vertices are when the key points are at `now` and the free end has turned in its
  /// place by `turned_rad`; none: the end is not held, and what lies beyond it moves with the last section.
  /// `out_m`: one entry a vertex of the mesh (contract).
  void deform(const LatticePlaces& now, std::optional<double> turned_rad, std::span<Vec3> out_m) const;

 private:
  /// A vertex at rest and the key points that carry it; on the side of the organ only.
  struct CarriedVertex {
    LatticePart part = LatticePart::kSide;
    Vec3 rest_m;
    std::array<std::size_t, 4> points{};
    std::array<double, 4> weights{};
    Vec3 aside_m;  ///< from the point of the patch, along its three directions
  };

  std::vector<CarriedVertex> vertices_;
  LatticePlaces rest_;
  AxisFrame end_;
};

}  // namespace torsio
