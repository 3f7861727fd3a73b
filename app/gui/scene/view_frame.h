// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuaternion>
#include <QVector3D>

#include "sim/base/pose.h"

namespace torsio::gui {

/// The one border between the simulation's frame (metres, LPS: x left, y back, z up) and the scene graph's
/// (millimetres, y up, z towards the viewer who stands in front of the patient).
inline constexpr float kViewUnitsPerMetre = 1000.0F;

/// A direction: turned, not scaled.
[[nodiscard]] inline QVector3D toViewDirection(const Vec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.z), static_cast<float>(-v.y)};
}

/// A point in metres.
[[nodiscard]] inline QVector3D toView(const Vec3& point_m) {
  return toViewDirection(point_m) * kViewUnitsPerMetre;
}

[[nodiscard]] inline Vec3 fromViewDirection(const QVector3D& v) {
  return {static_cast<double>(v.x()), -static_cast<double>(v.z()), static_cast<double>(v.y())};
}

[[nodiscard]] inline Vec3 fromView(const QVector3D& point_mm) {
  return fromViewDirection(point_mm) / static_cast<double>(kViewUnitsPerMetre);
}

/// The turn of a rigid body; its own axes turn along.
[[nodiscard]] inline QQuaternion toView(const Quat& q) {
  return {static_cast<float>(q.w), static_cast<float>(q.x), static_cast<float>(q.z),
          static_cast<float>(-q.y)};
}

[[nodiscard]] inline Quat fromView(const QQuaternion& q) {
  return {static_cast<double>(q.scalar()), static_cast<double>(q.x()), -static_cast<double>(q.z()),
          static_cast<double>(q.y())};
}

}  // namespace torsio::gui
