// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGraphicsWidget>
#include <QStringList>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// A heat map: one cell per row and column, shaded by value, the value printed if there is room, with a
/// scale. Missing values are crossed out. Vector output on paper.
class HeatMapItem : public QGraphicsWidget {
 public:
  HeatMapItem(const ReportFigure& figure, const ChartStyle& look, const Wording& wording);

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintCells(QPainter& painter, const QRectF& plot) const;
  void paintRowNames(QPainter& painter, const QRectF& plot, const QStringList& names) const;
  /// Layout of the column names: font size, every how many-th is shown, and lines.
  struct ColumnNames {
    int pixels = 0;
    qsizetype every = 1;
    QStringList names;
    qsizetype lines = 1;
  };
  [[nodiscard]] ColumnNames columnNames(double width) const;
  void paintColumnNames(QPainter& painter, const QRectF& plot, const ColumnNames& set) const;
  void paintScale(QPainter& painter, const QRectF& bar) const;
  [[nodiscard]] QFont font(int pixels) const;

  ReportFigure figure_;
  ChartStyle style_;
  Wording say_;
  double low_ = 0.0;
  double high_ = 1.0;
  int decimals_ = 0;  // 0 for whole marks
};

}  // namespace torsio
