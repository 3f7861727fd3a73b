// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/stored_sentence.h"

#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace torsio {

namespace {

/// Returns [pattern, argument ...], with the arguments being sentences.
nlohmann::json jsonOf(const Text& text) {
  nlohmann::json json = nlohmann::json::array({text.pattern()});
  for (const Text& argument : text.arguments()) {
    json.push_back(jsonOf(argument));
  }
  return json;
}

Text textOf(const nlohmann::json& json) {
  if (!json.is_array() || json.empty() || !json[0].is_string()) {
    return {};
  }
  const auto pattern = json[0].get<std::string>();
  std::vector<Text> given;
  for (std::size_t i = 1; i < json.size(); ++i) {
    given.push_back(textOf(json[i]));
  }
  return Text::restored(pattern, std::move(given));
}

}  // namespace

std::string storedSentence(const Text& text) {
  return text.empty() ? std::string()
                      : jsonOf(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Text readSentence(const std::string& stored) {
  return stored.empty() ? Text() : textOf(nlohmann::json::parse(stored, nullptr, false));
}

}  // namespace torsio
