// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/ledger.h"
#include "assessment/results/report_model.h"
#include "assessment/statistics/values.h"
#include "sim/core/text.h"

// Tables and figures of the report as projections of the ledger: a cell and a point know their result.
namespace torsio {

/// How a result is shown.
struct Format {
  enum class Kind : std::uint8_t {
    kFixed,
    kExact,
    kP,             ///< "< 0.001"
    kEqualsP,       ///< with its letter, for sentences: "p < 0.001", "p = 0.032"
    kPercent,       ///< of a share: "12.5 %"
    kWithInterval,  ///< with the interval `statistic`_95: "1.234 [1.000, 1.500]"
    kInterval,      ///< "[1.0, 1.5]"; without this, an interval has three decimals
    kQuantity,      ///< of the catalogue: its scale and decimals
    kValues,        ///< the number of values behind it
  };
  Kind kind = Kind::kFixed;
  int decimals = 0;     ///< of a quantity: additional ones
  Quantity quantity{};  ///< for kQuantity
};
[[nodiscard]] constexpr Format fixed(int decimals) noexcept {
  return {Format::Kind::kFixed, decimals};
}
[[nodiscard]] constexpr Format intervalWith(int decimals) noexcept {
  return {Format::Kind::kInterval, decimals};
}
[[nodiscard]] constexpr Format percent(int decimals) noexcept {
  return {Format::Kind::kPercent, decimals};
}
[[nodiscard]] constexpr Format shownAs(Quantity quantity, int more = 0) noexcept {
  return {Format::Kind::kQuantity, more, quantity};
}
inline constexpr Format kExactly{Format::Kind::kExact};
inline constexpr Format kAsP{Format::Kind::kP};
inline constexpr Format kEqualsP{Format::Kind::kEqualsP};
inline constexpr Format kWithInterval{Format::Kind::kWithInterval};
inline constexpr Format kValues{Format::Kind::kValues};

/// Results with a common key that differ in statistic.
class ResultsAt {
 public:
  ResultsAt(const Ledger& ledger, ResultKey place) : ledger_(&ledger), place_(std::move(place)) {}

  /// Returns a cell; `otherwise`: its words if the result has no value and no reason for it.
  [[nodiscard]] ReportCell operator()(const std::string& statistic, Format format = {},
                                      const Text& otherwise = Text::tr("not defined")) const;
  /// Returns a count, or the number of values behind a result, for a caption; empty if there is none.
  [[nodiscard]] ReportCell count(const std::string& statistic, Format format = {}) const;
  [[nodiscard]] const Result* find(const std::string& statistic) const;
  /// Returns a number; empty if it is undefined, missing or hidden.
  [[nodiscard]] std::optional<double> number(const std::string& statistic) const;

 private:
  [[nodiscard]] ResultKey keyOf(const std::string& statistic) const;

  const Ledger* ledger_;
  ResultKey place_;
};

/// Returns the key for the comparison of two groups.
[[nodiscard]] inline ResultKey pairKey(const Ledger& ledger, std::size_t first, std::size_t second) {
  return {.section = ResultSection::kComparison,
          .group = ledger.group(first),
          .against = ledger.group(second),
          .occasion = ledger.lastOccasion()};
}
/// Results of the comparison of all groups at the last occasion.
[[nodiscard]] inline ResultsAt resultsAtEnd(const Ledger& ledger) {
  return {ledger, {.section = ResultSection::kComparison, .occasion = ledger.lastOccasion()}};
}
/// Lists a result of that comparison for each of these groups: "Group 1 6.2, Group 2 5.9".
[[nodiscard]] ReportParagraph valuesOfGroups(const CohortInputs& inputs, const Ledger& ledger,
                                             const std::vector<std::size_t>& groups,
                                             const std::string& statistic, Format format);
[[nodiscard]] inline ResultsAt resultsOfPair(const Ledger& ledger, std::size_t first, std::size_t second) {
  return {ledger, pairKey(ledger, first, second)};
}

/// A column of a table: a label if it has no statistic.
struct ResultColumn {
  Text title;
  std::string statistic{};
  Format format{};
  Text otherwise = Text::tr("not defined");
};

/// Builds a table whose rows show the results of one key each.
class ResultTable {
 public:
  ResultTable(const Ledger& ledger, ReportTable& table, std::vector<ResultColumn> columns);
  /// Adds a row; `labels`: the cells of the columns without a statistic, in order.
  void row(const std::vector<ReportCell>& labels, const ResultKey& place);

 private:
  const Ledger& ledger_;
  ReportTable& table_;
  std::vector<ResultColumn> columns_;
};

/// Adds the point of a result to a series, with its interval `statistic`_95 if the series shows intervals; a
/// gap if it has no value.
void addPoint(FigureSeries& series, const ResultsAt& results, const std::string& statistic,
              bool withInterval = false);

/// Formats a value with its interval, "1.234 [1.000, 1.500]", three decimals; without an interval, the value
/// alone.
[[nodiscard]] std::string withInterval(double value, const std::optional<Interval>& interval);
/// Describes why a statistic is missing: "not defined: every rating is the same". `reason`: from an Outcome.
[[nodiscard]] Text notDefined(const Text& reason);
/// Returns "Mean: Time (s)" or "Median: Time (s)", for the column of a quantity.
[[nodiscard]] Text meanTitle(Quantity quantity);
[[nodiscard]] Text medianTitle(Quantity quantity);

}  // namespace torsio
