// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QGraphicsItem>
#include <QStringList>

#include "app/outputs/charts/chart_style.h"

namespace torsio {

/// The title of an upright axis, which Qt would cut where it is longer than the axis: set in letters and
/// lines that fit, anew for every size of the plot.
class UprightTitle : public QGraphicsItem {
 public:
  UprightTitle(QString words, const ChartStyle& look, QGraphicsItem* parent);

  /// What it takes of the width, whatever the height.
  [[nodiscard]] double width() const { return width_; }
  /// Stands beside `plot`, at the left edge of the parent.
  void place(const QRectF& plot);
  /// As it was placed last.
  [[nodiscard]] const QStringList& lines() const { return lines_; }

  [[nodiscard]] QRectF boundingRect() const override { return area_; }
  void paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget* widget) override;

 private:
  [[nodiscard]] QFont font(int pixels) const;

  QString words_;
  QColor ink_;
  int largest_px_;
  double width_ = 0.0;
  QRectF area_;
  int pixels_;
  QStringList lines_;
};

}  // namespace torsio
