// SPDX-License-Identifier: GPL-3.0-or-later
// The figures of a report as native spreadsheet charts, with their data in cells next to them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <xlsxwriter.h>

#include "app/outputs/tables/workbook_sheets.h"

namespace torsio {

namespace {

constexpr std::uint16_t kChartColumn = 10;
constexpr std::uint32_t kChartRows = 20;

/// Cell range of a figure.
struct Block {
  std::uint32_t first = 0;  ///< row of the first numbers, below the heading
  std::uint32_t rows = 0;
  [[nodiscard]] std::uint32_t last() const noexcept { return first + std::max(rows, 1U) - 1; }
};

class FigureWriter {
 public:
  FigureWriter(lxw_workbook* workbook, const std::string& sheetName, SheetPen& pen,
               const WorkbookFormats& formats, const ExportWording& say)
      : book_(workbook), name_(sheetName), pen_(pen), formats_(formats), say_(say) {}

  /// Writes a figure and returns the row below it.
  std::uint32_t write(const ReportFigure& figure, std::uint32_t row) {
    pen_.text(row, 0, say_(figure.title), formats_.title);
    const std::uint32_t head = row + 2;
    lxw_chart* chart = nullptr;
    Block block;
    switch (figure.kind) {
      case FigureKind::kGroupedBars:
      case FigureKind::kRanges:
      case FigureKind::kForest:
      case FigureKind::kHeatMap:
        block = byCategory(figure, head);
        chart = figure.kind == FigureKind::kHeatMap ? nullptr : bars(figure, block);
        break;
      case FigureKind::kBoxes:
        block = boxes(figure, head);
        chart = boxChart(figure, block);
        break;
      case FigureKind::kLines:
      case FigureKind::kPoints:
      case FigureKind::kScatter:
        block = points(figure, head, chart);
        break;
      case FigureKind::kReliefs:  // pictures have no numbers
        break;
    }
    if (chart != nullptr) {
      finish(figure, chart, row);
    }
    return std::max(block.last() + 3, row + kChartRows + 4);
  }

 private:
  [[nodiscard]] std::string categoryOf(const ReportFigure& figure, std::size_t i) const {
    return i < figure.categories.size() ? say_(figure.categories[i]) : std::to_string(i + 1);
  }

