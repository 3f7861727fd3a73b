// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QHeaderView>

class QTableView;

namespace torsio::gui {

struct ColumnWidth {
  int wanted_px = 0;  ///< shows all content
  int least_px = 0;   ///< minimum width
};

/// Distributes widths: if the columns are wider than the list, the widest shrink, pixel by pixel and the
/// first of several, to avoid horizontal scrolling as long as the list is legible. If the list is wider, all
/// grow equally, at most to three times their width, so that rows stay easy to follow. Returns px, one per
/// column.
[[nodiscard]] std::vector<int> sharedWidths(const std::vector<ColumnWidth>& columns, int list_px);

/// Column titles; a number's title has the same padding as the numbers below.
class ColumnTitles final : public QHeaderView {
 public:
  explicit ColumnTitles(QWidget* parent);
  /// Returns a title's unclipped width without the sort arrow, px.
  [[nodiscard]] int unsortedWidth(int column) const;

 protected:
  void paintSection(QPainter* painter, const QRect& rect, int column) const override;
  [[nodiscard]] QSize sectionSizeFromContents(int column) const override;
};

/// Returns the extra padding right of a number with this alignment, before the next column, px.
[[nodiscard]] int afterNumber(Qt::Alignment alignment);

/// The widths of a list's columns: they share the list's width until the user chooses widths, order, hidden
/// columns or sorting. Creates the list's column titles and belongs to the list. GUI thread.
class ColumnWidths final : public QObject {
 public:
  explicit ColumnWidths(QTableView& list);

  /// Fits columns to their content; unless `first`, they only grow, so that a list that refreshes itself does
  /// not move.
  void fit(bool first);
  /// Distributes the list's width. Call when it has changed.
  void share();
  /// Lets the last column fill a wide list, except for a number, which would be far from its context.
  void letLastFill();
  void setHidden(int column, bool hidden);
  /// Wraps texts when the list is too narrow.
  void wrapWhatIsCut();
  /// Returns the width at which no visible cell is clipped.
  [[nodiscard]] int whole_px() const;

  /// Whether the user has moved, resized, hidden or sorted columns: they then keep their widths.
  void setChosen(bool chosen) noexcept { chosen_ = chosen; }
  [[nodiscard]] bool chosen() const noexcept { return chosen_; }

 private:
  void measure(bool first);
  /// Returns widths that fill the list, px; in a crowded one, titles have no room for the sort arrow.
  [[nodiscard]] std::vector<int> widths_px(bool crowded) const;
  void makeRoomForArrow(int column);

  QTableView& list_;
  ColumnTitles& titles_;
  std::vector<int> cells_;   // width of each column without clipping, px
  std::vector<int> wanted_;  // width of its title with the sort arrow
  bool wraps_ = false;
  bool sharing_ = false;  // resizing columns, not the user
  bool chosen_ = false;
};

}  // namespace torsio::gui
