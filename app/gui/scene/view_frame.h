// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuaternion>
#include <QVector3D>

#include "sim/core/pose.h"

namespace torsio::gui {

/// Conversion between the simulation's frame (metres, LPS: x left, y back, z up) and the scene graph's (mm, y
/// up, z towards a viewer in front of the patient). The only place where it is done.
inline constexpr float kViewUnitsPerMetre = 1000.0F;

/// Converts a direction: rotates without scaling.
[[nodiscard]] inline QVector3D toViewDirection(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.z), static_cast<float>(-v.y)};
}

/// Converts a point in metres.
[[nodiscard]] inline QVector3D toView(const Vec3& point_m) {
  return toViewDirection(point_m) * kViewUnitsPerMetre;
}

[[nodiscard]] inline Vec3 fromViewDirection(const QVector3D& v) {
  return {static_cast<double>(v.x()), -static_cast<double>(v.z()), static_cast<double>(v.y())};
}

[[nodiscard]] inline Vec3 fromView(const QVector3D& point_mm) {
  return fromViewDirection(point_mm) / static_cast<double>(kViewUnitsPerMetre);
}

/// Converts camera or tool axes (x right, y up, z towards the viewer) from a node's rotation in the view
/// frame to world axes; identity is a viewer in front of the patient.
[[nodiscard]] inline Quat cameraToWorld(const QQuaternion& q) {
  constexpr double kHalfRoot =
      0.70710678118654752;  // a quarter turn about x maps the view's y to the world's z
  return Quat{kHalfRoot, kHalfRoot, 0.0, 0.0} * Quat{static_cast<double>(q.scalar()),
                                                     static_cast<double>(q.x()), static_cast<double>(q.y()),
                                                     static_cast<double>(q.z())};
}

/// Converts the rotation of a tool to its node's, keeping the tool's axes (z along the shaft).
[[nodiscard]] inline QQuaternion toolToView(const Quat& q) {
  constexpr double kHalfRoot = 0.70710678118654752;
  const Quat turned = Quat{kHalfRoot, -kHalfRoot, 0.0, 0.0} * q;
  return {static_cast<float>(turned.w), static_cast<float>(turned.x), static_cast<float>(turned.y),
          static_cast<float>(turned.z)};
}

}  // namespace torsio::gui
