// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/page_flow.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <QFontMetricsF>
#include <QPageSize>
#include <QPdfWriter>

#include "app/outputs/charts/chart_style.h"
#include "app/outputs/charts/typeface.h"

namespace torsio {

namespace {

constexpr double kPageWidth_mm = 210.0;
constexpr double kPageHeight_mm = 297.0;
constexpr double kBetweenColumns_mm = 6.0;
constexpr double kReference_pt = 5.5;  // fits a hash in each of two lines
constexpr int kTextFlags = Qt::AlignLeft | Qt::TextWordWrap;
const QColor kInk(0x26, 0x32, 0x38);
const QColor kHeaderFill(0xE4, 0xEC, 0xF2);
const QColor kRule(0xC3, 0xCD, 0xD3);

}  // namespace

PageFlow::PageFlow(QPdfWriter& writer, Style style)
    : writer_(writer), style_(std::move(style)), unit_(writer.resolution() / 25.4), cursor_mm_(0.0) {
  newPage();
}

double PageFlow::width_mm() const {
  return columns_ ? columnWidth_mm() : kPageWidth_mm - 2.0 * style_.marginSide_mm;
}

double PageFlow::columnWidth_mm() const {
  return 0.5 * (kPageWidth_mm - 2.0 * style_.marginSide_mm - kBetweenColumns_mm);
}

void PageFlow::beginColumns(double height_mm) {
  if (cursor_mm_ + height_mm > bottom_mm()) {
    newPage();
  }
  columns_ = Columns{false, cursor_mm_, cursor_mm_};
}

void PageFlow::nextColumn() {
  columns_->lowest_mm = cursor_mm_;
  columns_->right = true;
  cursor_mm_ = columns_->top_mm;
}

void PageFlow::endColumns() {
  cursor_mm_ = std::max(columns_->lowest_mm, cursor_mm_);
  columns_.reset();
}

double PageFlow::bottom_mm() const {
  return kPageHeight_mm - style_.marginBottom_mm;
}

QFont PageFlow::font(double points, bool bold) const {
  QFont f = printedTypeface();
  f.setPointSizeF(points);
  f.setBold(bold);
  return f;
}

void PageFlow::newPage() {
  if (!pages_.empty() && pages_.back().empty()) {
    return;
  }
  pages_.emplace_back();
  cursor_mm_ = style_.marginTop_mm;
}

void PageFlow::add(double height_mm, Draw draw, double keepWithNext_mm, PdfPart part) {
  if (!columns_ && cursor_mm_ + height_mm + keepWithNext_mm > bottom_mm()) {
    newPage();
  }
  const double left_mm =
      style_.marginSide_mm + (columns_ && columns_->right ? columnWidth_mm() + kBetweenColumns_mm : 0.0);
  pages_.back().push_back({left_mm, width_mm(), cursor_mm_, height_mm, std::move(draw), std::move(part)});
  cursor_mm_ += height_mm;
}

double PageFlow::room_mm() const {
  return bottom_mm() - cursor_mm_;
}

void PageFlow::space(double height_mm) {
  if (!pages_.back().empty()) {
    cursor_mm_ += height_mm;
  }
}

double PageFlow::textHeight_mm(const QString& content, double points, bool bold, double width_mm) const {
  const QFontMetricsF metrics(font(points, bold), &writer_);
  const QRectF room(0, 0, width_mm * unit_, 1e9);
  return metrics.boundingRect(room, kTextFlags, content).height() / unit_ + 0.6;
}

void PageFlow::text(const QString& content, double points, bool bold, const QColor& colour,
                    double keepWithNext_mm) {
  const QFont f = font(points, bold);
  add(textHeight_mm(content, points, bold),
      [=](QPainter& painter, const QRectF& area, double) {
        painter.setFont(f);
        painter.setPen(colour);
        painter.drawText(area, kTextFlags, content);
      },
      keepWithNext_mm, {PdfRole::kParagraph});
}

void PageFlow::bookmark(const QString& title, int level) {
  if (!pages_.back().empty()) {
    bookmarks_.push_back({title, pages_.size() - 1, pages_.back().back().top_mm, level});
    pages_.back().back().part.role = level == 0 ? PdfRole::kSection : PdfRole::kTitle;
  }
}

TableLayout PageFlow::layOut(const PlainTable& table, double width_mm) const {
  return torsio::layOut(table, width_mm, writer_, unit_,
                        [this](double points, bool bold) { return font(points, bold); });
}

void PageFlow::table(const PlainTable& table) {
  this->table(table, layOut(table));
}

PageFlow::Draw PageFlow::drawnRow(const std::vector<QString>& cells, const TableLayout& layout,
                                  std::size_t number, PdfRole role, std::size_t row) {
  const double total_mm = std::accumulate(layout.widths_mm.begin(), layout.widths_mm.end(), 0.0);
  const bool header = row == 0;
  return
      [this, cells, number, role, row, total_mm, header, widths = layout.widths_mm, numeric = layout.numeric,
       letters = header ? layout.bold : layout.regular](QPainter& painter, const QRectF& area, double unit) {
        double x = area.left();
        const double total = total_mm * unit;
        if (header) {
          painter.fillRect(QRectF(x, area.top(), total, area.height()), kHeaderFill);
        }
        painter.setPen(QPen(kRule, 0.15 * unit));
        painter.drawLine(QPointF(x, area.bottom()), QPointF(x + total, area.bottom()));
        painter.setFont(letters);
        painter.setPen(kInk);
        for (std::size_t c = 0; c < cells.size(); ++c) {
          const QRectF cell(x + kCellPadding_mm * unit, area.top(),
                            (widths[c] - 2.0 * kCellPadding_mm) * unit, area.height());
          if (role != PdfRole::kArtifact) {
            begin(painter, {role, {}, 0, number, row});
            painter.setPen(kInk);
          }
          painter.drawText(
              cell, Qt::TextWordWrap | Qt::AlignVCenter | (numeric[c] ? Qt::AlignRight : Qt::AlignLeft),
              cells[c]);
          x += widths[c] * unit;
        }
      };
}

void PageFlow::addHeader(const PlainTable& table, const TableLayout& layout, std::size_t number,
                         PdfRole role) {
  if (layout.header_mm > 0.0) {
    add(layout.header_mm, drawnRow(table.columns, layout, number, role, 0), 6.0);
  }
}

void PageFlow::addRow(const PlainTable& table, const TableLayout& layout, std::size_t number,
                      std::size_t row) {
  add(layout.rows_mm[row], drawnRow(table.rows[row], layout, number, PdfRole::kCell, row + 1));
}

void PageFlow::table(const PlainTable& table, const TableLayout& layout, double keepWithLast_mm) {
  const std::size_t number = ++tables_;
  addHeader(table, layout, number, PdfRole::kHeaderCell);
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    const std::size_t left = table.rows.size() - r - 1;  // no row stands alone on the next page
    const double under_mm = left == 0   ? keepWithLast_mm
                            : left == 1 ? layout.rows_mm[r + 1] + keepWithLast_mm
                                        : 0.0;
    if (cursor_mm_ + layout.rows_mm[r] + under_mm > bottom_mm()) {
      newPage();
      addHeader(table, layout, number, PdfRole::kArtifact);  // readers have heard it already
    }
    addRow(table, layout, number, r);
  }
}

