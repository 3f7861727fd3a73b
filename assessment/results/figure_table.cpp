// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/figure_table.h"

#include <algorithm>
#include <cmath>

#include "assessment/results/number_format.h"

namespace torsio {

namespace {

/// Writes the values of one figure.
class Twin {
 public:
  Twin(const ReportFigure& figure, int decimals) : figure_(figure), decimals_(decimals) {
    table_.id = "data-" + figure.id;
    table_.title = figure.title;
    table_.individual = figure.individual;
    table_.provenance = figure.provenance;
  }

  ReportTable take() {
    switch (figure_.kind) {
      case FigureKind::kBoxes:
        boxes();
        break;
      case FigureKind::kScatter:
        scatter();
        break;
      case FigureKind::kHeatMap:
        heatMap();
        break;
      case FigureKind::kReliefs:  // pictures have no values
        break;
      case FigureKind::kPoints:
        points();
        break;
      case FigureKind::kLines:
        if (figure_.categories.empty()) {
          scatter();
        } else {
          byCategory();
        }
        break;
      default:
        byCategory();
    }
    if (decimals_ != kExactDecimals) {
      for (std::size_t column = 1; column < table_.columns.size(); ++column) {
        dropIdleZeros(column);
      }
    }
    return std::move(table_);
  }

 private:
  /// Removes trailing zeros that all numbers of a column have: marks are "8.5", means "8.73".
  void dropIdleZeros(std::size_t column) {
    std::size_t idle = static_cast<std::size_t>(decimals_) + 1;  // including the point
    for (const std::vector<ReportCell>& row : table_.rows) {
      const std::string cell = row[column].str();
      if (cell.empty()) {
        continue;
      }
      const std::size_t last = cell.find_last_not_of('0');
      const auto point = cell.size() - std::min(cell.size(), static_cast<std::size_t>(decimals_) + 1);
      const bool number = cell.find_first_not_of("-0123456789.") == std::string::npos && cell[point] == '.';
      idle = !number ? 0 : std::min(idle, cell[last] == '.' ? cell.size() - last : cell.size() - 1 - last);
    }
    for (std::vector<ReportCell>& row : table_.rows) {
      if (std::string cell = row[column].str(); idle > 0 && !cell.empty()) {
        static_cast<Text&>(row[column]) = cell.substr(0, cell.size() - idle);
      }
    }
  }

  [[nodiscard]] std::string number(double value) const {
    return decimals_ == kExactDecimals ? formatExact(value) : formatFixed(value, decimals_);
  }
  [[nodiscard]] Text heading() const {
    return figure_.xLabel.empty() ? Text::tr("Category") : figure_.xLabel;
  }

  /// Returns a cell about the i-th value of a series.
  static ReportCell cell(const std::string& words, const FigureSeries& series, std::size_t i) {
    return {words, i < series.keys.size() ? series.keys[i] : nullptr};
  }

  /// Writes one row per category; a series with intervals needs three columns.
  void byCategory() {
    table_.columns = {heading()};
    for (const FigureSeries& series : figure_.series) {
      const bool alone = figure_.series.size() == 1;
      if (!series.low.empty()) {
        table_.columns.push_back(alone ? Text::tr("low") : Text::tr("%1: low", series.name));
      }
      table_.columns.push_back(alone && series.name.empty() ? Text::tr("value") : series.name);
      if (!series.low.empty()) {
        table_.columns.push_back(alone ? Text::tr("high") : Text::tr("%1: high", series.name));
      }
    }
    for (std::size_t c = 0; c < figure_.categories.size(); ++c) {
      std::vector<ReportCell> row = {figure_.categories[c]};
      for (const FigureSeries& series : figure_.series) {
        const bool known = c < series.y.size() && series.y[c].has_value();
        if (!series.low.empty()) {
          row.push_back(cell(known ? number(series.low[c]) : std::string(), series, c));
        }
        row.push_back(cell(known ? number(*series.y[c]) : std::string(), series, c));
        if (!series.low.empty()) {
          row.push_back(cell(known ? number(series.high[c]) : std::string(), series, c));
        }
      }
      table_.rows.push_back(row);
    }
  }

