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

/// One cell: what is read, and what sorts.
struct Cell {
  QString text;
  QVariant sortKey{};  ///< number or ISO text; invalid: the text itself, by the rules of the language
  QString tip{};
  bool time = false;  ///< `sortKey` is a time: put into words when it is looked at, a long list is not
};

/// Date and time in the language of the list, sorted by time; a dash for 0.
[[nodiscard]] Cell timeCell(std::int64_t utc_us);

struct Column {
  QString title;
  bool number = false;  ///< right-aligned
  bool total = false;   ///< its positive sort keys are added up below the list, over the rows that are seen
};

struct Row {
  QString id;  ///< what the caller knows the row by
  std::vector<Cell> cells;
};

/// A list as people expect it: sorts by any column, filters while typing, hides and reorders columns
/// (remembered under `name` for each role: the property "role" of the page it stands on), copies with its
/// headers. Without the mouse: the context menu key sorts by the column one stands in and chooses columns.
/// Holds 100,000 rows.
class DataTable : public QWidget {
  Q_OBJECT

 public:
  /// `name`: under which column order and widths are remembered; empty: they are not.
  explicit DataTable(const QString& name, QWidget* parent = nullptr);
  ~DataTable() override;

  /// Call again after a change of language: order, widths and selection stay.
  void setColumns(const std::vector<Column>& columns);
  /// Every row has one cell a column. Selection and sorting stay.
  void setRows(std::vector<Row> rows);
  void setColumnHidden(int column, bool hidden);
  /// Not shown unless somebody has chosen their columns; the filter looks into it all the same. Once the
  /// columns are set.
  void hideAtFirst(int column);
  /// Shown in place of rows when there are none: what this list will hold, and how it gets filled.
  void setEmptyText(const QString& sentence);
  /// Below the filter, to the right of the count: buttons that concern the list.
  void addTool(QWidget* tool);

  [[nodiscard]] QString currentId() const;  ///< empty: nothing selected
  [[nodiscard]] QStringList selectedIds() const;
  void select(const QString& id);
  /// Selects the rows with these ids and no others.
  void selectAll(const QStringList& ids);
  [[nodiscard]] int visibleRows() const;
  /// Rows as they are shown, with a header line, tab-separated: the selection, or everything.
  [[nodiscard]] QString asText() const;

  /// For a list of few rows with long names: where the list is too narrow they stand in several lines.
  void wrapWhatIsCut();
  /// Width at which no cell of the columns that are shown is cut.
  [[nodiscard]] int wholeWidth() const;
  [[nodiscard]] QTableView& view() const noexcept { return *view_; }
  [[nodiscard]] QLineEdit& filter() const noexcept { return *filter_; }
  /// What is added up, in words; empty: nothing is.
  [[nodiscard]] QString totals() const;

 Q_SIGNALS:
  void currentChanged(const QString& id);
  void activated(const QString& id);  ///< double click or Enter

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Model;
  /// Widths that fill the list, px; a crowded one keeps no room beside its titles for the arrow of a sorting.
  [[nodiscard]] std::vector<int> widthsOf(bool crowded) const;
  void makeRoomForArrow(int column);
  void createActions();
  void copy() const;
  void showColumnMenu(const QPoint& at);
  void sortByCurrent();
  void fitColumns(bool first);
  void shareWidth();
  void letLastFill();
  void showCount();
  void retranslate();
  [[nodiscard]] QString settingsKey() const;
  void remember() const;
  void restore();
  [[nodiscard]] QString idAt(const QModelIndex& proxied) const;

  QString name_;
  QString key_;  // of the settings, once the table has its columns
  Model* model_;
  QSortFilterProxyModel* proxy_;
  QTableView* view_;
  QLineEdit* filter_;
  QLabel* count_;
  QLabel* empty_;
  QWidget* tools_;
  QLabel* totals_;
  QAction* copyAction_ = nullptr;
  QAction* sortAction_ = nullptr;
  QAction* columnsAction_ = nullptr;
  std::vector<int> cells_;   // width of each column that shows all its cells, px
  std::vector<int> wanted_;  // and its title with the arrow of a sorting
  bool wraps_ = false;
  bool sharing_ = false;  // the table sizes its columns, not somebody with the mouse
  bool restored_ = false;
  bool touched_ = false;  // somebody moved, sized, hid or sorted: only that is worth remembering
};

}  // namespace torsio::gui
