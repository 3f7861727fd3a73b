// SPDX-License-Identifier: GPL-3.0-or-later
// Column widths and visibility of DataTable.
#include <algorithm>
#include <numeric>

#include <QHeaderView>
#include <QScrollBar>

#include "app/gui/widgets/column_widths.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/data_table_model.h"
#include "app/gui/widgets/row_view.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kLeastWidth = 12 * kSpace;  // minimum of a wider column before the list scrolls horizontally

}  // namespace

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
