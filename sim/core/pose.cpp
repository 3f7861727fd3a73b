// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/pose.h"

#include <cmath>
#include <cstddef>

namespace torsio {

namespace {

/// Shepperd's method.
Quat quaternionOf(const std::array<double, 9>& m) noexcept {
  const double trace = m[0] + m[4] + m[8];
  Quat q;
  if (trace > 0.0) {
    q = {1.0 + trace, m[7] - m[5], m[2] - m[6], m[3] - m[1]};
  } else if (m[0] >= m[4] && m[0] >= m[8]) {
    q = {m[7] - m[5], 1.0 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6]};
  } else if (m[4] >= m[8]) {
    q = {m[2] - m[6], m[1] + m[3], 1.0 - m[0] + m[4] - m[8], m[5] + m[7]};
  } else {
    q = {m[3] - m[1], m[2] + m[6], m[5] + m[7], 1.0 - m[0] - m[4] + m[8]};
  }
  return normalized(q);
}

}  // namespace

std::optional<Quat> rotationFromRows(const std::array<double, 9>& m) noexcept {
  const std::array<Vec3, 3> rows = {{{m[0], m[1], m[2]}, {m[3], m[4], m[5]}, {m[6], m[7], m[8]}}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Vec3& next = rows[(i + 1) % rows.size()];
    const bool sound =
        std::abs(norm(rows[i]) - 1.0) <= kRotationSlack && std::abs(dot(rows[i], next)) <= kRotationSlack;
    if (!sound) {  // nor is what is no number
      return std::nullopt;
    }
  }
  if (dot(cross(rows[0], rows[1]), rows[2]) < 0.0) {  // a mirror
    return std::nullopt;
  }
  return quaternionOf(m);
}

std::array<double, 9> rowsOfRotation(const Quat& rotation) noexcept {
  const Vec3 x = rotate(rotation, {1.0, 0.0, 0.0});
  const Vec3 y = rotate(rotation, {0.0, 1.0, 0.0});
  const Vec3 z = rotate(rotation, {0.0, 0.0, 1.0});
  return {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
}

}  // namespace torsio
