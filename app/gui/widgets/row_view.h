// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

namespace torsio::gui {

/// A list whose rows go on, in their colours, to the edge of the list where its columns end before: a table
/// of numbers beside their names does not look torn off.
class RowView final : public QTableView {
 public:
  using QTableView::QTableView;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace torsio::gui
