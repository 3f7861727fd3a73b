// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/ledger.h"
#include "sim/core/text.h"
#include "sim/core/vec3.h"

namespace torsio {

/// Lines of labels and values.
using Facts = std::vector<std::pair<Text, Text>>;

/// Content of a table cell, with the result that it shows, or whose values it counts.
struct ReportCell : Text {
  ReportCell() = default;
  ReportCell(const std::convertible_to<Text> auto& words) : Text(words) {}  // NOLINT: text is a cell
  ReportCell(const Text& words, std::shared_ptr<const ResultKey> of) : Text(words), key(std::move(of)) {}
  ReportCell(const Text& words, ResultKey of)
      : Text(words), key(std::make_shared<const ResultKey>(std::move(of))) {}

  /// The words alone, as an argument of another text.
  [[nodiscard]] const Text& words() const noexcept { return *this; }

  std::shared_ptr<const ResultKey> key;  ///< null: no result
};

/// Source of a table or figure, printed below it.
struct Provenance {
  Text formula;  ///< "Eq. 26" ...
  std::string formulaVersion;
  ReportCell n;             ///< number of values used; empty: not stated
  ReportCell missing;       ///< of the values that there should be; empty: none can be missing
  std::vector<Text> flags;  ///< "renormalised", "demonstration data" ...
};

/// A sentence with the results that it states.
struct ReportParagraph : Text {
  ReportParagraph() = default;
  ReportParagraph(const std::convertible_to<Text> auto& words) : Text(words) {}  // NOLINT: text is one
  /// `from`: the cells among the arguments of `words`; `also`: keys of other results that it states.
  ReportParagraph(const Text& words, std::initializer_list<ReportCell> from,
                  std::vector<std::shared_ptr<const ResultKey>> also = {})
      : Text(words), keys(std::move(also)) {
    for (const ReportCell& cell : from) {
      if (cell.key != nullptr) {
        keys.push_back(cell.key);
      }
    }
  }

  /// The words alone, as an argument of another text.
  [[nodiscard]] const Text& words() const noexcept { return *this; }

  std::vector<std::shared_ptr<const ResultKey>> keys{};
  /// Stands against the answer on the first page. Those without room there are counted, and all are listed
  /// behind it.
  bool reservation = false;
};

struct ReportTable {
  std::string id;  ///< stable id, "table-evaluation"
  Text title;
  std::vector<Text> columns;
  std::vector<std::vector<ReportCell>> rows;  ///< each as long as `columns`; numbers are already formatted
  bool individual = false;                    ///< lists single people: not part of an aggregated report
  bool annex = false;                         ///< shown only in the annex
  std::vector<ReportParagraph> notes;
  Provenance provenance;
};

enum class FigureKind {
  kGroupedBars,  ///< one bar per category and series
  kRanges,       ///< low, middle, high per category and series
  kBoxes,        ///< five numbers per series (values), with outliers and mean
  kPoints,       ///< every value of a series at its category
  kLines,        ///< y over x; with intervals if low and high are given
  kScatter,      ///< markers at (x, y)
  kForest,       ///< categories from top to bottom, values with intervals along the horizontal axis
  kHeatMap,      ///< categories are columns, series are rows; cells are shaded by value
  kReliefs,      ///< categories are columns, series are rows; a picture in each cell
};

/// A place in a picture: x to the right, y up, z towards the reader, any unit.
using ReliefPlace = std::array<float, 3>;

/// Where a place of the patient is seen from the front: x to the left of the patient, which is to the right.
[[nodiscard]] inline ReliefPlace seenFromFront(const Vec3& place_m) {
  return {static_cast<float>(place_m.x), static_cast<float>(place_m.z), static_cast<float>(-place_m.y)};
}

/// A closed surface to be drawn as a solid body.
struct ReportRelief {
  Text caption;  ///< below it
  std::shared_ptr<const std::vector<std::array<std::uint32_t, 3>>>
      triangles;                                             ///< corners anticlockwise seen from outside
  std::vector<ReliefPlace> places;                           ///< of the corners
  std::vector<std::vector<ReliefPlace>> lines{};             ///< on the surface
  std::vector<std::pair<std::string, ReliefPlace>> marks{};  ///< short names and their places on it
};

/// A line across a figure, such as a limit, a target or zero. Crosses the value axis.
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
  Text name{};
  std::vector<double>
      x{};  ///< kLines without categories: abscissa; kPoints: category index from 0; otherwise empty
  std::vector<std::optional<double>> y{};  ///< one per category; kBoxes: all raw values
  std::vector<double> low{};               ///< kRanges, kForest: same length as y; kLines: same or empty
  std::vector<double> high{};
  std::optional<BoxSummary> box{};      ///< kBoxes: required
  std::optional<std::size_t> look{};    ///< colour and marker of this index instead of the series' own
  bool faint = false;                   ///< one curve of many: thin, unnamed; kScatter: a reference line
  std::vector<ReportRelief> reliefs{};  ///< kReliefs: one per column
  std::vector<std::shared_ptr<const ResultKey>> keys{};  ///< of y; null or shorter: no result
  std::shared_ptr<const ResultKey> boxKey{};             ///< of the median
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
  bool logarithmic = false;    ///< kPoints: powers of ten on the value axis; all values are positive
  std::optional<double> yMin;  ///< of the value axis, in either orientation
  std::optional<double> yMax;
  bool individual = false;      ///< shows single people: not part of an aggregated report
  bool annex = false;           ///< shown only in the annex
  bool valuesInLabels = false;  ///< labels or a table of the section have the values: no table of its own
  std::vector<ReportParagraph> notes;
  Provenance provenance;
  Text valuesStand;  ///< a sentence on where to find values too many to print; empty: nowhere else
};

struct ReportSection {
  std::string id;  ///< stable id, "methods"
  Text title;
  bool onFirstPage = false;  ///< below the title, on the same page
  bool annex = false;        ///< shown only in the annex, which begins on a page of its own
  bool startsPage = false;   ///< begins on a page of its own
  std::vector<ReportParagraph> paragraphs{};
  std::vector<ReportFigure> figures{};
  std::vector<ReportTable> tables{};
};

/// A cohort report as plain values, the only source of PDF and screen. Strings are Text, so that they can be
/// translated; numbers are the same in every language. Free text by people is a Text without arguments.
struct ReportModel {
  Text title;
  Text subtitle;
  std::string centre;
  std::string softwareVersion;
  std::int64_t createdUtc_us = 0;
  std::string number;  ///< on every page: "R-1204-3fa29b1c"; empty: none
  std::string
      numbersHash;  ///< BLAKE2b-256 of the table of numbers (cohortCsvText(), without a byte order mark)
  std::string auditHead;       ///< hash of the latest entry of the audit trail
  bool demonstration = false;  ///< stated on every page
  Facts facts;                 ///< on the cover
  std::vector<ReportSection> sections;
};

}  // namespace torsio
