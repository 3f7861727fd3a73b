// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/rod/rod.h"

namespace torsio {

/// A rod of the size and stiffness of a stomach (G = 3 kPa): 31 elements on 270 mm of a J, radius 14 mm at
/// the pylorus (node 0, pinned) to 34 mm, a pin at the cardia, bend limits. Everything by element, nothing
/// solved.
[[nodiscard]] Rod stomachRod();

/// A loop of bowel: two limbs of radius `radius_m`, 120 mm long and `gap_m` apart from wall to wall, joined
/// by half a circle; both feet pinned. 31 elements, G = 3 kPa.
[[nodiscard]] Rod bowelLoop(double radius_m, double gap_m);

/// Adds the bend limit of a circular section of `radius_m` to an element (docs/model.md R.3).
void limitBend(double radius_m, double stretch_N, RodElement& element);

}  // namespace torsio
