// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

class QChart;
class QGraphicsWidget;

namespace torsio {

/// The figure as something that a scene draws, on paper and on the screen alike: a chart, or a heat map.
/// Says its words as `wording` does; title and notes are left to whoever shows it. Needs a QApplication; GUI
/// thread.
[[nodiscard]] std::unique_ptr<QGraphicsWidget> buildFigure(const ReportFigure& figure,
                                                           const ChartStyle& look = {},
                                                           const Wording& wording = englishWording);

/// The figure as a Qt chart: no animation, no shadow (both spoil vector output). Every kind but kHeatMap.
[[nodiscard]] std::unique_ptr<QChart> buildChart(const ReportFigure& figure, const ChartStyle& look = {},
                                                 const Wording& wording = englishWording);

}  // namespace torsio
