// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/people/password_rule.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>

#include "assessment/domain/people/common_passwords.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Counts UTF-8 characters: every byte that is not a continuation byte.
std::ptrdiff_t charactersOf(const std::string& text) {
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// True for a short pattern repeated throughout: "aaaa...", "abcabcabc...".
bool repeats(const std::string& text) {
  constexpr std::size_t kPiece = 5;
  for (std::size_t piece = 1; piece <= kPiece; ++piece) {
    bool same = true;
    for (std::size_t i = piece; i < text.size() && same; ++i) {
      same = text[i] == text[i - piece];
    }
    if (same) {
      return true;
    }
  }
  return false;
}

/// True for a run along the keyboard or the alphabet: "123456789...", "qwertyuiop...".
bool isRun(const std::string& text) {
  static constexpr std::array<const char*, 3> kRuns{"12345678901234567890123456789012345678901234567890",
                                                    "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz",
                                                    "qwertyuiopasdfghjklzxcvbnmqwertyuiopasdfghjklzxcvbnm"};
  return std::any_of(kRuns.begin(), kRuns.end(),
                     [&](const char* run) { return std::string(run).find(text) != std::string::npos; });
}

[[noreturn]] void refuse(const Text& what, const Text& remedy) {
  refuseParameter(what, Text::tr("password"), remedy);
}

}  // namespace

void checkPassword(const std::string& password, const std::string& login) {
  if (charactersOf(password) < kShortestPassword) {
    refuse(Text::tr("the password is shorter than %1 characters", kShortestPassword),
           Text::tr("Use a sentence: spaces and any letters are allowed"));
  }
  if (password.size() > static_cast<std::size_t>(kLongestPassword)) {
    refuse(Text::tr("the password is too long"), Text::tr("Shorten it"));
  }
  const std::string plain = lowered(password);
  const std::string name = lowered(login);
  if (isCommonPassword(password)) {
    refuse(Text::tr("the password is made of words that are tried first"),
           Text::tr("Use a sentence of your own"));
  }
  if (repeats(plain) || isRun(plain)) {
    refuse(Text::tr("the password is a simple pattern"), Text::tr("Use a sentence of your own"));
  }
  if (name.size() >= 3 && plain.size() < name.size() + 8 && plain.find(name) != std::string::npos) {
    refuse(Text::tr("the password is little more than the login name"),
           Text::tr("Use a sentence of your own"));
  }
}

}  // namespace torsio
