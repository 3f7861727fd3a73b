// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "sim/core/text.h"

namespace torsio {

/// A JSON object of a map that knows its path: what is missing, unknown or of another kind is refused with
/// its place (Error, kBadData). Keeps a view of the JSON. Any thread.
class MapPart {
 public:
  MapPart(const nlohmann::json& json, std::string where);

  [[noreturn]] void refuseAt(const std::string& key, const Text& what, const Text& remedy) const;
  [[nodiscard]] std::string placeOf(const std::string& key) const;
  /// Refuses unknown keys: a misspelt one would be silently ignored.
  void allow(std::initializer_list<std::string_view> keys) const;
  [[nodiscard]] bool has(const char* key) const;
  [[nodiscard]] std::string text(const char* key) const;
  [[nodiscard]] std::string textOr(const char* key, const std::string& other) const;
  /// Like textOr(), for a name or label: one readable line.
  [[nodiscard]] std::string labelOr(const char* key, const std::string& other) const;
  [[nodiscard]] std::string label(const char* key) const;
  /// False without the key.
  [[nodiscard]] bool yesOrNo(const char* key) const;
  [[nodiscard]] double number(const char* key) const;
  [[nodiscard]] MapPart part(const char* key) const;
  [[nodiscard]] std::vector<MapPart> list(const char* key) const;
  [[nodiscard]] std::vector<std::string> texts(const char* key, std::size_t count) const;
  [[nodiscard]] const std::string& where() const noexcept { return where_; }

 private:
  [[nodiscard]] const nlohmann::json& array(const char* key) const;

  const nlohmann::json& json_;
  std::string where_;
};

}  // namespace torsio
