// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sim/geometry/query/deformed_surface.h"
#include "sim/scene/hollow_organ.h"
#include "sim/tissue/twist/twist_model_map.h"

namespace torsio {

/// How a hollow organ lies as a map of space (docs/model.md H.8): each section turns by its share of
/// the angle and shrinks to the mean radius of the wrung wall there, as HollowOrgan::moved says; folds are
/// left out, so that a tool meets a smooth surface. What is common to all points is computed on construction.
/// Lives on the stack of a query; noexcept, allocation-free, portable arithmetic only.
class HollowMap {
 public:
  HollowMap(const SectionLattice& lattice, const HollowOrgan& organ, const OrganState& state) noexcept;

  /// Returns how a section at a place is turned.
  [[nodiscard]] HollowOrgan::Section section(const HollowOrgan::Place& place) const noexcept;
  /// Least and largest turn and radius of some sections.
  struct Spread {
    HollowOrgan::Section least;
    HollowOrgan::Section most;
  };
  /// Returns those of the sections of a span from one share to another, of the mobile part for span -1.
  [[nodiscard]] Spread spread(int span, double from, double to) const noexcept;
  /// Returns where a point of the organ at rest goes.
  [[nodiscard]] Vec3 forward(const Vec3& rest_m) const noexcept;
  /// Returns where a point near the organ would be at rest: the inverse of forward() up to rounding, as long
  /// as the nearest point of the axis is the only one.
  [[nodiscard]] Vec3 backward(const Vec3& deformed_m) const noexcept;
  /// Returns where a vertex goes.
  [[nodiscard]] Vec3 vertex(const TwistVertex& vertex) const noexcept;

 private:
  [[nodiscard]] TwistLine ownAxis(double arc_m) const noexcept;
  [[nodiscard]] ArcFound solve(const Vec3& deformed_m, double from_m) const noexcept;
  [[nodiscard]] ArcFound between(const Vec3& deformed_m, double low_m, double high_m) const noexcept;
  [[nodiscard]] Vec3 unwound(const Vec3& deformed_m, double arc_m) const noexcept;
  [[nodiscard]] double miss(const Vec3& deformed_m, double arc_m) const noexcept;

  const SectionLattice& lattice_;
  const HollowOrgan& organ_;
  double angle_rad_ = 0.0;
  std::array<HollowOrgan::Sections, 2> profiles_;  // of the spans
};

/// The surface of a hollow organ that came twisted as it lies, without its folds, for DeformedSurface. Lives
/// on the stack of a query, longer than the DeformedSurface that asks it; `organ` outlives it.
struct WrungSurface {
  HollowMap map;
  const HollowOrgan& organ;

  [[nodiscard]] VertexPlaces places() const noexcept { return {this, &WrungSurface::at}; }
  /// Returns nothing for an organ whose reach was not measured.
  [[nodiscard]] PieceBounds bounds() const noexcept {
    return organ.reach().empty() ? PieceBounds{}
                                 : PieceBounds{this, &WrungSurface::group_m, &WrungSurface::patch_m};
  }

 private:
  static const WrungSurface& of(const void* self) noexcept { return *static_cast<const WrungSurface*>(self); }
  static Vec3 at(const void* self, std::uint32_t vertex) noexcept {
    return of(self).map.vertex(of(self).organ.vertices()[vertex]);
  }
  static double group_m(const void* self, std::size_t group) noexcept {
    return of(self).organ.reach().group_m(group, of(self).map);
  }
  static double patch_m(const void* self, std::size_t patch) noexcept {
    return of(self).organ.reach().patch_m(patch, of(self).map);
  }
};

}  // namespace torsio
