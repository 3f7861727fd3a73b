// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/services/review/discrepancy_review.h"

namespace torsio::gui {

/// One's own marks against the others' range and mean, one bar per row: a band from lowest to highest, a line
/// at the mean, a diamond at the own mark; discrepant rows are also described in words.
class ComparisonBars : public QWidget {
  Q_OBJECT

 public:
  explicit ComparisonBars(QWidget* parent = nullptr);
  void setTheme(const Theme& theme);
  void setRows(std::vector<RowComparison> rows);
  void retranslate() { describe(); }
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] int rowHeight() const;
  void drawRow(QPainter& painter, const RowComparison& row, const QRect& area) const;
  [[nodiscard]] QString sentenceOf(const RowComparison& row) const;
  void describe();

  const Theme* theme_;
  std::vector<RowComparison> rows_;
};

}  // namespace torsio::gui
