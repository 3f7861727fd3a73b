// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QAbstractTableModel>
#include <QCollator>
#include <QHeaderView>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>

#include "app/gui/widgets/data_table.h"

namespace torsio::gui {

// What a DataTable shows its rows with; used by data_table.cpp alone.

inline constexpr int kSortRole = Qt::UserRole;    ///< what sorts a cell
inline constexpr int kIdRole = Qt::UserRole + 1;  ///< Row::id

/// Holds the columns and rows of a DataTable.
class DataTable::Model final : public QAbstractTableModel {
 public:
  /// Times are put into words in the language of `table`.
  explicit Model(DataTable* table);

  /// Keeps the rows where the number of columns stays.
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

/// Sorts numbers by size and texts by the rules of the language ("T-2" before "T-10").
class SortedRows final : public QSortFilterProxyModel {
 public:
  explicit SortedRows(QObject* parent);

 protected:
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  QCollator collator_;
};

/// Titles of columns; that of a number keeps as far from what follows as the numbers below it.
class ColumnTitles final : public QHeaderView {
 public:
  explicit ColumnTitles(QWidget* parent);
  /// Of a title that is whole as long as the list is not sorted by it, px.
  [[nodiscard]] int unsortedWidth(int column) const;

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int column) const override;
  [[nodiscard]] QSize sectionSizeFromContents(int column) const override;

 private:
  [[nodiscard]] int afterNumber(int column) const;
};

/// Draws cells as far from their edges as the headers: a number never touches the text beside it. A text that
/// is cut is told whole in its tooltip.
class PaddedCells final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;
};

}  // namespace torsio::gui
