// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "sim/core/vec3.h"

namespace torsio {

struct CurveFrame;
struct TriangleMesh;

/// A place on the outer surface, by the way along the centreline from the fixed end and the angle about it,
/// right-handed in that direction from the organ's zero line.
struct OrganPlace {
  std::string name;
  double arc_mm = 0.0;
  double angle_deg = 0.0;  ///< [0, 360)
  Vec3 position_m;
};

/// A place that is wanted: a share of the length and an angle.
struct WantedPlace {
  const char* name;
  double share;
  double angle_deg;
};

/// Named places and the zero line of an organ along a curve; metres, LPS.
struct OrganPlaces {
  std::vector<OrganPlace> markers;
  std::vector<Vec3> zeroLine_m;  ///< on the skin, every 10 mm
};

/// Finds places on a surface in metres that surrounds the curve `frames` (millimetres). The zero line runs
/// `zero_deg` from e1. Every place lies on the surface.
[[nodiscard]] OrganPlaces placesOn(const TriangleMesh& surface, const std::vector<CurveFrame>& frames,
                                   double zero_deg, const std::vector<WantedPlace>& wanted);

}  // namespace torsio
