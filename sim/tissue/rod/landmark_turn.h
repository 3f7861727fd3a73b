// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/vec3.h"

namespace torsio {

/// Three points of the skin that measure a turn: `point` is seen against the line from `from` to `to`.
struct Landmarks {
  Vec3 from;
  Vec3 point;
  Vec3 to;
};

/// Returns the angle by which `now.point` has turned about its line since `rest`, in radians, right-handed
/// about the line from `from` to `to`; the line itself may have moved: the direction at rest is carried along
/// by the shortest rotation. Of all whole turns the one nearest to `before_rad`, the last measurement, is
/// meant. A point on the line, or a line turned back on itself, has no turn: `before_rad` is returned. Real
/// time, portable arithmetic.
[[nodiscard]] double landmarkTurn_rad(const Landmarks& rest, const Landmarks& now,
                                      double before_rad) noexcept;

}  // namespace torsio
