// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/report_model.h"

namespace torsio {

/// Value of `decimals` for the shortest text that reads back as the same number.
inline constexpr int kExactDecimals = -1;

/// Returns the numbers behind a figure as a table: every value that is drawn, and nothing else. A value
/// that does not exist is an empty cell. `decimals`: at most so many, as few as all numbers of a column do
/// with; or kExactDecimals.
[[nodiscard]] ReportTable figureTable(const ReportFigure& figure, int decimals = kExactDecimals);

}  // namespace torsio
