// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/json_fields.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "sim/core/error.h"

namespace torsio {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace

JsonFields::JsonFields(const nlohmann::json& json, std::string where)
    : json_(json), where_(std::move(where)) {
  if (!json_.is_object()) {
    throw Error(ErrorCode::kBadData, Text::tr("must be an object in braces"), where_,
                Text::tr("Correct the file."));
  }
}

void JsonFields::refuse(const std::string& name, const Text& problem, const Text& remedy) const {
  throw Error(ErrorCode::kBadData, Text::tr("field '%1' %2", name, problem), where_, remedy);
}

bool JsonFields::has(const std::string& name) const {
  return json_.contains(name);
}

const nlohmann::json& JsonFields::find(const std::string& name) {
  asked_.insert(name);
  const auto found = json_.find(name);
  if (found == json_.end()) {
    refuse(name, Text::tr("is missing"), Text::tr("Add it."));
  }
  return *found;
}

const nlohmann::json& JsonFields::child(const std::string& name) {
  return find(name);
}

std::string JsonFields::text(const std::string& name) {
  const nlohmann::json& value = find(name);
  if (!value.is_string()) {
    refuse(name, Text::tr("must be a text"), Text::tr("Put it in quotes."));
  }
  return value.get<std::string>();
}

std::string JsonFields::text(const std::string& name, const std::string& fallback) {
  asked_.insert(name);
  return has(name) ? text(name) : fallback;
}

double JsonFields::number(const std::string& name, double low, double high) {
  const nlohmann::json& value = find(name);
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!(number >= low && number <= high)) {
    std::ostringstream limits;
    limits << "must be a number from " << low << " to " << high;
    if (value.is_number()) {
      limits << ", not " << number;
    }
    refuse(name, limits.str(), Text::tr("Correct the value."));
  }
  return number;
}

double JsonFields::number(const std::string& name, double low, double high, double fallback) {
  asked_.insert(name);
  return has(name) ? number(name, low, high) : fallback;
}

int JsonFields::integer(const std::string& name, int low, int high, int fallback) {
  const double value = number(name, low, high, fallback);
  if (value != std::floor(value)) {
    refuse(name, Text::tr("must be a whole number"), Text::tr("Correct the value."));
  }
  return static_cast<int>(value);
}

bool JsonFields::flag(const std::string& name, bool fallback) {
  asked_.insert(name);
  if (!has(name)) {
    return fallback;
  }
  const nlohmann::json& value = find(name);
  if (!value.is_boolean()) {
    refuse(name, Text::tr("must be true or false"), Text::tr("Correct the value."));
  }
  return value.get<bool>();
}

Vec3 JsonFields::vector(const std::string& name) {
  const nlohmann::json& value = find(name);
  if (!value.is_array() || value.size() != 3 || !value[0].is_number() || !value[1].is_number() ||
      !value[2].is_number()) {
    refuse(name, Text::tr("must be three numbers in brackets"), Text::tr("Write [x, y, z]."));
  }
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

std::size_t JsonFields::choice(const std::string& name, const std::vector<std::string>& names,
                               std::size_t fallback) {
  asked_.insert(name);
  if (!has(name)) {
    return fallback;
  }
  const std::string given = text(name);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (names[i] == given) {
      return i;
    }
  }
  refuse(name, Text::tr("is '%1'", given), Text::tr("Choose one of %1.", joined(names)));
}

void JsonFields::finish() const {
  for (const auto& item : json_.items()) {
    if (!asked_.contains(item.key())) {
      refuse(item.key(), Text::tr("is not known here"), Text::tr("Remove it, or check its spelling."));
    }
  }
}

}  // namespace torsio
