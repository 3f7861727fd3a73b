// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/row_view.h"

#include <algorithm>

#include <QHeaderView>
#include <QPaintEvent>
#include <QPainter>

namespace torsio::gui {

void paintRowFocus(QPainter& painter, const QRect& row, const QPalette& palette, bool selected) {
  constexpr int kWidth_px = 1;
  const int inset = selected ? 2 : 0;  // within the selection's background
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing, false);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette.color(selected ? QPalette::HighlightedText : QPalette::Highlight), kWidth_px));
  painter.drawRect(row.adjusted(inset, inset, -inset - kWidth_px, -inset - kWidth_px));
  painter.restore();
}

void RowView::currentChanged(const QModelIndex& current, const QModelIndex& previous) {
  QTableView::currentChanged(current, previous);
  viewport()->update();  // the outline spans every cell of the row
}

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
  const QModelIndex current = currentIndex();
  if (!hasFocus() || !current.isValid()) {
    return;
  }
  const bool selected = selectionModel()->isRowSelected(current.row(), rootIndex());
  if (selected && selectionModel()->selectedRows().size() == 1) {
    return;  // the selection shows the current row
  }
  QPainter painter(viewport());
  paintRowFocus(painter,
                QRect(0, rowViewportPosition(current.row()), viewport()->width(), rowHeight(current.row())),
                palette(), selected);
}

}  // namespace torsio::gui
