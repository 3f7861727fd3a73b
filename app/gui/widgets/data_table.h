// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <QString>
#include <QStringList>
#include <QVariant>
#include <QWidget>

class QLabel;
class QLineEdit;
class QModelIndex;
class QPoint;
class QSortFilterProxyModel;
class QTableView;

namespace torsio::gui {

class ColumnWidths;

/// A cell: its text, and its sort key.
struct Cell {
  QString text;
  QVariant sortKey{};  ///< number or ISO text; invalid: the text itself, in locale order
  QString tip{};
  bool time = false;  ///< `sortKey` is a time, formatted only when displayed, because lists are long
};

/// Makes a cell with date and time in the list's language, sorted by time; a dash for 0.
[[nodiscard]] Cell timeCell(std::int64_t utc_us);

struct Column {
  QString title;
  bool number = false;  ///< right-aligned
  bool total = false;   ///< shows the sum of the visible rows' positive sort keys below the list
};

struct Row {
  QString id;  ///< the caller's id of the row
  std::vector<Cell> cells;
};

/// A list with sorting by any column, filter as you type, hidden and reordered columns (stored under `name`
/// for each role: the property "role" of its page), and copying with headers. Keyboard: the context menu key
/// sorts by the current column and selects columns. Handles 100,000 rows.
class DataTable : public QWidget {
  Q_OBJECT

 public:
  /// `name`: settings key of column order and widths; empty: not stored.
  explicit DataTable(const QString& name, QWidget* parent = nullptr);
  ~DataTable() override;

  /// Call again after a change of language: keeps order, widths and selection.
  void setColumns(const std::vector<Column>& columns);
  /// Each row needs one cell per column. Keeps selection and sorting.
  void setRows(std::vector<Row> rows);
  void setColumnHidden(int column, bool hidden);
  /// Hides a column unless the user has chosen columns; the filter still searches it. Call after
  /// setColumns().
  void hideAtFirst(int column);
  /// Sets the text for an empty list: what it will contain, and how to fill it.
  void setEmptyText(const QString& sentence);
  /// Adds a button for the list below the filter, right of the count.
  void addTool(QWidget* tool);

  [[nodiscard]] QString currentId() const;  ///< empty: no selection
  [[nodiscard]] QStringList selectedIds() const;
  void select(const QString& id);
  /// Selects exactly the rows with these ids.
  void selectAll(const QStringList& ids);
  [[nodiscard]] int visibleRows() const;
  /// Returns the selection, or all rows, as displayed, tab-separated with a header line.
  [[nodiscard]] QString asText() const;

  /// For a short list with long names: wraps them if the list is too narrow.
  void wrapWhatIsCut();
  /// Returns the width at which no visible cell is clipped.
  [[nodiscard]] int wholeWidth() const;
  [[nodiscard]] QTableView& view() const noexcept { return *view_; }
  [[nodiscard]] QLineEdit& filter() const noexcept { return *filter_; }
  /// Returns the text of the sums; empty: none.
  [[nodiscard]] QString totals() const;

 Q_SIGNALS:
  void currentChanged(const QString& id);
  void activated(const QString& id);  ///< double click or Enter

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Model;
  void createActions();
  void copy() const;
  void showColumnMenu(const QPoint& at);
  void sortByCurrent();
  void showCount();
  void retranslate();
  [[nodiscard]] QString settingsKey() const;
  void remember() const;
  void restore();
  [[nodiscard]] QString idAt(const QModelIndex& proxied) const;

  QString name_;
  QString key_;  // settings key, once the columns are set
  Model* model_;
  QSortFilterProxyModel* proxy_;
  QTableView* view_;
  QLineEdit* filter_;
  QLabel* count_;
  QLabel* empty_;
  QWidget* tools_;
  QLabel* totals_;
  ColumnWidths* widths_;
  QAction* copyAction_ = nullptr;
  QAction* sortAction_ = nullptr;
  QAction* columnsAction_ = nullptr;
  bool restored_ = false;
};

}  // namespace torsio::gui
