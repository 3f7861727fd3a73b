// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "sim/baseline/elastic_body.h"
#include "sim/baseline/swept_solid.h"
#include "sim/core/portable_math.h"

namespace torsio {

/// Outlines of a straight bar along z: `points` corners of a circle of this radius, `layers` steps.
inline std::vector<std::vector<Vec3>> straightOutlines(int points, int layers, double radius_m,
                                                       double length_m) {
  std::vector<std::vector<Vec3>> outlines;
  for (int j = 0; j <= layers; ++j) {
    std::vector<Vec3> outline;
    for (int k = 0; k < points; ++k) {
      const double angle = 2.0 * kPi * k / points;
      outline.push_back({radius_m * std::cos(angle), radius_m * std::sin(angle), length_m * j / layers});
    }
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

inline SweptSolid straightBar(int points, int layers, int rings, double radius_m, double length_m) {
  return sweptSolid(straightOutlines(points, layers, radius_m, length_m), {0.0, 0.0, 1.0}, rings);
}

/// A round bar whose axis is an arc of a circle in the plane y = 0, turning by `bend_rad` from +z to +x.
inline SweptSolid bentBar(int points, int layers, int rings, double radius_m, double length_m,
                          double bend_rad) {
  const double curvatureRadius_m = length_m / bend_rad;
  std::vector<std::vector<Vec3>> outlines;
  for (int j = 0; j <= layers; ++j) {
    const double turn = bend_rad * j / layers;
    const Vec3 centre{curvatureRadius_m * (1.0 - std::cos(turn)), 0.0, curvatureRadius_m * std::sin(turn)};
    const Vec3 outwards{std::cos(turn), 0.0, -std::sin(turn)};
    std::vector<Vec3> outline;
    for (int k = 0; k < points; ++k) {
      const double angle = 2.0 * kPi * k / points;
      outline.push_back(centre + (radius_m * std::cos(angle)) * outwards +
                        Vec3{0.0, radius_m * std::sin(angle), 0.0});
    }
    outlines.push_back(std::move(outline));
  }
  return sweptSolid(outlines, {std::sin(bend_rad), 0.0, std::cos(bend_rad)}, rings);
}

/// An organ turned by a jaw; none: by its end.
inline TwistHold jawAt(const std::optional<double>& grasp) {
  return {.span = {0.0, 1.0}, .grasp = grasp};
}

/// Polar moment of a regular polygon: N triangles of R^4 sin(a) (2 + cos(a)) / 12 with a = 2 pi / N.
inline double polygonPolarMoment_m4(int points, double radius_m) {
  const double a = 2.0 * kPi / points;
  return points * std::pow(radius_m, 4) * std::sin(a) * (2.0 + std::cos(a)) / 12.0;
}

/// Torsion constant of the regular polygon over R^4, from the conformal-map series.
inline constexpr double kTorsion12 = 1.425364842;
inline constexpr double kTorsion24 = 1.534238759;

}  // namespace torsio
