// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/data_table.h"

#include <algorithm>
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
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/gui/widgets/window_events.h"
#include "app/outputs/wording/printed_minus.h"

namespace torsio::gui {

namespace {

constexpr int kRowHeight = 32;
constexpr int kToolHeight = 36;  // of a button, so that adjacent lists align with and without tools

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
      totals_(new QLabel(this)),
      widths_(new ColumnWidths(*view_)) {
  view_->setItemDelegate(new PaddedCells(view_));
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
  bareLayout<QHBoxLayout>(tools_, kSpace);
  auto* column = bareLayout<QVBoxLayout>(this, kSpace);
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
  connect(view_->horizontalHeader(), &QHeaderView::customContextMenuRequested, this,
          &DataTable::showColumnMenu);
  followLanguage(this, [this] { retranslate(); });
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
  widths_->letLastFill();
}

void DataTable::setRows(std::vector<Row> rows) {
  const QString current = currentId();
  const QStringList chosen = selectedIds();
  const bool first = model_->rowCount({}) == 0;
  model_->setRows(std::move(rows));
  widths_->fit(first);
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
      widths_->setChosen(true);
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

bool DataTable::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize && watched == view_->viewport()) {
    widths_->share();
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
  if (name_.isEmpty() || !widths_->chosen() || model_->columnCount({}) == 0) {
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
  widths_->setChosen(!state.isEmpty() && view_->horizontalHeader()->restoreState(state));
}

void DataTable::wrapWhatIsCut() {
  widths_->wrapWhatIsCut();
}

int DataTable::wholeWidth() const {
  return widths_->whole_px();
}

void DataTable::setColumnHidden(int column, bool hidden) {
  widths_->setHidden(column, hidden);
}

void DataTable::hideAtFirst(int column) {
  if (!widths_->chosen()) {
    setColumnHidden(column, true);
  }
}

}  // namespace torsio::gui
