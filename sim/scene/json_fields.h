// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "sim/core/text.h"
#include "sim/core/vec3.h"
#include "sim/scene/organ_finding.h"

namespace torsio {

// For .cpp files only, wherever a data file of Torsio's own is read: sim/scene (scenes, materials,
// instruments), app/services/study (curricula, rubrics), app/cli (plans of an allocation). Includes nlohmann,
// and so never goes into a public header.

/// Returns the text of a JSON file, checked by requireSoundJson(). Throws Error: kFileMissing,
/// kFileUnreadable, kBadData.
[[nodiscard]] std::string jsonTextIn(const std::filesystem::path& file);
/// Throws Error{kBadData} for a text that is not JSON, or costs or hides more than any file of Torsio's: more
/// than 16 MiB, 64 brackets within each other, a text of more than 64 KiB, a character that plainText() does
/// not let through (ends of lines may have a return). Takes no memory for what it reads. `name`: file for
/// messages.
void requireSoundJson(const std::string& text, const std::string& name);

/// One JSON object of a data file, read field by field. Every refusal names file and field; finish() refuses
/// unknown fields, so that a misspelt one never passes silently.
class JsonFields {
 public:
  /// Makes a reader of `json`, which outlives it. `where`: file and place for messages.
  JsonFields(const nlohmann::json& json, std::string where);

  [[nodiscard]] bool has(const std::string& name) const;
  [[nodiscard]] std::string text(const std::string& name);
  [[nodiscard]] std::string text(const std::string& name, const std::string& fallback);
  /// Reads a finite number within [low, high].
  [[nodiscard]] double number(const std::string& name, double low, double high);
  [[nodiscard]] double number(const std::string& name, double low, double high, double fallback);
  [[nodiscard]] int integer(const std::string& name, int low, int high, int fallback);
  /// Reads true or false.
  [[nodiscard]] bool flag(const std::string& name, bool fallback);
  [[nodiscard]] Vec3 vector(const std::string& name);
  /// Reads one of `names`; returns its position.
  [[nodiscard]] std::size_t choice(const std::string& name, const std::vector<std::string>& names,
                                   std::size_t fallback);
  /// Returns the child object or array, which must exist.
  [[nodiscard]] const nlohmann::json& child(const std::string& name);
  [[nodiscard]] const std::string& where() const noexcept { return where_; }

  void finish() const;
  [[noreturn]] void refuse(const std::string& name, const Text& problem, const Text& remedy) const;

 private:
  const nlohmann::json& find(const std::string& name);

  const nlohmann::json& json_;
  std::string where_;
  std::set<std::string> asked_;
};

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
