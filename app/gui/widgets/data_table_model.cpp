// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/data_table_model.h"

#include <algorithm>
#include <utility>

#include <QAbstractItemView>
#include <QApplication>
#include <QHeaderView>
#include <QHelpEvent>
#include <QPaintEvent>
#include <QPainter>
#include <QToolTip>

#include "app/gui/widgets/column_widths.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"

namespace torsio::gui {

namespace {

/// The "C" locale compares bytes and does not sort numbers within text.
QLocale collation() {
  const QLocale locale;
  return locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
}

/// Returns the rectangle of a cell's text.
QRect textPlace(const QStyleOptionViewItem& cell) {
  return cell.rect.adjusted(kSpace, 0, -kSpace - afterNumber(cell.displayAlignment), 0);
}

}  // namespace

DataTable::Model::Model(DataTable* table) : QAbstractTableModel(table), table_(table) {}

void DataTable::Model::setColumns(const std::vector<Column>& columns) {
  if (columns.size() == columns_.size()) {
    columns_ = columns;
    if (!columns_.empty()) {
      Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount({}) - 1);
    }
    return;
  }
  beginResetModel();
  columns_ = columns;
  rows_.clear();
  endResetModel();
}

void DataTable::Model::setRows(std::vector<Row> rows) {
  beginResetModel();
  rows_ = std::move(rows);
  endResetModel();
}

int DataTable::Model::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int DataTable::Model::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(columns_.size());
}

QVariant DataTable::Model::data(const QModelIndex& index, int role) const {
  const Row& row = rows_[static_cast<std::size_t>(index.row())];
  const auto column = static_cast<std::size_t>(index.column());
  if (role == kIdRole) {
    return row.id;
  }
  if (role == Qt::TextAlignmentRole && columns_[column].number) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (column >= row.cells.size()) {
    return {};
  }
  const Cell& cell = row.cells[column];
  switch (role) {
    case Qt::DisplayRole:
      return cell.time ? shownTime(cell.sortKey.toLongLong(), table_->locale()) : cell.text;
    case Qt::ToolTipRole:
      return cell.tip.isEmpty() ? QVariant() : QVariant(cell.tip);
    case kSortRole:
      return cell.sortKey.isValid() ? cell.sortKey : QVariant(cell.text);
    default:
      return {};
  }
}

QVariant DataTable::Model::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  const Column& column = columns_[static_cast<std::size_t>(section)];
  if (role == Qt::DisplayRole) {
    return column.title;
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant((column.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  return {};
}

SortedRows::SortedRows(QObject* parent) : QSortFilterProxyModel(parent), collator_(collation()) {
  setSortRole(kSortRole);
  setFilterCaseSensitivity(Qt::CaseInsensitive);
  setFilterKeyColumn(-1);
  collator_.setNumericMode(true);
  collator_.setCaseSensitivity(Qt::CaseInsensitive);
}

bool SortedRows::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const QVariant a = left.data(kSortRole);
  const QVariant b = right.data(kSortRole);
  if (a.typeId() == QMetaType::QString || b.typeId() == QMetaType::QString) {
    return collator_.compare(a.toString(), b.toString()) < 0;
  }
  return a.toDouble() < b.toDouble();
}

void PaddedCells::paint(QPainter* painter, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const {
  QStyleOptionViewItem cell = option;
  initStyleOption(&cell, index);
  const QString text = cell.text;
  cell.text.clear();
  if (dynamic_cast<const RowView*>(cell.widget) != nullptr) {
    cell.state.setFlag(QStyle::State_HasFocus, false);  // the list outlines the row
  }
  const QStyle* style = cell.widget != nullptr ? cell.widget->style() : QApplication::style();
  style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
  const bool enabled = cell.state.testFlag(QStyle::State_Enabled);
  painter->save();
  painter->setFont(cell.font);
  painter->setPen(cell.palette.color(
      enabled ? QPalette::Active : QPalette::Disabled,
      cell.state.testFlag(QStyle::State_Selected) ? QPalette::HighlightedText : QPalette::Text));
  const QRect place = textPlace(cell);
  if (cell.features.testFlag(QStyleOptionViewItem::WrapText)) {
    painter->drawText(place, static_cast<int>(cell.displayAlignment | Qt::TextWordWrap), text);
  } else {
    painter->drawText(place, static_cast<int>(cell.displayAlignment | Qt::TextSingleLine),
                      cell.fontMetrics.elidedText(text, Qt::ElideRight, place.width()));
  }
  painter->restore();
}

QSize PaddedCells::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  QStyleOptionViewItem inside = option;
  initStyleOption(&inside, index);
  const int after = afterNumber(inside.displayAlignment);
  if (inside.features.testFlag(QStyleOptionViewItem::WrapText)) {
    const int spare = QApplication::style()->pixelMetric(QStyle::PM_FocusFrameHMargin, &option) + 1;
    inside.rect.adjust(kSpace - spare, 0, spare - kSpace - after, 0);  // the style has its own margin
  }
  return QStyledItemDelegate::sizeHint(inside, index) + QSize(2 * kSpace + after, 0);
}

bool PaddedCells::helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                            const QModelIndex& index) {
  const QString text = index.data().toString();
  QStyleOptionViewItem cell = option;
  initStyleOption(&cell, index);
  const bool cut = !cell.features.testFlag(QStyleOptionViewItem::WrapText) &&
                   cell.fontMetrics.horizontalAdvance(text) > textPlace(cell).width();
  if (event->type() == QEvent::ToolTip && cut && !index.data(Qt::ToolTipRole).isValid()) {
    QToolTip::showText(event->globalPos(), text, view);
    return true;
  }
  return QStyledItemDelegate::helpEvent(event, view, option, index);
}

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
