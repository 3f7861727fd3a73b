// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/site.h"

#include <algorithm>

namespace torsio {

namespace {

constexpr std::size_t kMaxInitials = 4;

bool isLatin(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}
char capital(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

}  // namespace

std::string firstCentreCode(std::string_view name, const CentreId& id) {
  std::string initials;
  bool inWord = false;
  for (const char c : name) {
    const bool letter = isLatin(c) || static_cast<unsigned char>(c) >= 0x80U;
    if (letter && !inWord && isLatin(c) && initials.size() < kMaxInitials) {
      initials += capital(c);
    }
    inWord = letter || c == '\'';
  }
  if (initials.size() >= 2) {
    return initials;
  }
  std::string code("C");
  code.append(id.text(), 0, 4);
  std::transform(code.begin(), code.end(), code.begin(), capital);
  return isCentreCode(code) ? code : "C";
}

}  // namespace torsio
