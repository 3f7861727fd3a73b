// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "sim/core/portable_math.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Unit quaternion w + xi + yj + zk; rotates a vector from the tool frame to the world frame.
struct Quat {
  double w = 1.0;
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  friend constexpr bool operator==(const Quat&, const Quat&) = default;
};

/// Position in metres and orientation, world frame (LPS: x to the patient's left, y back, z up).
struct Pose {
  Vec3 position_m;
  Quat orientation;
  friend constexpr bool operator==(const Pose&, const Pose&) = default;
};

constexpr Quat operator*(const Quat& a, const Quat& b) noexcept {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
constexpr Quat conjugate(const Quat& q) noexcept {
  return {q.w, -q.x, -q.y, -q.z};
}
inline double norm(const Quat& q) noexcept {
  return std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
}
/// Returns `q` scaled to unit length; the zero quaternion becomes the identity.
inline Quat normalized(const Quat& q) noexcept {
  const double n = norm(q);
  return n > 0.0 ? Quat{q.w / n, q.x / n, q.y / n, q.z / n} : Quat{};
}
/// Rotates `v` by the unit quaternion `q`: q v q*.
constexpr Vec3 rotate(const Quat& q, const Vec3& v) noexcept {
  const Vec3 u{q.x, q.y, q.z};
  const Vec3 t = 2.0 * cross(u, v);
  return v + q.w * t + cross(u, t);
}
/// Returns the rotation by `angle_rad` about the unit vector `axis` (portable sine and cosine).
inline Quat axisAngle(const Vec3& axis, double angle_rad) noexcept {
  const SinCos half = portableSinCos(0.5 * angle_rad);
  return {half.cos, half.sin * axis.x, half.sin * axis.y, half.sin * axis.z};
}
/// Rotates `v` by `angle_rad` about the unit vector `axis` through the origin (Rodrigues).
inline Vec3 rotateAbout(const Vec3& v, const Vec3& axis, double angle_rad) noexcept {
  const SinCos a = portableSinCos(angle_rad);
  return v * a.cos + cross(axis, v) * a.sin + axis * (dot(axis, v) * (1.0 - a.cos));
}
/// Returns the turn of `to` against `from` about the unit vector `axis`, (-2 pi, 2 pi]: the twist of swing
/// and twist. Portable arithmetic.
inline double turnAbout(const Vec3& axis, const Quat& from, const Quat& to) noexcept {
  const Quat q = to * conjugate(from);
  return 2.0 * portableAtan2(q.x * axis.x + q.y * axis.y + q.z * axis.z, q.w);
}

/// By how much lengths and angles of a rotation may be off, as rounded numbers have them.
inline constexpr double kRotationSlack = 0.02;

/// Returns the rotation of the matrix whose rows are m[0..2], m[3..5], m[6..8]; empty when it is none: rows
/// that are not of length 1 and at right angles within kRotationSlack, a mirror, numbers that are not finite.
/// Any thread.
[[nodiscard]] std::optional<Quat> rotationFromRows(const std::array<double, 9>& m) noexcept;
/// Returns the matrix of a unit quaternion, row by row. Any thread.
[[nodiscard]] std::array<double, 9> rowsOfRotation(const Quat& rotation) noexcept;

}  // namespace torsio
