// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/row_view.h"

#include <algorithm>

#include <QHeaderView>
#include <QPaintEvent>
#include <QPainter>

namespace torsio::gui {

void RowView::paintEvent(QPaintEvent* event) {
  const int end = horizontalHeader()->length() - horizontalHeader()->offset();
  const int rows = model() != nullptr ? model()->rowCount(rootIndex()) : 0;
  if (rows > 0 && end < viewport()->width()) {
    QPainter painter(viewport());
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    for (int row = std::max(0, rowAt(0)); row < rows; ++row) {
      const int top = rowViewportPosition(row);
      if (top > event->rect().bottom()) {
        break;
      }
      option.rect = QRect(end, top, viewport()->width() - end, rowHeight(row));
      option.features.setFlag(QStyleOptionViewItem::Alternate, row % 2 == 1);
      option.state.setFlag(QStyle::State_Selected, selectionModel()->isRowSelected(row, rootIndex()));
      style()->drawPrimitive(QStyle::PE_PanelItemViewRow, &option, &painter, this);
      style()->drawPrimitive(QStyle::PE_PanelItemViewItem, &option, &painter, this);
    }
  }
  QTableView::paintEvent(event);
}

}  // namespace torsio::gui
