// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGraphicsWidget>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// Pictures of bodies in rows and columns, all in one scale, with a caption below each.
class ReliefItem : public QGraphicsWidget {
 public:
  ReliefItem(const ReportFigure& figure, const ChartStyle& look, const Wording& wording);

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

  /// Returns the height that pictures need in a figure of this width, pixels.
  [[nodiscard]] static double heightFor(const ReportFigure& figure, double width,
                                        const ChartStyle& look = {});

 private:
  void paintCell(QPainter& painter, const ReportRelief& relief, const QRectF& cell, const QRectF& box) const;
  [[nodiscard]] static double namesWidth(const ReportFigure& figure);

  ReportFigure figure_;
  ChartStyle style_;
  Wording say_;
};

}  // namespace torsio
