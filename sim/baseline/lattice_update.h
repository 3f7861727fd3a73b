// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/tissue/twist/twist_model.h"
#include "sim/tissue/view/cpu_isa.h"

namespace torsio {

/// Measures how long the twist model takes to move all key points of its lattice to another torque: the angle
/// of every section, then one pass of the view's kernel. Median of many, s, with the
/// kernels of an instruction set, on this thread.
[[nodiscard]] double latticeUpdateTime_s(const TwistModel& model, Isa isa);

}  // namespace torsio
