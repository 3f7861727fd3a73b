// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/study/day_board.h"
#include "sim/core/text.h"

namespace torsio {

/// An alert of the day in one sentence, the same wherever it is shown. `since` and `occasion`: as the place
/// writes a time, and names an occasion.
[[nodiscard]] Text alertText(const DayAlert& alert, const std::string& since, const Text& occasion);

}  // namespace torsio
