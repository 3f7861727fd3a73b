// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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
};

struct Column {
  QString title;
  bool number = false;  ///< right-aligned
};

struct Row {
  QString id;  ///< what the caller knows the row by
  std::vector<Cell> cells;
};

/// A list as people expect it: sorts by any column, filters while typing, hides and reorders columns
/// (remembered under `name`), copies with its headers. Holds 100,000 rows.
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
  /// Shown in place of rows when there are none: what this list will hold, and how it gets filled.
  void setEmptyText(const QString& sentence);
  /// Below the filter, to the right of the count: buttons that concern the list.
  void addTool(QWidget* tool);

  [[nodiscard]] QString currentId() const;  ///< empty: nothing selected
  [[nodiscard]] QStringList selectedIds() const;
  void select(const QString& id);
  [[nodiscard]] int visibleRows() const;
  /// Rows as they are shown, with a header line, tab-separated: the selection, or everything.
  [[nodiscard]] QString asText() const;

  [[nodiscard]] QTableView& view() const noexcept { return *view_; }
  [[nodiscard]] QLineEdit& filter() const noexcept { return *filter_; }

 Q_SIGNALS:
  void currentChanged(const QString& id);
  void activated(const QString& id);  ///< double click or Enter

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  class Model;
  void createActions();
  void copy() const;
  void showColumnMenu(const QPoint& at);
  void showCount();
  void retranslate();
  void remember() const;
  void restore();
  [[nodiscard]] QString idAt(const QModelIndex& proxied) const;

  QString name_;
  Model* model_;
  QSortFilterProxyModel* proxy_;
  QTableView* view_;
  QLineEdit* filter_;
  QLabel* count_;
  QLabel* empty_;
  QWidget* tools_;
  QAction* copyAction_ = nullptr;
  bool restored_ = false;
};

}  // namespace torsio::gui
