// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QGraphicsItem>
#include <QStringList>

#include "app/outputs/charts/chart_style.h"

namespace torsio {

/// Title of a vertical axis, which Qt would truncate if longer than the axis: uses a font size and lines that
/// fit, updated for every plot size.
class UprightTitle : public QGraphicsItem {
 public:
  UprightTitle(QString words, const ChartStyle& look, QGraphicsItem* parent);

  /// Returns the width that it takes, independent of the height.
  [[nodiscard]] double width() const { return width_; }
  /// Places it next to `plot`, at the left edge of the parent.
  void place(const QRectF& plot);
  /// Returns the lines of the last placement.
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
