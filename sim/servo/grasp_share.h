// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Returns how far the organ turns about `axis` at a rest point for a small turn of the pattern, as a share
/// of that turn: 1 where the pattern has its full angle, less where it still rises, 0 where the organ is
/// held or on the axis itself. The hand that holds the point moves by the share of the pattern's angle.
/// Runs in the servo tick.
[[nodiscard]] double graspShare(const TwistModel& model, const AxisFrame& axis, double arc_m,
                                const Vec3& rest_m) noexcept;

}  // namespace torsio
