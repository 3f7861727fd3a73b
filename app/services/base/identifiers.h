// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "sim/core/text.h"

namespace torsio {

inline constexpr std::size_t kLongestNumber = 64;  ///< characters of a staff or student number
inline constexpr std::size_t kLongestLogin = 64;   ///< characters of a sign-in name
inline constexpr std::size_t kLongestField = 200;  ///< characters of a name, address, level or post

/// Returns why a name, number or label is rejected: too long, or with an invisible character (controls, line
/// ends, direction marks, zero-width spaces, fillers). Empty: accepted.
[[nodiscard]] Text flawOf(std::string_view text, std::size_t longest);

/// Returns a canonical form for comparing numbers and sign-in names by appearance: unifies wide and accented
/// forms, dashes and spaces, digits of all scripts, Cyrillic, Greek and Armenian letters that look like Latin
/// ones, O and 0, and case. Look-alikes would split one person into two, or merge two people.
[[nodiscard]] std::string likenessOf(std::string_view number);

/// Returns whether a text has the form that spreadsheets give to long numbers: 1E+05, 1.23457E+11. The digits
/// that identified somebody are then lost.
[[nodiscard]] bool isSpreadsheetNumber(std::string_view text);

/// Throws Error{kBadData} if flawOf() finds a flaw in a text. `where`: the place named in the message.
void requireReadable(std::string_view text, const Text& where, std::size_t longest = kLongestField);

/// Identifiers of one kind in one file or list: every reader of people, raters, groups and targets takes them
/// through here, so that two spellings of one name never count as two.
class Identifiers {
 public:
  /// `kind`: what they name, for messages: "subject".
  explicit Identifiers(std::string kind) : kind_(std::move(kind)) {}

  /// Notes an identifier; one that was taken before is accepted again. Throws Error{kBadData} if it cannot be
  /// read (requireReadable()) or looks like an earlier one but is written differently; both places are named.
  void take(const std::string& name, const std::string& where);

 private:
  struct First {
    std::string name;
    std::string where;
  };
  std::string kind_;
  std::unordered_map<std::string, First> byLikeness_;
};

}  // namespace torsio
