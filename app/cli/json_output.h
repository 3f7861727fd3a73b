// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/values.h"

namespace torsio::cli {

// Private to app/cli's .cpp files.

/// Returns JSON as text; `indent`: blanks a level, -1: on one line. What is not UTF-8 is replaced.
[[nodiscard]] std::string jsonText(const auto& json, int indent = 2) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Prints indented JSON to standard output. Non-integers have 17 significant digits and a decimal point, so
/// that reading them back gives the same double. Throws ContractError for a number that is not finite.
void printJson(const nlohmann::ordered_json& value);

/// Lists a table's unused columns and damaged identifiers on standard error.
void noteTable(const CsvTable& table);

/// Returns {"undefined": reason}, in place of a statistic that is undefined for the data.
[[nodiscard]] nlohmann::ordered_json undefinedJson(const std::string& reason);
/// Returns {"lower": ..., "upper": ...}.
[[nodiscard]] nlohmann::ordered_json intervalJson(const Interval& interval);
/// Returns the number, or {"undefined": reason} if empty.
[[nodiscard]] nlohmann::ordered_json numberJson(const std::optional<double>& value,
                                                const std::string& reason);
/// Returns {"name": ..., "value": ...}: an effect size.
[[nodiscard]] nlohmann::ordered_json namedValue(const std::string& name, double value);
/// Returns a test in the common form; missing parts are stated, never omitted.
[[nodiscard]] nlohmann::ordered_json testJson(double statistic, nlohmann::ordered_json df, double p,
                                              nlohmann::ordered_json effect, nlohmann::ordered_json interval);
/// Placeholder for the interval of a test that has none.
[[nodiscard]] nlohmann::ordered_json noInterval();
/// Returns the word of an enumeration's value; `words`: one for each value, in its order.
template <class Value, std::size_t Size>
[[nodiscard]] constexpr const char* wordOf(Value value, const std::array<const char*, Size>& words) {
  return words.at(static_cast<std::size_t>(value));
}
/// Returns `show(value)`, or {"undefined": reason}.
template <class T, class Show>
[[nodiscard]] nlohmann::ordered_json outcomeJson(const Outcome<T>& outcome, const Show& show) {
  return outcome ? nlohmann::ordered_json(show(*outcome)) : undefinedJson(outcome.reason().str());
}

}  // namespace torsio::cli
