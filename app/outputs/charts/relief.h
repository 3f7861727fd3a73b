// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <QImage>
#include <QPointF>
#include <QRectF>

#include "app/outputs/charts/chart_style.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// A drawn body: its picture, and where its marks are.
struct DrawnRelief {
  QImage image;
  std::vector<QPointF> marks;  ///< pixels of the image
  std::vector<bool> seen;      ///< false: the mark is on the far side
};

/// Returns the smallest box around bodies, x and y.
[[nodiscard]] QRectF reliefBox(const std::vector<ReportRelief>& reliefs);

/// Draws a body in shaded relief, lit from the upper left: hidden parts are hidden, without transparency.
/// `box`: what the picture shows, in the body's units; `width_px`: of the picture, as high as the box
/// demands.
[[nodiscard]] DrawnRelief drawRelief(const ReportRelief& relief, const QRectF& box, int width_px,
                                     const ChartStyle& look = {});

}  // namespace torsio
