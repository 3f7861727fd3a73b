// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "sim/scene/organ_finding.h"

namespace torsio {

// For .cpp files of this folder only: warnings in organ files and in the parameters of a recording.

/// Writes warnings so that they can still be said in another language.
[[nodiscard]] inline nlohmann::ordered_json warningsJson(const std::vector<OrganWarning>& warnings) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const OrganWarning& warning : warnings) {
    nlohmann::ordered_json arguments = nlohmann::ordered_json::array();
    for (const Text& argument : warning.text.arguments()) {
      arguments.push_back(argument.str());
    }
    list.push_back({{"code", warning.code}, {"text", warning.text.pattern()}, {"arguments", arguments}});
  }
  return list;
}

/// Reads them; throws nlohmann's exceptions for anything else.
[[nodiscard]] inline std::vector<OrganWarning> warningsOf(const nlohmann::json& list) {
  std::vector<OrganWarning> warnings;
  for (const nlohmann::json& one : list) {
    std::vector<Text> arguments;
    for (const nlohmann::json& argument : one.at("arguments")) {
      arguments.emplace_back(argument.get<std::string>());
    }
    warnings.push_back({one.at("code").get<std::string>(),
                        Text::restored(one.at("text").get<std::string>(), std::move(arguments))});
  }
  return warnings;
}

}  // namespace torsio
