// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

namespace torsio {

/// Id of one kind of thing, as text: a UUID in the record, the name of a folder or file in the assets. A text
/// becomes an id and an id reads as a text without a word, so that literals, columns and JSON stay plain; the
/// id of another kind is refused by the compiler: it can neither be made from one, nor be assigned or
/// compared. `Tag` only names the kind and is never defined. Empty: none.
template <typename Tag>
class Id {
 public:
  Id() = default;
  Id(std::string text) noexcept : text_(std::move(text)) {}  // NOLINT(google-explicit-constructor)
  Id(const char* text) : text_(text) {}                      // NOLINT(google-explicit-constructor)
  template <typename Other>
  requires(!std::same_as<Other, Tag>) Id(const Id<Other>& other)
  = delete;
  template <typename Other>
  requires(!std::same_as<Other, Tag>) Id& operator=(const Id<Other>& other) = delete;

  [[nodiscard]] const std::string& text() const noexcept { return text_; }
  operator const std::string&() const noexcept { return text_; }  // NOLINT(google-explicit-constructor)
  [[nodiscard]] bool empty() const noexcept { return text_.empty(); }

  friend bool operator==(const Id&, const Id&) = default;
  /// Orders by the bytes of the texts.
  friend std::strong_ordering operator<=>(const Id& a, const Id& b) noexcept { return a.text_ <=> b.text_; }
  /// Joins the text with what stands before or behind it.
  friend std::string operator+(const Id& id, std::string_view behind) {
    return std::string(id.text_).append(behind);
  }
  friend std::string operator+(std::string_view before, const Id& id) {
    return std::string(before).append(id.text_);
  }
  friend std::ostream& operator<<(std::ostream& out, const Id& id) { return out << id.text_; }

 private:
  std::string text_;
};

/// Ids of two kinds are never compared.
template <typename A, typename B>
requires(!std::same_as<A, B>) bool operator==(const Id<A>& a, const Id<B>& b) = delete;
template <typename A, typename B>
requires(!std::same_as<A, B>) std::strong_ordering operator<=>(const Id<A>& a, const Id<B>& b) = delete;

// A recording, and assets by the names of their files.
using TrialId = Id<struct TrialIdTag>;
using SceneId = Id<struct SceneIdTag>;
using PatternId = Id<struct PatternIdTag>;

}  // namespace torsio

/// Hashes an id as its text.
template <typename Tag>
struct std::hash<torsio::Id<Tag>> {
  std::size_t operator()(const torsio::Id<Tag>& id) const noexcept {
    return std::hash<std::string>{}(id.text());
  }
};
