// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "app/services/base/csv_table.h"
#include "assessment/statistics/values.h"

namespace torsio::cli {

// Private to app/cli's .cpp files.

/// Prints to standard output, indented. Numbers that are not whole have 17 significant digits, always with a
/// point: reading them back gives the same double. Our own bug when one is not finite.
void printJson(const nlohmann::ordered_json& value);

/// Says on standard error which columns of a table were not used.
void noteIgnoredColumns(const CsvTable& table);

/// Gives {"undefined": reason}, which stands in place of a statistic that the data do not define.
[[nodiscard]] nlohmann::ordered_json undefinedJson(const std::string& reason);
/// Gives {"lower": ..., "upper": ...}.
[[nodiscard]] nlohmann::ordered_json intervalJson(const Interval& interval);
/// Gives the number, or {"undefined": reason} where there is none.
[[nodiscard]] nlohmann::ordered_json numberJson(const std::optional<double>& value,
                                                const std::string& reason);
/// Gives {"name": ..., "value": ...}, as effect sizes stand in a test.
[[nodiscard]] nlohmann::ordered_json namedValue(const std::string& name, double value);
/// Gives one test in the form that all tests share; what a test does not have is said, never left out.
[[nodiscard]] nlohmann::ordered_json testJson(double statistic, nlohmann::ordered_json df, double p,
                                              nlohmann::ordered_json effect, nlohmann::ordered_json interval);
/// Stands for the interval of a test that has none.
[[nodiscard]] nlohmann::ordered_json noInterval();
/// Gives what `show` makes of the value, or {"undefined": reason}.
template <class T, class Show>
[[nodiscard]] nlohmann::ordered_json outcomeJson(const Outcome<T>& outcome, const Show& show) {
  return outcome ? nlohmann::ordered_json(show(*outcome)) : undefinedJson(outcome.reason().str());
}

}  // namespace torsio::cli
