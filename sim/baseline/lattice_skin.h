// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "sim/baseline/lattice_surface.h"

namespace torsio {

/// Shows a model by the organ's own mesh: what lies between key points moves as they do, bilinearly in arc
/// length and ridge angle, and what stands out from their patch turns with it; beyond the fixed end nothing
/// moves, beyond the free end all turns with it as a rigid body. Immutable; copies its data.
class LatticeSkin {
 public:
  LatticeSkin(const TriangleMesh& mesh, const SectionLattice& lattice);

  /// Computes where the vertices are when the key points are at `now` and the free end has turned by
  /// `angle_rad`. `out_m`: one entry a vertex of the mesh (contract).
  void deform(const LatticePlaces& now, double angle_rad, std::span<Vec3> out_m) const;

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
