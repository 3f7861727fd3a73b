// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/page_flow.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <QFontMetricsF>
#include <QPageSize>
#include <QPdfWriter>

namespace torsio {

namespace {

constexpr double kPageWidth_mm = 210.0;
constexpr double kPageHeight_mm = 297.0;
constexpr double kTablePoints = 7.5;
constexpr double kCellPadding_mm = 1.4;
const QColor kInk(0x26, 0x32, 0x38);
const QColor kQuiet(0x60, 0x6E, 0x76);
const QColor kHeaderFill(0xE4, 0xEC, 0xF2);
const QColor kRule(0xC3, 0xCD, 0xD3);
const QColor kWarning(0xA0, 0x4A, 0x00);

bool looksNumeric(const std::string& cell) {
  return !cell.empty() && cell.find_first_not_of("0123456789.,+-eE% ") == std::string::npos;
}

/// The longest word of a text: the narrowest that a cell may become.
double widestWord(const QString& content, const QFontMetricsF& metrics) {
  double widest = 0.0;
  for (const QString& word : content.split(' ')) widest = std::max(widest, metrics.horizontalAdvance(word));
  return widest;
}

/// Every column gets its longest word; what is left goes first to those that lack little, so that short cells
/// ("Group 1") stay on one line and long sentences wrap. Headers may wrap, so only their words count.
std::vector<double> columnWidths(const std::vector<std::string>& columns,
                                 const std::vector<std::vector<std::string>>& rows,
                                 const QFontMetricsF& regular, const QFontMetricsF& bold, double unit,
                                 double available_mm) {
  constexpr double kRounding_mm = 0.6;  // a cell exactly as wide as its text would wrap
  const double margin_mm = 2.0 * kCellPadding_mm + kRounding_mm;
  std::vector<double> least;
  std::vector<double> natural;
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double word = widestWord(QString::fromStdString(columns[c]), bold);
    double full = word;
    for (const auto& row : rows) {
      const QString cell = QString::fromStdString(row[c]);
      word = std::max(word, widestWord(cell, regular));
      full = std::max(full, regular.horizontalAdvance(cell));
    }
    least.push_back(word / unit + margin_mm);
    natural.push_back(full / unit + margin_mm);
  }
  const double leastSum = std::accumulate(least.begin(), least.end(), 0.0);
  const double lacking = std::accumulate(natural.begin(), natural.end(), 0.0) - leastSum;
  std::vector<double> widths = least;
  if (leastSum > available_mm) {
    for (double& width : widths) width *= available_mm / leastSum;
  } else if (leastSum + lacking <= available_mm) {
    for (std::size_t c = 0; c < widths.size(); ++c)
      widths[c] = natural[c] * std::min(1.35, available_mm / (leastSum + lacking));
  } else {
    std::vector<std::size_t> order(widths.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return natural[a] - least[a] < natural[b] - least[b];
    });
    double room = available_mm - leastSum;
    for (std::size_t place = 0; place < order.size(); ++place) {
      const std::size_t c = order[place];
      const double share = room / static_cast<double>(order.size() - place);
      const double given = std::min(natural[c] - least[c], share);
      widths[c] += given;
      room -= given;
    }
  }
  return widths;
}

}  // namespace

PageFlow::PageFlow(QPdfWriter& writer, Style style)
    : writer_(writer), style_(std::move(style)), unit_(writer.resolution() / 25.4), cursor_mm_(0.0) {
  newPage();
}

double PageFlow::width_mm() const {
  return kPageWidth_mm - 2.0 * style_.marginSide_mm;
}

double PageFlow::bottom_mm() const {
  return kPageHeight_mm - style_.marginBottom_mm;
}

QFont PageFlow::font(double points, bool bold) const {
  QFont f(QStringLiteral("DejaVu Sans"));
  f.setPointSizeF(points);
  f.setBold(bold);
  return f;
}

void PageFlow::newPage() {
  if (!pages_.empty() && pages_.back().empty()) return;
  pages_.emplace_back();
  cursor_mm_ = style_.marginTop_mm;
}

void PageFlow::add(double height_mm, Draw draw, double keepWithNext_mm) {
  if (cursor_mm_ + height_mm + keepWithNext_mm > bottom_mm()) newPage();
  pages_.back().push_back({cursor_mm_, height_mm, std::move(draw)});
  cursor_mm_ += height_mm;
}

double PageFlow::room_mm() const {
  return bottom_mm() - cursor_mm_;
}

void PageFlow::space(double height_mm) {
  if (!pages_.back().empty()) cursor_mm_ += height_mm;
}

