// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/services/training/trend.h"

namespace torsio::gui {

/// Attempts over time with threshold, learning curve and its band; passed and failed differ in shape. Below
/// them, the evidence for the level. The accessible description says the same.
class TrendPlot : public QWidget {
  Q_OBJECT

 public:
  explicit TrendPlot(QWidget* parent = nullptr);

  void setTrend(const Trend& trend);
  void setTheme(const Theme& theme);
  void retranslate();
  /// Returns the values of the grid lines, ascending, in the displayed unit: only whole ones for counts and
  /// yes-or-no answers.
  [[nodiscard]] std::vector<double> marks() const;
  [[nodiscard]] QSize sizeHint() const override { return {640, 340}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {320, 240}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  /// Returns a stored value in the displayed unit.
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
