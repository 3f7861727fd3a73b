// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include <QFont>
#include <QtGlobal>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/report_model.h"

class QBarCategoryAxis;
class QCategoryAxis;
class QChart;
class QValueAxis;

namespace torsio {

/// Returns the report's typeface in this size, pixels.
[[nodiscard]] QFont chartFont(int pixels);

/// Minimum and maximum of the values added; empty without values.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

/// The axes of one figure's chart. The chart owns them. GUI thread.
class ChartAxes {
 public:
  /// All four must outlive this object.
  ChartAxes(const ReportFigure& figure, const ChartStyle& look, const Wording& wording, QChart& chart);

  /// Adds the value axis, covering all values. Its title is vertical if it is on the left. Of a logarithmic
  /// figure (on the left): marked by values, laid out by their powers of ten.
  QCategoryAxis* addValues(Qt::Alignment side);
  /// Adds a category axis at the bottom, continuous with categories at 1, 2, 3 ..., so that markers can be
  /// side by side.
  QCategoryAxis* addCategories();
  /// Adds a number axis at the bottom, covering the abscissas of all series.
  QCategoryAxis* addNumbers();
  /// Adds a category axis on the left, first row at the top, at 1, 2, 3 ...
  QCategoryAxis* addRows();
  /// Adds the bottom axis with the names of boxes.
  QBarCategoryAxis* addBoxes();
  /// Returns the range of the axis without the values; 0 to 1 before it exists.
  [[nodiscard]] const AxisRange& across() const noexcept { return across_; }

 private:
  QCategoryAxis* addPowers();
  template <typename Axis>
  Axis* styled(Axis* axis, const Text& title) const;
  [[nodiscard]] QCategoryAxis* numbered(const QValueAxis& range, int decimals, const Text& title,
                                        Qt::Alignment side) const;
  void leaveRoomForLast(QCategoryAxis& axis) const;
  void addUprightTitle(const Text& words) const;
  [[nodiscard]] AxisRange valueRange() const;

  const ReportFigure& figure_;
  const ChartStyle& style_;
  const Wording& say_;
  QChart& chart_;
  AxisRange across_{0.0, 1.0};
};

}  // namespace torsio
