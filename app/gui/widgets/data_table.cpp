// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/data_table.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMetaMethod>
#include <QScrollBar>
#include <QSettings>
#include <QVBoxLayout>

#include "app/gui/widgets/column_widths.h"
#include "app/gui/widgets/data_table_model.h"
#include "app/gui/widgets/number_text.h"
#include "app/gui/widgets/row_view.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/wording/printed_minus.h"

namespace torsio::gui {

namespace {

constexpr int kRowHeight = 32;
constexpr int kToolHeight = 36;     // of a button, so that adjacent lists align with and without tools
constexpr int kMeasuredRows = 200;  // for column widths: a long list would take too long

constexpr int kLeastWidth = 12 * kSpace;  // minimum of a wider column before the list scrolls horizontally

}  // namespace

Cell timeCell(std::int64_t utc_us) {
  return {.text = {}, .sortKey = static_cast<qlonglong>(utc_us), .time = true};
}

DataTable::DataTable(const QString& name, QWidget* parent)
    : QWidget(parent),
      name_(name),
      model_(new Model(this)),
      proxy_(new SortedRows(this)),
      view_(new RowView(this)),
      filter_(new QLineEdit(this)),
      count_(new QLabel(this)),
      empty_(new QLabel(view_)),
      tools_(new QWidget(this)),
      totals_(new QLabel(this)) {
  view_->setItemDelegate(new PaddedCells(view_));
  view_->setHorizontalHeader(new ColumnTitles(view_));
  proxy_->setSourceModel(model_);
  view_->setModel(proxy_);
  view_->setSortingEnabled(true);
  view_->sortByColumn(-1, Qt::AscendingOrder);  // unsorted until a header is clicked
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
  bar->addStrut(kToolHeight);
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
  totals_->setProperty("quiet", true);
  totals_->hide();
  column->addWidget(totals_);
  setFocusProxy(view_);

  createActions();
  connect(filter_, &QLineEdit::textChanged, this, [this](const QString& text) {
    proxy_->setFilterFixedString(text);
    showCount();
  });
  // Not the model's currentRowChanged, which is emitted before or after the selection, depending on the
  // input.
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { Q_EMIT currentChanged(currentId()); });
  connect(view_, &QTableView::doubleClicked, this,
          [this](const QModelIndex& index) { Q_EMIT activated(idAt(index)); });
  QHeaderView* header = view_->horizontalHeader();
  connect(header, &QHeaderView::customContextMenuRequested, this, &DataTable::showColumnMenu);
  connect(header, &QHeaderView::sectionMoved, this, [this] { touched_ = true; });
  connect(header, &QHeaderView::sectionResized, this, [this] {
    if (!sharing_ && QApplication::mouseButtons().testFlag(Qt::LeftButton)) {
      touched_ = true;
    }
  });
  connect(header, &QHeaderView::sortIndicatorChanged, this, [this](int sorted) {
    if (sorted >= 0) {
      makeRoomForArrow(sorted);
      touched_ = true;
    }
  });
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
  sortAction_ = new QAction(this);
  view_->addAction(sortAction_);
  connect(sortAction_, &QAction::triggered, this, &DataTable::sortByCurrent);
  columnsAction_ = new QAction(this);
  view_->addAction(columnsAction_);
  connect(columnsAction_, &QAction::triggered, this,
          [this] { showColumnMenu(view_->horizontalHeader()->rect().bottomLeft()); });
}

void DataTable::sortByCurrent() {
  const int column = std::max(0, view_->currentIndex().column());
  const QHeaderView& header = *view_->horizontalHeader();
  const bool again =
      header.sortIndicatorSection() == column && header.sortIndicatorOrder() == Qt::AscendingOrder;
  view_->sortByColumn(column, again ? Qt::DescendingOrder : Qt::AscendingOrder);
}

void DataTable::setColumns(const std::vector<Column>& columns) {
  model_->setColumns(columns);
  if (!restored_) {
    restore();
  }
  restored_ = true;
  letLastFill();
}

void DataTable::setRows(std::vector<Row> rows) {
  const QString current = currentId();
  const QStringList chosen = selectedIds();
  const bool first = model_->rowCount({}) == 0;
  model_->setRows(std::move(rows));
  if (!touched_) {
    fitColumns(first);
  }
  if (!current.isEmpty()) {
    select(current);
  }
  if (chosen.size() > 1) {
    selectAll(chosen);
  }
  showCount();
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
  if (selection.isRowSelected(selection.currentIndex().row(), {})) {
    return idAt(selection.currentIndex());
  }
  const QModelIndexList rows = selection.selectedRows();
  return rows.isEmpty() ? QString() : idAt(rows.first());
}

QStringList DataTable::selectedIds() const {
  QModelIndexList rows = view_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  QStringList ids;
  for (const QModelIndex& row : rows) {
    ids << idAt(row);
  }
  return ids;
}

void DataTable::select(const QString& id) {
  for (int row = 0; row < proxy_->rowCount(); ++row) {
    if (idAt(proxy_->index(row, 0)) != id) {
      continue;
    }
    view_->selectRow(row);
    view_->scrollTo(proxy_->index(row, 0));
    return;
  }
}

