// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/column_widths.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include <QApplication>
#include <QPainter>
#include <QScrollBar>
#include <QTableView>

#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr std::int64_t kMaxGrowth = 3;
constexpr int kMeasuredRows = 200;        // a long list would take too long
constexpr int kLeastWidth = 12 * kSpace;  // minimum of a wider column before the list scrolls horizontally

int paddingAfter(const QHeaderView& titles, int column) {
  return afterNumber(
      Qt::Alignment(titles.model()->headerData(column, Qt::Horizontal, Qt::TextAlignmentRole).toInt()));
}

}  // namespace

std::vector<int> sharedWidths(const std::vector<ColumnWidth>& columns, int list_px) {
  std::vector<int> widths;
  int over = -list_px;
  for (const ColumnWidth& column : columns) {
    widths.push_back(column.wanted_px);
    over += column.wanted_px;
  }
  if (over < 0) {
    const std::int64_t whole = over + list_px;
    const std::int64_t room = std::min<std::int64_t>(list_px, kMaxGrowth * whole);
    for (int& width : widths) {
      width = whole > 0 ? static_cast<int>(width * room / whole) : width;
    }
  }
  for (; over > 0; --over) {
    std::size_t widest = widths.size();
    for (std::size_t at = 0; at < widths.size(); ++at) {
      if (widths[at] > columns[at].least_px && (widest == widths.size() || widths[at] > widths[widest])) {
        widest = at;
      }
    }
    if (widest == widths.size()) {
      break;
    }
    --widths[widest];
  }
  return widths;
}

int afterNumber(Qt::Alignment alignment) {
  return alignment.testFlag(Qt::AlignRight) ? kSpace : 0;
}

ColumnTitles::ColumnTitles(QWidget* parent) : QHeaderView(Qt::Horizontal, parent) {
  setSectionsClickable(true);
}

void ColumnTitles::paintSection(QPainter* painter, const QRect& rect, int column) const {
  QHeaderView::paintSection(painter, rect.adjusted(0, 0, -paddingAfter(*this, column), 0), column);
}

QSize ColumnTitles::sectionSizeFromContents(int column) const {
  return QHeaderView::sectionSizeFromContents(column) + QSize(paddingAfter(*this, column), 0);
}

int ColumnTitles::unsortedWidth(int column) const {
  QStyleOptionHeader title;
  initStyleOption(&title);
  title.section = column;
  title.text = model()->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
  QFont bold = font();
  bold.setBold(true);
  title.fontMetrics = QFontMetrics(bold);
  return style()->sizeFromContents(QStyle::CT_HeaderSection, &title, QSize(), this).width() +
         paddingAfter(*this, column);
}

ColumnWidths::ColumnWidths(QTableView& list)
    : QObject(&list), list_(list), titles_(*new ColumnTitles(&list)) {
  list.setHorizontalHeader(&titles_);
  titles_.setResizeContentsPrecision(kMeasuredRows);
  connect(&titles_, &QHeaderView::sectionMoved, this, [this] { chosen_ = true; });
  connect(&titles_, &QHeaderView::sectionResized, this, [this] {
    if (!sharing_ && QApplication::mouseButtons().testFlag(Qt::LeftButton)) {
      chosen_ = true;
    }
  });
  connect(&titles_, &QHeaderView::sortIndicatorChanged, this, [this](int sorted) {
    if (sorted >= 0) {
      makeRoomForArrow(sorted);
      chosen_ = true;
    }
  });
}

void ColumnWidths::fit(bool first) {
  if (!chosen_) {
    measure(first);
    share();
    letLastFill();
  }
}

void ColumnWidths::measure(bool first) {
  if (wraps_) {
    list_.setWordWrap(false);  // while measuring the names
  }
  titles_.setStretchLastSection(false);  // a stretched last column is wider than its content
  wanted_.resize(static_cast<std::size_t>(titles_.count()), 0);
  cells_.resize(wanted_.size(), 0);
  for (int column = 0; column < titles_.count(); ++column) {
    const auto at = static_cast<std::size_t>(column);
    const bool hidden = titles_.isSectionHidden(column);
    const int cells = hidden ? 0 : static_cast<const QAbstractItemView&>(list_).sizeHintForColumn(column);
    const int all = hidden ? 0 : std::max(cells, titles_.sectionSizeHint(column));
    cells_[at] = first ? cells : std::max(cells_[at], cells);
    wanted_[at] = first ? all : std::max(wanted_[at], all);
  }
}