  /// Writes one row per category and one column per series, with intervals if there are any.
  Block byCategory(const ReportFigure& figure, std::uint32_t head) {
    std::size_t count = figure.categories.size();
    std::uint16_t column = 1;
    columns_.clear();
    const bool intervals = figure.kind == FigureKind::kRanges || figure.kind == FigureKind::kForest;
    for (const FigureSeries& series : figure.series) {
      count = std::max(count, series.y.size());
      columns_.push_back(column);
      pen_.text(head, column++, say_(series.name), formats_.heading);
      if (intervals) {
        pen_.text(head, column++, say_(Text::tr("low")), formats_.heading);
        pen_.text(head, column++, say_(Text::tr("high")), formats_.heading);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto row = static_cast<std::uint32_t>(head + 1 + i);
      pen_.text(row, 0, categoryOf(figure, i));
      for (std::size_t s = 0; s < figure.series.size(); ++s) {
        const FigureSeries& series = figure.series[s];
        if (i < series.y.size() && series.y[i]) {
          pen_.number(row, columns_[s], *series.y[i], formats_.figure);
        }
        if (intervals && i < series.low.size() && i < series.high.size()) {
          pen_.number(row, static_cast<std::uint16_t>(columns_[s] + 1), series.low[i], formats_.figure);
          pen_.number(row, static_cast<std::uint16_t>(columns_[s] + 2), series.high[i], formats_.figure);
        }
      }
    }
    return {head + 1, static_cast<std::uint32_t>(count)};
  }

  lxw_chart_series* addSeries(lxw_chart* chart, const Block& block, std::uint16_t x, std::uint16_t y,
                              const std::string& name) {
    lxw_chart_series* series = chart_add_series(chart, nullptr, nullptr);
    chart_series_set_categories(series, name_.c_str(), block.first, x, block.last(), x);
    chart_series_set_values(series, name_.c_str(), block.first, y, block.last(), y);
    chart_series_set_name(series, name.c_str());
    return series;
  }

  lxw_chart* bars(const ReportFigure& figure, const Block& block) {
    lxw_chart* chart =
        workbook_add_chart(book_, figure.kind == FigureKind::kForest ? LXW_CHART_BAR : LXW_CHART_COLUMN);
    for (std::size_t s = 0; s < figure.series.size(); ++s) {
      addSeries(chart, block, 0, columns_[s], say_(figure.series[s].name));
    }
    return chart;
  }

  /// Writes one row per box: its five numbers, mean, and the segments of a stacked column.
  Block boxes(const ReportFigure& figure, std::uint32_t head) {
    std::uint16_t column = 1;
    for (const Phrase name :
         {Text::tr("lower whisker"), Text::tr("lower quartile"), Text::tr("median"),
          Text::tr("upper quartile"), Text::tr("upper whisker"), Text::tr("mean"),
          Text::tr("median less lower quartile"), Text::tr("upper quartile less median")}) {
      pen_.text(head, column++, say_(name), formats_.heading);
    }
    std::uint32_t row = head + 1;
    for (const FigureSeries& series : figure.series) {
      if (series.box) {
        const BoxSummary& box = *series.box;
        pen_.text(row, 0, say_(series.name));
        column = 1;
        for (const double value :
             {box.lowerWhisker, box.lowerQuartile, box.median, box.upperQuartile, box.upperWhisker, box.mean,
              box.median - box.lowerQuartile, box.upperQuartile - box.median}) {
          pen_.number(row, column++, value, formats_.figure);
        }
        ++row;
      }
    }
    return {head + 1, row - head - 1};
  }

  /// Draws boxes as stacked columns, which every spreadsheet supports; the lowest segment is invisible.
  lxw_chart* boxChart(const ReportFigure&, const Block& block) {
    lxw_chart* chart = workbook_add_chart(book_, LXW_CHART_COLUMN_STACKED);
    lxw_chart_series* base = addSeries(chart, block, 0, 2, say_(Text::tr("lower quartile")));
    lxw_chart_fill none{};
    none.none = LXW_TRUE;
    chart_series_set_fill(base, &none);
    addSeries(chart, block, 0, 7, say_(Text::tr("lower quartile to median")));
    addSeries(chart, block, 0, 8, say_(Text::tr("median to upper quartile")));
    std::int16_t hidden[] = {0, -1};
    chart_legend_delete_series(chart, hidden);
    return chart;
  }

  /// Writes the columns x and y of each series.
  Block points(const ReportFigure& figure, std::uint32_t head, lxw_chart*& chart) {
    const bool lines = figure.kind == FigureKind::kLines;
    chart = workbook_add_chart(book_, lines ? LXW_CHART_SCATTER_STRAIGHT_WITH_MARKERS : LXW_CHART_SCATTER);
    std::uint16_t column = 0;
    std::size_t longest = 0;
    for (const FigureSeries& series : figure.series) {
      pen_.text(head, column, say_(figure.xLabel.empty() ? Text(Text::tr("category")) : figure.xLabel),
                formats_.heading);
      pen_.text(head, static_cast<std::uint16_t>(column + 1), say_(series.name), formats_.heading);
      longest = std::max(longest, series.y.size());
      column = static_cast<std::uint16_t>(column + 2);
    }
    for (std::size_t i = 0; i < longest; ++i) {  // rows in order: written rows are flushed to disk
      const auto row = static_cast<std::uint32_t>(head + 1 + i);
      column = 0;
      for (const FigureSeries& series : figure.series) {
        if (i < series.y.size()) {
          pen_.number(row, column, i < series.x.size() ? series.x[i] : static_cast<double>(i + 1));
          if (series.y[i]) {
            pen_.number(row, static_cast<std::uint16_t>(column + 1), *series.y[i], formats_.figure);
          }
        }
        column = static_cast<std::uint16_t>(column + 2);
      }
    }
    column = 0;
    for (const FigureSeries& series : figure.series) {
      const Block own{head + 1, static_cast<std::uint32_t>(series.y.size())};
      addSeries(chart, own, column, static_cast<std::uint16_t>(column + 1), say_(series.name));
      column = static_cast<std::uint16_t>(column + 2);
    }
    return {head + 1, static_cast<std::uint32_t>(longest)};
  }

  void finish(const ReportFigure& figure, lxw_chart* chart, std::uint32_t row) {
    chart_title_off(chart);
    const std::string x = say_(figure.xLabel);
    const std::string y = say_(figure.yLabel);
    const bool lying = figure.kind == FigureKind::kForest;  // a bar chart has its axes swapped
    chart_axis_set_name(lying ? chart->y_axis : chart->x_axis, x.c_str());
    chart_axis_set_name(lying ? chart->x_axis : chart->y_axis, y.c_str());
    if (figure.yMin && figure.kind != FigureKind::kForest) {
      chart_axis_set_min(chart->y_axis, *figure.yMin);
    }
    if (figure.yMax && figure.kind != FigureKind::kForest) {
      chart_axis_set_max(chart->y_axis, *figure.yMax);
    }
    chart_legend_set_position(chart, LXW_CHART_LEGEND_BOTTOM);
    std::uint16_t place = kChartColumn;
    if (figure.kind == FigureKind::kLines || figure.kind == FigureKind::kPoints ||
        figure.kind == FigureKind::kScatter) {
      place = static_cast<std::uint16_t>(std::max<std::size_t>(kChartColumn, 2 * figure.series.size() + 1));
    } else if (!columns_.empty()) {
      place = std::max(place, static_cast<std::uint16_t>(columns_.back() + 4));
    }
    lxw_chart_options options{};
    options.x_scale = 1.3;
    options.y_scale = 1.3;
    worksheet_insert_chart_opt(pen_.sheet(), row + 1, place, chart, &options);
  }

  lxw_workbook* book_;
  std::string name_;
  SheetPen& pen_;
  const WorkbookFormats& formats_;
  const ExportWording& say_;
  std::vector<std::uint16_t> columns_;
};

}  // namespace

void writeFigures(lxw_workbook* workbook, const std::string& sheetName, SheetPen pen,
                  const std::vector<const ReportFigure*>& figures, const WorkbookFormats& formats,
                  const ExportWording& say) {
  worksheet_set_column(pen.sheet(), 0, 0, 28.0, nullptr);
  worksheet_set_column(pen.sheet(), 1, 40, 13.0, nullptr);
  FigureWriter writer(workbook, sheetName, pen, formats, say);
  std::uint32_t row = 0;
  for (const ReportFigure* figure : figures) {
    row = writer.write(*figure, row);
  }
}

}  // namespace torsio
