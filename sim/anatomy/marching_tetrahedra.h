// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "sim/geometry/mesh/iso_surface.h"

namespace torsio {

/// The isoSurface() of a field, negative inside. `field` should grow by at most `slope` per unit of length:
/// regions further from the surface than that allows are skipped.
[[nodiscard]] TriangleMesh zeroSurface(const SampleGrid& grid, double slope,
                                       const std::function<double(const Vec3&)>& field);

}  // namespace torsio
