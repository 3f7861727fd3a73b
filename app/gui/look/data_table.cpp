// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/look/data_table.h"

#include <algorithm>
#include <utility>

#include <QAbstractTableModel>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QCollator>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSettings>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/look/theme.h"

namespace torsio::gui {

namespace {

constexpr int kSortRole = Qt::UserRole;
constexpr int kIdRole = Qt::UserRole + 1;
constexpr int kRowHeight = 32;
constexpr int kMeasuredRows = 200;  // for the widths of the columns: all of a long list would take too long

/// Numbers by size, texts by the rules of the language ("T-2" before "T-10").
class SortedRows final : public QSortFilterProxyModel {
 public:
  explicit SortedRows(QObject* parent) : QSortFilterProxyModel(parent), collator_(collation()) {
    setSortRole(kSortRole);
    setFilterCaseSensitivity(Qt::CaseInsensitive);
    setFilterKeyColumn(-1);
    collator_.setNumericMode(true);
    collator_.setCaseSensitivity(Qt::CaseInsensitive);
  }

 protected:
  [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
    const QVariant a = left.data(kSortRole);
    const QVariant b = right.data(kSortRole);
    if (a.typeId() == QMetaType::QString || b.typeId() == QMetaType::QString) {
      return collator_.compare(a.toString(), b.toString()) < 0;
    }
    return a.toDouble() < b.toDouble();
  }

 private:
  /// The "C" locale compares bytes and knows no numbers.
  static QLocale collation() {
    const QLocale locale;
    return locale.language() == QLocale::C ? QLocale(QLocale::English) : locale;
  }

  QCollator collator_;
};

}  // namespace

class DataTable::Model final : public QAbstractTableModel {
 public:
  using QAbstractTableModel::QAbstractTableModel;

  void setColumns(const std::vector<Column>& columns) {
    if (columns.size() == columns_.size()) {
      columns_ = columns;
      if (!columns_.empty()) Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount({}) - 1);
      return;
    }
    beginResetModel();
    columns_ = columns;
    rows_.clear();
    endResetModel();
  }

  void setRows(std::vector<Row> rows) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
  }

  [[nodiscard]] int rowCount(const QModelIndex& parent) const override {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
  }
  [[nodiscard]] int columnCount(const QModelIndex& parent) const override {
    return parent.isValid() ? 0 : static_cast<int>(columns_.size());
  }

  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override {
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<std::size_t>(index.column());
    if (role == kIdRole) return row.id;
    if (role == Qt::TextAlignmentRole && columns_[column].number) {
      return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    }
    if (column >= row.cells.size()) return {};
    const Cell& cell = row.cells[column];
    switch (role) {
      case Qt::DisplayRole:
        return cell.text;
      case Qt::ToolTipRole:
        return cell.tip.isEmpty() ? QVariant() : QVariant(cell.tip);
      case kSortRole:
        return cell.sortKey.isValid() ? cell.sortKey : QVariant(cell.text);
      default:
        return {};
    }
  }

  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override {
    if (orientation != Qt::Horizontal) return {};
    const Column& column = columns_[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) return column.title;
    if (role == Qt::TextAlignmentRole) {
      return QVariant((column.number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    }
    return {};
  }

 private:
  std::vector<Column> columns_;
  std::vector<Row> rows_;
};

DataTable::DataTable(const QString& name, QWidget* parent)
    : QWidget(parent),
      name_(name),
      model_(new Model(this)),
      proxy_(new SortedRows(this)),
      view_(new QTableView(this)),
      filter_(new QLineEdit(this)),
      count_(new QLabel(this)),
      empty_(new QLabel(view_)),
      tools_(new QWidget(this)) {
  proxy_->setSourceModel(model_);
  view_->setModel(proxy_);
  view_->setSortingEnabled(true);
  view_->sortByColumn(-1, Qt::AscendingOrder);  // as given, until a header is pressed
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  view_->setAlternatingRowColors(true);
  view_->setShowGrid(false);
  view_->setWordWrap(false);
  view_->setTabKeyNavigation(false);  // Tab leaves the list, arrows move in it
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(kRowHeight);
  view_->horizontalHeader()->setSectionsMovable(true);
  view_->horizontalHeader()->setStretchLastSection(true);
  view_->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
  view_->horizontalHeader()->setHighlightSections(false);
  view_->horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  view_->installEventFilter(this);
  view_->viewport()->installEventFilter(this);
  filter_->setClearButtonEnabled(true);
  count_->setProperty("quiet", true);
  empty_->setProperty("quiet", true);
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->hide();

  auto* bar = new QHBoxLayout;
  bar->addWidget(filter_, 2);
  bar->addWidget(count_);
  bar->addStretch(1);
  bar->addWidget(tools_);
  auto* tools = new QHBoxLayout(tools_);
  tools->setContentsMargins(0, 0, 0, 0);
  tools->setSpacing(kSpace);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kSpace);
  column->addLayout(bar);
  column->addWidget(view_, 1);
  setFocusProxy(view_);

  createActions();
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    proxy_->setFilterFixedString(text);
    showCount();
  });
  // Not the model's currentRowChanged: it comes before the row is selected or after, as the user moved.
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { Q_EMIT currentChanged(currentId()); });
  connect(view_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { Q_EMIT activated(idAt(index)); });
  connect(view_->horizontalHeader(), &QHeaderView::customContextMenuRequested, this,
          &DataTable::showColumnMenu);
  retranslate();
}

DataTable::~DataTable() {
  remember();
}

