// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/geometry/query/deformed_surface.h"
#include "sim/scene/hollow_map.h"
#include "sim/scene/hollow_organ.h"

namespace torsio {

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