  /// Writes one row per category with the value of each series.
  void points() {
    table_.columns = {heading()};
    for (const FigureSeries& series : figure_.series) {
      table_.columns.push_back(series.name);
    }
    for (std::size_t c = 0; c < figure_.categories.size(); ++c) {
      std::vector<ReportCell> row = {figure_.categories[c]};
      for (const FigureSeries& series : figure_.series) {
        ReportCell cell;
        for (std::size_t i = 0; i < series.y.size(); ++i) {
          const std::size_t at = i < series.x.size() ? static_cast<std::size_t>(series.x[i]) : i;
          if (at != c || !series.y[i]) {
            continue;
          }
          cell = Twin::cell(cell.str() + (cell.empty() ? "" : "; ") + number(*series.y[i]), series, i);
        }
        row.push_back(std::move(cell));
      }
      table_.rows.push_back(row);
    }
  }

  void boxes() {
    table_.columns = {Text::tr("Series"),         Text::tr("Values"), Text::tr("Lower whisker"),
                      Text::tr("Lower quartile"), Text::tr("Median"), Text::tr("Upper quartile"),
                      Text::tr("Upper whisker"),  Text::tr("Mean"),   Text::tr("Outside")};
    for (const FigureSeries& series : figure_.series) {
      const BoxSummary box = series.box.value_or(BoxSummary{});
      std::string outside;
      for (const double value : box.outliers) {
        outside += (outside.empty() ? "" : "; ") + number(value);
      }
      std::vector<ReportCell> row{series.name};
      for (const std::string& words :
           {std::to_string(series.y.size()), number(box.lowerWhisker), number(box.lowerQuartile),
            number(box.median), number(box.upperQuartile), number(box.upperWhisker), number(box.mean)}) {
        row.emplace_back(words, series.boxKey);
      }
      row.emplace_back(outside, series.boxKey);
      table_.rows.push_back(std::move(row));
    }
  }

  void scatter() {
    const bool intervals = std::any_of(figure_.series.begin(), figure_.series.end(),
                                       [](const FigureSeries& one) { return !one.low.empty(); });
    table_.columns = {Text::tr("Series"), heading(), figure_.yLabel};
    if (intervals) {
      table_.columns.insert(table_.columns.end(), {Text::tr("low"), Text::tr("high")});
    }
    for (const FigureSeries& series : figure_.series) {
      if (series.faint && figure_.kind == FigureKind::kScatter) {
        continue;  // a reference line has no values of its own
      }
      for (std::size_t i = 0; i < series.y.size(); ++i) {
        if (!series.y[i]) {
          continue;
        }
        const double x = i < series.x.size() ? series.x[i] : static_cast<double>(i + 1);
        table_.rows.push_back({series.name, cell(x == std::floor(x) ? formatExact(x) : number(x), series, i),
                               cell(number(*series.y[i]), series, i)});
        if (intervals) {
          const bool known = i < series.low.size() && i < series.high.size();
          table_.rows.back().push_back(cell(known ? number(series.low[i]) : std::string(), series, i));
          table_.rows.back().push_back(cell(known ? number(series.high[i]) : std::string(), series, i));
        }
      }
    }
  }

  void heatMap() {
    table_.columns = {heading()};
    table_.columns.insert(table_.columns.end(), figure_.categories.begin(), figure_.categories.end());
    for (const FigureSeries& series : figure_.series) {
      std::vector<ReportCell> row = {series.name};
      for (std::size_t c = 0; c < figure_.categories.size(); ++c) {
        row.push_back(
            cell(c < series.y.size() && series.y[c] ? number(*series.y[c]) : std::string(), series, c));
      }
      table_.rows.push_back(row);
    }
  }

  const ReportFigure& figure_;
  int decimals_;
  ReportTable table_;
};

}  // namespace

ReportTable figureTable(const ReportFigure& figure, int decimals) {
  return Twin(figure, decimals).take();
}

}  // namespace torsio
