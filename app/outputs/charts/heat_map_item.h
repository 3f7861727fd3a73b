// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGraphicsWidget>
#include <QStringList>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

namespace torsio {

/// A heat map: one cell a row and column, shaded by its value, the value printed where there is room, and a
/// scale beside it. Missing values are crossed out. Vector on paper.
class HeatMapItem : public QGraphicsWidget {
 public:
  HeatMapItem(const ReportFigure& figure, const ChartStyle& look, const Wording& wording);

  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  void paintCells(QPainter& painter, const QRectF& plot) const;
  void paintRowNames(QPainter& painter, const QRectF& plot, const QStringList& names) const;
  /// Names of the columns as they are set: size of the letters, every how many-th, and in which lines.
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
  int decimals_ = 0;  // whole marks need none
};

}  // namespace torsio
