// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Measures how long the twist model takes to move all key points of its lattice to another torque: the angle
/// of every section, then one pass of the view's kernel. Median of many, s; the processor's widest
/// instruction set, on this thread.
[[nodiscard]] double latticeUpdateTime_s(const TwistModel& model);

}  // namespace torsio
