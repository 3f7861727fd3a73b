// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "assessment/domain/ids.h"

namespace torsio {

using Blob = std::vector<std::byte>;

/// A value to bind: null, 64-bit integer, double, bool, UTF-8 text or bytes. Converts implicitly from the
/// corresponding C++ types and from std::optional of them (empty = null).
class Value {
 public:
  using Storage = std::variant<std::monostate, std::int64_t, double, bool, std::string, Blob>;

  Value() = default;
  Value(std::nullptr_t) {}  // NOLINT(google-explicit-constructor): a row is written as a list of values
  template <std::integral T>
  requires(!std::same_as<T, bool> && (std::signed_integral<T> || sizeof(T) < sizeof(std::int64_t)))
      Value(T number)
      : storage_(static_cast<std::int64_t>(number)) {}  // NOLINT(google-explicit-constructor)
  template <std::same_as<bool> T>
  Value(T flag) : storage_(flag) {}  // NOLINT(google-explicit-constructor)
  template <std::floating_point T>
  Value(T number) : storage_(static_cast<double>(number)) {}     // NOLINT(google-explicit-constructor)
  Value(std::string text) : storage_(std::move(text)) {}         // NOLINT(google-explicit-constructor)
  Value(std::string_view text) : storage_(std::string(text)) {}  // NOLINT(google-explicit-constructor)
  Value(const char* text) : storage_(std::string(text)) {}       // NOLINT(google-explicit-constructor)
  Value(Blob bytes) : storage_(std::move(bytes)) {}              // NOLINT(google-explicit-constructor)
  template <typename Tag>
  Value(const Id<Tag>& id) : storage_(id.text()) {}  // NOLINT(google-explicit-constructor)
  template <typename T>
  Value(const std::optional<T>& maybe) {  // NOLINT(google-explicit-constructor)
    if (maybe) {
      *this = Value(*maybe);
    }
  }

  [[nodiscard]] const Storage& storage() const noexcept { return storage_; }

 private:
  Storage storage_;
};

/// Maps empty text to null: for columns in which "not known" is legal and an empty text means nothing.
[[nodiscard]] inline Value textOrNull(const std::string& text) {
  return text.empty() ? Value() : Value(text);
}

}  // namespace torsio
