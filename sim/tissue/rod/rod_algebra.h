// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "sim/core/organ_pose.h"

/// Small rotations and 3 x 3 matrices of the rod: +, -, *, / and sqrt only, so that every build gives the
/// same bits. Shared by the sources of sim/tissue/rod.
namespace torsio {

constexpr Vec3 vectorPart(const Quat& q) noexcept {
  return {q.x, q.y, q.z};
}
constexpr Quat quatOf(double w, const Vec3& v) noexcept {
  return {w, v.x, v.y, v.z};
}
/// Returns sigma = p_v / (1 + p_w) = e tan(angle / 4) of the shorter of the two ways of turning by `p`.
constexpr Vec3 quarterTangent(const Quat& p) noexcept {
  const double sign = p.w < 0.0 ? -1.0 : 1.0;
  return (sign / (1.0 + sign * p.w)) * vectorPart(p);
}
/// How the rotation vector grows with sigma: phi e = 4 f(sigma^2) sigma, f(s) = atan(sqrt(s)) / sqrt(s), by
/// its Pade approximant (945 + 735 s + 64 s^2) / (945 + 1050 s + 225 s^2). Its error is 2e-4 s^5: below
/// rounding up to a turn of 20 degrees, 1e-9 at 65, 2e-4 at 180; it is what the rod means by an angle, at any
/// angle.
struct AngleScale {
  double f = 1.0;
  double slope = 0.0;  ///< df / ds
  double bend = 0.0;   ///< d2f / ds2
};
constexpr AngleScale angleScale(double s) noexcept {
  const double inverse = 1.0 / (945.0 + s * (1050.0 + 225.0 * s));
  const double below1 = 1050.0 + 450.0 * s;
  const double f = (945.0 + s * (735.0 + 64.0 * s)) * inverse;
  const double slope = (735.0 + 128.0 * s - f * below1) * inverse;
  return {.f = f, .slope = slope, .bend = (128.0 - 2.0 * slope * below1 - 450.0 * f) * inverse};
}
/// Returns the unit quaternion of the turn (1, v) points along.
inline Quat unitFrom(const Vec3& v) noexcept {
  const double scale = 1.0 / std::sqrt(1.0 + dot(v, v));
  return quatOf(scale, scale * v);
}
/// Returns `q` turned by the body rotation theta: q cay(theta), cay = (1, theta/2) / sqrt(1 + |theta|^2/4).
inline Quat turnedBy(const Quat& q, const Vec3& theta) noexcept {
  return normalized(q * unitFrom(0.5 * theta));
}

/// A 3 x 3 matrix: row, column. No array, so that a compiler keeps it in registers.
struct Mat3 {
  double xx = 0.0, xy = 0.0, xz = 0.0;
  double yx = 0.0, yy = 0.0, yz = 0.0;
  double zx = 0.0, zy = 0.0, zz = 0.0;
};

constexpr Mat3 operator+(const Mat3& a, const Mat3& b) noexcept {
  return {a.xx + b.xx, a.xy + b.xy, a.xz + b.xz, a.yx + b.yx, a.yy + b.yy,
          a.yz + b.yz, a.zx + b.zx, a.zy + b.zy, a.zz + b.zz};
}
constexpr Mat3 operator-(const Mat3& a, const Mat3& b) noexcept {
  return {a.xx - b.xx, a.xy - b.xy, a.xz - b.xz, a.yx - b.yx, a.yy - b.yy,
          a.yz - b.yz, a.zx - b.zx, a.zy - b.zy, a.zz - b.zz};
}
constexpr Mat3 operator*(double k, const Mat3& a) noexcept {
  return {k * a.xx, k * a.xy, k * a.xz, k * a.yx, k * a.yy, k * a.yz, k * a.zx, k * a.zy, k * a.zz};
}
constexpr Mat3 operator*(const Mat3& a, const Mat3& b) noexcept {
  return {a.xx * b.xx + a.xy * b.yx + a.xz * b.zx, a.xx * b.xy + a.xy * b.yy + a.xz * b.zy,
          a.xx * b.xz + a.xy * b.yz + a.xz * b.zz, a.yx * b.xx + a.yy * b.yx + a.yz * b.zx,
          a.yx * b.xy + a.yy * b.yy + a.yz * b.zy, a.yx * b.xz + a.yy * b.yz + a.yz * b.zz,
          a.zx * b.xx + a.zy * b.yx + a.zz * b.zx, a.zx * b.xy + a.zy * b.yy + a.zz * b.zy,
          a.zx * b.xz + a.zy * b.yz + a.zz * b.zz};
}
constexpr Vec3 operator*(const Mat3& a, const Vec3& v) noexcept {
  return {a.xx * v.x + a.xy * v.y + a.xz * v.z, a.yx * v.x + a.yy * v.y + a.yz * v.z,
          a.zx * v.x + a.zy * v.y + a.zz * v.z};
}
constexpr Mat3 transposed(const Mat3& a) noexcept {
  return {a.xx, a.yx, a.zx, a.xy, a.yy, a.zy, a.xz, a.yz, a.zz};
}
/// Returns a^T v.
constexpr Vec3 transposedTimes(const Mat3& a, const Vec3& v) noexcept {
  return {a.xx * v.x + a.yx * v.y + a.zx * v.z, a.xy * v.x + a.yy * v.y + a.zy * v.z,
          a.xz * v.x + a.yz * v.y + a.zz * v.z};
}
constexpr Mat3 scaledIdentity(double k) noexcept {
  return {k, 0, 0, 0, k, 0, 0, 0, k};
}
/// Returns [a x], the matrix of the cross product.
constexpr Mat3 crossMatrix(const Vec3& a) noexcept {
  return {0, -a.z, a.y, a.z, 0, -a.x, -a.y, a.x, 0};
}
/// Returns a b^T.
constexpr Mat3 outer(const Vec3& a, const Vec3& b) noexcept {
  return {a.x * b.x, a.x * b.y, a.x * b.z, a.y * b.x, a.y * b.y, a.y * b.z, a.z * b.x, a.z * b.y, a.z * b.z};
}
/// Returns M [a x]: each row of M crossed with a.
constexpr Mat3 timesCross(const Mat3& m, const Vec3& a) noexcept {
  return {m.xy * a.z - m.xz * a.y, m.xz * a.x - m.xx * a.z, m.xx * a.y - m.xy * a.x,
          m.yy * a.z - m.yz * a.y, m.yz * a.x - m.yx * a.z, m.yx * a.y - m.yy * a.x,
          m.zy * a.z - m.zz * a.y, m.zz * a.x - m.zx * a.z, m.zx * a.y - m.zy * a.x};
}
/// Returns [a x] M: each column of M crossed by a.
constexpr Mat3 crossTimes(const Vec3& a, const Mat3& m) noexcept {
  return {a.y * m.zx - a.z * m.yx, a.y * m.zy - a.z * m.yy, a.y * m.zz - a.z * m.yz,
          a.z * m.xx - a.x * m.zx, a.z * m.xy - a.x * m.zy, a.z * m.xz - a.x * m.zz,
          a.x * m.yx - a.y * m.xx, a.x * m.yy - a.y * m.xy, a.x * m.yz - a.y * m.xz};
}
/// Returns the rotation matrix of the unit quaternion `q`: columns e1, e2, t.
constexpr Mat3 rotationMatrix(const Quat& q) noexcept {
  const double xx = q.x * q.x;
  const double yy = q.y * q.y;
  const double zz = q.z * q.z;
  const double xy = q.x * q.y;
  const double xz = q.x * q.z;
  const double yz = q.y * q.z;
  const double wx = q.w * q.x;
  const double wy = q.w * q.y;
  const double wz = q.w * q.z;
  return {1.0 - 2.0 * (yy + zz), 2.0 * (xy - wz),       2.0 * (xz + wy),
          2.0 * (xy + wz),       1.0 - 2.0 * (xx + zz), 2.0 * (yz - wx),
          2.0 * (xz - wy),       2.0 * (yz + wx),       1.0 - 2.0 * (xx + yy)};
}
/// Returns B(sigma) = (1 - sigma^2) I + 2 [sigma x] + 2 sigma sigma^T: 4 d sigma = B d theta_j - B^T d
/// theta_i.
constexpr Mat3 turnRate(const Vec3& s) noexcept {
  return scaledIdentity(1.0 - dot(s, s)) + 2.0 * crossMatrix(s) + 2.0 * outer(s, s);
}

}  // namespace torsio
