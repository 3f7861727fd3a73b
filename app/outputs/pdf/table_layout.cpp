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
  static const QString kSigns = QStringLiteral("0123456789.,+-eE%<= \u00A0");
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

/// Returns widths with which no cell takes more than `lines` lines, or nothing if there is no room for them.
std::vector<double> widthsOfLines(const Demand& demand, int lines, double available_mm) {
  constexpr double kUneven = 1.15;  // lines break between words, so none is quite full
  std::vector<double> widths;
  for (std::size_t c = 0; c < demand.least.size(); ++c) {
    const double share = kUneven * (demand.cells[c] - kMargin_mm) / lines + kMargin_mm;
    widths.push_back(std::max(demand.least[c], std::min(demand.cells[c], share)));
  }
  return sum(widths) <= available_mm ? widened(widths, demand.cells, available_mm) : std::vector<double>{};
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

namespace {

/// Measures cells in one size of letters.
struct Letters {
  QFont regular;
  QFont bold;
  QFontMetricsF ofCells;
  QFontMetricsF ofHeader;
  Demand demand;
};

Letters lettersOf(const PlainTable& table, double points, QPaintDevice& device, double unit,
                  const std::function<QFont(double points, bool bold)>& font) {
  Letters out{font(points, false),
              font(points, true),
              QFontMetricsF(font(points, false), &device),
              QFontMetricsF(font(points, true), &device),
              {}};
  out.demand = demandOf(table, out.ofCells, out.ofHeader, unit);
  return out;
}

TableLayout withWidths(const PlainTable& table, const Letters& letters, std::vector<double> widths_mm,
                       double unit) {
  TableLayout layout;
  layout.regular = letters.regular;
  layout.bold = letters.bold;
  layout.widths_mm = std::move(widths_mm);
  layout.header_mm =
      table.hasHeader() ? heightOf(table.columns, layout.widths_mm, letters.ofHeader, unit) : 0.0;
  for (const std::vector<QString>& row : table.rows) {
    layout.rows_mm.push_back(heightOf(row, layout.widths_mm, letters.ofCells, unit));
  }
  return layout;
}

/// Returns the lowest layout: cells of several columns may take few lines where one would take many.
TableLayout lowest(const PlainTable& table, const Letters& letters, double available_mm, double unit) {
  TableLayout layout = withWidths(table, letters, widthsFor(letters.demand, available_mm), unit);
  if (sum(letters.demand.least) > available_mm || sum(letters.demand.cells) <= available_mm) {
    return layout;
  }
  for (const int lines : {2, 3, 4}) {
    if (std::vector<double> widths = widthsOfLines(letters.demand, lines, available_mm); !widths.empty()) {
      if (TableLayout other = withWidths(table, letters, std::move(widths), unit);
          other.height_mm() < layout.height_mm()) {
        layout = std::move(other);
      }
    }
  }
  return layout;
}

}  // namespace

TableLayout layOut(const PlainTable& table, double available_mm, QPaintDevice& device, double unit,
                   const std::function<QFont(double points, bool bold)>& font) {
  constexpr double kMuchLower = 0.75;     // for which smaller letters are worth it
  constexpr double kSmallForLower = 6.5;  // but not smaller
  TableLayout layout;
  bool chosen = false;
  for (const double points : kPoints) {
    if (chosen && points < kSmallForLower) {
      break;
    }
    const Letters letters = lettersOf(table, points, device, unit, font);
    if (TableLayout other = lowest(table, letters, available_mm, unit);
        !chosen || other.height_mm() < kMuchLower * layout.height_mm()) {
      layout = std::move(other);
    }
    chosen = chosen || sum(letters.demand.wanted) <= available_mm;
    if (chosen && sum(letters.demand.cells) <= available_mm) {
      break;  // nothing takes more than a line
    }
  }
  layout.numeric.assign(table.columns.size(), !table.rows.empty());
  for (const std::vector<QString>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) {
      if (!row[c].isEmpty() && !looksNumeric(row[c])) {
        layout.numeric[c] = false;
      }
    }
  }
  return layout;
}

}  // namespace torsio
