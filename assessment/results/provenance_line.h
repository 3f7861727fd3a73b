// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/report_model.h"

namespace torsio {

/// Returns the line that is printed beneath a figure or table: "Eq. 26 (evaluation-1); n = 360; missing =
/// 0; few raters". Empty when there is nothing to say.
[[nodiscard]] Text provenanceLine(const Provenance& from);

}  // namespace torsio
