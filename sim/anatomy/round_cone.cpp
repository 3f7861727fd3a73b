// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/round_cone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace torsio {

double distanceTo(const RoundCone& cone, const Vec3& p) {
  const Vec3 axis = cone.b - cone.a;
  const double t = std::clamp(dot(p - cone.a, axis) / dot(axis, axis), 0.0, 1.0);
  return norm(p - cone.a - t * axis) - (cone.radiusA + t * (cone.radiusB - cone.radiusA));
}

double joined(double a, double b, double width) {
  // Quilez 2013, quadratic.
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - 0.25 * width * h * h;
}

double joinedChain(std::span<const RoundCone> cones, const Vec3& p, double width) {
  double d = std::numeric_limits<double>::max();
  for (const RoundCone& cone : cones) {
    d = joined(d, distanceTo(cone, p), width);
  }
  return d;
}

}  // namespace torsio