void PageFlow::text(const QString& content, double points, bool bold, const QColor& colour,
                    double keepWithNext_mm) {
  const QFont f = font(points, bold);
  const QFontMetricsF metrics(f, &writer_);
  const QRectF room(0, 0, width_mm() * unit_, 1e9);
  const int flags = Qt::AlignLeft | Qt::TextWordWrap;
  const double height_mm = metrics.boundingRect(room, flags, content).height() / unit_ + 0.6;
  add(
      height_mm,
      [=](QPainter& painter, const QRectF& area, double) {
        painter.setFont(f);
        painter.setPen(colour);
        painter.drawText(area, flags, content);
      },
      keepWithNext_mm);
}

void PageFlow::table(const std::vector<std::string>& columns,
                     const std::vector<std::vector<std::string>>& rows) {
  const QFont regular = font(kTablePoints, false);
  const QFont bold = font(kTablePoints, true);
  const QFontMetricsF regularMetrics(regular, &writer_);
  const QFontMetricsF boldMetrics(bold, &writer_);
  const std::vector<double> widths =
      columnWidths(columns, rows, regularMetrics, boldMetrics, unit_, width_mm());
  std::vector<bool> numeric(columns.size(), !rows.empty());
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (!row[c].empty() && !looksNumeric(row[c])) numeric[c] = false;
    }
  }
  const int wrap = Qt::TextWordWrap | Qt::AlignVCenter;
  const auto rowHeight = [&](const std::vector<std::string>& cells, const QFontMetricsF& metrics) {
    double tallest = 0.0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
      const QRectF room(0, 0, (widths[c] - 2.0 * kCellPadding_mm) * unit_, 1e9);
      tallest =
          std::max(tallest, metrics.boundingRect(room, wrap, QString::fromStdString(cells[c])).height());
    }
    return tallest / unit_ + 1.6;
  };
  const auto drawRow = [=](const std::vector<std::string>& cells, const QFont& f, const QColor& fill) {
    return [=](QPainter& painter, const QRectF& area, double unit) {
      double x = area.left();
      const double total = std::accumulate(widths.begin(), widths.end(), 0.0) * unit;
      if (fill.isValid()) painter.fillRect(QRectF(x, area.top(), total, area.height()), fill);
      painter.setPen(QPen(kRule, 0.15 * unit));
      painter.drawLine(QPointF(x, area.bottom()), QPointF(x + total, area.bottom()));
      painter.setFont(f);
      painter.setPen(kInk);
      for (std::size_t c = 0; c < cells.size(); ++c) {
        const QRectF cell(x + kCellPadding_mm * unit, area.top(), (widths[c] - 2.0 * kCellPadding_mm) * unit,
                          area.height());
        painter.drawText(cell, wrap | (numeric[c] ? Qt::AlignRight : Qt::AlignLeft),
                         QString::fromStdString(cells[c]));
        x += widths[c] * unit;
      }
    };
  };
  const double headerHeight = rowHeight(columns, boldMetrics);
  const auto header = [&] { add(headerHeight, drawRow(columns, bold, kHeaderFill), 6.0); };
  header();
  for (const auto& row : rows) {
    const double height = rowHeight(row, regularMetrics);
    if (cursor_mm_ + height > bottom_mm()) {
      newPage();
      header();
    }
    add(height, drawRow(row, regular, QColor()));
  }
}

void PageFlow::drawFrame(QPainter& painter, std::size_t page, double unit) const {
  const double left = style_.marginSide_mm * unit;
  const double wide = width_mm() * unit;
  painter.setFont(font(7.5, false));
  painter.setPen(kQuiet);
  const QRectF foot(left, (kPageHeight_mm - 14.0) * unit, wide, 6.0 * unit);
  painter.drawText(foot, Qt::AlignLeft | Qt::AlignVCenter, style_.footerText);
  painter.drawText(foot, Qt::AlignRight | Qt::AlignVCenter,
                   QStringLiteral("page %1 of %2").arg(page + 1).arg(pages_.size()));
  const QRectF head(left, 9.0 * unit, wide, 6.0 * unit);
  if (page > 0) painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter, style_.headerText);
  if (!style_.watermark.isEmpty()) {
    painter.setFont(font(8.0, true));
    painter.setPen(kWarning);
    painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, style_.watermark);
  }
}

void PageFlow::render(QPainter& painter,
                      const std::function<void(std::size_t page, std::size_t pages)>& progress) const {
  for (std::size_t page = 0; page < pages_.size(); ++page) {
    if (page > 0) writer_.newPage();
    drawFrame(painter, page, unit_);
    for (const Block& block : pages_[page]) {
      painter.save();
      block.draw(painter,
                 QRectF(style_.marginSide_mm * unit_, block.top_mm * unit_, width_mm() * unit_,
                        block.height_mm * unit_),
                 unit_);
      painter.restore();
    }
    if (progress) progress(page + 1, pages_.size());
  }
}

}  // namespace torsio
