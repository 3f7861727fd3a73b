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

/// The typeface of the report in this size, pixels.
[[nodiscard]] QFont chartFont(int pixels);

/// The least and the greatest of some numbers; empty before the first.
struct AxisRange {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void take(double v) {
    low = std::min(low, v);
    high = std::max(high, v);
  }
  [[nodiscard]] bool empty() const { return !(low <= high); }
};

/// The axes of one figure's chart. Each is added to the chart, which owns it. GUI thread.
class ChartAxes {
 public:
  /// All four must outlive this.
  ChartAxes(const ReportFigure& figure, const ChartStyle& look, const Wording& wording, QChart& chart);

  /// Adds the axis of values, wide enough for all of them. One at the left has its title upright.
  QCategoryAxis* addValues(Qt::Alignment side);
  /// Adds categories below, on a continuous axis at 1, 2, 3 ..., so that marks may stand beside each other.
  QCategoryAxis* addCategories();
  /// Adds numbers below, wide enough for the abscissas of all series.
  QCategoryAxis* addNumbers();
  /// Adds categories at the left, the first on top, at 1, 2, 3 ...
  QCategoryAxis* addRows();
  /// Adds the axis below that boxes name themselves on.
  QBarCategoryAxis* addBoxes();
  /// Gives the range of the axis that is not that of the values; 0 to 1 before there is one.
  [[nodiscard]] const AxisRange& across() const noexcept { return across_; }

 private:
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
