// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QStringList>

#include "app/outputs/charts/chart_style.h"

namespace torsio {

/// Category names formatted for a chart's axis.
struct CategoryLabels {
  QStringList html;  ///< one per category, up to three lines if they fit
  QFont font;
};

/// Chooses the largest font, up to that of the axis, in which the names fit side by side on an axis of
/// `look.axis_px`, or a narrow one as a last resort: Qt truncates labels wider than their share of the axis.
/// Needs a QGuiApplication.
[[nodiscard]] CategoryLabels categoryLabels(const QStringList& names, const ChartStyle& look);
/// Returns whether the names fit side by side on such an axis in a font that can be read in print.
[[nodiscard]] bool labelsAreReadable(const QStringList& names, const ChartStyle& look);

}  // namespace torsio
