// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGraphicsWidget>

#include "app/report/chart_look.h"
#include "assessment/report/report_model.h"

namespace torsio {

/// A heat map: one cell a row and column, shaded by its value, the value printed where there is room, and a
/// scale beside it. Missing values are crossed out. Vector on paper.
class HeatMapItem : public QGraphicsWidget {
 public:
  HeatMapItem(const ReportFigure& figure, const ChartLook& look);

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintCells(QPainter& painter, const QRectF& plot) const;
  void paintLabels(QPainter& painter, const QRectF& plot) const;
  void paintScale(QPainter& painter, const QRectF& bar) const;
  [[nodiscard]] QFont font(int pixels) const;

  ReportFigure figure_;
  ChartLook look_;
  double low_ = 0.0;
  double high_ = 1.0;
};

}  // namespace torsio