void ColumnWidths::letLastFill() {
  int place = titles_.count() - 1;
  while (place >= 0 && titles_.isSectionHidden(titles_.logicalIndex(place))) {
    --place;
  }
  titles_.setStretchLastSection(place < 0 || paddingAfter(titles_, titles_.logicalIndex(place)) == 0);
}

void ColumnWidths::wrapWhatIsCut() {
  wraps_ = true;
  QHeaderView* lines = list_.verticalHeader();
  lines->setMinimumSectionSize(lines->defaultSectionSize());
  lines->setSectionResizeMode(QHeaderView::ResizeToContents);
}

int ColumnWidths::whole_px() const {
  int width = 2 * list_.frameWidth() + list_.verticalScrollBar()->sizeHint().width();
  for (std::size_t column = 0; column < wanted_.size(); ++column) {
    width += titles_.isSectionHidden(static_cast<int>(column)) ? 0 : wanted_[column];
  }
  return width;
}

/// Shrinks columns down to their titles, which are not clipped.
std::vector<int> ColumnWidths::widths_px(bool crowded) const {
  std::vector<ColumnWidth> columns;
  for (int column = 0; column < titles_.count(); ++column) {
    const int title = crowded && titles_.sortIndicatorSection() != column ? titles_.unsortedWidth(column)
                                                                          : titles_.sectionSizeHint(column);
    columns.push_back(titles_.isSectionHidden(column)
                          ? ColumnWidth{0, 0}
                          : ColumnWidth{std::max(title, cells_[static_cast<std::size_t>(column)]),
                                        std::max(kLeastWidth, title)});
  }
  return sharedWidths(columns, list_.viewport()->width());
}

/// Makes room in a crowded list, taken from the widest other column.
void ColumnWidths::makeRoomForArrow(int column) {
  const int lacks = titles_.sectionSizeHint(column) - titles_.sectionSize(column);
  if (chosen_ || lacks <= 0 || titles_.isSectionHidden(column)) {
    return;
  }
  int widest = -1;
  for (int other = 0; other < titles_.count(); ++other) {
    if (other != column && (widest < 0 || titles_.sectionSize(other) > titles_.sectionSize(widest))) {
      widest = other;
    }
  }
  sharing_ = true;
  if (widest >= 0 && titles_.sectionSize(widest) - lacks >= kLeastWidth) {
    titles_.resizeSection(widest, titles_.sectionSize(widest) - lacks);
  }
  titles_.resizeSection(column, titles_.sectionSize(column) + lacks);
  sharing_ = false;
}

void ColumnWidths::share() {
  if (chosen_ || wanted_.size() != static_cast<std::size_t>(titles_.count())) {
    return;
  }
  const bool crowded = std::accumulate(wanted_.begin(), wanted_.end(), 0) > list_.viewport()->width();
  const std::vector<int> widths = widths_px(crowded);
  sharing_ = true;
  for (int column = 0; column < titles_.count(); ++column) {
    if (!titles_.isSectionHidden(column)) {
      titles_.resizeSection(column, widths[static_cast<std::size_t>(column)]);
    }
  }
  sharing_ = false;
  if (wraps_) {
    list_.setWordWrap(whole_px() > list_.width());
  }
}

void ColumnWidths::setHidden(int column, bool hidden) {
  if (titles_.isSectionHidden(column) == hidden) {
    return;
  }
  titles_.setSectionHidden(column, hidden);
  // It had no width while hidden: fits it now, not when the list is filled next.
  if (!chosen_) {
    fit(false);
  } else if (!hidden && titles_.sectionSize(column) < kLeastWidth) {
    list_.resizeColumnToContents(column);
  }
}

}  // namespace torsio::gui
