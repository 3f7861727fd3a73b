// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include <QColor>

#include "assessment/report/report_model.h"

class QChart;

namespace torsio {

/// Colour of series `i`: told apart by colour-blind readers and, by lightness, in grey (Okabe and Ito).
[[nodiscard]] QColor seriesColour(std::size_t i);

/// The figure as a Qt chart: no animation, no shadow (both spoil vector output), fonts for print.
/// Title and notes are left to the page. Needs a QApplication; GUI thread.
[[nodiscard]] std::unique_ptr<QChart> buildChart(const ReportFigure& figure);

}  // namespace torsio