void DataTable::selectAll(const QStringList& ids) {
  QItemSelection chosen;
  for (int row = 0; row < proxy_->rowCount(); ++row) {
    const QModelIndex index = proxy_->index(row, 0);
    if (ids.contains(idAt(index))) {
      chosen.select(index, index);
    }
  }
  view_->selectionModel()->select(chosen, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

int DataTable::visibleRows() const {
  return proxy_->rowCount();
}

QString DataTable::asText() const {
  QModelIndexList rows = view_->selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end());
  if (rows.isEmpty()) {
    for (int row = 0; row < proxy_->rowCount(); ++row) {
      rows << proxy_->index(row, 0);
    }
  }
  const QHeaderView& header = *view_->horizontalHeader();
  std::vector<int> columns;
  for (int place = 0; place < header.count(); ++place) {
    if (!header.isSectionHidden(header.logicalIndex(place))) {
      columns.push_back(header.logicalIndex(place));
    }
  }
  const auto line = [&columns](const auto& textOf) {
    QStringList cells;
    for (const int column : columns) {
      cells << textOf(column);
    }
    return cells.join(QLatin1Char('\t'));
  };
  QStringList lines{line(
      [this](int column) { return model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(); })};
  for (const QModelIndex& row : rows) {
    lines << line([&row](int column) {  // so that another program reads numbers as numbers
      return plainMinus(row.siblingAtColumn(column).data().toString());
    });
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
    connect(shown, &QAction::toggled, header, [this, column](bool on) {
      setColumnHidden(column, !on);
      touched_ = true;
    });
  }
  menu.exec(header->mapToGlobal(at));
}

void DataTable::showCount() {
  const int all = model_->rowCount({});
  const int seen = proxy_->rowCount();
  count_->setText(seen == all ? tr("%n row(s)", nullptr, all)
                              : tr("%1 of %n row(s)", nullptr, all).arg(locale().toString(seen)));
  totals_->setText(totals());
  totals_->setVisible(!totals_->text().isEmpty());
  empty_->setVisible(all == 0 && !empty_->text().isEmpty());
  empty_->setGeometry(view_->viewport()->geometry().adjusted(4 * kSpace, 0, -4 * kSpace, 0));
}

QString DataTable::totals() const {
  QStringList parts;
  if (proxy_->rowCount() == 0) {
    return {};
  }
  const std::vector<Column>& columns = model_->columns();
  for (int column = 0; column < static_cast<int>(columns.size()); ++column) {
    if (!columns[static_cast<std::size_t>(column)].total) {
      continue;
    }
    double sum = 0.0;
    for (int row = 0; row < proxy_->rowCount(); ++row) {
      sum += std::max(0.0, proxy_->index(row, column).data(kSortRole).toDouble());
    }
    parts << tr("%1 %2").arg(columns[static_cast<std::size_t>(column)].title,
                             locale().toString(sum, 'g', 10));
  }
  return parts.isEmpty() ? QString() : tr("Total: %1").arg(parts.join(QStringLiteral(" \u00B7 ")));
}

void DataTable::retranslate() {
  filter_->setPlaceholderText(tr("Filter\u2026"));
  filter_->setAccessibleName(tr("Filter"));
  copyAction_->setText(tr("Copy with headers"));
  sortAction_->setText(tr("Sort by this column"));
  columnsAction_->setText(tr("Columns\u2026"));
  showCount();
}

void DataTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QWidget::changeEvent(event);
}

