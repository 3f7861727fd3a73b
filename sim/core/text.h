// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/core/ids.h"

/// Names the context of the translations of a class; read by Qt's lupdate only (assets/translations/renew).
#define TORSIO_TRANSLATION_CONTEXT(context)

namespace torsio {

/// English words that stand in a source as one literal: made by Text::tr() or Text::verbatim() alone, so that
/// a literal that nobody marked is no text. A constant, a column of a table, a parameter.
class Phrase {
 public:
  /// Makes a phrase without words.
  constexpr Phrase() noexcept = default;
  /// Returns the words as they stand in the source: UTF-8, ends with a zero. Lives as long as the program.
  [[nodiscard]] constexpr std::string_view english() const noexcept { return english_; }
  [[nodiscard]] constexpr bool empty() const noexcept { return english_.empty(); }

 private:
  friend class Text;
  constexpr explicit Phrase(std::string_view english) noexcept : english_(english) {}

  std::string_view english_;
};

/// A sentence with places for its arguments: `Text::tr("trial %1 is sealed", id)`. English stands in the
/// pattern; whoever shows the text may replace the pattern by that of another language before the arguments
/// enter. Arguments are texts themselves. What is only known while the program runs (a name, a path, a
/// number) is a std::string and a text as it stands; a bare literal is none, but for "".
class Text {
  TORSIO_TRANSLATION_CONTEXT(Text)

 public:
  Text() = default;
  Text(const char (&)[1]) {}                                         // NOLINT(google-explicit-constructor)
  Text(Phrase words) : pattern_(words.english()) {}                  // NOLINT(google-explicit-constructor)
  Text(std::string asItStands) : pattern_(std::move(asItStands)) {}  // NOLINT(google-explicit-constructor)
  template <typename Tag>
  Text(const Id<Tag>& id) : pattern_(id.text()) {}  // NOLINT(google-explicit-constructor)
  /// A literal that is not marked is no text.
  Text(std::same_as<const char*> auto unmarked) = delete;
  /// `%1` to `%9` of the pattern stand for the arguments: texts, phrases, strings and whole numbers.
  template <typename... Rest>
  Text(Phrase pattern, const auto& first, const Rest&... rest)
      : pattern_(pattern.english()), arguments_{argument(first), argument(rest)...} {}

  /// Marks a literal that is translated: lupdate finds it, and a test asks for its Chinese.
  template <std::size_t Size>
  [[nodiscard]] static constexpr Phrase tr(const char (&words)[Size]) noexcept {
    return Phrase({words, Size - 1});
  }
  /// Marks the literal of a sentence that is translated and fills in what varies.
  template <std::size_t Size, typename... Rest>
  [[nodiscard]] static Text tr(const char (&pattern)[Size], const auto& first, const Rest&... rest) {
    return {tr(pattern), first, rest...};
  }
  /// Marks a literal that is the same in every language (a unit, a code, a file's name), or that only the
  /// command line and the folded details of a refusal show, which are English.
  template <std::size_t Size>
  [[nodiscard]] static constexpr Phrase verbatim(const char (&words)[Size]) noexcept {
    return Phrase({words, Size - 1});
  }
  /// As verbatim(), and fills in what varies.
  template <std::size_t Size, typename... Rest>
  [[nodiscard]] static Text verbatim(const char (&pattern)[Size], const auto& first, const Rest&... rest) {
    return {verbatim(pattern), first, rest...};
  }
  /// Makes a text again that was stored as its pattern() and arguments().
  [[nodiscard]] static Text restored(std::string pattern, std::vector<Text> arguments) {
    Text text(std::move(pattern));
    text.arguments_ = std::move(arguments);
    return text;
  }

  [[nodiscard]] const std::string& pattern() const noexcept { return pattern_; }
  [[nodiscard]] const std::vector<Text>& arguments() const noexcept { return arguments_; }
  [[nodiscard]] bool empty() const noexcept { return pattern_.empty(); }
  /// Returns the English sentence with its arguments.
  [[nodiscard]] std::string str() const;
  /// Compares what both texts say in English.
  friend bool operator==(const Text& a, const Text& b) { return a.str() == b.str(); }
  /// Compares what the text says in English.
  friend bool operator==(const Text& a, const std::convertible_to<std::string_view> auto& english) {
    return a.str() == std::string_view(english);
  }
  friend std::ostream& operator<<(std::ostream& out, const Text& text) { return out << text.str(); }

 private:
  /// A literal as an argument is marked like any other.
  template <std::size_t Size>
  static Text argument(const char (&unmarked)[Size]) = delete;
  static Text argument(const std::convertible_to<Text> auto& text) { return text; }
  static Text argument(std::string_view words) { return std::string(words); }
  static Text argument(std::integral auto number) { return std::to_string(number); }

  std::string pattern_;
  std::vector<Text> arguments_;
};

/// Returns `pattern` with `%1` to `%9` replaced by the arguments in one pass; a place without an argument
/// stays.
[[nodiscard]] std::string filledIn(std::string_view pattern, const std::vector<std::string>& arguments);

/// Joins texts to "a, b, c"; empty for none. `two` is the pattern that joins two of them.
[[nodiscard]] inline Text listed(std::span<const Text> items, Phrase two = Text::tr("%1, %2")) {
  Text all;
  for (const Text& item : items) {
    all = all.empty() ? item : Text(two, all, item);
  }
  return all;
}

}  // namespace torsio
