// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

class QChart;
class QGraphicsWidget;

namespace torsio {

/// Builds a figure for a scene, on paper or screen: a chart, a heat map or pictures. Translates with
/// `wording`; the caller shows title and notes. Needs a QApplication; GUI thread.
[[nodiscard]] std::unique_ptr<QGraphicsWidget> buildFigure(const ReportFigure& figure,
                                                           const ChartStyle& look = {},
                                                           const Wording& wording = englishWording);

/// Builds a figure as a Qt chart without animation or shadow (both spoil vector output). Every kind but
/// kHeatMap and kReliefs.
[[nodiscard]] std::unique_ptr<QChart> buildChart(const ReportFigure& figure, const ChartStyle& look = {},
                                                 const Wording& wording = englishWording);

}  // namespace torsio