void DataTable::createActions() {
  copyAction_ = new QAction(this);
  copyAction_->setShortcut(QKeySequence::Copy);
  copyAction_->setShortcutContext(Qt::WidgetShortcut);
  view_->addAction(copyAction_);
  connect(copyAction_, &QAction::triggered, this, &DataTable::copy);
}

void DataTable::setColumns(const std::vector<Column>& columns) {
  model_->setColumns(columns);
  if (!restored_) restore();
  restored_ = true;
}

void DataTable::setRows(std::vector<Row> rows) {
  const QString current = currentId();
  const bool first = model_->rowCount({}) == 0;
  model_->setRows(std::move(rows));
  if (first && !view_->horizontalHeader()->property("remembered").toBool()) view_->resizeColumnsToContents();
  if (!current.isEmpty()) select(current);
  showCount();
}

void DataTable::setColumnHidden(int column, bool hidden) {
  view_->horizontalHeader()->setSectionHidden(column, hidden);
}

void DataTable::setEmptyText(const QString& sentence) {
  empty_->setText(sentence);
  showCount();
}

void DataTable::addTool(QWidget* tool) {
  tools_->layout()->addWidget(tool);
}

QString DataTable::idAt(const QModelIndex& proxied) const {
  return proxied.isValid() ? proxied.data(kIdRole).toString() : QString();
}

QString DataTable::currentId() const {
  const QItemSelectionModel& selection = *view_->selectionModel();
  if (selection.isRowSelected(selection.currentIndex().row(), {})) return idAt(selection.currentIndex());
  const QModelIndexList rows = selection.selectedRows();
  return rows.isEmpty() ? QString() : idAt(rows.first());
}

QStringList DataTable::selectedIds() const {
  QModelIndexList rows = view_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  QStringList ids;
  for (const QModelIndex& row : rows) ids << idAt(row);
  return ids;
}

void DataTable::select(const QString& id) {
  for (int row = 0; row < proxy_->rowCount(); ++row) {
    if (idAt(proxy_->index(row, 0)) != id) continue;
    view_->selectRow(row);
    view_->scrollTo(proxy_->index(row, 0));
    return;
  }
}

int DataTable::visibleRows() const {
  return proxy_->rowCount();
}

QString DataTable::asText() const {
  QModelIndexList rows = view_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  if (rows.isEmpty()) {
    for (int row = 0; row < proxy_->rowCount(); ++row) rows << proxy_->index(row, 0);
  }
  const QHeaderView& header = *view_->horizontalHeader();
  std::vector<int> columns;
  for (int place = 0; place < header.count(); ++place) {
    if (!header.isSectionHidden(header.logicalIndex(place))) columns.push_back(header.logicalIndex(place));
  }
  const auto line = [&columns](const auto& textOf) {
    QStringList cells;
    for (const int column : columns) cells << textOf(column);
    return cells.join(QLatin1Char('\t'));
  };
  QStringList lines{line(
      [this](int column) { return model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(); })};
  for (const QModelIndex& row : rows) {
    lines << line([&row](int column) { return row.siblingAtColumn(column).data().toString(); });
  }
  return lines.join(QLatin1Char('\n')) + QLatin1Char('\n');
}

void DataTable::copy() const {
  QApplication::clipboard()->setText(asText());
}

void DataTable::showColumnMenu(const QPoint& at) {
  QMenu menu(this);
  QHeaderView* header = view_->horizontalHeader();
  for (int column = 0; column < header->count(); ++column) {
    const QString title = model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    QAction* shown = menu.addAction(title);
    shown->setCheckable(true);
    shown->setChecked(!header->isSectionHidden(column));
    shown->setEnabled(shown->isChecked() ? header->count() - header->hiddenSectionCount() > 1 : true);
    connect(shown, &QAction::toggled, header,
            [header, column](bool on) { header->setSectionHidden(column, !on); });
  }
  menu.exec(header->mapToGlobal(at));
}

void DataTable::showCount() {
  const int all = model_->rowCount({});
  const int seen = proxy_->rowCount();
  count_->setText(seen == all ? tr("%n row(s)", nullptr, all)
                              : tr("%1 of %2 rows").arg(locale().toString(seen), locale().toString(all)));
  empty_->setVisible(all == 0 && !empty_->text().isEmpty());
  empty_->setGeometry(view_->viewport()->geometry().adjusted(4 * kSpace, 0, -4 * kSpace, 0));
}

void DataTable::retranslate() {
  filter_->setPlaceholderText(tr("Filter\u2026"));
  filter_->setAccessibleName(tr("Filter"));
  copyAction_->setText(tr("Copy with headers"));
  showCount();
}

void DataTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

bool DataTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == view_->viewport()) showCount();
  if (event->type() == QEvent::KeyPress && watched == view_) {
    if (static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
      copy();  // the view itself would copy one cell
      return true;
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !currentId().isEmpty()) {
      Q_EMIT activated(currentId());
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void DataTable::remember() const {
  if (name_.isEmpty() || model_->columnCount({}) == 0) return;
  QSettings().setValue(QStringLiteral("tables/") + name_, view_->horizontalHeader()->saveState());
}

void DataTable::restore() {
  if (name_.isEmpty()) return;
  const QByteArray state = QSettings().value(QStringLiteral("tables/") + name_).toByteArray();
  if (!state.isEmpty() && view_->horizontalHeader()->restoreState(state)) {
    view_->horizontalHeader()->setProperty("remembered", true);
  }
}

}  // namespace torsio::gui
