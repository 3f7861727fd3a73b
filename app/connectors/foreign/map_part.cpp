// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/foreign/map_part.h"

#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/services/base/identifiers.h"
#include "sim/core/error.h"

namespace torsio {

MapPart::MapPart(const nlohmann::json& json, std::string where) : json_(json), where_(std::move(where)) {
  if (!json_.is_object()) {
    refuse(Text::tr("not a JSON object"), where_, Text::tr("See the example of a map"));
  }
}

void MapPart::refuseAt(const std::string& key, const Text& what, const Text& remedy) const {
  refuse(what, placeOf(key), remedy);
}

std::string MapPart::placeOf(const std::string& key) const {
  return where_ + ", \"" + key + "\"";
}

void MapPart::allow(std::initializer_list<std::string_view> keys) const {
  for (const auto& [key, value] : json_.items()) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      refuseAt(key, Text::tr("the map has an unknown field"), Text::tr("Check its spelling"));
    }
  }
}

bool MapPart::has(const char* key) const {
  return json_.contains(key);
}

std::string MapPart::text(const char* key) const {
  std::string found = textOr(key, "");
  if (found.empty()) {
    refuseAt(key, Text::tr("the map must say this"), Text::tr("Write it into the map; nothing is guessed"));
  }
  return found;
}

std::string MapPart::textOr(const char* key, const std::string& other) const {
  if (!has(key)) {
    return other;
  }
  if (!json_[key].is_string()) {
    refuseAt(key, Text::tr("not a text"), Text::tr("Put it in quotes"));
  }
  return json_[key].get<std::string>();
}

std::string MapPart::labelOr(const char* key, const std::string& other) const {
  std::string found = textOr(key, other);
  requireReadable(found, placeOf(key));
  return found;
}

std::string MapPart::label(const char* key) const {
  std::string found = text(key);
  requireReadable(found, placeOf(key));
  return found;
}

bool MapPart::yesOrNo(const char* key) const {
  if (!has(key)) {
    return false;
  }
  if (!json_[key].is_boolean()) {
    refuseAt(key, Text::tr("neither true nor false"), Text::tr("Write one of them, without quotes"));
  }
  return json_[key].get<bool>();
}

double MapPart::number(const char* key) const {
  if (!has(key) || !json_[key].is_number()) {
    refuseAt(key, Text::tr("the map must say this number"), Text::tr("Write it without quotes"));
  }
  return json_[key].get<double>();
}

MapPart MapPart::part(const char* key) const {
  if (!has(key)) {
    refuseAt(key, Text::tr("the map must say this"), Text::tr("Write it into the map; nothing is guessed"));
  }
  return {json_[key], where_ + ", \"" + key + "\""};
}

std::vector<MapPart> MapPart::list(const char* key) const {
  std::vector<MapPart> parts;
  std::size_t number = 0;
  for (const nlohmann::json& one : array(key)) {
    parts.emplace_back(one, where_ + ", \"" + key + "\" " + std::to_string(++number));
  }
  return parts;
}

std::vector<std::string> MapPart::texts(const char* key, std::size_t count) const {
  std::vector<std::string> found;
  for (const nlohmann::json& one : array(key)) {
    found.push_back(one.is_string() ? one.get<std::string>() : std::string());
  }
  const bool empty = std::any_of(found.begin(), found.end(), [](const std::string& t) { return t.empty(); });
  if (found.size() != count || empty) {
    refuseAt(key, Text::tr("%1 {name of a column belongs|names of columns belong} here", count),
             Text::tr("Name each of them once"));
  }
  return found;
}

const nlohmann::json& MapPart::array(const char* key) const {
  if (!has(key) || !json_[key].is_array()) {
    refuseAt(key, Text::tr("a list belongs here"), Text::tr("See the example of a map"));
  }
  return json_[key];
}

}  // namespace torsio
