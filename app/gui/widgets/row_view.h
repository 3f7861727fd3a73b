// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

class QPainter;
class QPalette;
class QRect;

namespace torsio::gui {

/// Outlines the current row, from edge to edge. `row`: in pixels of the list.
void paintRowFocus(QPainter& painter, const QRect& row, const QPalette& palette, bool selected);

/// A list whose row colours extend to the list's edge beyond the last column, so that narrow tables do not
/// look cut off. Focus is on a row, never on a cell.
class RowView final : public QTableView {
 public:
  using QTableView::QTableView;

 protected:
  void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace torsio::gui
