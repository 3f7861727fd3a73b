// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace torsio::web {

/// Reads an object that a browser sent, field by field. What is missing, of another kind or out of range
/// throws Error{kBadParameter} that names the field.
class JsonBody {
 public:
  /// Throws Error{kBadParameter} when `text` is no JSON object.
  [[nodiscard]] static JsonBody parse(const std::string& text);
  explicit JsonBody(nlohmann::json object) : object_(std::move(object)) {}

  [[nodiscard]] bool has(const char* field) const;
  /// At most `most` bytes.
  [[nodiscard]] std::string text(const char* field, std::size_t most) const;
  /// As text(), empty where the field is missing or null.
  [[nodiscard]] std::string textOrNone(const char* field, std::size_t most) const;
  [[nodiscard]] std::int64_t whole(const char* field, std::int64_t least, std::int64_t most) const;
  /// Nothing where the field is missing or null.
  [[nodiscard]] std::optional<std::int64_t> wholeOrNone(const char* field, std::int64_t least,
                                                        std::int64_t most) const;
  [[nodiscard]] double number(const char* field, double least, double most) const;
  [[nodiscard]] JsonBody object(const char* field) const;
  /// The objects of an array of at most `most` of them.
  [[nodiscard]] std::vector<JsonBody> objects(const char* field, std::size_t most) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* field) const;

  nlohmann::json object_;
};

}  // namespace torsio::web
