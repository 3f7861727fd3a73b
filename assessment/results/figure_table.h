// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "assessment/results/report_model.h"

namespace torsio {

/// `decimals` for the shortest text that reads back as the same number.
inline constexpr int kExactDecimals = -1;

/// Returns the numbers of a figure as a table: exactly the values drawn. Missing values are empty cells.
/// `decimals`: maximum; each column uses as few as its numbers need; or kExactDecimals.
[[nodiscard]] ReportTable figureTable(const ReportFigure& figure, int decimals = kExactDecimals);

}  // namespace torsio
