// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/report_model.h"

namespace torsio {

/// Returns the line printed below a figure or table: "Eq. 26 (evaluation-1); n = 360; missing = 0; few
/// raters". May be empty.
[[nodiscard]] Text provenanceLine(const Provenance& from);

}  // namespace torsio
