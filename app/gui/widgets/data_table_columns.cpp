// SPDX-License-Identifier: GPL-3.0-or-later
// Of DataTable: how wide its columns are, and which are shown.
#include <algorithm>

#include <QHeaderView>
#include <QScrollBar>

#include "app/gui/widgets/column_widths.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/data_table_model.h"
#include "app/gui/widgets/row_view.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kLeastWidth = 12 * kSpace;  // a wider column gives way before a list scrolls sideways

}  // namespace

/// As wide as what is in them; with new rows they only grow, so that a list that reads itself anew stands
/// still.
void DataTable::fitColumns(bool first) {
  QHeaderView* header = view_->horizontalHeader();
  if (wraps_) {
    view_->setWordWrap(false);  // while it is found out how wide the names are
  }
  header->setStretchLastSection(false);  // a last column that fills the list is wider than what is in it
  view_->resizeColumnsToContents();
  wanted_.resize(static_cast<std::size_t>(header->count()), 0);
  for (int column = 0; column < header->count(); ++column) {
    int& wanted = wanted_[static_cast<std::size_t>(column)];
    wanted = first ? header->sectionSize(column) : std::max(wanted, header->sectionSize(column));
  }
  shareWidth();
  letLastFill();
}

/// The last column takes the rest of a wide list, but for a number, which would stand far from what it
/// belongs to.
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

void DataTable::shareWidth() {
  QHeaderView* header = view_->horizontalHeader();
  if (touched_ || wanted_.size() != static_cast<std::size_t>(header->count())) {
    return;
  }
  // A column gives way down to its title, which stays whole.
  std::vector<ColumnWidth> columns;
  for (int column = 0; column < header->count(); ++column) {
    const int least = std::max(kLeastWidth, header->sectionSizeHint(column));
    columns.push_back(header->isSectionHidden(column)
                          ? ColumnWidth{0, 0}
                          : ColumnWidth{wanted_[static_cast<std::size_t>(column)], least});
  }
  const std::vector<int> widths = sharedWidths(columns, view_->viewport()->width());
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
  // While it was hidden nobody gave it a width: at once, not when the list is filled the next time.
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
