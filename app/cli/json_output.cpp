// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/json_output.h"

#include <array>
#include <charconv>
#include <cmath>
#include <iostream>
#include <utility>

#include "sim/core/contracts.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kSignificantDigits = 17;

/// Formats like "%.17g" in every locale; printf might write a decimal comma.
std::string decimal(double value) {
  TORSIO_EXPECTS(std::isfinite(value));
  std::array<char, 40> text{};
  const auto [end, error] = std::to_chars(text.data(), text.data() + text.size(), value,
                                          std::chars_format::general, kSignificantDigits);
  TORSIO_EXPECTS(error == std::errc());
  return {text.data(), end};
}

void write(std::string& out, const Json& value, const std::string& indent) {
  if (value.is_number_float()) {
    out += decimal(value.get<double>());
    return;
  }
  if (!value.is_structured() || value.empty()) {
    out += jsonText(value, -1);
    return;
  }
  const bool object = value.is_object();
  const std::string inner = indent + "  ";
  out += object ? "{" : "[";
  bool first = true;
  for (const auto& [key, child] : value.items()) {
    out += first ? "\n" : ",\n";
    out += inner;
    if (object) {
      out += jsonText(Json(key), -1) + ": ";
    }
    write(out, child, inner);
    first = false;
  }
  out += "\n" + indent + (object ? "}" : "]");
}

}  // namespace

void printJson(const Json& value) {
  std::string text;
  write(text, value, "");
  std::cout << text << '\n';
}

void noteTable(const CsvTable& table) {
  for (const std::string& column : table.ignored()) {
    std::cerr << "torsio: " << table.name() << ": the column \"" << column << "\" is not used\n";
  }
  for (const Text& one : table.damaged()) {
    std::cerr << "torsio: " << one.str() << "\n";
  }
}

Json undefinedJson(const std::string& reason) {
  return {{"undefined", reason}};
}

Json intervalJson(const Interval& interval) {
  return {{"lower", interval.lower}, {"upper", interval.upper}};
}

Json numberJson(const std::optional<double>& value, const std::string& reason) {
  return value ? Json(*value) : undefinedJson(reason);
}

Json namedValue(const std::string& name, double value) {
  return {{"name", name}, {"value", value}};
}

Json testJson(double statistic, Json df, double p, Json effect, Json interval) {
  Json out;
  out["statistic"] = statistic;
  out["df"] = std::move(df);
  out["p"] = p;
  out["effect_size"] = std::move(effect);
  out["interval"] = std::move(interval);
  return out;
}

Json noInterval() {
  return undefinedJson("this test has no interval");
}

}  // namespace torsio::cli
