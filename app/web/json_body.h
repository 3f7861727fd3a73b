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

/// Reads a JSON object from a browser field by field. A missing field, a wrong type or a value out of range
/// throws Error{kBadParameter} naming the field.
class JsonBody {
 public:
  /// Throws Error{kBadParameter} if `text` is not a JSON object.
  [[nodiscard]] static JsonBody parse(const std::string& text);
  explicit JsonBody(nlohmann::json object) : object_(std::move(object)) {}

  [[nodiscard]] bool has(const char* field) const;
  /// At most `most` bytes.
  [[nodiscard]] std::string text(const char* field, std::size_t most) const;
  /// Like text(); empty if the field is missing or null.
  [[nodiscard]] std::string textOrNone(const char* field, std::size_t most) const;
  [[nodiscard]] std::int64_t whole(const char* field, std::int64_t least, std::int64_t most) const;
  /// Empty if the field is missing or null.
  [[nodiscard]] std::optional<std::int64_t> wholeOrNone(const char* field, std::int64_t least,
                                                        std::int64_t most) const;
  [[nodiscard]] double number(const char* field, double least, double most) const;
  [[nodiscard]] JsonBody object(const char* field) const;
  /// Returns the objects of an array of at most `most`.
  [[nodiscard]] std::vector<JsonBody> objects(const char* field, std::size_t most) const;

 private:
  [[nodiscard]] const nlohmann::json& at(const char* field) const;

  nlohmann::json object_;
};

}  // namespace torsio::web
