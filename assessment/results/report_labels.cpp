// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/report_labels.h"

#include <algorithm>

#include "assessment/results/number_format.h"

namespace torsio {

namespace {

constexpr int kLabelDecimals = 3;

std::string intervalText(const Interval& interval, int decimals = kLabelDecimals) {
  return filledIn("[%1, %2]", {formatFixed(interval.lower, decimals), formatFixed(interval.upper, decimals)});
}

std::string equalsP(double p) {
  return filledIn(p < 0.001 ? "p %1" : "p = %1", {formatP(p)});
}

Text numberText(double value, Format format, const std::optional<Interval>& interval) {
  switch (format.kind) {
    case Format::Kind::kP:
      return formatP(value);
    case Format::Kind::kEqualsP:
      return equalsP(value);
    case Format::Kind::kPercent:
      return Text::verbatim("%1 %", formatFixed(100.0 * value, format.decimals));
    case Format::Kind::kWithInterval:
      return withInterval(value, interval);
    case Format::Kind::kExact:
      return formatExact(value);
    case Format::Kind::kQuantity:
      return shownNumber(format.quantity, value, format.decimals);
    default:
      return formatFixed(value, format.decimals);
  }
}

}  // namespace

ResultKey ResultsAt::keyOf(const std::string& statistic) const {
  ResultKey key = place_;
  key.statistic = statistic;
  return key;
}

const Result* ResultsAt::find(const std::string& statistic) const {
  return ledger_->find(keyOf(statistic));
}

std::optional<double> ResultsAt::number(const std::string& statistic) const {
  const Result* result = find(statistic);
  return result == nullptr ? std::nullopt : numberIn(result->value);
}

ReportCell ResultsAt::count(const std::string& statistic, Format format) const {
  return find(statistic) == nullptr ? ReportCell() : (*this)(statistic, format);
}

ReportCell ResultsAt::operator()(const std::string& statistic, Format format, const Text& otherwise) const {
  const ResultKey key = keyOf(statistic);
  const Result* result = ledger_->find(key);
  if (result == nullptr) {
    return ledger_->hides(key) ? Text(Text::tr("not shown")) : otherwise;
  }
  if (format.kind == Format::Kind::kValues) {
    return {std::to_string(result->n), key};
  }
  if (const auto* none = std::get_if<Undefined>(&result->value)) {
    return {none->reason.empty() ? otherwise : notDefined(none->reason), key};
  }
  if (const auto* word = std::get_if<Text>(&result->value)) {
    return {*word, key};
  }
  if (const auto* interval = std::get_if<Interval>(&result->value)) {
    return {
        intervalText(*interval, format.kind == Format::Kind::kInterval ? format.decimals : kLabelDecimals),
        key};
  }
  if (const auto* yes = std::get_if<bool>(&result->value)) {
    return {*yes ? Text(Text::tr("yes")) : Text(Text::tr("no")), key};
  }
  if (const auto* count = std::get_if<std::int64_t>(&result->value)) {
    return {std::to_string(*count), key};
  }
  const Result* interval =
      format.kind == Format::Kind::kWithInterval ? ledger_->find(keyOf(statistic + "_95")) : nullptr;
  return {numberText(*numberIn(result->value), format,
                     interval == nullptr ? std::nullopt : std::optional(std::get<Interval>(interval->value))),
          key};
}

ReportParagraph valuesOfGroups(const CohortInputs& in, const Ledger& ledger,
                               const std::vector<std::size_t>& groups, const std::string& statistic,
                               Format format) {
  std::vector<Text> values;
  std::vector<std::shared_ptr<const ResultKey>> keys;
  for (const std::size_t group : groups) {
    ResultKey place{.section = ResultSection::kComparison,
                    .group = ledger.group(group),
                    .occasion = ledger.lastOccasion()};
    const ReportCell value = ResultsAt(ledger, std::move(place))(statistic, format);
    values.push_back(Text::verbatim("%1 %2", in.groups[group].name, value.words()));
    keys.push_back(value.key);
  }
  return {listed(values), {}, keys};
}

ResultTable::ResultTable(const Ledger& ledger, ReportTable& table, std::vector<ResultColumn> columns)
    : ledger_(ledger), table_(table), columns_(std::move(columns)) {
  for (const ResultColumn& column : columns_) {
    table_.columns.push_back(column.title);
  }
}

void ResultTable::row(const std::vector<ReportCell>& labels, const ResultKey& place) {
  const ResultsAt cell(ledger_, place);
  std::vector<ReportCell> row;
  auto label = labels.begin();
  for (const ResultColumn& column : columns_) {
    row.push_back(column.statistic.empty() ? *label++
                                           : cell(column.statistic, column.format, column.otherwise));
  }
  table_.rows.push_back(std::move(row));
}

void addPoint(FigureSeries& series, const ResultsAt& results, const std::string& statistic,
              bool withInterval) {
  const Result* result = results.find(statistic);
  const std::optional<double> value = result == nullptr ? std::nullopt : numberIn(result->value);
  series.y.push_back(value);
  series.keys.push_back(value ? std::make_shared<const ResultKey>(result->key) : nullptr);
  if (withInterval) {
    const Result* interval = results.find(statistic + "_95");
    const auto* ends = interval == nullptr ? nullptr : std::get_if<Interval>(&interval->value);
    series.low.push_back(ends == nullptr ? value.value_or(0.0) : ends->lower);
    series.high.push_back(ends == nullptr ? value.value_or(0.0) : ends->upper);
  }
}

std::string withInterval(double value, const std::optional<Interval>& interval) {
  const std::string shown = formatFixed(value, kLabelDecimals);
  return interval ? shown + " " + intervalText(*interval) : shown;
}

Text notDefined(const Text& reason) {
  return Text::tr("not defined: %1", reason);
}

Text meanTitle(Quantity quantity) {
  return Text::tr("Mean: %1", titleWithUnit(quantity));
}

Text medianTitle(Quantity quantity) {
  return Text::tr("Median: %1", titleWithUnit(quantity));
}

}  // namespace torsio