void PageFlow::tableInColumns(const PlainTable& table, const TableLayout& layout) {
  const std::size_t number = ++tables_;
  double left_mm = std::accumulate(layout.rows_mm.begin(), layout.rows_mm.end(), 0.0);
  std::size_t next = 0;
  const auto addColumn = [&](double height_mm) {
    addHeader(table, layout, number, next == 0 ? PdfRole::kHeaderCell : PdfRole::kArtifact);
    double added_mm = 0.0;
    const std::size_t first = next;  // a row that is higher than a page stands alone
    while (next < table.rows.size() && (next == first || added_mm + layout.rows_mm[next] <= height_mm)) {
      added_mm += layout.rows_mm[next];
      addRow(table, layout, number, next++);
    }
    left_mm -= added_mm;
  };
  while (next < table.rows.size()) {
    const double tallest_mm = *std::max_element(layout.rows_mm.begin(), layout.rows_mm.end());
    const double half_mm = 0.5 * left_mm + tallest_mm;
    if (room_mm() < layout.header_mm + std::min(half_mm, 2.0 * tallest_mm)) {
      newPage();
    }
    constexpr double kRounding_mm = 0.01;
    const double height_mm = std::min(half_mm, room_mm() - layout.header_mm - kRounding_mm);
    beginColumns(layout.header_mm + height_mm);
    addColumn(height_mm);
    nextColumn();
    if (next < table.rows.size()) {
      addColumn(height_mm);
    }
    endColumns();
    if (next < table.rows.size()) {
      newPage();
    }
  }
}

void PageFlow::begin(QPainter& painter, PdfPart part) {
  part.page = page_;
  markPart(painter, parts_.size());
  parts_.push_back(std::move(part));
}

void PageFlow::drawFrame(QPainter& painter, std::size_t page, double unit) {
  begin(painter, {});
  const double left = style_.marginSide_mm * unit;
  const double wide = width_mm() * unit;
  painter.setFont(font(7.5, false));
  painter.setPen(kQuietInk);
  const QRectF foot(left, (kPageHeight_mm - 14.0) * unit, wide, 6.0 * unit);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, style_.footerText);
  painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter, style_.pageText(page + 1, pages_.size()));
  if (!style_.reference.isEmpty()) {
    painter.setFont(font(kReference_pt, false));
    painter.drawText(QRectF(left, (kPageHeight_mm - 9.2) * unit, wide, 5.2 * unit),
                     Qt::AlignLeft | Qt::AlignVCenter, style_.reference);
  }
  const QRectF head(left, 9.0 * unit, wide, 6.0 * unit);
  if (page > 0) {
    painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, style_.headerText);
  }
  if (!style_.watermark.isEmpty()) {
    painter.setFont(font(8.0, true));
    painter.setPen(kWarningInk);
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, style_.watermark);
  }
}

void PageFlow::render(QPainter& painter,
                      const std::function<void(std::size_t page, std::size_t pages)>& progress) {
  for (std::size_t page = 0; page < pages_.size(); ++page) {
    if (page > 0) {
      writer_.newPage();
    }
    page_ = page;
    drawFrame(painter, page, unit_);
    for (const Block& block : pages_[page]) {
      begin(painter, block.part);
      painter.save();
      block.draw(painter,
                 QRectF(block.left_mm * unit_, block.top_mm * unit_, block.width_mm * unit_,
                        block.height_mm * unit_),
                 unit_);
      painter.restore();
    }
    if (progress) {
      progress(page + 1, pages_.size());
    }
  }
}

}  // namespace torsio
