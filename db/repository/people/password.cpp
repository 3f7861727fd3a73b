// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/password.h"

#include <algorithm>
#include <array>
#include <cctype>

#include <sodium.h>

#include "assessment/people/account.h"
#include "sim/base/contracts.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

struct Limits {
  unsigned long long operations;
  std::size_t memory;
};

Limits limitsOf(PasswordCost cost) {
  switch (cost) {
    case PasswordCost::kTest:
      return {crypto_pwhash_OPSLIMIT_MIN, crypto_pwhash_MEMLIMIT_MIN};
    case PasswordCost::kInteractive:
      return {crypto_pwhash_OPSLIMIT_INTERACTIVE, crypto_pwhash_MEMLIMIT_INTERACTIVE};
    case PasswordCost::kModerate:
      break;
  }
  return {crypto_pwhash_OPSLIMIT_MODERATE, crypto_pwhash_MEMLIMIT_MODERATE};
}

/// UTF-8 characters: every byte that does not continue one.
std::ptrdiff_t charactersOf(const std::string& text) {
  return std::count_if(text.begin(), text.end(),
                       [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; });
}

std::string lowered(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// "aaaa...", "abcabcabc...": a short piece over and over.
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

/// "123456789...", "qwertyuiop...": a run along the keyboard or the alphabet.
bool isRun(const std::string& text) {
  static constexpr std::array<const char*, 3> kRuns{"12345678901234567890123456789012345678901234567890",
                                                    "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz",
                                                    "qwertyuiopasdfghjklzxcvbnmqwertyuiopasdfghjklzxcvbnm"};
  return std::any_of(kRuns.begin(), kRuns.end(),
                     [&](const char* run) { return std::string(run).find(text) != std::string::npos; });
}

[[noreturn]] void refuse(const Text& what, const Text& remedy) {
  throw Error(ErrorCode::kBadParameter, what, "password", remedy);
}

}  // namespace

void checkPassword(const std::string& password, const std::string& login) {
  if (charactersOf(password) < kShortestPassword) {
    refuse(Text("the password is shorter than %1 characters", kShortestPassword),
           "Take a sentence: spaces and any letters are welcome");
  }
  if (password.size() > static_cast<std::size_t>(kLongestPassword)) {
    refuse("the password is too long", "Shorten it");
  }
  const std::string plain = lowered(password);
  const std::string name = lowered(login);
  if (repeats(plain) || isRun(plain)) {
    refuse("the password is a simple pattern", "Take a sentence of your own");
  }
  if (name.size() >= 3 && plain.size() < name.size() + 8 && plain.find(name) != std::string::npos) {
    refuse("the password is little more than the login name", "Take a sentence of your own");
  }
}

std::string hashPassword(const std::string& password, PasswordCost cost) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  std::array<char, crypto_pwhash_STRBYTES> hash{};
  const Limits limits = limitsOf(cost);
  if (crypto_pwhash_str(hash.data(), password.data(), password.size(), limits.operations, limits.memory) !=
      0) {
    throw Error(ErrorCode::kInternal, "not enough memory to protect the password", "",
                "Close other programs and try again");
  }
  return hash.data();
}

bool passwordMatches(const std::string& hash, const std::string& password) {
  TORSIO_EXPECTS(sodium_init() >= 0);
  return crypto_pwhash_str_verify(hash.c_str(), password.data(), password.size()) == 0;
}

}  // namespace torsio
