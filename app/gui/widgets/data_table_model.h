// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QAbstractTableModel>
#include <QCollator>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <QTableView>

#include "app/gui/widgets/data_table.h"

class QPainter;
class QPalette;
class QRect;

namespace torsio::gui {

// Model and views of DataTable; other lists use the views for its look.

inline constexpr int kSortRole = Qt::UserRole;    ///< sort key of a cell
inline constexpr int kIdRole = Qt::UserRole + 1;  ///< Row::id

/// The columns and rows of a DataTable.
class DataTable::Model final : public QAbstractTableModel {
 public:
  /// Times are formatted in the language of `table`.
  explicit Model(DataTable* table);

  /// Keeps the rows if the number of columns does not change.
  void setColumns(const std::vector<Column>& columns);
  void setRows(std::vector<Row> rows);
  [[nodiscard]] const std::vector<Column>& columns() const noexcept { return columns_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  const DataTable* table_;
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

/// Sorts numbers by size and texts in locale order ("T-2" before "T-10").
class SortedRows final : public QSortFilterProxyModel {
 public:
  explicit SortedRows(QObject* parent);

 protected:
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  QCollator collator_;
};

/// Draws cells with the padding of the headers, so that a number never touches the next text. Clipped text is
/// shown in the tool tip.
class PaddedCells final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;
};

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
