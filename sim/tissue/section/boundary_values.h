// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/tissue/section/boundary_elements.h"
#include "sim/tissue/section/quadratic_elements.h"
#include "sim/tissue/section/section_outline.h"

namespace torsio {

/// Values of the fields on the outline and the holes, in the lengths of the SectionShape.
struct BoundaryValues {
  std::vector<std::vector<double>> warping;  ///< psi per loop and given point
  std::vector<std::vector<double>> shear;    ///< |tau| per loop and given point
  double maxShear = 0.0;
  double warpingMin = 0.0;
  double warpingMax = 0.0;
};

[[nodiscard]] BoundaryValues boundaryValues(const SectionShape& shape, const QuadraticFields& fields);

/// Reads the boundary values out of `fields`, given on the loops of the shape with every edge halved.
[[nodiscard]] BoundaryValues boundaryValues(const SectionShape& shape, const BoundaryFields& fields);

}  // namespace torsio
