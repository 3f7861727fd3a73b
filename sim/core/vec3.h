// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace torsio {

/// A point or vector of three doubles, trivially copyable (Eigen's is not), so that it may cross threads.
struct Vec3 {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;

  constexpr Vec3& operator+=(const Vec3& b) noexcept {
    x += b.x, y += b.y, z += b.z;
    return *this;
  }
  constexpr Vec3& operator-=(const Vec3& b) noexcept {
    x -= b.x, y -= b.y, z -= b.z;
    return *this;
  }
  constexpr Vec3& operator*=(double k) noexcept {
    x *= k, y *= k, z *= k;
    return *this;
  }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(Vec3 a, const Vec3& b) noexcept {
  return a += b;
}
constexpr Vec3 operator-(Vec3 a, const Vec3& b) noexcept {
  return a -= b;
}
constexpr Vec3 operator-(const Vec3& a) noexcept {
  return {-a.x, -a.y, -a.z};
}
constexpr Vec3 operator*(Vec3 a, double k) noexcept {
  return a *= k;
}
constexpr Vec3 operator*(double k, Vec3 a) noexcept {
  return a *= k;
}
constexpr Vec3 operator/(const Vec3& a, double k) noexcept {
  return {a.x / k, a.y / k, a.z / k};
}

constexpr double dot(const Vec3& a, const Vec3& b) noexcept {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec3 cross(const Vec3& a, const Vec3& b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec3& a) noexcept {
  return std::sqrt(dot(a, a));
}
/// Returns the unit vector along `a`; the zero vector stays zero.
inline Vec3 normalized(const Vec3& a) noexcept {
  const double n = norm(a);
  return n > 0.0 ? a / n : Vec3{};
}
inline bool isFinite(const Vec3& a) noexcept {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}
/// Returns some unit vector perpendicular to the unit vector `t`; continuous except near t = +-x.
inline Vec3 anyPerpendicular(const Vec3& t) noexcept {
  const Vec3 helper = std::abs(t.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  return normalized(cross(t, helper));
}

}  // namespace torsio
