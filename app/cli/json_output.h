// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "app/base/csv_table.h"
#include "assessment/statistics/values.h"

namespace torsio::cli {

// Private to app/cli's .cpp files.

/// Prints to standard output, indented. Numbers that are not whole have 17 significant digits, always with a
/// point: reading them back gives the same double. Our own bug when one is not finite.
void printJson(const nlohmann::ordered_json& value);

/// Says on standard error which columns of a table were not used.
void noteIgnoredColumns(const CsvTable& table);

[[nodiscard]] inline nlohmann::ordered_json undefinedJson(const std::string& reason) {
  return {{"undefined", reason}};
}
[[nodiscard]] inline nlohmann::ordered_json intervalJson(const Interval& interval) {
  return {{"lower", interval.lower}, {"upper", interval.upper}};
}
[[nodiscard]] inline nlohmann::ordered_json numberJson(const std::optional<double>& value,
                                                       const std::string& reason) {
  return value ? nlohmann::ordered_json(*value) : undefinedJson(reason);
}
/// What `show` makes of the value, or {"undefined": reason}.
template <class T, class Show>
[[nodiscard]] nlohmann::ordered_json outcomeJson(const Outcome<T>& outcome, const Show& show) {
  return outcome ? nlohmann::ordered_json(show(*outcome)) : undefinedJson(outcome.reason());
}

}  // namespace torsio::cli
