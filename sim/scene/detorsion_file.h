// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "sim/scene/hollow_organ.h"

namespace torsio {

class JsonFields;

/// Reads the goal of a pattern: nothing for one that is to be twisted, or the field "detorsion" of one whose
/// "goal" is "detorse". Throws Error{kBadData} naming file and field: one without the other, a field that is
/// missing, unknown or out of range, spans that overlap.
[[nodiscard]] std::shared_ptr<const Detorsion> readGoal(JsonFields& pattern);

}  // namespace torsio
