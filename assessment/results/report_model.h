// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/ledger.h"
#include "sim/core/text.h"

namespace torsio {

/// Lines of a label and its value.
using Facts = std::vector<std::pair<Text, Text>>;

/// Where a table or figure comes from; printed beneath it.
struct Provenance {
  Text formula;  ///< "Eq. 26" ...
  std::string formulaVersion;
  std::int64_t n = 0;  ///< values used
  std::int64_t missing = 0;
  std::vector<Text> flags;  ///< "renormalised", "demonstration data" ...
};

/// What stands in a cell of a table. It knows the result that it shows, or whose values it counts.
struct ReportCell : Text {
  ReportCell() = default;
  ReportCell(const std::convertible_to<Text> auto& words) : Text(words) {}  // NOLINT: text is a cell
  ReportCell(const Text& words, ResultKey of)
      : Text(words), key(std::make_shared<const ResultKey>(std::move(of))) {}

  std::shared_ptr<const ResultKey> key;  ///< null: no result stands behind it
};

struct ReportTable {
  std::string id;  ///< stable, "table-evaluation"
  Text title;
  std::vector<Text> columns;
  std::vector<std::vector<ReportCell>> rows;  ///< each as long as columns; numbers are formatted already
  bool individual = false;                    ///< lists single people: no part of an aggregated report
  std::vector<Text> notes;
  Provenance provenance;
};

enum class FigureKind {
  kGroupedBars,  ///< one bar a category and series
  kRanges,       ///< low, middle, high a category and series
  kBoxes,        ///< five numbers a series (values), outliers and mean drawn
  kPoints,       ///< every value of a series at its category
  kLines,        ///< y over x; intervals where low and high are given
  kScatter,      ///< marks at (x, y)
  kForest,       ///< categories from top to bottom, the value with its interval along the horizontal axis
  kHeatMap,      ///< categories are columns, series are rows; a cell is shaded by its value
};

/// A line across a figure: a limit, a target, zero. Crosses the axis of values.
struct FigureReference {
  double value = 0.0;
  Text label;
};

/// A box as drawn: type-7 quartiles, whiskers to the last value within 1.5 interquartile ranges of the box.
struct BoxSummary {
  double lowerWhisker = 0.0;
  double lowerQuartile = 0.0;
  double median = 0.0;
  double upperQuartile = 0.0;
  double upperWhisker = 0.0;
  double mean = 0.0;
  std::vector<double> outliers;
};

struct FigureSeries {
  Text name;
  std::vector<double>
      x;  ///< kLines without categories: abscissa; kPoints: category number from 0; else empty
  std::vector<std::optional<double>> y;  ///< one a category; kBoxes: all raw values
  std::vector<double> low;               ///< kRanges, kForest: same length as y; kLines: same or none
  std::vector<double> high;
  std::optional<BoxSummary> box;    ///< kBoxes: required
  std::optional<std::size_t> look;  ///< colour and marker of this number instead of the series' own
  bool faint = false;               ///< a course of many: thin, unnamed; kScatter: a line to compare with
};

struct ReportFigure {
  std::string id;  ///< "figure-15"
  Text title;
  Text xLabel;
  Text yLabel;  ///< with unit
  FigureKind kind = FigureKind::kGroupedBars;
  std::vector<Text> categories;
  std::vector<FigureSeries> series;
  std::vector<FigureReference> references;
  std::optional<double> yMin;  ///< of the axis of values, whichever way it lies
  std::optional<double> yMax;
  bool individual = false;      ///< shows single people: no part of an aggregated report
  bool valuesInLabels = false;  ///< each category says its value: nobody needs a table of them
  std::vector<Text> notes;
  Provenance provenance;
  Text valuesStand;  ///< a sentence: where the values stand that are too many to print; "": nowhere else
};

struct ReportSection {
  Text title;
  bool onFirstPage = false;  ///< stands under the title, on one page with it
  std::vector<Text> paragraphs;
  std::vector<ReportFigure> figures;
  std::vector<ReportTable> tables;
};

/// All that a cohort report says, as plain values: PDF and screen are drawn from this and nothing else. Words
/// are Text, so that whoever shows them may say them in another language; numbers are the same in every
/// language. What people wrote themselves is a Text without places.
struct ReportModel {
  Text title;
  Text subtitle;
  std::string centre;
  std::string softwareVersion;
  std::int64_t createdUtc_us = 0;
  std::string number;  ///< on every page: "R-1204-3fa29b1c"; empty: none
  std::string
      numbersHash;  ///< BLAKE2b-256 of the table of numbers (cohortCsvText(), without a byte order mark)
  std::string auditHead;       ///< hash of the newest entry of the audit trail
  bool demonstration = false;  ///< then every page says so
  Facts facts;                 ///< cover
  ResultNames names;           ///< for the keys of cells
  std::vector<ReportSection> sections;
};

}  // namespace torsio
