// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "sim/core/pose.h"

namespace torsio {

/// By how much lengths and angles of a rotation may be off, as rounded numbers have them.
inline constexpr double kRotationSlack = 0.02;

/// Returns the rotation of the matrix whose rows are m[0..2], m[3..5], m[6..8]; empty when it is none: rows
/// that are not of length 1 and at right angles within kRotationSlack, a mirror, numbers that are not finite.
/// Any thread.
[[nodiscard]] std::optional<Quat> rotationFromRows(const std::array<double, 9>& m) noexcept;
/// Returns the matrix of a unit quaternion, row by row. Any thread.
[[nodiscard]] std::array<double, 9> rowsOfRotation(const Quat& rotation) noexcept;

}  // namespace torsio