bool DataTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == view_->viewport()) {
    shareWidth();
    showCount();
  }
  if (event->type() == QEvent::KeyPress && watched == view_) {
    if (static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
      copy();  // the view itself would copy one cell
      return true;
    }
    const int key = static_cast<QKeyEvent*>(event)->key();
    // If rows open nothing, Enter presses the dialog's default button.
    static const QMetaMethod kActivated = QMetaMethod::fromSignal(&DataTable::activated);
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && !currentId().isEmpty() &&
        isSignalConnected(kActivated)) {
      Q_EMIT activated(currentId());
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

QString DataTable::settingsKey() const {
  for (const QWidget* around = parentWidget(); around != nullptr; around = around->parentWidget()) {
    const QString role = around->property("role").toString();
    if (!role.isEmpty()) {
      return QStringLiteral("tables/%1/%2").arg(role, name_);
    }
  }
  return QStringLiteral("tables/%1").arg(name_);
}

void DataTable::remember() const {
  if (name_.isEmpty() || !touched_ || model_->columnCount({}) == 0) {
    return;
  }
  QSettings().setValue(key_, view_->horizontalHeader()->saveState());
}

void DataTable::restore() {
  if (name_.isEmpty()) {
    return;
  }
  key_ = settingsKey();
  const QByteArray state = QSettings().value(key_).toByteArray();
  touched_ = !state.isEmpty() && view_->horizontalHeader()->restoreState(state);
}

/// Fits columns to their content; with new rows they only grow, so that a list that refreshes itself does not
/// move.
void DataTable::fitColumns(bool first) {
  QHeaderView* header = view_->horizontalHeader();
  if (wraps_) {
    view_->setWordWrap(false);  // while measuring the names
  }
  header->setStretchLastSection(false);  // a stretched last column is wider than its content
  wanted_.resize(static_cast<std::size_t>(header->count()), 0);
  cells_.resize(wanted_.size(), 0);
  for (int column = 0; column < header->count(); ++column) {
    const auto at = static_cast<std::size_t>(column);
    const bool hidden = header->isSectionHidden(column);
    const int cells = hidden ? 0 : static_cast<QAbstractItemView*>(view_)->sizeHintForColumn(column);
    const int all = hidden ? 0 : std::max(cells, header->sectionSizeHint(column));
    cells_[at] = first ? cells : std::max(cells_[at], cells);
    wanted_[at] = first ? all : std::max(wanted_[at], all);
  }
  shareWidth();
  letLastFill();
}

/// Lets the last column fill a wide list, except for a number, which would be far from its context.
void DataTable::letLastFill() {
  QHeaderView* header = view_->horizontalHeader();
  const std::vector<Column>& columns = model_->columns();
  int place = header->count() - 1;
  while (place >= 0 && header->isSectionHidden(header->logicalIndex(place))) {
    --place;
  }
  header->setStretchLastSection(place < 0 ||
                                !columns[static_cast<std::size_t>(header->logicalIndex(place))].number);
}

void DataTable::wrapWhatIsCut() {
  wraps_ = true;
  QHeaderView* lines = view_->verticalHeader();
  lines->setMinimumSectionSize(lines->defaultSectionSize());
  lines->setSectionResizeMode(QHeaderView::ResizeToContents);
}

int DataTable::wholeWidth() const {
  const QHeaderView& header = *view_->horizontalHeader();
  int width = 2 * view_->frameWidth() + view_->verticalScrollBar()->sizeHint().width();
  for (std::size_t column = 0; column < wanted_.size(); ++column) {
    width += header.isSectionHidden(static_cast<int>(column)) ? 0 : wanted_[column];
  }
  return width;
}

/// Shrinks columns down to their titles, which are not clipped.
std::vector<int> DataTable::widthsOf(bool crowded) const {
  const auto& titles = static_cast<const ColumnTitles&>(*view_->horizontalHeader());
  std::vector<ColumnWidth> columns;
  for (int column = 0; column < titles.count(); ++column) {
    const int title = crowded && titles.sortIndicatorSection() != column ? titles.unsortedWidth(column)
                                                                         : titles.sectionSizeHint(column);
    columns.push_back(titles.isSectionHidden(column)
                          ? ColumnWidth{0, 0}
                          : ColumnWidth{std::max(title, cells_[static_cast<std::size_t>(column)]),
                                        std::max(kLeastWidth, title)});
  }
  return sharedWidths(columns, view_->viewport()->width());
}

/// Makes room in a crowded list, taken from the widest other column.
void DataTable::makeRoomForArrow(int column) {
  QHeaderView* header = view_->horizontalHeader();
  const int lacks = header->sectionSizeHint(column) - header->sectionSize(column);
  if (touched_ || lacks <= 0 || header->isSectionHidden(column)) {
    return;
  }
  int widest = -1;
  for (int other = 0; other < header->count(); ++other) {
    if (other != column && (widest < 0 || header->sectionSize(other) > header->sectionSize(widest))) {
      widest = other;
    }
  }
  sharing_ = true;
  if (widest >= 0 && header->sectionSize(widest) - lacks >= kLeastWidth) {
    header->resizeSection(widest, header->sectionSize(widest) - lacks);
  }
  header->resizeSection(column, header->sectionSize(column) + lacks);
  sharing_ = false;
}

void DataTable::shareWidth() {
  QHeaderView* header = view_->horizontalHeader();
  if (touched_ || wanted_.size() != static_cast<std::size_t>(header->count())) {
    return;
  }
  const bool crowded = std::accumulate(wanted_.begin(), wanted_.end(), 0) > view_->viewport()->width();
  const std::vector<int> widths = widthsOf(crowded);
  sharing_ = true;
  for (int column = 0; column < header->count(); ++column) {
    if (!header->isSectionHidden(column)) {
      header->resizeSection(column, widths[static_cast<std::size_t>(column)]);
    }
  }
  sharing_ = false;
  if (wraps_) {
    view_->setWordWrap(wholeWidth() > width());
  }
}

void DataTable::setColumnHidden(int column, bool hidden) {
  QHeaderView* header = view_->horizontalHeader();
  if (header->isSectionHidden(column) == hidden) {
    return;
  }
  header->setSectionHidden(column, hidden);
  // It had no width while hidden: fits it now, not when the list is filled next.
  if (!touched_) {
    fitColumns(false);
  } else if (!hidden && header->sectionSize(column) < kLeastWidth) {
    view_->resizeColumnToContents(column);
  }
}

void DataTable::hideAtFirst(int column) {
  if (!touched_) {
    setColumnHidden(column, true);
  }
}

}  // namespace torsio::gui
