// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/services/comparison/comparison_run.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// Draws the compared organ: its markers (Fig. 11, if it has any), every model in equilibrium, and the film
/// strip of each (Figs. 8, 9 and 12).
[[nodiscard]] std::vector<ReportFigure> comparedPictures(const ComparisonResult& result);

}  // namespace torsio
