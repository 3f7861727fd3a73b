// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

class QPainter;
class QPalette;
class QRect;

namespace torsio::gui {

/// Outlines the row where the keys are, from edge to edge. `row` in pixels of the list.
void paintRowFocus(QPainter& painter, const QRect& row, const QPalette& palette, bool selected);

/// A list whose rows go on, in their colours, to the edge of the list where its columns end before: a table
/// of numbers beside their names does not look torn off. The keys are at a row, never at a cell of it.
class RowView final : public QTableView {
 public:
  using QTableView::QTableView;

 protected:
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace torsio::gui
