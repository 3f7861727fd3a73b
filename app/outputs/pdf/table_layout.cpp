// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/table_layout.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <QFontMetricsF>
#include <QRectF>
#include <QStringView>

#include "app/outputs/charts/text_fit.h"
#include "app/outputs/wording/printed_minus.h"

namespace torsio {

namespace {

constexpr std::array kPoints{7.5, 7.0, 6.5, 6.0, 5.5};
constexpr double kShortCell_mm = 34.0;  // shorter cells stay on one line
constexpr double kShortHeader_mm = 19.0;
constexpr double kHalf = 0.6;         // of a header: lets it break into two uneven lines
constexpr double kRounding_mm = 0.6;  // a cell exactly as wide as its text would wrap
constexpr double kMargin_mm = 2.0 * kCellPadding_mm + kRounding_mm;
constexpr double kMaxStretch = 1.35;

/// Accepts numbers and their substitutes: "< 0.001", "4, 54".
bool looksNumeric(const QString& cell) {
  static const QString kSigns = QStringLiteral("0123456789.,+-eE%<= ");
  const QString plain = plainMinus(cell);
  return !plain.isEmpty() &&
         std::all_of(plain.begin(), plain.end(), [](QChar sign) { return kSigns.contains(sign); });
}

/// Widths for each column: longest word, shortest width that keeps short cells on one line, longest cell, and
/// preferred header width.
struct Demand {
  std::vector<double> least;
  std::vector<double> wanted;
  std::vector<double> cells;
  std::vector<double> natural;
};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Headers may wrap, so only their words count; a short one stays whole, others take two lines if there is
/// room.
Demand demandOf(const PlainTable& table, const QFontMetricsF& regular, const QFontMetricsF& bold,
                double unit) {
  Demand demand;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const double whole = bold.horizontalAdvance(table.columns[c]) / unit;
    const double head = widestPart(table.columns[c], bold) / unit;
    double word = head;
    double wanted = head;
    double longest = head;
    const double header = std::max(head, whole <= kShortHeader_mm ? whole : kHalf * whole);
    for (const std::vector<QString>& row : table.rows) {
      const double cell = regular.horizontalAdvance(row[c]) / unit;
      longest = std::max(longest, cell);
      if (cell <= kShortCell_mm) {
        wanted = std::max(wanted, cell);
        if (cell <= word) {
          continue;  // its words are even shorter
        }
      }
      word = std::max(word, widestPart(row[c], regular) / unit);
    }
    demand.least.push_back(word + kMargin_mm);
    demand.wanted.push_back(std::max(word, wanted) + kMargin_mm);
    demand.cells.push_back(std::max(word, longest) + kMargin_mm);
    demand.natural.push_back(std::max({word, longest, header}) + kMargin_mm);
  }
  return demand;
}

/// Widens columns from `from` towards `to`, first those that lack little.
std::vector<double> widened(const std::vector<double>& from, const std::vector<double>& to,
                            double available_mm) {
  std::vector<double> widths = from;
  std::vector<std::size_t> order(widths.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return to[a] - from[a] < to[b] - from[b]; });
  double room = available_mm - sum(from);
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t c = order[place];
    const double given = std::min(to[c] - from[c], room / static_cast<double>(order.size() - place));
    widths[c] += given;
    room -= given;
  }
  return widths;
}

std::vector<double> widthsFor(const Demand& demand, double available_mm) {
  const double least = sum(demand.least);
  const double natural = sum(demand.natural);
  if (least > available_mm) {
    std::vector<double> widths = demand.least;
    for (double& width : widths) {
      width *= available_mm / least;
    }
    return widths;
  }
  if (natural <= available_mm) {
    std::vector<double> widths = demand.natural;
    for (double& width : widths) {
      width *= std::min(kMaxStretch, available_mm / natural);
    }
    return widths;
  }
  if (sum(demand.cells) <= available_mm) {
    return widened(demand.cells, demand.natural, available_mm);
  }
  if (sum(demand.wanted) <= available_mm) {
    return widened(demand.wanted, demand.cells, available_mm);
  }
  return widened(demand.least, demand.wanted, available_mm);
}

double heightOf(const std::vector<QString>& cells, const std::vector<double>& widths_mm,
                const QFontMetricsF& metrics, double unit) {
  constexpr double kAir_mm = 1.3;
  double tallest = metrics.height();
  for (std::size_t c = 0; c < cells.size(); ++c) {
    const double width = (widths_mm[c] - 2.0 * kCellPadding_mm) * unit;
    if (metrics.horizontalAdvance(cells[c]) <= width) {
      continue;
    }
    tallest = std::max(tallest,
                       metrics.boundingRect(QRectF(0, 0, width, 1e9), Qt::TextWordWrap, cells[c]).height());
  }
  return tallest / unit + kAir_mm;
}

}  // namespace

bool PlainTable::hasHeader() const {
  return std::any_of(columns.begin(), columns.end(), [](const QString& column) { return !column.isEmpty(); });
}

double TableLayout::height_mm() const {
  return header_mm + sum(rows_mm);
}

TableLayout layOut(const PlainTable& table, double available_mm, QPaintDevice& device, double unit,
                   const std::function<QFont(double points, bool bold)>& font) {
  TableLayout layout;
  Demand demand;
  for (const double points : kPoints) {
    layout.regular = font(points, false);
    layout.bold = font(points, true);
    demand =
        demandOf(table, QFontMetricsF(layout.regular, &device), QFontMetricsF(layout.bold, &device), unit);
    if (sum(demand.wanted) <= available_mm) {
      break;
    }
  }
  layout.widths_mm = widthsFor(demand, available_mm);
  layout.numeric.assign(table.columns.size(), !table.rows.empty());
  for (const std::vector<QString>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (!row[c].isEmpty() && !looksNumeric(row[c])) {
        layout.numeric[c] = false;
      }
    }
  }
  const QFontMetricsF regular(layout.regular, &device);
  if (table.hasHeader()) {
    layout.header_mm = heightOf(table.columns, layout.widths_mm, QFontMetricsF(layout.bold, &device), unit);
  }
  for (const std::vector<QString>& row : table.rows) {
    layout.rows_mm.push_back(heightOf(row, layout.widths_mm, regular, unit));
  }
  return layout;
}

}  // namespace torsio
