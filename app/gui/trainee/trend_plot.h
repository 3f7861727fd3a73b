// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/services/training/trend.h"

namespace torsio::gui {

/// Attempts over time with threshold, learning curve and its band; passed and failed differ in shape. Below
/// it the evidence for the level. Says the same in its accessible description.
class TrendPlot : public QWidget {
  Q_OBJECT

 public:
  explicit TrendPlot(QWidget* parent = nullptr);

  void setTrend(const Trend& trend);
  void setTheme(const Theme& theme);
  void retranslate();
  /// Values at the lines of the grid, rising, in the unit that is shown: what is counted, or answered by yes
  /// or no, has whole ones only.
  [[nodiscard]] std::vector<double> marks() const;
  [[nodiscard]] QSize sizeHint() const override { return {640, 340}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// A stored value in the unit that is shown.
  [[nodiscard]] double shown(double value) const;
  [[nodiscard]] double xOf(double attempt) const;
  [[nodiscard]] double yOf(double value) const;
  void findRange();
  void drawGrid(QPainter& painter) const;
  void drawCurve(QPainter& painter) const;
  void drawPoints(QPainter& painter) const;

  const Theme* theme_;
  Trend trend_;
  double low_ = 0.0;
  double high_ = 1.0;
};

}  // namespace torsio::gui
