// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/pose.h"
#include "sim/core/vec3.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

// The orientation of an instrument as the angles that mouse and keys change. Pure functions; thread-safe.

/// Angles of view * turn(y, yaw) * turn(x, pitch) * turn(z, roll).
struct Tilt {
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;
  double roll_rad = 0.0;
};

/// Returns the sum of the absolute differences of yaw, pitch and roll, rad.
inline double distance(const Tilt& a, const Tilt& b) {
  return std::abs(a.yaw_rad - b.yaw_rad) + std::abs(a.pitch_rad - b.pitch_rad) +
         std::abs(a.roll_rad - b.roll_rad);
}

/// Returns the equivalent angle within half a turn of the reference.
inline double nearTo(double angle_rad, double reference_rad) {
  return reference_rad + std::remainder(angle_rad - reference_rad, 2.0 * std::numbers::pi);
}

/// Returns the angles of a rotation. Of the two equivalent triples, returns the one that continues `before`.
inline Tilt tiltOf(const Quat& turn, const Tilt& before) {
  const Vec3 x = rotate(turn, {1.0, 0.0, 0.0});
  const Vec3 y = rotate(turn, {0.0, 1.0, 0.0});
  const Vec3 z = rotate(turn, {0.0, 0.0, 1.0});
  const double yaw = std::atan2(z.x, z.z);
  const double pitch = std::asin(std::clamp(-z.y, -1.0, 1.0));
  const double roll = std::atan2(x.y, y.y);
  const auto continued = [&before](double a, double b, double c) {
    return Tilt{nearTo(a, before.yaw_rad), nearTo(b, before.pitch_rad), nearTo(c, before.roll_rad)};
  };
  const Tilt first = continued(yaw, pitch, roll);
  const Tilt second = continued(yaw + std::numbers::pi, std::numbers::pi - pitch, roll + std::numbers::pi);
  return distance(first, before) <= distance(second, before) ? first : second;
}

/// Returns the instrument's waiting position: in front of the section to grasp, on the viewer's side, two
/// centimetres clear of the organ in any initial state. World frame.
[[nodiscard]] Vec3 parkingPoint_m(const Scene& scene);

}  // namespace torsio::gui
